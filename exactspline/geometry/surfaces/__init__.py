"""Features of a surface: the forms of its curvature, umbilics, singular points, ridges, joints, degenerate control
nets.
"""
