"""Formats of CAD programs: STEP, IGES, BREP, DXF, 3dm, g2, G+Smo, IRIT, geomdl."""
