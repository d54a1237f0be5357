"""Exercises with small answers, drawn from a seed and answered by the library; answers of students, checked exactly."""
