from . import teaching as teaching
