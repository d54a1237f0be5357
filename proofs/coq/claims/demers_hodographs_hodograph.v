(** Pythagorean-hodograph curves: the hodograph lies on the light cone: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import demers_hodographs.
Import ListNotations.
Local Open Scope formula_scope.

(** PH1a, phCurve.ts. *)
Theorem PH1a_speed_squared_ph_speed_squared : every_hodograph (fun K c =>
  chen_riesenfeld_cohen_2007.speed_squared c = ph_speed_squared c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ jets s 1 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 1 * var 1 - var 3 * var 3) * var 5); (8%positive, (var 1 * var 3 + var 1 * var 3) * var 5)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 3; var 5]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (chen_riesenfeld_cohen_2007.speed_squared c : expr)%formula = value K l (ph_speed_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH1b, Two Points or a Circle. *)
Theorem PH1b_velocity_spinor_squared : every_primitive_hodograph (fun K c =>
  chen_riesenfeld_cohen_2007.velocity c = spinor_squared c).
Proof.
  apply primitive_hodograph_by_position; intros K x_ y_ u_ v_ Hx Hy.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ [(5%positive, (var 1 * var 1 - var 3 * var 3) * number 1); (6%positive, (var 1 * var 3 + var 1 * var 3) * number 1)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 5; var 6] (number 1) []) [var 1; var 3; number 1]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (chen_riesenfeld_cohen_2007.velocity c : list expr)%formula = map (value K l) (spinor_squared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH1d, phCurve.ts. *)
Theorem PH1d_ph_normal_turned_unit_tangent : every_hodograph (fun K c =>
  (u_of c * u_of c + v_of c * v_of c) <> zero K ->
  ph_speed c <> zero K ->
  ph_normal c = turned_unit_tangent c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1 D2.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ jets s 1 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 1 * var 1 - var 3 * var 3) * var 5); (8%positive, (var 1 * var 3 + var 1 * var 3) * var 5)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 3; var 5]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (u_of c * u_of c + v_of c * v_of c : expr)%formula (num 1)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c : expr)%formula (var 1 ^ 2 + var 3 ^ 2)%formula (var 5)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (ph_normal c : list expr)%formula = map (value K l) (turned_unit_tangent c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH1e, The Hodograph Lies on the Light Cone. *)
Theorem PH1e_speed_less_first_twice_second_squared : every_primitive_hodograph (fun K c =>
  speed_less_first c = twice_second_squared c).
Proof.
  apply primitive_hodograph_by_position; intros K x_ y_ u_ v_ Hx Hy.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ [(5%positive, (var 1 * var 1 - var 3 * var 3) * number 1); (6%positive, (var 1 * var 3 + var 1 * var 3) * number 1)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 5; var 6] (number 1) []) [var 1; var 3; number 1]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (speed_less_first c : expr)%formula = value K l (twice_second_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH2a, phCurve.ts. *)
