"""Packages that only some users need, each with its commands, displays and formats. No other package imports them: the
tables of formats, verifiers, commands and pictures name their contents, which are loaded when they are used.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
