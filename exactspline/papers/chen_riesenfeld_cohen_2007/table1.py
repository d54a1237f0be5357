"""§2, Table 1: the operations, on polynomials p1, p2 and rationals p1/w1, p2/w2 of degrees d1 and d2."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot


@formula("Table 1, T1", on="table")
def T1(t):
    """Sum of two polynomials."""
    return t.p1 + t.p2


@formula("Table 1, T2", on="table")
def T2(t):
    """Product of two polynomials."""
    return t.p1 * t.p2


@formula("Table 1, T3", on="table")
def T3(t):
    """Quotient of two polynomials."""
    return t.p1 / t.p2


@formula("Table 1, T4", on="table")
def T4(t):
    """Sum of a rational and a polynomial."""
    return t.p1 / t.w1 + t.p2


@formula("Table 1, T5", on="table")
def T5(t):
    """Sum of two rationals."""
    return t.p1 / t.w1 + t.p2 / t.w2


@formula("Table 1, T6", on="table")
def T6(t):
    """Product of a rational and a polynomial."""
    return (t.p1 / t.w1) * t.p2


@formula("Table 1, T7", on="table")
def T7(t):
    """Product of two rationals."""
    return (t.p1 / t.w1) * (t.p2 / t.w2)


@formula("Table 1, T8", on="table")
def T8(t):
    """A rational divided by a polynomial."""
    return (t.p1 / t.w1) / t.p2


@formula("Table 1, T9", on="table")
def T9(t):
    """Quotient of two rationals."""
    return (t.p1 / t.w1) / (t.p2 / t.w2)


@formula("Table 1, T10", on="table")
def T10(t):
    """Cross product of two polynomial vectors."""
    return cross(t.v1, t.v2)


@formula("Table 1, T11", on="table")
def T11(t):
    """Dot product of two polynomial vectors."""
    return dot(t.v1, t.v2)


@formula("Table 1, T12", on="table")
def T12(t):
    """Cross product of a rational and a polynomial vector."""
    return cross(t.v1 / t.w1, t.v2)


@formula("Table 1, T13", on="table")
def T13(t):
    """Cross product of two rational vectors."""
    return cross(t.v1 / t.w1, t.v2 / t.w2)


@formula("Table 1, T14", on="table")
def T14(t):
    """Dot product of a rational and a polynomial vector."""
    return dot(t.v1 / t.w1, t.v2)


@formula("Table 1, T15", on="table")
def T15(t):
    """Dot product of two rational vectors."""
    return dot(t.v1 / t.w1, t.v2 / t.w2)


@formula("Table 1, T16", on="table")
def T16(t):
    """Derivative of a polynomial."""
    return t.p1.d(1)


@formula("Table 1, T17", on="table")
def T17(t):
    """Derivative of a rational."""
    return (t.p1 / t.w1).d(1)


@formula("Table 1, T1", on="table")
def T1_minus(t):
    """Difference of two polynomials."""
    return t.p1 - t.p2


@formula("Table 1, T4", on="table")
def T4_minus(t):
    """Difference of a rational and a polynomial."""
    return t.p1 / t.w1 - t.p2


@formula("Table 1, T5", on="table")
def T5_minus(t):
    """Difference of two rationals."""
    return t.p1 / t.w1 - t.p2 / t.w2