Theorem PH2a_ph_offset_distance : every_hodograph (fun K c =>
  ph_speed c <> zero K ->
  ph_offset_distance c = zero K).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ jets s 1 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 1 * var 1 - var 3 * var 3) * var 5); (8%positive, (var 1 * var 3 + var 1 * var 3) * var 5)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 3; var 5]).
  pose (atoms := [var 5; var 1 ^ 2 + var 3 ^ 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (ph_speed c : expr)%formula (var 1 ^ 2 + var 3 ^ 2)%formula (var 5)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c : expr)%formula (var 5)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (ph_offset_distance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH2c, The Hodograph Lies on the Light Cone. *)
Theorem PH2c_support_gained : every_hodograph (fun K c =>
  ph_speed c <> zero K ->
  support_gained c = zero K).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 1 u_ ++ jets s 1 v_ ++ jets s 1 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 1 * var 1 - var 3 * var 3) * var 5); (8%positive, (var 1 * var 3 + var 1 * var 3) * var 5)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 3; var 5]).
  pose (atoms := [var 5; var 1 ^ 2 + var 3 ^ 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (ph_speed c : expr)%formula (var 1 ^ 2 + var 3 ^ 2)%formula (var 5)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c : expr)%formula (var 5)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (support_gained c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH2d, The Hodograph Lies on the Light Cone. *)
Theorem PH2d_offset_velocity_at_any_distance_velocity_times_offset_factor : every_plane_curve_with 1 (fun K c =>
  dot (p c) (p c) <> zero K ->
  offset_velocity_at_any_distance c = velocity_times_offset_factor c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([3; 9], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) : expr)%formula (var 5 ^ 2)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (offset_velocity_at_any_distance c : list expr)%formula = map (value K l) (velocity_times_offset_factor c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH2d, The Hodograph Lies on the Light Cone. *)
Theorem PH2d_ph_offset_velocity_signed_offset_speed : every_hodograph (fun K c =>
  ph_speed c <> zero K ->
  ph_offset_velocity c = signed_offset_speed c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ jets s 2 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 1 * var 1 - var 4 * var 4) * var 7); (11%positive, (var 1 * var 4 + var 1 * var 4) * var 7)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 10; var 11] (number 1) []) [var 1; var 4; var 7]).
  pose (atoms := [var 7; var 1 ^ 2 + var 4 ^ 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0]); ([3; 3], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (ph_speed c : expr)%formula (var 1 ^ 2 + var 4 ^ 2)%formula (var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c : expr)%formula (var 7)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (ph_offset_velocity c : list expr)%formula = map (value K l) (signed_offset_speed c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH2e, The Hodograph Lies on the Light Cone. *)
Theorem PH2e_ph_curvature_spinor_wronskian : every_hodograph (fun K c =>
  ph_speed c ^ 3 <> zero K ->
  ph_curvature c = number 1 / ph_speed c ^ 2 * spinor_wronskian c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ jets s 2 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 1 * var 1 - var 4 * var 4) * var 7); (11%positive, (var 1 * var 4 + var 1 * var 4) * var 7)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 10; var 11] (number 1) []) [var 1; var 4; var 7]).
  pose (atoms := [var 7; var 1 ^ 2 + var 4 ^ 2]%formula : list expr).
  pose (known := [([3; 3], [0; 0]); ([2; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (ph_speed c ^ 3 : expr)%formula (var 1 ^ 6 * var 7 ^ 2 + num 3 * var 1 ^ 4 * var 4 ^ 2 * var 7 ^ 2 + num 3 * var 1 ^ 2 * var 4 ^ 4 * var 7 ^ 2 + var 4 ^ 6 * var 7 ^ 2)%formula (var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 7 ^ 3 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 3 + var 4 ^ 4 * var 7 ^ 3)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (ph_curvature c : expr)%formula = value K l (number 1 / ph_speed c ^ 2 * spinor_wronskian c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH3a, The Hodograph Lies on the Light Cone. *)
Theorem PH3a_cone_tangent_cone_tangent_by_product : every_hodograph (fun K c =>
  dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) <> zero K ->
  cone_tangent c = cone_tangent_by_product c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ jets s 2 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 1 * var 1 - var 4 * var 4) * var 7); (11%positive, (var 1 * var 4 + var 1 * var 4) * var 7)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 10; var 11] (number 1) []) [var 1; var 4; var 7]).
  pose (atoms := [var 7; var 1 ^ 2 + var 4 ^ 2]%formula : list expr).
  pose (known := [([2; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) : expr)%formula (var 1 ^ 4 * var 7 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 + var 4 ^ 4 * var 7)%formula (var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) : expr)%formula (var 1 ^ 2 * var 7 ^ 2 + var 4 ^ 2 * var 7 ^ 2)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (cone_tangent c : expr)%formula = value K l (cone_tangent_by_product c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH3b, The Hodograph Lies on the Light Cone. *)
Theorem PH3b_cone_tangent_cone_tangent_by_curvature : every_hodograph (fun K c =>
  ph_speed c ^ 3 <> zero K ->
  cone_tangent c = cone_tangent_by_curvature c).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy D1.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ jets s 2 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 1 * var 1 - var 4 * var 4) * var 7); (11%positive, (var 1 * var 4 + var 1 * var 4) * var 7)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 10; var 11] (number 1) []) [var 1; var 4; var 7]).
  pose (atoms := [var 7; var 1 ^ 2 + var 4 ^ 2]%formula : list expr).
  pose (known := [([3; 3], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (ph_speed c ^ 3 : expr)%formula (var 1 ^ 6 * var 7 ^ 2 + num 3 * var 1 ^ 4 * var 4 ^ 2 * var 7 ^ 2 + num 3 * var 1 ^ 2 * var 4 ^ 4 * var 7 ^ 2 + var 4 ^ 6 * var 7 ^ 2)%formula (var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (ph_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 7 ^ 3 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 3 + var 4 ^ 4 * var 7 ^ 3)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (cone_tangent c : expr)%formula = value K l (cone_tangent_by_curvature c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH3c, The Hodograph Lies on the Light Cone. *)
Theorem PH3c_speed_change : every_hodograph (fun K c =>
  speed_change c = zero K).
Proof.
  apply hodograph_by_position; intros K x_ y_ u_ v_ h_ Hx Hy.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ jets s 2 h_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 1 * var 1 - var 4 * var 4) * var 7); (11%positive, (var 1 * var 4 + var 1 * var 4) * var 7)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 10; var 11] (number 1) []) [var 1; var 4; var 7]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (speed_change c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH4a, phCurve.ts. *)
