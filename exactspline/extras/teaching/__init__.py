"""This package generates exercises with simple answers from a seed, solves them, and checks students' answers."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
