"""Questions about geometric objects: the entries of the registry, and the parts of answers. The entries themselves are
next to the exact answers, in `exactspline.geometry`.
"""
