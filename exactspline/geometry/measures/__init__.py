"""What is measured of a curve: arc lengths and the parameters at them, the area inside it, its moments and centroid."""
