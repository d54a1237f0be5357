"""Vectors: nasty curves with exact answers as plain JSON, for tests in any language; readers in four languages."""
