"""Sheets, schemes and sentences of the lessons; importing it lets notebooks and messages show their objects."""

from exactspline.extras.teaching.display import words as words
