"""The benchmarks measure what they say: the same values on both sides, targets held as they stand, peers told when
they are missing.
"""

import json
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest

from docs.site import benchmarks
from exactspline import formula_of
from exactspline.batch.sweep import Where
from exactspline.display.plot import PlotError
from exactspline.errors import FormulaError
from exactspline.tables import surface_pair
from workshop.bench import (
    alone,
    features,
    forms,
    inline,
    inputs,
    measures,
    memory,
    peers,
    picture,
    row,
    splines,
    sweeps,
    table,
)
from workshop.bench.__main__ import main
from workshop.bench.row import OURS, Options, Row, bounded, compared


@pytest.mark.parametrize(("name", "segments"), [(name, n) for name in forms.BY_HAND for n in (1, 3)])
def test_what_is_written_by_hand_is_the_formula(name, segments):
    c = inputs.curve(3, segments)
    ours = formula_of(name)(c)
    for (own, k), (row_, m) in zip(ours.forms, inputs.forms(c), strict=True):
        by_hand = forms.BY_HAND[name](*row_, 3, inline.form_derivative)
        # the library's denominators are the least, those by hand powers of that of the control points
        degree = by_hand.degree() - own.degree()
        raised = own * inline.U_PLUS_V**degree
        assert by_hand * raised.leading_coefficient() == raised * by_hand.leading_coefficient()
        assert m**10 % k == 0


def test_torsion_by_hand_is_the_formula():
    c = inputs.curve(4, dimension=3)
    ((*p, w), _) = next(inputs.forms(c))
    value = formula_of("torsion_reduced")(c)
    top, bottom = inline.torsion(p, w, 4, inline.form_derivative)
    assert value.numerator.numerators[0] * bottom == top * value.denominator.numerators[0]


