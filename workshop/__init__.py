"""What developers, and maintainers of other libraries, run from a checkout; nothing of it is in the wheel.

`bench` measures times, `grade` compares other libraries with exact answers, `mutation` changes formulas and engines on
purpose, to see that a claim or a test notices.
"""
