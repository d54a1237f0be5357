"""Exercises with simple answers, generated from a seed and solved by the library; exact checks of students' answers."""
