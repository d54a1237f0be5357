"""The zeros of functions of two parameters: common zeros, zero curves and their singular points, joined across
patches, and the proofs that these are all.
"""
