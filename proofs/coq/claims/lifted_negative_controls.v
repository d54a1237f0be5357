(** Lifted forms: the lowest degrees, and why: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import lifted.
Import ListNotations.
Local Open Scope formula_scope.

(** N1, negative control, fails. *)
Theorem N1_tangent_binormal_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K /\
  ~ same_surface (chen_riesenfeld_cohen_2007.tangent_developable c) (chen_riesenfeld_cohen_2007.binormal_scroll c).
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 2 + num 15 * var 1 ^ 2 + num 2 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 6 * var 1 ^ 5 + var 1 ^ 6; var 1; num 1 + num 2 * var 1; num 0 - num 1 + num 3 * var 1 + num 3 * var 1 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2; 1], [0; 0; 0]); ([0; 1; 0; 1; 1; 1], [5; 0; 0; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (cross (generator (chen_riesenfeld_cohen_2007.tangent_developable c)) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  intro Z. assert (Y : same_surface ((map (value K l) (directrix (chen_riesenfeld_cohen_2007.tangent_developable c))), (map (value K l) (generator (chen_riesenfeld_cohen_2007.tangent_developable c)))) ((map (value K l) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))), (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))))) by vm_cast_no_check Z.
  destruct (parallel_of_one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.tangent_developable c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.tangent_developable c))) (map (value K l) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))) eq_refl eq_refl eq_refl eq_refl Y) as [Y1 Y2].
  apply U. vm_cast_no_check (f_equal (component 0) Y1).
Qed.

(** N1, negative control, fails. *)
Theorem N1_focal_binormal_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K /\
  ~ same_surface (chen_riesenfeld_cohen_2007.focal_surface c) (chen_riesenfeld_cohen_2007.binormal_scroll c).
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 2 + num 15 * var 1 ^ 2 + num 2 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 6 * var 1 ^ 5 + var 1 ^ 6; num 1 - var 1 ^ 2 + num 5 * var 1 ^ 4 + num 6 * var 1 ^ 5 + num 2 * var 1 ^ 6]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2; 1], [0; 0; 0]); ([0; 2; 1], [6; 0; 0]); ([0; 1; 0; 1], [6; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (cross (generator (chen_riesenfeld_cohen_2007.focal_surface c)) (vsub (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c)) (directrix (chen_riesenfeld_cohen_2007.focal_surface c)))) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  intro Z. assert (Y : same_surface ((map (value K l) (directrix (chen_riesenfeld_cohen_2007.focal_surface c))), (map (value K l) (generator (chen_riesenfeld_cohen_2007.focal_surface c)))) ((map (value K l) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))), (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))))) by vm_cast_no_check Z.
  destruct (parallel_of_one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.focal_surface c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.focal_surface c))) (map (value K l) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))) eq_refl eq_refl eq_refl eq_refl Y) as [Y1 Y2].
  apply U. vm_cast_no_check (f_equal (component 0) Y2).
Qed.

(** N2, negative control, fails. *)
Theorem N2_f0_f1_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.f0 c <> chen_riesenfeld_cohen_2007.f1 c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; var 1; num 2 + var 1; num 2 + num 2 * var 1 + var 1 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 1; 1; 1], [3; 0; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (chen_riesenfeld_cohen_2007.f0 c - chen_riesenfeld_cohen_2007.f1 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply different; vm_cast_no_check U.
Qed.

(** N2, negative control, fails. *)
Theorem N2_curvature_radius_squared_curvature_squared_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.f2 c <> zero K /\
  chen_riesenfeld_cohen_2007.curvature_radius_squared c <> chen_riesenfeld_cohen_2007.curvature_squared c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 1 + num 4 * var 1 ^ 2 + num 4 * var 1 ^ 3 + var 1 ^ 4; num 5 + num 24 * var 1 + num 72 * var 1 ^ 2 + num 92 * var 1 ^ 3 + num 111 * var 1 ^ 4 + num 120 * var 1 ^ 5 + num 140 * var 1 ^ 6 + num 216 * var 1 ^ 7 + num 243 * var 1 ^ 8 + num 160 * var 1 ^ 9 + num 60 * var 1 ^ 10 + num 12 * var 1 ^ 11 + var 1 ^ 12; num 0 - num 3 - num 24 * var 1 - num 48 * var 1 ^ 2 - num 68 * var 1 ^ 3 - num 9 * var 1 ^ 4 + num 72 * var 1 ^ 5 + num 132 * var 1 ^ 6 + num 216 * var 1 ^ 7 + num 243 * var 1 ^ 8 + num 160 * var 1 ^ 9 + num 60 * var 1 ^ 10 + num 12 * var 1 ^ 11 + var 1 ^ 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 0; 3], [12; 0; 0]); ([6; 2; 0], [0; 0; 3]); ([0; 0; 0; 1; 1], [6; 2; 3; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 4). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 12). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 12). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.f2 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (chen_riesenfeld_cohen_2007.curvature_radius_squared c - chen_riesenfeld_cohen_2007.curvature_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply different; vm_cast_no_check U.
Qed.

(** N4, negative control, fails. *)
Theorem N4_f2_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.f2 c <> zero K.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (chen_riesenfeld_cohen_2007.f2 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  exact U.
Qed.

(** N8, negative control, fails. *)
Theorem N8_plane_bisector_polynomial_tangent_developable_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [number 1; number 2] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.plane_bisector_determinant c <> zero K /\
  chen_riesenfeld_cohen_2007.plane_bisector_polynomial c ++ [zero K] <> directrix (chen_riesenfeld_cohen_2007.tangent_developable (embedded c)).
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [var 1; num 2 + var 1; num 5 + num 8 * var 1 - num 4 * var 1 ^ 3 + var 1 ^ 4; num 2; num 0 - num 1 + var 1; num 1 + var 1]%formula : list expr).
  pose (known := [([1; 1; 1; 0; 0; 0], [0; 0; 0; 2; 1; 2]); ([0; 0; 0; 0; 0; 1], [0; 0; 0; 0; 0; 0]); ([0; 0; 0; 1; 1; 1], [0; 0; 0; 0; 0; 0]); ([0; 0; 0; 1; 0; 0], [0; 0; 0; 0; 0; 0]); ([0; 0; 0; 1; 1; 2], [0; 0; 0; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [number 1; number 2])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 4). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.plane_bisector_determinant c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (chen_riesenfeld_cohen_2007.plane_bisector_polynomial c ++ [number 0]) - component 0 (directrix (chen_riesenfeld_cohen_2007.tangent_developable (embedded c))) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.
