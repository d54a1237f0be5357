"""``python -m exactspline.cli``: the command line."""

from exactspline.cli import main

main()