def test_the_bisector_by_hand_is_the_formula():
    one, two = (inputs.curve(3, dimension=3, seed=seed) for seed in (1, 2))
    value = formula_of("bisector_symmetric")(surface_pair(one, two))
    ((numerators, below),) = forms.packed_bisector(one, two)

    def at(packed, z, y):
        stride = forms.STRIDE
        return sum(int(x) * z ** (i % stride) * y ** (i // stride) for i, x in enumerate(packed.coeffs()))

    z, y = Fraction(1, 2), Fraction(2, 3)
    point = [at(n, z, y) / (2 * at(below, z, y)) for n in numerators]
    assert [str(x) for x in value("1/3", "2/5")] == [str(x) for x in point]


def test_the_peers_polynomials_are_the_curve():
    c = inputs.curve(3, 2)
    t = Fraction(1, 3)
    for i, powers in enumerate(peers.powers(c)):
        *p, w = (sum(a * t**k for k, a in enumerate(x)) for x in powers)
        assert [str(x / w) for x in p] == [str(x) for x in c(f"{3 * i + 1}/3")]
    # in powers of t the Wronskian is that of the forms: it vanishes where they do
    ((x, y, w), _) = next(inputs.forms(c))
    first = [peers.FractionPoly(q) for q in peers.powers(c)[0]]
    in_powers = inline.f2(*first, 3, lambda p, n: p.derivative()).coefficients
    form = inline.f2(x, y, w, 3, inline.form_derivative)
    scale = Fraction(int(form[0])) / in_powers[0]
    value = sum(a * t**k for k, a in enumerate(in_powers))
    assert value * scale == sum(int(a) * Fraction(1, 2) ** k * (1 - t) ** 6 for k, a in enumerate(form.coeffs()))


def test_sympys_polynomials_under_the_librarys_formulas():
    c = inputs.curve(3)
    ((x, y, w),) = peers.sympy_polys(c)
    (argument,) = peers.sympy_arguments(c)
    for name, by_hand in forms.BY_HAND.items():
        assert formula_of(name)(argument).poly == by_hand(x, y, w, 3, lambda p, n: p.diff())


def test_a_peer_that_is_not_installed_is_told(monkeypatch):
    monkeypatch.setattr(splines, "installed", lambda who: who == OURS)
    monkeypatch.setattr(splines, "best", lambda timed: dict.fromkeys(timed, 2))
    rows = list(splines.spline_rows(Options()))
    assert {each.peer for each in rows if each.note == "not installed"} == {"scipy", "geomdl", "pynurbs"}
    assert all(each.value is None and each.met is None for each in rows if each.note)


@pytest.mark.parametrize(
    ("value", "most", "met"), [(5, 5, True), (5.01, 5, False), (None, 5, False), (0.2, Fraction(15, 100), False)]
)
def test_a_target_is_held_as_it_stands(value, most, met):
    assert bounded("s", "c", value, "ms", most).met is met


def test_a_ratio_is_ours_over_theirs():
    ours, fast, slow = compared(
        "s", "c", {OURS: 2, "PARI": 1, "sympy": 40}, {"PARI": Fraction(1), "sympy": Fraction(1, 10)}
    )
    assert (ours.ratio, fast.ratio, slow.ratio) == (None, 2, 0.05)
    assert (ours.met, fast.met, slow.met) == (None, False, True)
    assert slow.target == "≤ 1/10"


def test_what_takes_too_long_is_ended_and_missed():
    took = alone.run("inspect", 10**5, 1)
    assert (took.seconds, took.note) == (None, "more than 1 s")
    quick = alone.run("inspect", 10, 30)
    assert quick.seconds is not None  # two milliseconds, which is nothing where the clock ticks slowly
    assert not quick.note


def test_open_cascade_gets_the_curve_that_we_have():
    pytest.importorskip("OCP")
    for i in range(12):
        c = inputs.MIXED.curve(i)
        theirs = features._in_occ(*features._floats(c))
        for t in ("0", "1/3", str(c.domain[1])):
            point = theirs.Value(float(Fraction(t)))
            assert (point.X(), point.Y()) == pytest.approx(tuple(map(float, c(t))), rel=1e-9)


def test_a_kill_is_measured_on_a_corpus_of_its_own(tmp_path):
    corpus = ["six_segment_cubic", "cusp", *["circle"] * 60]
    one = sweeps.swept(corpus, Where("serial"), tmp_path / "serial.jsonl")
    rate, lost = sweeps._killed(corpus, "curves", one, tmp_path)
    assert (lost.value, lost.met) == (0, True)
    assert rate.value > 0
    assert "changed" not in lost.note


def test_files_are_compared_byte_for_byte_without_their_times(tmp_path):
    one, other = tmp_path / "one", tmp_path / "other"
    one.write_bytes(b'{"index":0,"seconds":1}\n{"index":1,"seconds":2}\n')
    other.write_bytes(b'{"index":0,"seconds":3}\n{"index":1,"seconds":2}\n')
    assert sweeps.differing(one, other) == 0
    other.write_bytes(b'{"index":0,"seconds":1}\n{"index":2,"seconds":2}\n')
    assert sweeps.differing(one, other) == 1
    other.write_bytes(b'{"index":0,"seconds":1}\n')
    assert sweeps.differing(one, other) == sweeps.differing(other, one) == 1


def test_memory_is_told_when_a_sweep_comes_to_no_end(monkeypatch):
    sizes = iter([5.0, 9.0, 3.0, None, 80.0, 90.0])
    monkeypatch.setattr(alone, "run", lambda *_: alone.Took(1.0, next(sizes)))
    grown = [each for each in memory.memory_rows(Options()) if each.target]
    assert [(each.value, each.met) for each in grown] == [(4.0, True), (None, False)]


def test_the_program_prints_table_json_and_picture(tmp_path, monkeypatch, capsys):
    made = [
        Row("forms", "g2", OURS, 0.15, "ms", target="≤ 1 ms", met=True),
        Row("forms", "g2", "PARI", 0.3, "ms", 0.5),
        Row("growth", "g2 by degree: 3", OURS, 1 / 3, "ms"),
        Row("growth", "g2 by degree: 3", "python-flint inline", 0.00123, "ms", 4),
    ]
    monkeypatch.setattr(table, "rows", lambda sections, options: iter(made))
    place = tmp_path / "bench.svg"
    assert main(["forms", "--plot", str(place)]) == 0
    printed = capsys.readouterr().out
    assert "1 of 1 targets met" in printed
    assert "0.00123 ms" in printed
    assert place.read_text().startswith("<?xml")
    assert main(["--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    jsonschema.validate(data, json.loads((Path(row.__file__).parent / "schema.json").read_text(encoding="utf-8")))
    assert [each["value"] for each in data["rows"]] == [each.value for each in made]
    made[0] = bounded("forms", "g2", 2, "ms", 1)
    assert main([]) == 1
    with pytest.raises(PlotError):
        picture.draw(made, str(tmp_path / "bench.gif"))
    with pytest.raises(PlotError, match="no ratio"):
        picture.draw(made[:1], str(tmp_path / "bench.svg"))


def test_a_section_that_breaks_off_does_not_lose_the_others(monkeypatch):
    def failing(options):
        yield Row("roots", "a case", OURS, 1, "ms")
        raise RuntimeError("a peer has failed")

    monkeypatch.setitem(table.SECTIONS, "roots", failing)
    monkeypatch.setitem(table.SECTIONS, "splines", lambda options: iter([Row("splines", "a case", OURS, 2, "ms")]))
    first, broken, last = table.rows(["roots", "splines"], Options())
    assert (first.value, last.value) == (1, 2)
    assert (broken.value, broken.met, broken.note) == (None, False, "RuntimeError: a peer has failed")


def test_lengths_distances_and_deviations_are_those_of_scipy(monkeypatch):
    monkeypatch.setattr(row, "ROUNDS", 1)
    for name in ("CURVES", "PATCHES", "PAIRS"):
        monkeypatch.setattr(measures, name, 2)
    notes = {(each.case[:3], each.peer): each.note for each in measures.measure_rows(Options())}
    errors = [float(notes[case, "scipy"].split()[-1]) for case in ("len", "nea", "how")]
    assert all(error <= most for error, most in zip(errors, (1e-12, 1e-8, 2e-2), strict=True))


def test_sections_are_known_by_name():
    assert table.chosen_sections(["roots", "forms"]) == ("forms", "roots")
    assert table.chosen_sections([]) == tuple(table.SECTIONS)
    with pytest.raises(FormulaError, match="nearest are roots"):
        table.chosen_sections(["root"])


def test_versions_are_those_of_the_packages():
    assert row.version_of("python-flint") == row.version_of("python-flint inline") != ""
    assert row.version_of("Fraction") == ""


def test_every_section_is_on_record_and_on_the_page(tmp_path):
    assert [each["section"] for each in benchmarks.recorded()] == list(table.SECTIONS)
    (tmp_path / "page.md").write_text("# Measurements\n", encoding="utf-8")
    benchmarks.add_tables(tmp_path / "page.md", tmp_path / "pictures")
    page = (tmp_path / "page.md").read_text(encoding="utf-8")
    assert page.startswith("# Measurements\n")
    for record in benchmarks.recorded():
        assert f"\n### {record['section'].capitalize()}\n" in page
        assert record["rows"]
        for each in record["rows"]:
            assert each["case"].replace("|", "\\|") in page
            assert each["version"] in page
