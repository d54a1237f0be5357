"""Features of all curves and surfaces near a given one, such as one with rounded numbers, and how far they are
stable.
"""
