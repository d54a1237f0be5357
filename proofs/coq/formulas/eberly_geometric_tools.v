(** Geometric Tools: curves and implicit surfaces: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require petrunin_zamora_barrera.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** NURBSCurve.h, Evaluate. `(X′ − w′ jet[0]) / w`. *)
Definition jet_1 (c : curve A) : list A :=
  vdiv (vsub (vder (along c) (p c)) (vmul (der (along c) (w c)) (gamma c))) (w c).

(** NURBSCurve.h, Evaluate. `(X″ − 2 w′ jet[1] − w″ jet[0]) / w`. *)
Definition jet_2 (c : curve A) : list A :=
  vdiv (vsub (vsub (vders (along c) 2 (p c)) (vmul (number 2 * der (along c) (w c)) (jet_1 c))) (vmul (ders (along c) 2 (w c)) (gamma c))) (w c).

(** NURBSCurve.h, Evaluate. `(X‴ − 3 w′ jet[2] − 3 w″ jet[1] − w‴ jet[0]) / w`. *)
Definition jet_3 (c : curve A) : list A :=
  vdiv (vsub (vders (along c) 3 (p c)) (vadd (vadd (vmul (number 3 * der (along c) (w c)) (jet_2 c)) (vmul (number 3 * ders (along c) 2 (w c)) (jet_1 c))) (vmul (ders (along c) 3 (w c)) (gamma c)))) (w c).

(** FrenetFrame.h, FrenetFrame2. `Perp(tangent) = (y, −x)`, without its length. *)
Definition clockwise_normal (c : curve A) : list A :=
  ([component 1 (vder (along c) (gamma c))] ++ [- component 0 (vder (along c) (gamma c))]).

(** Vector2.h, DotPerp. `Dot(jet[1], Perp(jet[2]))`: the numerator of the curvature. *)
Definition dot_perp (c : curve A) : A :=
  component 0 (vder (along c) (gamma c)) * component 1 (vders (along c) 2 (gamma c)) + component 1 (vder (along c) (gamma c)) * - component 0 (vders (along c) 2 (gamma c)).

(** FrenetFrame.h, FrenetFrame2. `κN` of curvature and normal as they are computed. *)
Definition bending_along_the_clockwise_normal (c : curve A) : list A :=
  vmul (dot_perp c / dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) ^ 2) (clockwise_normal c).

(** Frenet equations. The derivative of the unit tangent by arc length. *)
Definition tangent_by_arc_length (c : curve A) : list A :=
  petrunin_zamora_barrera.acceleration_by_arc_length c.

(** FrenetFrame.h, FrenetFrame3. `VDotV · A − VDotA · V`. *)
Definition normal_of_the_frame (c : curve A) : list A :=
  vsub (vmul (dot (vder (along c) (gamma c)) (vder (along c) (gamma c))) (vders (along c) 2 (gamma c))) (vmul (dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (vder (along c) (gamma c))).

End Formulas.
