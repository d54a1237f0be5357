(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C6.2b, eq. (34). *)
Theorem C62b_point_bisector_polynomial_point_bisector : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector_polynomial c) (point_bisector c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0]); ([0; 1; 0], [0; 0; 0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E1 : map (value K l) (cross (generator (point_bisector_polynomial c)) (generator (point_bisector c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector_polynomial c)) (vsub (directrix (point_bisector c)) (directrix (point_bisector_polynomial c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector_polynomial c)) (generator (point_bisector_polynomial c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector c)) (generator (point_bisector c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector_polynomial c))) (map (value K l) (generator (point_bisector_polynomial c))) (map (value K l) (directrix (point_bisector c))) (map (value K l) (generator (point_bisector c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (point_bisector_polynomial c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (point_bisector c))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2b, eq. (34), as printed. *)
Theorem C62b_point_bisector_misprint_point_bisector_misprint_by_height : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  point_bisector_misprint c = point_bisector_misprint_by_height c).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0]); ([1; 1; 6], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E : map (value K l) (point_bisector_misprint c : list expr)%formula = map (value K l) (point_bisector_misprint_by_height c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2b, eq. (34). *)
Theorem C62b_generator_of_34_point_bisector_generator_polynomial : every_space_curve_with_point (fun K c =>
  number 2 <> zero K ->
  point_bisector_determinant_polynomial c * w c <> zero K ->
  generator_of_34 c = vmul (number 1 / w c) (point_bisector_generator_polynomial c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw P2 D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 7], [0; 0; 0]); ([0; 0; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (point_bisector_determinant_polynomial c * w c : expr)%formula (num 0 - var 7 ^ 7)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (generator_of_34 c : list expr)%formula = map (value K l) (vmul (number 1 / w c) (point_bisector_generator_polynomial c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2b, eq. (34). *)
Theorem C62b_point_bisector_generator_polynomial_point_bisector_generator : every_space_curve_with_point (fun K c =>
  point_bisector_generator_polynomial c = vmul (w c ^ 3) (point_bisector_generator c)).
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
  assert (E : map (value K l) (point_bisector_generator_polynomial c : list expr)%formula = map (value K l) (vmul (w c ^ 3) (point_bisector_generator c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2b, eqs. (31), (34). *)
Theorem C62b_point_bisector_point_bisector_polynomial : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector c) (point_bisector_polynomial c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 1; 7], [0; 0; 0]); ([0; 1; 0], [0; 0; 0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E1 : map (value K l) (cross (generator (point_bisector c)) (generator (point_bisector_polynomial c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector c)) (vsub (directrix (point_bisector_polynomial c)) (directrix (point_bisector c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector c)) (generator (point_bisector c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_polynomial c)) (generator (point_bisector_polynomial c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector c))) (map (value K l) (generator (point_bisector c))) (map (value K l) (directrix (point_bisector_polynomial c))) (map (value K l) (generator (point_bisector_polynomial c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (point_bisector c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (point_bisector_polynomial c))) (conj eq_refl U2)) E1 E2).
Qed.

(** C6.2d, eq. (35). *)
Theorem C62d_point_bisector_direct_naive_point_bisector_direct_z : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  directrix (point_bisector_direct_naive c) = directrix (point_bisector_direct_z c) /\ generator (point_bisector_direct_naive c) = generator (point_bisector_direct_z c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E1 : map (value K l) (directrix (point_bisector_direct_naive c) : list expr)%formula = map (value K l) (directrix (point_bisector_direct_z c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (generator (point_bisector_direct_naive c) : list expr)%formula = map (value K l) (generator (point_bisector_direct_z c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (conj E1 E2).
Qed.

(** C6.2d, §6.2, direct approach. *)
Theorem C62d_direct_x_of_directrix : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_x c <> zero K ->
  number 2 <> zero K ->
  direct_x_of_directrix c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 4 * var 5 - var 3 * var 6 + var 6 * var 10 - var 4 * var 11; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E : value K l (direct_x_of_directrix c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2d, §6.2, direct approach. *)
Theorem C62d_direct_y_of_directrix : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  direct_determinant_y c <> zero K ->
  number 2 <> zero K ->
  direct_y_of_directrix c = zero K).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 H2 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 5 - var 1 * var 6 + var 6 * var 9 - var 2 * var 11; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
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
  assert (E : value K l (direct_y_of_directrix c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2c, §6.2, direct approach. *)
Theorem C62c_direct_determinant_x_generator_x : every_space_curve_with_point (fun K c =>
  direct_determinant_x c = generator_x c).
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
  assert (E : value K l (direct_determinant_x c : expr)%formula = value K l (generator_x c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2c, §6.2, direct approach. *)
Theorem C62c_direct_determinant_y_generator_y : every_space_curve_with_point (fun K c =>
  direct_determinant_y c = generator_y c).
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
  assert (E : value K l (direct_determinant_y c : expr)%formula = value K l (generator_y c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.2a, eq. (31). *)
Theorem C62a_through_point_height_through_point_height_by_determinant : every_space_curve_with_point (fun K c =>
  through_point_height c = through_point_height_by_determinant c).
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
  assert (E : value K l (through_point_height c : expr)%formula = value K l (through_point_height_by_determinant c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
