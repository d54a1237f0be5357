"""The features of a surface: certified signs, curves and points where its curvature is special."""
