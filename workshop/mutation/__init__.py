"""Mutation: every formula and every engine is changed on purpose, to check that a claim or a test detects it."""
