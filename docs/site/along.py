"""Pages for reading along: the paper section by section in its order, each statement with its verdict in the margin."""

from __future__ import annotations

from pathlib import Path
from shutil import copyfile
from typing import Any

import exactspline as xs
from docs.site.narrow import beside, narrowed, png
from docs.site.pages import picture, plain
from exactspline.display.theorem import ReadingAlong, along_html, reading_along
from exactspline.papers import default_papers
from exactspline.papers.passages import sections_of
from exactspline.verification.vocabulary import Status

#: The notebook in which the statements of a section are derived.
NOTEBOOKS = {
    "1": "21_introduction_and_conclusion",
    "2": "02_table_1_live",
    "3": "03_derivatives_of_a_rational_curve",
    "4.1": "04_zero_curvature",
    "4.2": "05_critical_curvature",
    "4.3": "06_evolutes",
    "5": "07_torsion_and_ruled_surfaces",
    "5.5": "08_focal_curve_and_surface",
    "5.6": "08_focal_curve_and_surface",
    "6": "09_bisectors",
    "7": "21_introduction_and_conclusion",
}
#: Figures of the paper and pictures of other pages, by section: files beside the pages, and what is to be seen.
PICTURES = {
    "1": [("gallery/approximated.png", "Evolutes of a circle and of an ellipse, and those of their approximations")],
    "4.2": [("gallery/figure1.svg", "Figure 1, drawn again"), ("gallery/figure2.svg", "Figure 2, drawn again")],
    "4.3": [("gallery/figure3.svg", "Figure 3, drawn again")],
    "6.2": [(f"gallery/figure{n}.svg", f"Figure {n}, drawn again") for n in (4, 5, 6)],
}
#: Pictures drawn for a section: a formula, the example curve that it is given, and what is to be seen.
DRAWN = {
    "2": ("bracket", "rational_cubic", "A product of B-splines: [p p′] of a rational cubic, with its control points"),
    "3": ("f1", "rational_cubic", "[D1 D2] of a rational cubic, with its control points"),
    "4.1": ("f2", "six_segment_cubic", "The curvature numerator f2 of a cubic of six segments"),
    "5.1": ("radius_vector", "twisted_cubic", "κ⁻¹N of the twisted cubic"),
    "5.2": ("D1_D2_D3", "rational_space_cubic", "[D1 D2 D3], whose zeros are those of the torsion"),
    "5.3": ("tangent_developable_reduced", "rational_space_cubic", "The tangent developable of a rational cubic"),
    "5.4": ("rectifying_developable_reduced", "twisted_cubic", "The rectifying developable of the twisted cubic"),
    "5.5": ("focal_curve_reduced", "twisted_cubic", "The focal curve of the twisted cubic"),
    "5.6": ("focal_surface_reduced", "twisted_cubic", "The focal surface of the twisted cubic"),
    "7": ("g2", "conditioning_close_to_zero", "g2 where numerator and discarded denominator are close to zero"),
}
LINES = "The bisector of two lines: a hyperbolic paraboloid"
COLUMNS = ("section", "passages", "printed statements", "decided", "hold", "refuted", "notebook")


def write_reading(folder: Path, drawn: Path) -> list[str]:
    """One page per section, and one that lists them; `drawn` is the folder of pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    drawn.mkdir(parents=True, exist_ok=True)
    copyfile(Path(__file__).parents[1] / "pictures" / "approximated.png", drawn / "approximated.png")
    for section, (formula, curve, _) in DRAWN.items():
        _save(xs.plot(xs.formula_of(formula)(xs.example(curve))), drawn / f"{_name(section)}.svg")
    own = [xs.Nurbs(1, [-2, -2, 2, 2], ends) for ends in (((-2, 0, -1), (2, 0, -1)), ((0, -2, 1), (0, 2, 1)))]
    _save(xs.plot(xs.formula_of("bisector_symmetric")(xs.tables.surface_pair(*own))), drawn / f"{_name('6.1')}.svg")
    read = [reading_along(number) for number in sections_of(default_papers()[0])]
    names = [_name(each.section) for each in read]
    for i, each in enumerate(read):
        before, after = names[i - 1] if i else "", names[i + 1] if i + 1 < len(names) else ""
        (folder / f"{names[i]}.md").write_text(_page(each, before, after), encoding="utf-8")
    (folder / "index.md").write_text(_index(read), encoding="utf-8")
    return [f"{folder.name}/{name}" for name in ("index", *names)]


def _save(ax: Any, file: Path) -> None:
    ax.figure.savefig(file)
    beside(file).write_bytes(png(narrowed(ax.figure)))


def _name(section: str) -> str:
    return f"section-{section.replace('.', '-')}"


def _notebook(section: str) -> str:
    return NOTEBOOKS.get(section) or NOTEBOOKS[section.partition(".")[0]]


def _page(read: ReadingAlong, before: str, after: str) -> str:
    links = [f"[← previous]({before}.md)"] * bool(before) + ["[all sections](index.md)"]
    links += [f"[derived in a notebook](../notebooks/{_notebook(read.section)}.ipynb)"]
    links += [f"[next →]({after}.md)"] * bool(after)
    pictures = [picture(f"../{file}", seen) for file, seen in _pictures(read.section)]
    body = f'```{{raw}} html\n<div class="tex2jax_process">{along_html(read)}</div>\n```'
    return "\n\n".join([f"# §{read.section} {plain(read.title)}", " · ".join(links), *pictures, body]) + "\n"


def _pictures(section: str) -> list[tuple[str, str]]:
    text = DRAWN[section][2] if section in DRAWN else LINES if section == "6.1" else ""
    drawn = [(f"gallery/{_name(section)}.svg", text)] if text else []
    return [*PICTURES.get(section, []), *drawn]


def _index(read: list[ReadingAlong]) -> str:
    rows = []
    for each in read:
        printed = each.counts[Status.PRINTED]
        book = _notebook(each.section)
        title = f"[§{each.section} {plain(each.title)}]({_name(each.section)}.md)"
        numbers = (printed.statements, printed.hold + printed.refuted, printed.hold, printed.refuted)
        rows.append((title, len(each.passages), *numbers, f"[{book[:2]}](../notebooks/{book}.ipynb)"))
    sums = [sum(row[i] for row in rows) for i in range(1, 6)]
    rows.append(("all", *sums, ""))
    table = "\n".join(f"| {' | '.join(map(str, row))} |" for row in (COLUMNS, ["---"] * len(COLUMNS), *rows))
    text = (
        f"{sums[2]} of {sums[1]} printed statements are decided. The paper is read sentence by sentence: every "
        "statement, in its order, with its verdict in the margin, its formula and degree, and its proof. A passage is "
        "quoted by its first words, a statement by its decisive words; keep the paper at hand."
    )
    return f"# Reading along\n\n*{plain(default_papers()[0].title)}*\n\n{text}\n\n{table}\n"
