"""Rational surfaces, from their fundamental forms to lines of curvature: results of this project."""
