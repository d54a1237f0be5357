"""Printers of expression trees as LaTeX and as text."""
