"""The site: ``python -m docs.site``, which ``./run site`` calls."""
