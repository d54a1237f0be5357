"""The questions about curves, surfaces, maps and pairs, with their answers from all other packages of the geometry."""
