(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C6.2c, §6.2.2. *)
Theorem C62c_point_bisector_direct_z_point_bisector : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector_direct_z c) (point_bisector c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 0; 0; 1], [0; 0; 0; 0]); ([0; 0; 0; 0], [0; 0; 0; 0]); ([0; 1; 0; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E1 : map (value K l) (cross (generator (point_bisector_direct_z c)) (generator (point_bisector c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector_direct_z c)) (vsub (directrix (point_bisector c)) (directrix (point_bisector_direct_z c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector_direct_z c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector_direct_z c))) (map (value K l) (generator (point_bisector_direct_z c))) (map (value K l) (directrix (point_bisector c))) (map (value K l) (generator (point_bisector c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2c, §6.2.2. *)
Theorem C62c_point_bisector_direct_z_point_bisector_direct_naive : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector_direct_z c) (point_bisector_direct_naive c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 1; 0], [0; 0; 0]); ([0; 0; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (point_bisector_direct_z c)) (generator (point_bisector_direct_naive c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector_direct_z c)) (vsub (directrix (point_bisector_direct_naive c)) (directrix (point_bisector_direct_z c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector_direct_z c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_direct_naive c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector_direct_z c))) (map (value K l) (generator (point_bisector_direct_z c))) (map (value K l) (directrix (point_bisector_direct_naive c))) (map (value K l) (generator (point_bisector_direct_naive c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2d, §6.2.2. *)
Theorem C62d_direct_height_of_directrix : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  direct_height_of_directrix c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (direct_height_of_directrix c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2d, §6.2.2. *)
Theorem C62d_direct_height_of_generator : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  direct_height_of_generator c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (direct_height_of_generator c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2e, §6.2.2. *)
Theorem C62e_direct_determinant_z_generator_z : every_space_curve_with_point (fun K c =>
  direct_determinant_z c = generator_z c).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (direct_determinant_z c : expr)%formula = value K l (generator_z c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2e, §6.2.2. *)
Theorem C62e_point_bisector_direct_x_point_bisector_direct_z : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_x c <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector_direct_x c) (point_bisector_direct_z c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 H3 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 4 * var 5 - var 3 * var 6 + var 6 * var 10 - var 4 * var 11; var 7; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 0; 4; 1], [0; 0; 0; 0]); ([0; 0; 0; 1], [0; 1; 0; 0]); ([0; 0; 0; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_x c : expr)%formula (var 7 ^ 3)%formula (var 4 * var 5 - var 3 * var 6 + var 6 * var 10 - var 4 * var 11)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N4 into N.
  assert (E1 : map (value K l) (cross (generator (point_bisector_direct_x c)) (generator (point_bisector_direct_z c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector_direct_x c)) (vsub (directrix (point_bisector_direct_z c)) (directrix (point_bisector_direct_x c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector_direct_x c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_direct_z c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector_direct_x c))) (map (value K l) (generator (point_bisector_direct_x c))) (map (value K l) (directrix (point_bisector_direct_z c))) (map (value K l) (generator (point_bisector_direct_z c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2e, §6.2.2. *)
Theorem C62e_point_bisector_direct_y_point_bisector_direct_z : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_y c <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector_direct_y c) (point_bisector_direct_z c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 H3 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 5 - var 1 * var 6 + var 6 * var 9 - var 2 * var 11; var 7; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 0; 4; 1], [0; 0; 0; 0]); ([0; 0; 0; 1], [0; 1; 0; 0]); ([0; 0; 0; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (direct_determinant_y c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 2 * var 5 - var 1 * var 6 + var 6 * var 9 - var 2 * var 11)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N4 into N.
  assert (E1 : map (value K l) (cross (generator (point_bisector_direct_y c)) (generator (point_bisector_direct_z c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector_direct_y c)) (vsub (directrix (point_bisector_direct_z c)) (directrix (point_bisector_direct_y c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector_direct_y c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_direct_z c)) (axis 2 (length (p c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector_direct_y c))) (map (value K l) (generator (point_bisector_direct_y c))) (map (value K l) (directrix (point_bisector_direct_z c))) (map (value K l) (generator (point_bisector_direct_z c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (axis 2 (length (p c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2f, §6.2, Fig. 6. *)
Theorem C62f_plane_bisector_polynomial_point_bisector_polynomial : every_plane_curve_with_point (fun K c =>
  plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_polynomial c ++ [zero K] = directrix (point_bisector_polynomial (embedded c))).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([1; 0; 0], [0; 0; 0]); ([0; 2; 7], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (plane_bisector_polynomial c ++ [number 0] : list expr)%formula
    = map (value K l) (directrix (point_bisector_polynomial (embedded c)) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2f, §6.2, Fig. 6. *)
Theorem C62f_plane_bisector_polynomial_point_bisector_direct_z : every_plane_curve_with_point (fun K c =>
  plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_polynomial c ++ [zero K] = directrix (point_bisector_direct_z (embedded c))).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([1; 0; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (plane_bisector_polynomial c ++ [number 0] : list expr)%formula
    = map (value K l) (directrix (point_bisector_direct_z (embedded c)) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2g, eq. (34), fails. *)
Theorem C62g_point_bisector_directrix_printed_point_bisector_directrix_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [number 1; number 2; number 5] in
  w c <> zero K /\
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K /\
  point_bisector_directrix_printed c <> point_bisector_directrix c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 33 + num 24 * var 1 + num 34 * var 1 ^ 2 - num 32 * var 1 ^ 3 - num 50 * var 1 ^ 4 + num 24 * var 1 ^ 5 + num 14 * var 1 ^ 6 - num 8 * var 1 ^ 7 + var 1 ^ 8; num 2; num 3; num 5; var 1; num 5 - num 4 * var 1 - num 16 * var 1 ^ 2 - num 8 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 6 * var 1 ^ 5]%formula : list expr).
  pose (known := [([1], [0]); ([2; 1], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([3; 1; 0], [0; 0; 0]); ([0; 1; 0], [4; 0; 0]); ([0; 0; 0; 1; 1; 1; 1], [1; 1; 0; 0; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [number 1; number 2; number 5])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 8). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 5). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (point_bisector_directrix_printed c) - component 0 (point_bisector_directrix c) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** C6.2g, eq. (34). *)
Theorem C62g_point_bisector_directrix_polynomial_point_bisector_directrix : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  point_bisector_directrix_polynomial c = point_bisector_directrix c).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (point_bisector_directrix_polynomial c : list expr)%formula = map (value K l) (point_bisector_directrix c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E30, definition of the bisector. *)
Theorem E30_point_bisector_in_normal_plane : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  point_bisector_in_normal_plane c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (point_bisector_in_normal_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E30, definition of the bisector. *)
Theorem E30_point_bisector_equidistance : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  point_bisector_equidistance c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (point_bisector_equidistance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E30, definition of the bisector. *)
Theorem E30_plane_bisector_in_normal : every_plane_curve_with_point (fun K c =>
  plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_in_normal c = zero K).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (plane_bisector_in_normal c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E30, definition of the bisector. *)
Theorem E30_plane_bisector_equidistance : every_plane_curve_with_point (fun K c =>
  plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_equidistance c = zero K).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (plane_bisector_equidistance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E30, eq. (30) in the plane. *)
Theorem E30_plane_bisector_polynomial_plane_bisector : every_plane_curve_with_point (fun K c =>
  plane_bisector_determinant c <> zero K ->
  number 2 <> zero K ->
  plane_bisector_polynomial c = plane_bisector c).
Proof.
  apply plane_point_by_position; intros K x_ y_ w_ q1 q2 Hq1 Hq2 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [q1; q2]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) [var 7; var 8]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8; var 5]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (plane_bisector_determinant c : expr)%formula (var 5 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 7 - var 2 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (plane_bisector_polynomial c : list expr)%formula = map (value K l) (plane_bisector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
