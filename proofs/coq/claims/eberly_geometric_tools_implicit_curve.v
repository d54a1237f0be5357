(** Geometric Tools: curves and implicit surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import eberly_geometric_tools.
Import ListNotations.
Local Open Scope formula_scope.
