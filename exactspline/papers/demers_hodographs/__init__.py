"""E. Demers, talks and code on Pythagorean-hodograph curves: hodographs on the light cone, offsets, Möbius maps."""
