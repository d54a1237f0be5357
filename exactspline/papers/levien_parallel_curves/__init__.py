"""R. Levien, posts on parallel curves of Bézier curves and on flattening: their formulas, text and code."""
