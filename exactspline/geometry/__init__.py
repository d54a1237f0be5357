"""The geometry of curves, pairs of curves and surfaces: features, constructions, bisectors, measures, recognition."""
