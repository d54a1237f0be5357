"""Space curves with ``c′ = A i A*``: the quaternion A consists of the four functions of a rational space curve."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, join, norm2


def _product(a, b):
    """The product of quaternions ``a₀ + a₁i + a₂j + a₃k``."""
    u, v = a[1:4], b[1:4]
    return join(a[0] * b[0] - dot(u, v), v * a[0] + u * b[0] + cross(u, v))


@formula("Space: square the radius, rotate i", on="space", symbol="A")
def quaternion(c):
    """``A = w + xi + yj + zk``."""
    return join(c.w, c.p)


@formula("Space: square the radius, rotate i", on="space")
def sandwich(c):
    """``A i A*``."""
    a = quaternion(c)
    by_i = join(-a[1], a[0], a[3], -a[2])
    return _product(by_i, join(a[0], -a[1:4]))


@formula("Space: square the radius, rotate i", on="space")
def sandwich_real_part(c):
    """The real part of ``A i A*``: zero, so that the product lies in R³."""
    return sandwich(c)[0]


@formula("Space: square the radius, rotate i", on="space")
def sandwich_squared(c):
    """The squared norm of ``A i A*``."""
    return norm2(sandwich(c))


@formula("Space: square the radius, rotate i", on="space")
def quaternion_squared(c):
    """``|A|²``."""
    return norm2(quaternion(c))


@formula("polynomial quadruples", on="space")
def hopf_map(c):
    """``(w² + x² − y² − z², 2(xy + wz), 2(xz − wy))``."""
    w, x, y, z = c.w, c.p[0], c.p[1], c.p[2]
    return join(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y))


@formula("Space: square the radius, rotate i", on="space")
def sandwich_vector(c):
    """The vector part of the sandwich."""
    return sandwich(c)[1:4]


@formula("The ambiguity is a group", on="space with a, b")
def turned_sandwich(c):
    """``B i B*`` for ``B = A (a + bi)``."""
    q = quaternion(c)
    turned = join(q[0] * c.a - q[1] * c.b, q[0] * c.b + q[1] * c.a, q[2] * c.a + q[3] * c.b, q[3] * c.a - q[2] * c.b)
    by_i = join(-turned[1], turned[0], turned[3], -turned[2])
    return _product(by_i, join(turned[0], -turned[1:4]))[1:4]


@formula("The ambiguity is a group", on="space with a, b")
def turning_squared(c):
    """``a² + b²``: 1 for ``a + bi = e^{iθ}``."""
    return c.a * c.a + c.b * c.b


@formula("Every spinor works", on="space")
def quaternion_speed_change(c):
    """``σσ′ − c′·c″`` for ``c′ = A i A*`` and ``σ = |A|²``."""
    return quaternion_squared(c) * quaternion_squared(c).d(1) - dot(sandwich_vector(c), sandwich_vector(c).d(1))
