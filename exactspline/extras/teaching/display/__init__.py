"""Sheets, schemes and sentences of the lessons."""
