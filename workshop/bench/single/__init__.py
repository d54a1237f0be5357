"""Benchmarks of single operations, for pytest-benchmark: ``./run benchmarks``."""
