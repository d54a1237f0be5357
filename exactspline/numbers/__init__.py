"""What numbers are before there are polynomials: the gate for what comes in, intervals, rounding, values, sides."""
