"""The geometry of a curve: constructions, features, ruled surfaces, bisectors."""
