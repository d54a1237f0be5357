"""What the given surface has: certified signs, curves and points where its curvature is special."""
