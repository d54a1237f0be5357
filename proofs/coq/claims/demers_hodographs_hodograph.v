(** Pythagorean-hodograph curves: the hodograph lies on the light cone: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import demers_hodographs.
Import ListNotations.
Local Open Scope formula_scope.
