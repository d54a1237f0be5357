"""What the surface at hand has: certified signs, curves and points where its curvature is special."""
