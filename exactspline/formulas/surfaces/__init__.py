"""Rational surfaces, from their fundamental forms to lines of curvature."""
