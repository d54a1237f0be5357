"""Claims and their verdicts: proofs for all curves, checks on one curve, the ledger, errata, degree tables."""
