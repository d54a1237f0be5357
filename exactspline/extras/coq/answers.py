"""Answers about one curve as theorems: where its curvature, the derivative of its curvature, its torsion vanish."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from flint import fmpq_poly

from exactspline.errors import ClaimError, counted
from exactspline.extras.coq.formulas import Formulas, comment
from exactspline.language.formula import Formula
from exactspline.numbers.exact import from_flint, mpq, to_fmpq
from exactspline.papers import find, papers
from exactspline.polynomials.isolation import Cell, cells_of
from exactspline.splines.bspline import in_powers
from exactspline.splines.control_points import lifted
from exactspline.splines.nurbs import Nurbs

#: The forms by the dimension of the curve: the name of the theorem, the formula, and the quantity that vanishes with
#: it.
FORMS = {
    2: (
        ("curvature", "f2", "the curvature"),
        ("curvature_derivative", "vertices_lifted", "the derivative of the curvature"),
    ),
    3: (("torsion", "torsion_zeros_lifted", "the torsion"),),
}


@dataclass(frozen=True)
class Answer:
    """A form of a curve: its polynomials span by span, and their cells."""

    name: str
    formula: Formula
    what: str
    polynomials: tuple[fmpq_poly, ...]
    cells: tuple[tuple[Cell, ...], ...]

    @property
    def points(self) -> list[tuple[mpq, mpq]]:
        """The intervals or points, each containing exactly one zero."""
        points: list[tuple[mpq, mpq]] = []
        for i, (f, cells) in enumerate(zip(self.polynomials, self.cells, strict=True)):
            last = i == len(self.cells) - 1
            if cells[0].sign is None:
                points += [(cells[-1].high, cells[-1].high)] if last else []
                continue
            for cell in cells:
                points += [(cell.low, cell.low)] if f(to_fmpq(cell.low)) == 0 else []
                points += [(cell.low, cell.high)] if cell.one else []
            points += [(cells[-1].high, cells[-1].high)] if last and f(to_fmpq(cells[-1].high)) == 0 else []
        return points

    @property
    def stretches(self) -> list[tuple[mpq, mpq]]:
        """The spans on which the form vanishes identically."""
        return [(cells[0].low, cells[0].high) for cells in self.cells if cells[0].sign is None]


def answers(curve: Nurbs) -> list[Answer]:
    """The forms of a curve with their cells.

    Raises `ClaimError` for a curve that is neither in the plane nor in space.
    """
    if curve.dimension not in FORMS:
        raise ClaimError(f"a curve in R{curve.dimension}", remedy="answers are proved in the plane and in space")
    spans, forms = list(pairwise(curve.breakpoints)), []
    for name, formula, what in FORMS[curve.dimension]:
        value = find(formula)(curve)
        polynomials = tuple(in_powers(value, i) for i in range(len(spans)))
        cells = tuple(tuple(cells_of(f, a, b)) for f, (a, b) in zip(polynomials, spans, strict=True))
        forms.append(Answer(name, find(formula), what, polynomials, cells))
    return forms


def theorem_of(curve: Nurbs) -> str:
    """A file with theorems about this curve, given by its control points."""
    forms = answers(curve)
    formulas = Formulas(papers())
    own = {formulas.owner[answer.formula].name for answer in forms}
    parts = [
        f"(** Where forms of the curve {comment(curve.name or 'without a name')} vanish: proved from its knots and "
        "control points.\n\n    Written by [exactspline inspect --emit-coq]; do not edit. It is compiled after the "
        "files that\n    [exactspline coq DIR] writes: coqc -R DIR ExactSpline FILE.v. *)\n",
        "Require Import ZArith QArith List Reals.\nFrom ExactSpline Require Import Base Answers.",
        *[f"From ExactSpline.formulas Require {name}." for name in sorted(own)],
        "Import ListNotations.\nLocal Open Scope Q_scope.\n",
        definition("this_curve", curve),
        "(** The domain of the curve, on which the theorems speak of it. *)\n"
        f"Theorem this_curve_has_the_domain : domain this_curve = ({', '.join(map(number_in_q, curve.domain))}).\n"
        "Proof. vm_cast_no_check (eq_refl (domain this_curve)). Qed.\n",
        "Lemma this_curve_sound : sound this_curve = true.\nProof. vm_cast_no_check (eq_refl true). Qed.\n",
        "(** Numerators and denominator between two knots are the B-splines by the recursion of Cox and de Boor. *)\n"
        "Theorem this_curve_is_in_pieces (j : nat) (t : R) :\n"
        "  (S j < length (knots this_curve))%nat ->\n"
        "  (knot (knots this_curve) j <= t < knot (knots this_curve) (S j))%R ->\n"
        "  Forall2 (fun x a => spline (knots this_curve) (degree this_curve) x t = at_real a t)\n"
        "          (coordinates this_curve) (p (curve_piece this_curve j)) /\\\n"
        "  spline (knots this_curve) (degree this_curve) (weights this_curve) t\n"
        "  = at_real (w (curve_piece this_curve j)) t.\n"
        "Proof. exact (pieces_are_splines this_curve j t this_curve_sound). Qed.\n",
    ]
    for answer in forms:
        parts.append(_theorem(curve, answer, formulas))
    return "\n".join(parts)


def definition(name: str, curve: Nurbs) -> str:
    """A curve as a record of Coq."""
    *coordinates, weights = map(_list, _homogeneous_columns(curve))
    return (
        "(** Knots, degree, coordinates of the control points times their weights, and the weights. *)\n"
        f"Definition {name} : nurbs := {{|\n  knots := {_list(curve.knots)};\n  degree := {curve.degree};\n"
        f"  coordinates := [{'; '.join(coordinates)}];\n  weights := {weights}\n|}}.\n"
    )


def _homogeneous_columns(curve: Nurbs) -> list[list[mpq]]:
    """The coordinates times the weights, coordinate by coordinate, and the weights."""
    rows = [(*lifted(point, weight), weight) for point, weight in zip(curve.control_points, curve.weights, strict=True)]
    return [list(column) for column in zip(*rows, strict=True)]


def _theorem(curve: Nurbs, answer: Answer, formulas: Formulas) -> str:
    form = formulas.named(answer.formula)
    low, high = number_in_q(answer.cells[0][0].low), number_in_q(answer.cells[-1][-1].high)
    cells = ";\n  ".join("[" + "; ".join(map(cell_text, own)) + "]" for own in answer.cells)
    pieces = ";\n  ".join(
        f"({number_in_q(own[-1].high)}, {coefficients_text(f)})"
        for f, own in zip(answer.polynomials, answer.cells, strict=True)
    )
    points, stretches = pairs_text(answer.points), pairs_text(answer.stretches)
    places = counted(len(answer.points), "point")
    places += f" and {counted(len(answer.stretches), 'stretch')}" if answer.stretches else ""
    return (
        f"Definition {answer.name}_in_pieces : pieces := [\n  {pieces}\n].\n\n"
        f"Definition cells_of_{answer.name} : list (list cell) := [\n  {cells}\n].\n\n"
        f"(** The form with which {answer.what} vanishes is zero at exactly {places}; and its signs. *)\n"
        f"Theorem {answer.name}_vanishes :\n"
        f"  vanishes_exactly (form_value (form_pieces {form} this_curve)) ({low}) ({high})\n"
        f"    {points}\n    {stretches} /\\\n"
        f"  Forall2 (fun b own => Forall (says (at_real (snd b))) own)\n"
        f"    (form_pieces {form} this_curve) cells_of_{answer.name}.\n"
        "Proof.\n"
        f"  apply (curve_answers {form} this_curve _ _ cells_of_{answer.name} _ _\n"
        f"    {answer.name}_in_pieces); [vm_cast_no_check (eq_refl true)|].\n"
        f"  vm_cast_no_check (eq_refl (true, ({high})%Q,\n"
        f"    ({points} : list (Q * Q))%Q, ({stretches} : list (Q * Q))%Q)).\n"
        "Qed.\n"
    )


def number_in_q(value: object) -> str:
    """An exact number in the scope of Q."""
    exact = mpq(value)
    return f"{exact.numerator}" if exact.denominator == 1 else f"{exact.numerator} # {exact.denominator}"


def _list(values: Iterable[object]) -> str:
    return "[" + "; ".join(map(number_in_q, values)) + "]"


def pairs_text(pairs: Iterable[tuple[mpq, mpq]]) -> str:
    """Pairs of exact numbers as a list of Coq."""
    return "[" + "; ".join(f"({number_in_q(a)}, {number_in_q(b)})" for a, b in pairs) + "]"


def coefficients_text(f: fmpq_poly) -> str:
    """A polynomial as the list of its coefficients."""
    return _list(from_flint(c) for c in f.coeffs())


def boolean(value: bool) -> str:
    """A truth value in Coq."""
    return "true" if value else "false"


def cell_text(cell: Cell) -> str:
    """A cell as a term of Coq."""
    ends = f"({number_in_q(cell.low)}) ({number_in_q(cell.high)})"
    if cell.sign is None:
        return f"Null {ends}"
    if cell.factor is not None and cell.rest is not None:
        return (
            f"Multiple {ends} {coefficients_text(cell.factor)} {boolean(cell.sign)} {cell.power} "
            f"{coefficients_text(cell.rest)} {boolean(cell.rest_sign)}"
        )
    return f"{'One' if cell.one else 'Sign'} {ends} {boolean(cell.sign)}"
