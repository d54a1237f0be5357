(** Rational surfaces: the open question of the paper: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

End Formulas.
