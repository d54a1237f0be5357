"""The language of formulas: operands, vectors, quotients, arguments, formulas, ruled surfaces."""
