(** A Primer on Bézier Curves: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import primer_on_bezier_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** PB5a, § The canonical form (for cubic curves). *)
Theorem PB5a_mapped_mapped_by_areas : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) <> zero K ->
  (- component 0 (bezier_1 c) + component 0 (bezier_3 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_3 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))) <> zero K ->
  mapped c = mapped_by_areas c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2 P3 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3; var 6 * var 9 + var 5 * var 10; var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([1; 1; 1], [0; 0; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 1], [1; 2; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (- component 1 (bezier_1 c) + component 1 (bezier_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6 * var 9 + var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (- component 0 (bezier_1 c) + component 0 (bezier_3 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_3 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) : expr)%formula ((num 1) / (num 6 * var 6 * var 9 + num 6 * var 5 * var 10))%formula (var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (mapped c : list expr)%formula = map (value K l) (mapped_by_areas c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5b, § The canonical form (for cubic curves). *)
Theorem PB5b_mapped_by_x43_mapped : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  component 1 (moved_2 c) <> zero K ->
  (component 0 (moved_3 c) - component 0 (moved_2 c) * (component 1 (moved_3 c) / component 1 (moved_2 c))) <> zero K ->
  mapped_by_x43 c = mapped c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2 P3 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3; var 6 * var 9 + var 5 * var 10; var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([1; 1; 1], [0; 0; 0]); ([0; 0; 0; 1], [1; 1; 1; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (component 1 (moved_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6 * var 9 + var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (component 0 (moved_3 c) - component 0 (moved_2 c) * (component 1 (moved_3 c) / component 1 (moved_2 c)) : expr)%formula ((num 1) / (num 6 * var 6 * var 9 + num 6 * var 5 * var 10))%formula (var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (mapped_by_x43 c : list expr)%formula = map (value K l) (mapped c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5c, § The canonical form (for cubic curves). *)
Theorem PB5c_mapped_by_steps_mapped : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  component 1 (moved_2 c) <> zero K ->
  component 0 (sheared_3 c) <> zero K ->
  mapped_by_steps c = mapped c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2 P3 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3; var 6 * var 9 + var 5 * var 10; var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([1; 1; 1], [0; 0; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (component 1 (moved_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6 * var 9 + var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (component 0 (sheared_3 c) : expr)%formula ((num 1) / (num 6 * var 6 * var 9 + num 6 * var 5 * var 10))%formula (var 3 * var 6 * var 9 ^ 2 - var 2 * var 7 * var 9 ^ 2 + var 3 * var 5 * var 9 * var 10 - var 1 * var 7 * var 9 * var 10 + num 2 * var 2 * var 5 * var 10 ^ 2 - num 2 * var 1 * var 6 * var 10 ^ 2 - var 2 * var 5 * var 9 * var 11 + var 1 * var 6 * var 9 * var 11)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (mapped_by_steps c : list expr)%formula = map (value K l) (mapped c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5d, § The canonical form (for cubic curves), fails. *)
Theorem PB5d_height_by_the_words_height_by_the_matrix_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.f2 c <> zero K /\
  height_by_the_words c <> height_by_the_matrix c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 2; num 3; var 1; num 0 - num 3 + num 2 * var 1; num 3 + num 2 * var 1]%formula : list expr).
  pose (known := [([], []); ([1], [0]); ([0; 1], [0; 0]); ([1; 0; 1], [0; 1; 0]); ([0; 0; 0; 1; 1], [0; 2; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.f2 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (height_by_the_words c - height_by_the_matrix c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply different; vm_cast_no_check U.
Qed.

(** PB5d, § The canonical form (for cubic curves). *)
Theorem PB5d_height_off : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 3 <> zero K ->
  component 1 (moved_2 c) <> zero K ->
  height_off c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P3 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 3; var 5 * var 7 + var 4 * var 8]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (component 1 (moved_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 5 * var 7 + var 4 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (height_off c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5d, § The canonical form (for cubic curves). *)
Theorem PB5d_height_by_the_words_first_rise_squared : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 3 <> zero K ->
  component 1 (moved_2 c) <> zero K ->
  height_by_the_words c = first_rise_squared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P3 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 3; var 5 * var 7 + var 4 * var 8]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (component 1 (moved_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 5 * var 7 + var 4 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (height_by_the_words c : expr)%formula = value K l (first_rise_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5k, § The canonical form (for cubic curves). *)
Theorem PB5k_sheared_2_off_axis : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 3 <> zero K ->
  component 1 (moved_2 c) <> zero K ->
  sheared_2_off_axis c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P3 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 3; var 5 * var 7 + var 4 * var 8]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (component 1 (moved_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 5 * var 7 + var 4 * var 8)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (sheared_2_off_axis c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5e, § The canonical form (for cubic curves). *)
Theorem PB5e_cusp_edge_cusp_condition : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) <> zero K ->
  cusp_edge c = number 1 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * cusp_condition c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 P3 D1.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3; var 6; var 3 * var 6 - var 2 * var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 2], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (- component 1 (bezier_1 c) + component 1 (bezier_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 6 - var 2 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (cusp_edge c : expr)%formula = value K l (number 1 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * cusp_condition c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5f, § The canonical form (for cubic curves). *)
Theorem PB5f_end_edge_end_condition : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) <> zero K ->
  end_edge c = number 144 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * end_condition c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 P3 D1.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3; var 6; var 3 * var 6 - var 2 * var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 2], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (- component 1 (bezier_1 c) + component 1 (bezier_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 6 - var 2 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (end_edge c : expr)%formula = value K l (number 144 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * end_condition c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5g, § The canonical form (for cubic curves). *)
Theorem PB5g_start_edge_start_condition : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) <> zero K ->
  start_edge c = number 36 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * start_condition c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 P3 D1.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3; var 6; var 3 * var 6 - var 2 * var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 2], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (- component 1 (bezier_1 c) + component 1 (bezier_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 6 - var 2 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (start_edge c : expr)%formula = value K l (number 36 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * start_condition c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5h, § The canonical form (for cubic curves). *)
Theorem PB5h_single_inflection_edge_turning_at_both_ends : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  number 3 <> zero K ->
  (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) <> zero K ->
  single_inflection_edge c = number 1 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * turning_at_both_ends c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 P3 D1.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3; var 6; var 3 * var 6 - var 2 * var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([0; 0; 0; 1], [1; 1; 1; 0]); ([0; 0; 0; 2], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (- component 1 (bezier_1 c) + component 1 (bezier_2 c) : expr)%formula ((num 1) / (num 3))%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 6 - var 2 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (single_inflection_edge c : expr)%formula = value K l (number 1 / chen_riesenfeld_cohen_2007.f0 c ^ 2 * turning_at_both_ends c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB5i, § The canonical form (for cubic curves). *)
Theorem PB5i_first_triangle_f0 : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 3 <> zero K ->
  number 2 <> zero K ->
  first_triangle c = number 1 / number 18 * chen_riesenfeld_cohen_2007.f0 c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P3 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (number 1) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([2; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (first_triangle c : expr)%formula = value K l (number 1 / number 18 * chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
