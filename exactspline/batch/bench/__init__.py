"""`exactspline bench`: what is computed, and how long it takes, here and with others, in one run on the same input."""
