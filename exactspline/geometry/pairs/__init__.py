"""Two curves, and a curve and a point: common points, distances, nearest points, winding numbers."""
