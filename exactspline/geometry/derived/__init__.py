"""Objects derived from a curve by a formula: constructions in all their variants, ruled surfaces."""
