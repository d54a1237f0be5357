"""This package is the language of formulas: operands, vectors, quotients, arguments, formulas and ruled surfaces."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
