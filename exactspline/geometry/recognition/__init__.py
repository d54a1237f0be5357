"""Curves and surfaces that are lines, circles, conics, planes, spheres, cylinders, cones or tori, exactly or within a
proved distance.
"""
