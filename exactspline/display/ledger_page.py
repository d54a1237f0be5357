"""The ledger as one self-contained page with filters."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from exactspline.display.glossary import glossary_list
from exactspline.display.ledger import WORDS, closing, found, headline, section, witness
from exactspline.display.page import cells, page
from exactspline.verification.rows import Row

_STYLE = """
body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:80rem;padding:0 1rem;color:#1a1a1a;background:#fff}
table{border-collapse:collapse;width:100%}th,td{text-align:left;vertical-align:top;padding:.3rem .8rem .3rem 0}
th{border-bottom:1px solid #999;position:sticky;top:0;background:#fff}
td{border-bottom:1px solid #eee;overflow-wrap:anywhere}
.PROVED{color:#00694d}.VERIFIED{color:#0060a0}.REFUTED{color:#b34700}.UNDECIDED,.VACUOUS,.INAPPLICABLE{color:#666}
.CONTRADICTION{color:#b00020}
td:first-child{font-weight:600}form{display:flex;flex-wrap:wrap;gap:1rem;margin:1rem 0}label{display:flex;gap:.4rem}
input,select{font:inherit;max-width:100%}dt{font-weight:600}
@media(max-width:800px){thead{display:none}tr:not([hidden]),td{display:block}
td{border:0;padding:.1rem 0}tr{border-bottom:1px solid #eee;padding:.4rem 0}}
"""
_SCRIPT = """
const form=document.querySelector("form"),rows=[...document.querySelectorAll("tbody tr")];
function filter(){const d=new FormData(form),text=d.get("text").toLowerCase();let n=0;
for(const r of rows){const ok=["verdict","section","curve"].every(k=>!d.get(k)||r.dataset[k]===d.get(k))
&&(!text||r.textContent.toLowerCase().includes(text));r.hidden=!ok;n+=ok}
document.querySelector("output").textContent=n+" of "+rows.length+" rows"}
form.addEventListener("input",filter);form.addEventListener("submit",e=>e.preventDefault());filter();
"""


def ledger_page(rows: Sequence[Row]) -> str:
    """The rows as an HTML page, with a filter by verdict, by section, by curve and by text.

    >>> from exactspline.verification.claims import select
    >>> from exactspline.verification.ledger import audit
    >>> text = ledger_page(list(audit(select(["C4.1a"]), [])))
    >>> "<title>" in text, "http" in text
    (True, False)
    """
    words = [w for w in WORDS if any(row.verdict == w for row in rows)]
    sections = list(dict.fromkeys(section(row.claim) for row in rows))
    curves = list(dict.fromkeys(_curve(row) for row in rows))
    choices = (("verdict", words), ("section", sections), ("curve", curves))
    filters = "".join(_select(name, values) for name, values in choices)
    head = cells(("verdict", "claim", "place", "on", "statement", "found", "witness"), "th")
    body = (
        f"<h1>{escape(headline(rows))}</h1><p>{escape(closing(rows))}</p>{_unchecked(rows)}"
        f'<form>{filters}<label>text <input name="text" type="search"></label><output></output></form>'
        f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(map(_row, rows))}</tbody></table>"
        f"{glossary_list(words)}<script>{_SCRIPT}</script>"
    )
    return page("Ledger", body, _STYLE)


def _unchecked(rows: Sequence[Row]) -> str:
    """The papers whose formulas ran unchecked."""
    papers = dict.fromkeys(row.claim.source_paper for row in rows)
    names = ", ".join(source.name for source in papers if source.trusted)
    return f"<p><b>Formulas that ran unchecked (--trust): {escape(names)}</b></p>" if names else ""


def _curve(row: Row) -> str:
    return row.curve or "all curves"


def _select(name: str, values: Sequence[str]) -> str:
    options = "".join(f"<option>{escape(value)}</option>" for value in values)
    return f'<label>{name} <select name="{name}"><option value="">all</option>{options}</select></label>'


def _row(row: Row) -> str:
    verdict = row.verdict
    data = {"verdict": verdict, "section": section(row.claim), "curve": _curve(row)}
    attributes = "".join(f' data-{name}="{escape(value)}"' for name, value in data.items())
    shown = cells((row.id, row.claim.source, _curve(row), row.statement, found(row), witness(row)))
    return f'<tr{attributes}><td class="{verdict}">{verdict}</td>{shown}</tr>'
