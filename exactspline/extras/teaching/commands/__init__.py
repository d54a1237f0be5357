"""For teachers: ``teach triangle``, ``teach exercise``, ``teach check``."""
