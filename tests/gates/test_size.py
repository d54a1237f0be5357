"""Law 10: the house does not grow by itself (`python -m tests.support.count_lines`, which `./run check` runs)."""

from tests.support import count_lines


def test_more_lines_of_statements_than_the_ceiling_are_refused(monkeypatch, tmp_path, capsys):
    """Passed before: 60,600 lines became 83,000 while they were to become fewer."""
    monkeypatch.setattr(count_lines, "CEILING", tmp_path / "ceiling.toml")
    monkeypatch.setattr(count_lines, "sources", lambda: {"exactspline/words.py": "x = 1\n\n# why\ny = 2\nz = 3\n"})
    for lines, status in ((2, 1), (3, 0)):
        count_lines.CEILING.write_text(f"[[change]]\nlines = {lines}\n", encoding="utf-8")
        assert count_lines.main("--check") == status
    assert capsys.readouterr().out.count("exceeded by 1") == 1
