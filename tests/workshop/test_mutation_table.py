"""The table of mutants: what is not known on this machine is kept, with its day."""

from collections import Counter

from workshop.mutation.__main__ import BEGIN, END, PAGE, lines, merged, read_rows


def test_rows_whose_verdicts_are_elsewhere_are_kept():
    """Before: the rows of all formulas were replaced by nothing where their verdicts were on another machine."""
    on_page = {
        "papers/a": ("2026-01-02", Counter(killed=7, equivalent=1)),
        "roots": ("2026-01-03", Counter(killed=9, survived=2)),
        "gone": ("2026-01-03", Counter(killed=9)),
    }
    here = {"papers/a": Counter(), "roots": Counter(killed=10, survived=1), "reals": Counter(killed=1)}
    rows, kept = merged(here, on_page, Counter(roots=2), "2026-02-02")
    assert kept == ["papers/a"]
    assert rows == {
        "papers/a": on_page["papers/a"],
        "roots": ("2026-02-02", Counter(killed=10, survived=1)),
        "reals": ("2026-02-02", Counter(killed=1)),
    }
    assert (
        merged({**here, "roots": Counter(killed=10)}, on_page, Counter(), "2026-02-02")[0]["roots"] == on_page["roots"]
    )
    # open mutants whose names are not known are not gone because others were noticed
    noticed = {**here, "roots": Counter(killed=20)}
    assert merged(noticed, on_page, Counter(), "2026-02-02")[0]["roots"] == on_page["roots"]
    assert merged(noticed, on_page, Counter(roots=2), "2026-02-02")[0]["roots"] == ("2026-02-02", Counter(killed=20))
    assert read_rows("\n".join(lines(rows))) == rows


def test_the_table_of_the_page_is_read_as_it_is_written():
    """Sums are those of the rows."""
    written = PAGE.read_text(encoding="utf-8").split(BEGIN)[1].split(END)[0]
    assert "\n".join(lines(read_rows(written))) + "\n" == written
