"""Pictures in space: surfaces and bisectors, shaded with their control nets, and as interactive pages. Needs matplotlib
(the extra ``plot``).
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
