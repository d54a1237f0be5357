"""What the bisector of two curves has beside its surface: lines, planes, single pairs, poles.

What the complete answer is, and why it is complete, is told in ``docs/bisectors.md``.
"""
