"""Lines, planes, circles and spheres attached to a curve at the parameter s, as equations for the point at s̄."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, norm2
from exactspline.papers.petrunin_zamora_barrera.plane import towards_the_centre
from exactspline.papers.petrunin_zamora_barrera.space import (
    binormal_by_arc_length,
    sphere_offset_along_binormal,
    towards_the_circle,
)


@formula("ch. Curvature, § Tangents", on="pair")
def off_the_tangent_line(c):
    """``γ′ × (γ(s̄) − γ)``."""
    return cross(c.first.gamma.d(1), c.second.gamma - c.first.gamma)


@formula("ch. Torsion, § Frenet frame", on="pair")
def off_the_osculating_plane(c):
    """``⟨B, γ(s̄) − γ⟩`` times ``|γ′|κ``."""
    return dot(binormal_by_arc_length(c.first), c.second.gamma - c.first.gamma)


@formula("ch. Signed curvature, § Osculating circline", on="plane pair")
def off_the_osculating_circle(c):
    """``|γ(s̄) − ω|² − |γ − ω|²`` for the centre ω of curvature: ``|v|² − 2 v·(ω − γ)`` with ``v = γ(s̄) − γ``."""
    way = c.second.gamma - c.first.gamma
    return norm2(way) - 2 * dot(way, towards_the_centre(c.first))


@formula("ch. Torsion, § Spherical curves", on="pair")
def off_the_printed_sphere(c):
    """``|γ(s̄) − p|² − |γ − p|²`` for the centre p as printed."""
    way = c.second.gamma - c.first.gamma
    return norm2(way) - 2 * dot(way, towards_the_circle(c.first) + sphere_offset_along_binormal(c.first))


@formula("ch. Torsion, § Spherical curves", on="pair")
def off_the_osculating_sphere(c):
    """``|γ(s̄) − p|² − |γ − p|²`` for the centre p with the opposite sign."""
    way = c.second.gamma - c.first.gamma
    return norm2(way) - 2 * dot(way, towards_the_circle(c.first) - sphere_offset_along_binormal(c.first))


@formula("ch. Torsion, § Spherical curves", on="pair")
def between_the_spheres(c):
    """The value for the centre with the opposite sign, minus that for the printed one."""
    return off_the_osculating_sphere(c) - off_the_printed_sphere(c)


@formula("ch. Torsion, § Spherical curves", on="pair")
def along_the_offset(c):
    """``v·o`` with ``v = γ(s̄) − γ`` and the offset o of the centre along B."""
    return dot(c.second.gamma - c.first.gamma, sphere_offset_along_binormal(c.first))
