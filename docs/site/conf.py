"""Sphinx's settings for the site; `docs.site` lays the sources beside this file."""

from pathlib import Path

from docutils import nodes
from PIL import Image

from docs.site.narrow import NARROW
from docs.site.navigation import context

project = "exactspline"
author = "the exactspline developers"
copyright = "the exactspline developers"  # Sphinx's name

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
nb_execution_mode = "off"  # they have been executed, side by side
nb_merge_streams = True
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
default_role = "code"
smartquotes = False  # a prime is not a quotation mark

# fonts, styles and scripts come with the site: no page asks another host
mathjax_path = "mathjax/tex-svg.js"
mathjax4_config = {
    "output": {
        # formulas that are wider than the page are broken into lines
        "displayOverflow": "linebreak",
        "linebreaks": {"inline": True, "width": "100%"},
        "displayAlign": "left",
        "fontPath": "[mathjax]/font",
    },
    # the fonts have the sign of \bot, but not that of \perp
    "tex": {
        "macros": {"perp": "\\bot"},
        "inlineMath": [["$", "$"], ["\\(", "\\)"]],
        "displayMath": [["$$", "$$"], ["\\[", "\\]"]],
    },
    "options": {
        # dollars are formulas in the outputs of notebooks, where they are printed as such, and nowhere else
        "ignoreHtmlClass": "page|document",
        "processHtmlClass": "tex2jax_process|mathjax_process|math|text_html",
        "enableMenu": False,
        # each formula has a copy in MathML for screen readers, made without the engine that speaks
        "menuOptions": {"settings": {"enrich": False, "speech": False, "braille": False, "assistiveMml": True}},
    },
}
myst_update_mathjax = False

html_theme = "furo"
html_title = "exactspline"
html_favicon = "icon.svg"
html_static_path = ["_static"]
templates_path = ["_templates"]
html_context = context()
html_sidebars = {
    "**": [
        *(f"sidebar/{part}.html" for part in ("brand", "search", "scroll-start", "navigation")),
        "interactive.html",
        "sidebar/scroll-end.html",
    ]
}
html_css_files = ["pages.css"]
html_js_files = ["pages.js"]
html_extra_path = ["_extra"]
html_show_sphinx = False
html_copy_source = False  # with the outputs of notebooks it would be a tenth of the site
html_show_sourcelink = False
exclude_patterns = ["_extra"]
suppress_warnings = ["mystnb.unknown_mime_type"]


def _tell(app, document):
    """Give pictures of notebooks, which say in themselves what they show, that as their alternative text; and those
    for narrow windows, which follow the others, a class.
    """
    before = None
    for picture in document.findall(nodes.image):
        file = Path(app.srcdir, picture["candidates"].get("*", picture["uri"]))
        if not picture.get("alt") and file.suffix == ".png":
            with Image.open(file) as opened:
                picture["alt"] = opened.text["Description"]
                if opened.text.get("Title") == NARROW:
                    picture["classes"].append(NARROW)
                    before["classes"].append("wide")
        before = picture


def _load_mathjax(app, page, template, context, document):
    """Let notebooks, and pages to read along, load MathJax, whatever Sphinx itself finds: formulas are in raw HTML."""
    raw = page.startswith(("notebooks/", "reading-along/"))
    context["has_maths_elements"] = context.get("has_maths_elements") or raw


def setup(app):
    """Sphinx asks for this by its name."""
    app.connect("doctree-read", _tell)
    app.connect("html-page-context", _load_mathjax, priority=100)  # before Sphinx decides
