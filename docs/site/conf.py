"""Sphinx's settings for the site; `docs.site` lays the sources beside this file."""

project = "exactspline"
author = "the exactspline developers"
copyright = "the exactspline developers"  # Sphinx's name

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_merge_streams = True
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
default_role = "code"

# fonts, styles and scripts come with the site: no page asks another host
mathjax_path = "mathjax/tex-svg.js"

html_theme = "furo"
html_title = "exactspline"
html_favicon = "icon.svg"
html_static_path = ["_static"]
html_extra_path = ["_extra"]
html_show_sphinx = False
exclude_patterns = ["_extra"]
suppress_warnings = ["mystnb.unknown_mime_type"]
