"""Questions about geometric objects: what an entry of the registry is, and what an answer looks like. The entries
themselves stand next to the exact answers, in `exactspline.geometry`.
"""
