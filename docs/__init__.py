"""Documentation, and the package that builds its site."""