Theorem PH4a_hodograph_1_quartic_1 : every_primitive_hodograph (fun K c =>
  number 2 <> zero K ->
  hodograph_1 c = quartic_1 c).
Proof.
  apply primitive_hodograph_by_position; intros K x_ y_ u_ v_ Hx Hy P2.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ [(7%positive, (var 1 * var 1 - var 4 * var 4) * number 1); (8%positive, (var 1 * var 4 + var 1 * var 4) * number 1)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 4; number 1]).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (hodograph_1 c : list expr)%formula = map (value K l) (quartic_1 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH4b, phCurve.ts. *)
Theorem PH4b_hodograph_2_quartic_2 : every_primitive_hodograph (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  hodograph_2 c = quartic_2 c).
Proof.
  apply primitive_hodograph_by_position; intros K x_ y_ u_ v_ Hx Hy P2 P3.
  pose (l := jets s 3 u_ ++ jets s 3 v_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ [(9%positive, (var 1 * var 1 - var 5 * var 5) * number 1); (10%positive, (var 1 * var 5 + var 1 * var 5) * number 1)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 9; var 10] (number 1) []) [var 1; var 5; number 1]).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([2; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (hodograph_2 c : list expr)%formula = map (value K l) (quartic_2 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH4c, phCurve.ts. *)
Theorem PH4c_quintic_step_hodograph_1 : every_primitive_hodograph (fun K c =>
  number 5 <> zero K ->
  number 2 <> zero K ->
  quintic_step c = hodograph_1 c).
Proof.
  apply primitive_hodograph_by_position; intros K x_ y_ u_ v_ Hx Hy P5 P2.
  pose (l := jets s 2 u_ ++ jets s 2 v_ ++ [x_; y_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ [(7%positive, (var 1 * var 1 - var 4 * var 4) * number 1); (8%positive, (var 1 * var 4 + var 1 * var 4) * number 1)]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 7; var 8] (number 1) []) [var 1; var 4; number 1]).
  pose (atoms := [num 5; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 2], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P5. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (quintic_step c : list expr)%formula = map (value K l) (hodograph_1 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
