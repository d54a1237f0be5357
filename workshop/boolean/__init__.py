"""An exact verifier of Boolean results: whether what an engine says is the union, intersection, difference or exclusive
or of two filled paths is that, but for a tube around the paths.
"""
