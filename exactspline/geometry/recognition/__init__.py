"""Which pieces of a curve are lines, circles or conics, exactly or within a proved distance."""
