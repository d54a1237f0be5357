"""Claims and answers as theorems of the proof assistant Coq, whose kernel is a second verifier."""
