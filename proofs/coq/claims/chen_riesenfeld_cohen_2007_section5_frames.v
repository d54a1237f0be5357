(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** E13, eq. (13). *)
Theorem E13_frame_products : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  frame_products c = [zero K; zero K; zero K; zero K; zero K; zero K; zero K]).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [var 2; var 4]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nrho. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (frame_products c : list expr)%formula = map (value K l) ([num 0; num 0; num 0; num 0; num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E13, eq. (13). *)
Theorem E13_unit_normal_unit_normal_by_product : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  unit_normal c = unit_normal_by_product c).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [var 4; var 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0]); ([1; 0], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nrho. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (unit_normal c : list expr)%formula = map (value K l) (unit_normal_by_product c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E13, Frenet equations. *)
Theorem E13_unit_tangent_derivative_unit_normal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  unit_tangent_derivative c = vmul (speed c * curvature_in_space c) (unit_normal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2 P2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Ssigma : value K k (eder s (dot [var 2; var 7; var 12] [var 2; var 7; var 12])%formula) = value K k (eadd (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Dsigma := root_derivative K sigma_ _ (value K k (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula) Hsigma Nsigma P2 Ssigma).
  assert (Isigma := inverse_derivative K sigma_ _ Nsigma Dsigma).
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  assert (Srho : value K k (eder s (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]))%formula) = value K k (eadd (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Drho := root_derivative K rho_ _ (value K k (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula) Hrho Nrho P2 Srho).
  assert (Irho := inverse_derivative K rho_ _ Nrho Drho).
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4 ++ [(2%positive, (var 6 * var 7 + var 11 * var 12 + var 16 * var 17) * var 1); (1%positive, - ((var 6 * var 7 + var 11 * var 12 + var 16 * var 17) * var 1 ^ 3)); (4%positive, (var 7 * var 8 * var 11 ^ 2 - var 6 * var 8 * var 11 * var 12 - var 6 * var 7 * var 11 * var 13 + var 6 ^ 2 * var 12 * var 13 + var 7 * var 8 * var 16 ^ 2 + var 12 * var 13 * var 16 ^ 2 - var 6 * var 8 * var 16 * var 17 - var 11 * var 13 * var 16 * var 17 - var 6 * var 7 * var 16 * var 18 - var 11 * var 12 * var 16 * var 18 + var 6 ^ 2 * var 17 * var 18 + var 11 ^ 2 * var 17 * var 18) * var 3); (3%positive, - ((var 7 * var 8 * var 11 ^ 2 - var 6 * var 8 * var 11 * var 12 - var 6 * var 7 * var 11 * var 13 + var 6 ^ 2 * var 12 * var 13 + var 7 * var 8 * var 16 ^ 2 + var 12 * var 13 * var 16 ^ 2 - var 6 * var 8 * var 16 * var 17 - var 11 * var 13 * var 16 * var 17 - var 6 * var 7 * var 16 * var 18 - var 11 * var 12 * var 16 * var 18 + var 6 ^ 2 * var 17 * var 18 + var 11 ^ 2 * var 17 * var 18) * var 3 ^ 3))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [num 2; var 2; var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2; var 4]%formula : list expr).
  pose (known := [([0; 1], [0; 0]); ([0; 1; 1], [0; 0; 0]); ([0; 1; 0; 1], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (D1_squared c : expr)%formula (var 20 ^ 4)%formula (var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Nrho. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (unit_tangent_derivative c : list expr)%formula = map (value K l) (vmul (speed c * curvature_in_space c) (unit_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E13, Frenet equations. *)
Theorem E13_unit_normal_derivative_turn_of_normal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  unit_normal_derivative c = vmul (speed c) (turn_of_normal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2 P2.
  pose (k := jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r0 := of_parameters (chain 1 5 ++ chain 7 5 ++ chain 13 5 ++ chain 19 5) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 19 ^ 4 : expr)%formula (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Ssigma : value K k (eder s (dot [var 2; var 8; var 14] [var 2; var 8; var 14])%formula) = value K k (eadd (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Dsigma := root_derivative K sigma_ _ (value K k (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula) Hsigma Nsigma P2 Ssigma).
  assert (Isigma := inverse_derivative K sigma_ _ Nsigma Dsigma).
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 19 ^ 6 : expr)%formula (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  assert (Srho : value K k (eder s (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]))%formula) = value K k (eadd (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Drho := root_derivative K rho_ _ (value K k (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula) Hrho Nrho P2 Srho).
  assert (Irho := inverse_derivative K rho_ _ Nrho Drho).
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r := of_parameters (chain 5 5 ++ chain 11 5 ++ chain 17 5 ++ chain 23 5 ++ [(2%positive, (var 6 * var 7 + var 12 * var 13 + var 18 * var 19) * var 1); (1%positive, - ((var 6 * var 7 + var 12 * var 13 + var 18 * var 19) * var 1 ^ 3)); (4%positive, (var 7 * var 8 * var 12 ^ 2 - var 6 * var 8 * var 12 * var 13 - var 6 * var 7 * var 12 * var 14 + var 6 ^ 2 * var 13 * var 14 + var 7 * var 8 * var 18 ^ 2 + var 13 * var 14 * var 18 ^ 2 - var 6 * var 8 * var 18 * var 19 - var 12 * var 14 * var 18 * var 19 - var 6 * var 7 * var 18 * var 20 - var 12 * var 13 * var 18 * var 20 + var 6 ^ 2 * var 19 * var 20 + var 12 ^ 2 * var 19 * var 20) * var 3); (3%positive, - ((var 7 * var 8 * var 12 ^ 2 - var 6 * var 8 * var 12 * var 13 - var 6 * var 7 * var 12 * var 14 + var 6 ^ 2 * var 13 * var 14 + var 7 * var 8 * var 18 ^ 2 + var 13 * var 14 * var 18 ^ 2 - var 6 * var 8 * var 18 * var 19 - var 12 * var 14 * var 18 * var 19 - var 6 * var 7 * var 18 * var 20 - var 12 * var 13 * var 18 * var 20 + var 6 ^ 2 * var 19 * var 20 + var 12 ^ 2 * var 19 * var 20) * var 3 ^ 3))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 10; var 16] [var 4; var 10; var 16]; dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 11; var 17] (var 23) []) (var 2) (var 4)).
  pose (atoms := [num 2; var 4; var 2; var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2; var 6 ^ 2 + var 12 ^ 2 + var 18 ^ 2]%formula : list expr).
  pose (known := [([0; 1; 1], [0; 0; 0]); ([0; 1; 0], [0; 0; 0]); ([0; 0; 0; 1], [0; 0; 0; 0]); ([0; 0; 1; 0], [0; 0; 0; 0]); ([0; 0; 1; 0; 1], [0; 0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nrho. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (binormal_form_squared c : expr)%formula (var 23 ^ 6)%formula (var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N4 into N.
  assert (N5 : all_nonzero K l (firstn 5 atoms)).
  { apply (and_nonzero K l (firstn 4 atoms) (nth 4 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 4 atoms) known N (D1_squared c : expr)%formula (var 23 ^ 4)%formula (var 6 ^ 2 + var 12 ^ 2 + var 18 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N5 into N.
  assert (E : map (value K l) (unit_normal_derivative c : list expr)%formula = map (value K l) (vmul (speed c) (turn_of_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E13, Frenet equations. *)
Theorem E13_unit_binormal_derivative_unit_normal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  unit_binormal_derivative c = vmul (number (-1) * speed c * torsion c) (unit_normal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2 P2.
  pose (k := jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r0 := of_parameters (chain 1 5 ++ chain 7 5 ++ chain 13 5 ++ chain 19 5) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 19 ^ 4 : expr)%formula (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Ssigma : value K k (eder s (dot [var 2; var 8; var 14] [var 2; var 8; var 14])%formula) = value K k (eadd (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Dsigma := root_derivative K sigma_ _ (value K k (var 2 * var 3 + var 8 * var 9 + var 14 * var 15)%formula) Hsigma Nsigma P2 Ssigma).
  assert (Isigma := inverse_derivative K sigma_ _ Nsigma Dsigma).
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 19 ^ 6 : expr)%formula (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  assert (Srho : value K k (eder s (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]))%formula) = value K k (eadd (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Drho := root_derivative K rho_ _ (value K k (var 3 * var 4 * var 8 ^ 2 - var 2 * var 4 * var 8 * var 9 - var 2 * var 3 * var 8 * var 10 + var 2 ^ 2 * var 9 * var 10 + var 3 * var 4 * var 14 ^ 2 + var 9 * var 10 * var 14 ^ 2 - var 2 * var 4 * var 14 * var 15 - var 8 * var 10 * var 14 * var 15 - var 2 * var 3 * var 14 * var 16 - var 8 * var 9 * var 14 * var 16 + var 2 ^ 2 * var 15 * var 16 + var 8 ^ 2 * var 15 * var 16)%formula) Hrho Nrho P2 Srho).
  assert (Irho := inverse_derivative K rho_ _ Nrho Drho).
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r := of_parameters (chain 5 5 ++ chain 11 5 ++ chain 17 5 ++ chain 23 5 ++ [(2%positive, (var 6 * var 7 + var 12 * var 13 + var 18 * var 19) * var 1); (1%positive, - ((var 6 * var 7 + var 12 * var 13 + var 18 * var 19) * var 1 ^ 3)); (4%positive, (var 7 * var 8 * var 12 ^ 2 - var 6 * var 8 * var 12 * var 13 - var 6 * var 7 * var 12 * var 14 + var 6 ^ 2 * var 13 * var 14 + var 7 * var 8 * var 18 ^ 2 + var 13 * var 14 * var 18 ^ 2 - var 6 * var 8 * var 18 * var 19 - var 12 * var 14 * var 18 * var 19 - var 6 * var 7 * var 18 * var 20 - var 12 * var 13 * var 18 * var 20 + var 6 ^ 2 * var 19 * var 20 + var 12 ^ 2 * var 19 * var 20) * var 3); (3%positive, - ((var 7 * var 8 * var 12 ^ 2 - var 6 * var 8 * var 12 * var 13 - var 6 * var 7 * var 12 * var 14 + var 6 ^ 2 * var 13 * var 14 + var 7 * var 8 * var 18 ^ 2 + var 13 * var 14 * var 18 ^ 2 - var 6 * var 8 * var 18 * var 19 - var 12 * var 14 * var 18 * var 19 - var 6 * var 7 * var 18 * var 20 - var 12 * var 13 * var 18 * var 20 + var 6 ^ 2 * var 19 * var 20 + var 12 ^ 2 * var 19 * var 20) * var 3 ^ 3))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 10; var 16] [var 4; var 10; var 16]; dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 11; var 17] (var 23) []) (var 2) (var 4)).
  pose (atoms := [num 2; var 4; var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2; var 2]%formula : list expr).
  pose (known := [([0; 1], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 1; 0; 1], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nrho. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (binormal_form_squared c : expr)%formula (var 23 ^ 6)%formula (var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (unit_binormal_derivative c : list expr)%formula = map (value K l) (vmul (number (-1) * speed c * torsion c) (unit_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E14, eq. (14). *)
Theorem E14_binormal_unit_binormal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  binormal c = vmul (binormal_length c) (unit_binormal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 3 4 ++ chain 8 4 ++ chain 13 4 ++ chain 18 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K rho_ Nrho) (conj Hrho I)).
  pose (c := Framed (homogeneous s [var 3; var 8; var 13] (var 18) []) (num 0) (var 2)).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nrho. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (binormal c : list expr)%formula = map (value K l) (vmul (binormal_length c) (unit_binormal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E14, eq. (14). *)
Theorem E14_normal_unit_normal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  normal c = vmul (speed c * binormal_length c) (unit_normal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [var 4; var 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nrho. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (normal c : list expr)%formula = map (value K l) (vmul (speed c * binormal_length c) (unit_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E14, eq. (14). *)
Theorem E14_velocity_unit_tangent : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  velocity c = vmul (speed c) (unit_tangent c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r0 := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 5; var 9] (var 13) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 6; var 10] [var 2; var 6; var 10] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 13 ^ 4 : expr)%formula (dot [var 2; var 6; var 10] [var 2; var 6; var 10] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_] ++ jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 3 3 ++ chain 7 3 ++ chain 11 3 ++ chain 15 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 2; var 6; var 10] [var 2; var 6; var 10]]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma I)).
  pose (c := Framed (homogeneous s [var 3; var 7; var 11] (var 15) []) (var 2) (num 0)).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (velocity c : list expr)%formula = map (value K l) (vmul (speed c) (unit_tangent c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E15, eq. (15). *)
Theorem E15_curvature_vector_unit_normal : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  curvature_vector c = vmul (curvature_in_space c) (unit_normal c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2; var 2; var 4]%formula : list expr).
  pose (known := [([2], [0]); ([1; 1], [0; 0]); ([0; 1; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_squared c : expr)%formula (var 20 ^ 4)%formula (var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Nrho. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (curvature_vector c : list expr)%formula = map (value K l) (vmul (curvature_in_space c) (unit_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E16, eq. (16). *)
Theorem E16_normal_by_curvature_radius_vector : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  normal_by_curvature c = radius_vector c).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [var 4; var 2; var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2; var 7 ^ 2 * var 11 ^ 2 - num 2 * var 6 * var 7 * var 11 * var 12 + var 6 ^ 2 * var 12 ^ 2 + var 7 ^ 2 * var 16 ^ 2 + var 12 ^ 2 * var 16 ^ 2 - num 2 * var 6 * var 7 * var 16 * var 17 - num 2 * var 11 * var 12 * var 16 * var 17 + var 6 ^ 2 * var 17 ^ 2 + var 11 ^ 2 * var 17 ^ 2]%formula : list expr).
  pose (known := [([1; 1], [0; 0]); ([0; 1; 1], [0; 0; 0]); ([1; 1; 0], [0; 0; 2]); ([0; 0; 0; 1], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nrho. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (D1_squared c : expr)%formula (var 20 ^ 4)%formula (var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (binormal_form_squared c : expr)%formula (var 20 ^ 6)%formula (var 7 ^ 2 * var 11 ^ 2 - num 2 * var 6 * var 7 * var 11 * var 12 + var 6 ^ 2 * var 12 ^ 2 + var 7 ^ 2 * var 16 ^ 2 + var 12 ^ 2 * var 16 ^ 2 - num 2 * var 6 * var 7 * var 16 * var 17 - num 2 * var 11 * var 12 * var 16 * var 17 + var 6 ^ 2 * var 17 ^ 2 + var 11 ^ 2 * var 17 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (normal_by_curvature c : list expr)%formula = map (value K l) (radius_vector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_direction_rectifying_generator : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_generator c = vmul (speed c) (rectifying_direction c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2.
  pose (k := jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r0 := of_parameters (chain 1 5 ++ chain 7 5 ++ chain 13 5 ++ chain 19 5) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 19 ^ 4 : expr)%formula (dot [var 2; var 8; var 14] [var 2; var 8; var 14] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 7; var 13] (var 19) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 19 ^ 6 : expr)%formula (dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 5 x_ ++ jets s 5 y_ ++ jets s 5 z_ ++ jets s 5 w_).
  pose (r := of_parameters (chain 5 5 ++ chain 11 5 ++ chain 17 5 ++ chain 23 5) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 10; var 16] [var 4; var 10; var 16]; dot (cross [var 2; var 8; var 14] [var 3; var 9; var 15]) (cross [var 2; var 8; var 14] [var 3; var 9; var 15])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 11; var 17] (var 23) []) (var 2) (var 4)).
  pose (atoms := [var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2; var 6 ^ 2 + var 12 ^ 2 + var 18 ^ 2; var 2; var 4]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 0; 0; 1], [0; 0; 0; 0]); ([0; 1; 1; 0], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 23 ^ 6)%formula (var 7 ^ 2 * var 12 ^ 2 - num 2 * var 6 * var 7 * var 12 * var 13 + var 6 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 18 ^ 2 + var 13 ^ 2 * var 18 ^ 2 - num 2 * var 6 * var 7 * var 18 * var 19 - num 2 * var 12 * var 13 * var 18 * var 19 + var 6 ^ 2 * var 19 ^ 2 + var 12 ^ 2 * var 19 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 23 ^ 4)%formula (var 6 ^ 2 + var 12 ^ 2 + var 18 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Nrho. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (rectifying_generator c : list expr)%formula = map (value K l) (vmul (speed c) (rectifying_direction c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5a, §5.5. *)
Theorem C55a_radius_derivative_along_binormal_psi : every_framed_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  radius_derivative_along_binormal c = vmul (speed c) (psi c)).
Proof.
  apply framed_space_by_position; intros K x_ y_ z_ w_ sigma_ rho_ Hw velocity_ binormal_ Hsigma Hrho H1 H2 P2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 16 ^ 4 : expr)%formula (dot [var 2; var 7; var 12] [var 2; var 7; var 12] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Ssigma : value K k (eder s (dot [var 2; var 7; var 12] [var 2; var 7; var 12])%formula) = value K k (eadd (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Dsigma := root_derivative K sigma_ _ (value K k (var 2 * var 3 + var 7 * var 8 + var 12 * var 13)%formula) Hsigma Nsigma P2 Ssigma).
  assert (Isigma := inverse_derivative K sigma_ _ Nsigma Dsigma).
  assert (Nrho : rho_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6; var 11] (var 16) []) (num 0) (num 0)).
    apply (root_nonzero K rho_ _ Hrho).
    assert (Z : value K k (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (binormal_form_squared c : expr)%formula (var 16 ^ 6 : expr)%formula (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  vm_cast_no_check Z. }
  assert (Srho : value K k (eder s (dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13]))%formula) = value K k (eadd (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Drho := root_derivative K rho_ _ (value K k (var 3 * var 4 * var 7 ^ 2 - var 2 * var 4 * var 7 * var 8 - var 2 * var 3 * var 7 * var 9 + var 2 ^ 2 * var 8 * var 9 + var 3 * var 4 * var 12 ^ 2 + var 8 * var 9 * var 12 ^ 2 - var 2 * var 4 * var 12 * var 13 - var 7 * var 9 * var 12 * var 13 - var 2 * var 3 * var 12 * var 14 - var 7 * var 8 * var 12 * var 14 + var 2 ^ 2 * var 13 * var 14 + var 7 ^ 2 * var 13 * var 14)%formula) Hrho Nrho P2 Srho).
  assert (Irho := inverse_derivative K rho_ _ Nrho Drho).
  pose (l := [quotient K (one K) sigma_; sigma_; quotient K (one K) rho_; rho_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 5 4 ++ chain 10 4 ++ chain 15 4 ++ chain 20 4 ++ [(2%positive, (var 6 * var 7 + var 11 * var 12 + var 16 * var 17) * var 1); (1%positive, - ((var 6 * var 7 + var 11 * var 12 + var 16 * var 17) * var 1 ^ 3)); (4%positive, (var 7 * var 8 * var 11 ^ 2 - var 6 * var 8 * var 11 * var 12 - var 6 * var 7 * var 11 * var 13 + var 6 ^ 2 * var 12 * var 13 + var 7 * var 8 * var 16 ^ 2 + var 12 * var 13 * var 16 ^ 2 - var 6 * var 8 * var 16 * var 17 - var 11 * var 13 * var 16 * var 17 - var 6 * var 7 * var 16 * var 18 - var 11 * var 12 * var 16 * var 18 + var 6 ^ 2 * var 17 * var 18 + var 11 ^ 2 * var 17 * var 18) * var 3); (3%positive, - ((var 7 * var 8 * var 11 ^ 2 - var 6 * var 8 * var 11 * var 12 - var 6 * var 7 * var 11 * var 13 + var 6 ^ 2 * var 12 * var 13 + var 7 * var 8 * var 16 ^ 2 + var 12 * var 13 * var 16 ^ 2 - var 6 * var 8 * var 16 * var 17 - var 11 * var 13 * var 16 * var 17 - var 6 * var 7 * var 16 * var 18 - var 11 * var 12 * var 16 * var 18 + var 6 ^ 2 * var 17 * var 18 + var 11 ^ 2 * var 17 * var 18) * var 3 ^ 3))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 4; var 9; var 14] [var 4; var 9; var 14]; dot (cross [var 2; var 7; var 12] [var 3; var 8; var 13]) (cross [var 2; var 7; var 12] [var 3; var 8; var 13])]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma (conj (root_inverse K rho_ Nrho) (conj Hrho I)))).
  pose (c := Framed (homogeneous s [var 5; var 10; var 15] (var 20) []) (var 2) (var 4)).
  pose (atoms := [num 2; var 4; var 2; var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2; var 7 ^ 2 * var 11 ^ 2 - num 2 * var 6 * var 7 * var 11 * var 12 + var 6 ^ 2 * var 12 ^ 2 + var 7 ^ 2 * var 16 ^ 2 + var 12 ^ 2 * var 16 ^ 2 - num 2 * var 6 * var 7 * var 16 * var 17 - num 2 * var 11 * var 12 * var 16 * var 17 + var 6 ^ 2 * var 17 ^ 2 + var 11 ^ 2 * var 17 ^ 2]%formula : list expr).
  pose (known := [([0; 1], [0; 0]); ([0; 0; 1; 1], [0; 0; 0; 0]); ([0; 1; 1; 0], [0; 0; 0; 2]); ([0; 0; 0; 0; 2], [0; 0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nrho. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (D1_squared c : expr)%formula (var 20 ^ 4)%formula (var 6 ^ 2 + var 11 ^ 2 + var 16 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (N5 : all_nonzero K l (firstn 5 atoms)).
  { apply (and_nonzero K l (firstn 4 atoms) (nth 4 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 4 atoms) known N (binormal_form_squared c : expr)%formula (var 20 ^ 6)%formula (var 7 ^ 2 * var 11 ^ 2 - num 2 * var 6 * var 7 * var 11 * var 12 + var 6 ^ 2 * var 12 ^ 2 + var 7 ^ 2 * var 16 ^ 2 + var 12 ^ 2 * var 16 ^ 2 - num 2 * var 6 * var 7 * var 16 * var 17 - num 2 * var 11 * var 12 * var 16 * var 17 + var 6 ^ 2 * var 17 ^ 2 + var 11 ^ 2 * var 17 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N5 into N.
  assert (E : map (value K l) (radius_derivative_along_binormal c : list expr)%formula = map (value K l) (vmul (speed c) (psi c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.2a, §4.2, eq. (10). *)
Theorem C42a_signed_curvature_derivative_g0 : every_framed_plane_curve (fun K c =>
  D1_squared c <> zero K ->
  number 2 <> zero K ->
  signed_curvature_derivative c = number 1 / speed c ^ 5 * g0 c).
Proof.
  apply framed_plane_by_position; intros K x_ y_ w_ sigma_ Hw Hsigma H1 P2.
  pose (k := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 w_).
  pose (r0 := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 6] (var 11) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 7] [var 2; var 7] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 11 ^ 4 : expr)%formula (dot [var 2; var 7] [var 2; var 7] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  assert (Ssigma : value K k (eder s (dot [var 2; var 7] [var 2; var 7])%formula) = value K k (eadd (var 2 * var 3 + var 7 * var 8)%formula (var 2 * var 3 + var 7 * var 8)%formula)).
  { apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }
  assert (Dsigma := root_derivative K sigma_ _ (value K k (var 2 * var 3 + var 7 * var 8)%formula) Hsigma Nsigma P2 Ssigma).
  assert (Isigma := inverse_derivative K sigma_ _ Nsigma Dsigma).
  pose (l := [quotient K (one K) sigma_; sigma_] ++ jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 3 4 ++ chain 8 4 ++ chain 13 4 ++ [(2%positive, (var 4 * var 5 + var 9 * var 10) * var 1); (1%positive, - ((var 4 * var 5 + var 9 * var 10) * var 1 ^ 3))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 2; var 7] [var 2; var 7]]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma I)).
  pose (c := Framed (homogeneous s [var 3; var 8] (var 13) []) (var 2) (num 0)).
  pose (atoms := [num 2; var 2; var 4 ^ 2 + var 9 ^ 2]%formula : list expr).
  pose (known := [([0; 1; 1], [0; 0; 0]); ([0; 1; 2], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 4 ^ 2 + var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N3 into N.
  assert (E : value K l (signed_curvature_derivative c : expr)%formula = value K l (number 1 / speed c ^ 5 * g0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E12, §4.3, eq. (12). *)
Theorem E12_evolute_by_unit_normal_evolute : every_framed_plane_curve (fun K c =>
  D1_squared c <> zero K ->
  f2 c <> zero K ->
  evolute_by_unit_normal c = evolute c).
Proof.
  apply framed_plane_by_position; intros K x_ y_ w_ sigma_ Hw Hsigma H1 H2.
  pose (k := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r0 := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.
  assert (Nsigma : sigma_ <> zero K).
  { pose (c := Framed (homogeneous s [var 1; var 5] (var 9) []) (num 0) (num 0)).
    apply (root_nonzero K sigma_ _ Hsigma).
    assert (Z : value K k (dot [var 2; var 6] [var 2; var 6] : expr)%formula <> zero K).
  { apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) (D1_squared c : expr)%formula (var 9 ^ 4 : expr)%formula (dot [var 2; var 6] [var 2; var 6] : expr)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  vm_cast_no_check Z. }
  pose (l := [quotient K (one K) sigma_; sigma_] ++ jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 3 3 ++ chain 7 3 ++ chain 11 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [dot [var 2; var 6] [var 2; var 6]]%formula : list expr).
  assert (Q : roots_hold K l roots) by exact (conj (root_inverse K sigma_ Nsigma) (conj Hsigma I)).
  pose (c := Framed (homogeneous s [var 3; var 7] (var 11) []) (var 2) (num 0)).
  pose (atoms := [var 2; var 4 ^ 2 + var 8 ^ 2; var 5 * var 8 - var 4 * var 9]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([1; 0; 1], [0; 2; 0]); ([0; 0; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Nsigma. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 11 ^ 4)%formula (var 4 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (f2 c : expr)%formula (num 0 - var 11 ^ 3)%formula (var 5 * var 8 - var 4 * var 9)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (evolute_by_unit_normal c : list expr)%formula = map (value K l) (evolute c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** N11, negative control, fails. *)
Theorem N11_unit_tangent_derivative_unit_binormal_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Framed (rational_curve s [number 3 * t; number 3 * t ^ 2; number 2 * t ^ 3] (number 1) []) (number 3 + number 6 * t ^ 2) (number 18 + number 36 * t ^ 2) in
  w c <> zero K /\
  D1_squared c <> zero K /\
  binormal_form_squared c <> zero K /\
  sigma c * sigma c = dot (vder s (gamma c)) (vder s (gamma c)) /\
  rho c * rho c = dot (cross (vder s (gamma c)) (vders s 2 (gamma c))) (cross (vder s (gamma c)) (vders s 2 (gamma c))) /\
  unit_tangent_derivative c <> vmul (speed c * curvature_in_space c) (unit_binormal c).
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 3; num 1 + num 2 * var 1 ^ 2; num 2; var 1; num 1 + var 1]%formula : list expr).
  pose (known := [([], []); ([2; 2], [0; 0]); ([4; 2; 2], [0; 0; 0]); ([1; 1; 0], [0; 0; 0]); ([3; 3; 0], [0; 0; 0]); ([2; 1; 1], [0; 0; 0]); ([0; 0; 2; 1; 1], [0; 2; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (Framed (rational_curve s [number 3 * (var 1); number 3 * (var 1) ^ 2; number 2 * (var 1) ^ 3] (number 1) []) (number 3 + number 6 * (var 1) ^ 2) (number 18 + number 36 * (var 1) ^ 2))%formula : framed expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H2 : value K l (binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E0 : value K l (sigma c * sigma c : expr)%formula = value K l (dot (vder s (gamma c)) (vder s (gamma c)) : expr)%formula).
  { apply (one_value K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E1 : value K l (rho c * rho c : expr)%formula = value K l (dot (cross (vder s (gamma c)) (vders s 2 (gamma c))) (cross (vder s (gamma c)) (vders s 2 (gamma c))) : expr)%formula).
  { apply (one_value K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (unit_tangent_derivative c) - component 0 (vmul (speed c * curvature_in_space c) (unit_binormal c)) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  split; [vm_cast_no_check H2|].
  split; [vm_cast_no_check E0|].
  split; [vm_cast_no_check E1|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** N11, negative control, fails. *)
Theorem N11_unit_binormal_derivative_unit_normal_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Framed (rational_curve s [number 3 * t; number 3 * t ^ 2; number 2 * t ^ 3] (number 1) []) (number 3 + number 6 * t ^ 2) (number 18 + number 36 * t ^ 2) in
  w c <> zero K /\
  D1_squared c <> zero K /\
  binormal_form_squared c <> zero K /\
  sigma c * sigma c = dot (vder s (gamma c)) (vder s (gamma c)) /\
  rho c * rho c = dot (cross (vder s (gamma c)) (vders s 2 (gamma c))) (cross (vder s (gamma c)) (vders s 2 (gamma c))) /\
  unit_binormal_derivative c <> vmul (speed c * torsion c) (unit_normal c).
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 3; num 1 + num 2 * var 1 ^ 2; num 2; var 1]%formula : list expr).
  pose (known := [([], []); ([2; 2], [0; 0]); ([4; 2; 2], [0; 0; 0]); ([2; 1; 1], [0; 0; 0]); ([3; 2; 1], [0; 0; 0]); ([0; 0; 3; 1], [0; 2; 0; 0])] : list (list nat * list nat)).
  pose (c := (Framed (rational_curve s [number 3 * (var 1); number 3 * (var 1) ^ 2; number 2 * (var 1) ^ 3] (number 1) []) (number 3 + number 6 * (var 1) ^ 2) (number 18 + number 36 * (var 1) ^ 2))%formula : framed expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H2 : value K l (binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E0 : value K l (sigma c * sigma c : expr)%formula = value K l (dot (vder s (gamma c)) (vder s (gamma c)) : expr)%formula).
  { apply (one_value K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E1 : value K l (rho c * rho c : expr)%formula = value K l (dot (cross (vder s (gamma c)) (vders s 2 (gamma c))) (cross (vder s (gamma c)) (vders s 2 (gamma c))) : expr)%formula).
  { apply (one_value K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (unit_binormal_derivative c) - component 0 (vmul (speed c * torsion c) (unit_normal c)) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  split; [vm_cast_no_check H2|].
  split; [vm_cast_no_check E0|].
  split; [vm_cast_no_check E1|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** N11, negative control, fails. *)
Theorem N11_signed_curvature_derivative_signed_curvature_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Framed (rational_curve s [number 3 * t - t ^ 3; number 3 * t ^ 2] (number 1) []) (number 3 + number 3 * t ^ 2) (number 0) in
  w c <> zero K /\
  D1_squared c <> zero K /\
  sigma c * sigma c = dot (vder s (gamma c)) (vder s (gamma c)) /\
  signed_curvature_derivative c <> number (-3) * signed_curvature c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 3; num 1 + var 1 ^ 2; num 2; num 3 - num 4 * var 1 + num 3 * var 1 ^ 2]%formula : list expr).
  pose (known := [([], []); ([2; 2], [0; 0]); ([3; 3], [0; 0]); ([0; 0; 1; 1], [1; 3; 0; 0])] : list (list nat * list nat)).
  pose (c := (Framed (rational_curve s [number 3 * (var 1) - (var 1) ^ 3; number 3 * (var 1) ^ 2] (number 1) []) (number 3 + number 3 * (var 1) ^ 2) (number 0))%formula : framed expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E0 : value K l (sigma c * sigma c : expr)%formula = value K l (dot (vder s (gamma c)) (vder s (gamma c)) : expr)%formula).
  { apply (one_value K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (signed_curvature_derivative c - number (-3) * signed_curvature c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  split; [vm_cast_no_check E0|].
  apply different; vm_cast_no_check U.
Qed.
