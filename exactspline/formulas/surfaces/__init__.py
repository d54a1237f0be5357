"""Formulas for rational surfaces, from fundamental forms to lines of curvature."""
