"""Bridges to other libraries: each function imports its library only when it is called."""
