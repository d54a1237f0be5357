"""What the given curve has: constructions, features, ruled surfaces, bisectors."""
