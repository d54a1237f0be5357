"""The tests of exactspline; a package so that they can share strategies and oracles."""
