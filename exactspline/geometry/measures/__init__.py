"""Measures of a curve: arc lengths and the parameters at arc lengths, the area inside the curve, its moments and its
centroid.
"""
