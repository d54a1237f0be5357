"""What only some need, each with its commands, displays and formats. Nothing outside imports it: the tables of formats,
judges, commands and pictures name what there is, and load it when it is used.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
