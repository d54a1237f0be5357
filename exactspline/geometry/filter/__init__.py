"""The certified filter: inflections and extrema of curvature decided in doubles with proved bounds."""
