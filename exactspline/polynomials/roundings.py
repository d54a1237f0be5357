"""The assumptions on one operation with doubles (docs/certified-filter.md)."""

#: The relative error of one operation is below this in every rounding mode.
ROUNDING = 2**-52
#: The largest loss by underflow in one operation, even where subnormal numbers are flushed to zero.
UNDERFLOW = 2**-1022
