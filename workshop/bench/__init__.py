"""`./run bench`: times of this library and of others, in one run on the same input."""
