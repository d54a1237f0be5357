"""Mutation: every formula and every engine changed on purpose, to see that somebody notices."""
