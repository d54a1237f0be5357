"""A. Petrunin, S. Zamora Barrera, *What is differential geometry: curves and surfaces*: curves."""
