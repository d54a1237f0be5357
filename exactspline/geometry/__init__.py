"""What the curve at hand has: constructions, features, ruled surfaces, bisectors."""
