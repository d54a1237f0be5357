"""Numbers: conversion of input to exact numbers, intervals, rounding to doubles, immutable values, sides of a point."""
