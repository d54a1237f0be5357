"""What formulas are like: ``formula degrees``, ``formula reduce``, ``formula conditioning``."""
