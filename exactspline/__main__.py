"""``python -m exactspline``: the command line."""

from exactspline.cli import main

main()
