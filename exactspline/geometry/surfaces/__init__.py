"""What a surface has: the forms of its curvature, umbilics, singular points, ridges, joints, degenerate nets."""
