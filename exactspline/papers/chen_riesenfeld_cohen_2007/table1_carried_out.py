"""§2, Table 1, the column "carried out as": every row as printed in the paper."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, join


@formula("Table 1, T4", on="table")
def T4_carried_out(t):
    """Row T4 over one denominator."""
    return (t.p1 + t.p2 * t.w1) / t.w1


@formula("Table 1, T5", on="table")
def T5_carried_out(t):
    """Row T5 over one denominator."""
    return (t.p1 * t.w2 + t.p2 * t.w1) / (t.w1 * t.w2)


@formula("Table 1, T6", on="table")
def T6_carried_out(t):
    """Row T6 over one denominator."""
    return (t.p1 * t.p2) / t.w1


@formula("Table 1, T7", on="table")
def T7_carried_out(t):
    """Row T7 over one denominator."""
    return (t.p1 * t.p2) / (t.w1 * t.w2)


@formula("Table 1, T8", on="table")
def T8_carried_out(t):
    """Row T8 over one denominator."""
    return t.p1 / (t.w1 * t.p2)


@formula("Table 1, T9", on="table")
def T9_carried_out(t):
    """Row T9 over one denominator."""
    return (t.p1 * t.w2) / (t.w1 * t.p2)


@formula("Table 1, T12", on="table")
def T12_carried_out(t):
    """Row T12 over one denominator."""
    return cross(t.v1, t.v2) / t.w1


@formula("Table 1, T13", on="table")
def T13_carried_out(t):
    """Row T13 over one denominator."""
    return cross(t.v1, t.v2) / (t.w1 * t.w2)


@formula("Table 1, T14", on="table")
def T14_carried_out(t):
    """Row T14 over one denominator."""
    return dot(t.v1, t.v2) / t.w1


@formula("Table 1, T15", on="table")
def T15_carried_out(t):
    """Row T15 over one denominator."""
    return dot(t.v1, t.v2) / (t.w1 * t.w2)


@formula("Table 1, T4", on="table")
def T4_minus_carried_out(t):
    """Row T4 with its lower sign."""
    return (t.p1 - t.p2 * t.w1) / t.w1


@formula("Table 1, T5", on="table")
def T5_minus_carried_out(t):
    """Row T5 with its lower sign."""
    return (t.p1 * t.w2 - t.p2 * t.w1) / (t.w1 * t.w2)


@formula("Table 1, T10", on="table")
def T10_carried_out(t):
    """Row T10: the printed component, and the two others in cyclic order."""
    a, b = t.v1, t.v2
    return join(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@formula("Table 1, T11", on="table")
def T11_carried_out(t):
    """Row T11: the sum of the products of components."""
    return t.v1[0] * t.v2[0] + t.v1[1] * t.v2[1] + t.v1[2] * t.v2[2]


@formula("Table 1, T17", on="table")
def T17_carried_out(t):
    """Row T17 over one denominator."""
    return (t.p1.d(1) * t.w1 - t.p1 * t.w1.d(1)) / t.w1**2
