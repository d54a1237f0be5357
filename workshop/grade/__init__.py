"""Grading of other people's libraries: cases, exact answers with certificates, adapters, verdicts, a page."""
