(** Lifted forms: the lowest degrees, and why: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import lifted.
Import ListNotations.
Local Open Scope formula_scope.

(** L15, lifted forms. *)
Theorem L15_bisector_lifted_bisector : every_two_curves (fun K c =>
  chen_riesenfeld_cohen_2007.bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_lifted c = chen_riesenfeld_cohen_2007.bisector c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 15; var 7]%formula : list expr).
  pose (known := [([1; 1; 4; 4], [0; 0; 0; 0]); ([1; 0; 0; 0], [0; 0; 0; 0]); ([0; 1; 0; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact HW. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (bisector_lifted c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.bisector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, lifted forms. *)
Theorem L15_plane_bisector_lifted_plane_bisector : every_plane_curve_with_point (fun K c =>
  chen_riesenfeld_cohen_2007.plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_lifted c = chen_riesenfeld_cohen_2007.plane_bisector c).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1; 1; 4], [0; 0; 0]); ([1; 0; 0], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (plane_bisector_lifted c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.plane_bisector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, lifted forms. *)
Theorem L15_point_bisector_point_bisector_lifted : every_space_curve_with_point (fun K c =>
  dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.point_bisector c) (point_bisector_lifted c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1; 6], [0; 0; 0]); ([0; 1; 0], [0; 0; 0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.point_bisector c)) (generator (point_bisector_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.point_bisector c)) (vsub (directrix (point_bisector_lifted c)) (directrix (chen_riesenfeld_cohen_2007.point_bisector c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.point_bisector c)) (generator (chen_riesenfeld_cohen_2007.point_bisector c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_lifted c)) (generator (point_bisector_lifted c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.point_bisector c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.point_bisector c))) (map (value K l) (directrix (point_bisector_lifted c))) (map (value K l) (generator (point_bisector_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (chen_riesenfeld_cohen_2007.point_bisector c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (point_bisector_lifted c))) (conj eq_refl U2)) E1 E2).
Qed.

(** L15, lifted forms. *)
Theorem L15_point_bisector_direct_naive_point_bisector_direct_lifted : every_space_curve_with_point (fun K c =>
  dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) <> zero K ->
  chen_riesenfeld_cohen_2007.direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c) (point_bisector_direct_lifted c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1; 4], [0; 0; 0]); ([0; 0; 0], [0; 0; 0]); ([0; 1; 2], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c)) (generator (point_bisector_direct_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c)) (vsub (directrix (point_bisector_direct_lifted c)) (directrix (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_direct_lifted c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.point_bisector_direct_naive c))) (map (value K l) (directrix (point_bisector_direct_lifted c))) (map (value K l) (generator (point_bisector_direct_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C5.4a, §5.4, definition. *)
Theorem C54a_rectifying_development : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  dot (rectifying_generator_lifted c) (rectifying_generator_lifted c) <> zero K ->
  rectifying_development c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 D1.
  pose (l := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 6; var 11] (var 16) []).
  pose (atoms := [dot (rectifying_generator_lifted c) (rectifying_generator_lifted c)]%formula : list expr).
  pose (known := [([1], [])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). vm_cast_no_check D1. }
  clear N. rename N1 into N.
  assert (E : value K l (rectifying_development c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, lifted forms. *)
Theorem L15_lifted_directrix_in_tangent_plane : every_space_curve_with_point (fun K c =>
  dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  lifted_directrix_in_tangent_plane c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1; 1; 6], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (lifted_directrix_in_tangent_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, lifted forms. *)
Theorem L15_lifted_directrix_height : every_space_curve_with_point (fun K c =>
  dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) <> zero K ->
  chen_riesenfeld_cohen_2007.direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  lifted_directrix_height c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (lifted_directrix_height c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
