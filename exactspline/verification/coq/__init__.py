"""Claims as theorems of the proof assistant Coq, whose kernel is the second judge."""
