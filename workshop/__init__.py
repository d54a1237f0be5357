"""Programs for developers and for maintainers of other libraries, run from a checkout; none of it is in the wheel.

`bench` measures times, `grade` compares other libraries with exact answers, `mutation` changes formulas and engines on
purpose, to check that a claim or a test detects each change.
"""
