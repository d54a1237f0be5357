"""What formulas are written in: operands, vectors, quotients, arguments, formulas, ruled surfaces."""
