(** What the proofs of the theorems are made of: curves by their position γ instead of their numerators, polynomials
    that do not vanish, and ruled surfaces. *)

Require Import ZArith List Bool Ring_theory Ring_polynom Field_theory Field.
From ExactSpline Require Import Base Reflection.
Import ListNotations.

(** ** By position *)

Section Position.
Variable K : differential_field.
Add Field K : (field_axioms K).

Lemma rational_is_homogeneous (q : parameter) (p : list K) (w : K) (Q : list K) :
  w <> zero K -> rational_curve q p w Q = homogeneous q (vdiv p w) w Q.
Proof.
  intro Hw. unfold rational_curve, homogeneous. f_equal.
  induction p as [|x p IH]; [reflexivity|]. simpl. rewrite <- IH. f_equal. field. exact Hw.
Qed.

Lemma over_one (x : K) : quotient K x (one K) = x.
Proof. field. apply (F_1_neq_0 (field_axioms K)). Qed.

Lemma times_one (x : K) : times K x (one K) = x.
Proof. ring. Qed.
End Position.

Lemma plane_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y w : K), w <> zero K -> P K (homogeneous s [x; y] w [])) -> every_plane_curve P.
Proof. intros H K x y w Hw. rewrite rational_is_homogeneous by exact Hw. apply H, Hw. Qed.

Lemma space_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y z w : K), w <> zero K -> P K (homogeneous s [x; y; z] w [])) ->
  every_space_curve P.
Proof. intros H K x y z w Hw. rewrite rational_is_homogeneous by exact Hw. apply H, Hw. Qed.

Lemma plane_point_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y w a b : K), constant a -> constant b -> w <> zero K ->
   P K (homogeneous s [x; y] w [a; b])) -> every_plane_curve_with_point P.
Proof. intros H K x y w a b Ha Hb Hw. rewrite rational_is_homogeneous by exact Hw. now apply H. Qed.

Lemma space_point_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y z w a b c : K), constant a -> constant b -> constant c -> w <> zero K ->
   P K (homogeneous s [x; y; z] w [a; b; c])) -> every_space_curve_with_point P.
Proof. intros H K x y z w a b c Ha Hb Hc Hw. rewrite rational_is_homogeneous by exact Hw. now apply H. Qed.

Lemma pair_by_position (P : forall K : differential_field, pair K -> Prop) :
  (forall (K : differential_field) (x y z w X Y Z W : K), w <> zero K -> W <> zero K ->
   P K (Pair (homogeneous s [x; y; z] w []) (homogeneous s_bar [X; Y; Z] W []))) -> every_two_curves P.
Proof.
  intros H K x y z w X Y Z W Hw HW. rewrite (rational_is_homogeneous K s [x; y; z] w) by exact Hw.
  rewrite (rational_is_homogeneous K s_bar [X; Y; Z] W) by exact HW. now apply H.
Qed.

Lemma plane_pair_by_position (P : forall K : differential_field, pair K -> Prop) :
  (forall (K : differential_field) (x y w X Y W : K), w <> zero K -> W <> zero K ->
   P K (Pair (homogeneous s [x; y] w []) (homogeneous s_bar [X; Y] W []))) -> every_two_plane_curves P.
Proof.
  intros H K x y w X Y W Hw HW. rewrite (rational_is_homogeneous K s [x; y] w) by exact Hw.
  rewrite (rational_is_homogeneous K s_bar [X; Y] W) by exact HW. now apply H.
Qed.

(** A polynomial curve is one over the denominator 1. *)
Lemma polynomial_is_homogeneous (K : differential_field) (q : parameter) (p : list K) (Q : list K) :
  rational_curve q p (number 1) Q = homogeneous q p (number 1) Q.
Proof.
  assert (E : vdiv p (number 1) = p).
  { rewrite <- (map_id p) at 2. apply map_ext. intro x. apply over_one. }
  unfold rational_curve, homogeneous. rewrite E. f_equal.
  rewrite <- (map_id p) at 1. apply map_ext. intro x. symmetry. apply times_one.
Qed.

Lemma polynomial_plane_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y : K), P K (homogeneous s [x; y] (number 1) [])) ->
  every_polynomial_plane_curve P.
Proof. intros H K x y. rewrite polynomial_is_homogeneous. apply H. Qed.

Lemma polynomial_space_by_position (P : forall K : differential_field, curve K -> Prop) :
  (forall (K : differential_field) (x y z : K), P K (homogeneous s [x; y; z] (number 1) [])) ->
  every_polynomial_space_curve P.
Proof. intros H K x y z. rewrite polynomial_is_homogeneous. apply H. Qed.

Lemma plane_with_by_position (n : nat) (P : forall K : differential_field, accompanied K -> Prop) :
  (forall (K : differential_field) (x y w : K), w <> zero K ->
   every_constants n (fun ks => P K (Accompanied (homogeneous s [x; y] w []) ks))) -> every_plane_curve_with n P.
Proof. intros H K x y w Hw. rewrite rational_is_homogeneous by exact Hw. apply H, Hw. Qed.

Lemma space_with_by_position (n : nat) (P : forall K : differential_field, accompanied K -> Prop) :
  (forall (K : differential_field) (x y z w : K), w <> zero K ->
   every_constants n (fun ks => P K (Accompanied (homogeneous s [x; y; z] w []) ks))) -> every_space_curve_with n P.
Proof. intros H K x y z w Hw. rewrite rational_is_homogeneous by exact Hw. apply H, Hw. Qed.

Lemma framed_plane_by_position (P : forall K : differential_field, framed K -> Prop) :
  (forall (K : differential_field) (x y w sigma : K), w <> zero K ->
   times K sigma sigma = dot (vder s [x; y]) (vder s [x; y]) ->
   P K (Framed (homogeneous s [x; y] w []) sigma (zero K))) ->
  every_framed_plane_curve P.
Proof. intros H K x y w sigma Hw c velocity Hs. unfold c. rewrite rational_is_homogeneous by exact Hw. now apply H. Qed.

Lemma framed_space_by_position (P : forall K : differential_field, framed K -> Prop) :
  (forall (K : differential_field) (x y z w sigma rho : K), w <> zero K ->
   let velocity := vder s [x; y; z] in
   let binormal := cross velocity (vders s 2 [x; y; z]) in
   times K sigma sigma = dot velocity velocity -> times K rho rho = dot binormal binormal ->
   P K (Framed (homogeneous s [x; y; z] w []) sigma rho)) ->
  every_framed_space_curve P.
Proof.
  intros H K x y z w sigma rho Hw c velocity binormal Hs Hr. unfold c. rewrite rational_is_homogeneous by exact Hw.
  now apply H.
Qed.

Lemma hodograph_by_position (P : forall K : differential_field, accompanied K -> Prop) :
  (forall (K : differential_field) (x y u v h : K),
   derivative K s x = mul (sub (mul u u) (mul v v)) h -> derivative K s y = mul (add (mul u v) (mul u v)) h ->
   P K (Accompanied (homogeneous s [x; y] (number 1) []) [u; v; h])) -> every_hodograph P.
Proof.
  intros H K x y u v h c E. injection E as Ex Ey. unfold c. rewrite polynomial_is_homogeneous. now apply H.
Qed.

Lemma primitive_hodograph_by_position (P : forall K : differential_field, accompanied K -> Prop) :
  (forall (K : differential_field) (x y u v : K),
   derivative K s x = mul (sub (mul u u) (mul v v)) (number 1) ->
   derivative K s y = mul (add (mul u v) (mul u v)) (number 1) ->
   P K (Accompanied (homogeneous s [x; y] (number 1) []) [u; v; number 1])) -> every_primitive_hodograph P.
Proof.
  intros H K x y u v c E. injection E as Ex Ey. unfold c. rewrite polynomial_is_homogeneous. now apply H.
Qed.

Lemma implicit_curve_by_position (P : forall K : differential_field, implicit K -> Prop) :
  (forall (K : differential_field) (x y pace fx fy fxx fxy fyy : K),
   let dx := mul (neg fy) pace in
   let dy := mul fx pace in
   derivative K s x = dx -> derivative K s y = dy ->
   derivative K s fx = add (mul fxx dx) (mul fxy dy) -> derivative K s fy = add (mul fxy dx) (mul fyy dy) ->
   P K (Implicit (homogeneous s [x; y] (number 1) []) [pace] [fx; fy] [[fxx; fxy]; [fxy; fyy]])) ->
  every_implicit_curve P.
Proof.
  intros H K x y pace fx fy fxx fxy fyy c V C. unfold chain_rule in C. unfold c in *. clear c.
  rewrite polynomial_is_homogeneous in *. cbn [on_level gamma homogeneous gradient_f hessian_f free] in *.
  injection V as Vx Vy. injection C as Cx Cy. rewrite Vx, Vy in Cx, Cy. now apply H.
Qed.

Lemma implicit_surface_by_position (P : forall K : differential_field, implicit K -> Prop) :
  (forall (K : differential_field) (x y z l m n fx fy fz fxx fxy fxz fyy fyz fzz : K),
   let dx := sub (mul fy n) (mul fz m) in
   let dy := sub (mul fz l) (mul fx n) in
   let dz := sub (mul fx m) (mul fy l) in
   derivative K s x = dx -> derivative K s y = dy -> derivative K s z = dz ->
   derivative K s fx = add (add (mul fxx dx) (mul fxy dy)) (mul fxz dz) ->
   derivative K s fy = add (add (mul fxy dx) (mul fyy dy)) (mul fyz dz) ->
   derivative K s fz = add (add (mul fxz dx) (mul fyz dy)) (mul fzz dz) ->
   P K (Implicit (homogeneous s [x; y; z] (number 1) []) [l; m; n] [fx; fy; fz]
     [[fxx; fxy; fxz]; [fxy; fyy; fyz]; [fxz; fyz; fzz]])) ->
  every_implicit_surface P.
Proof.
  intros H K x y z l m n fx fy fz fxx fxy fxz fyy fyz fzz c V C. unfold chain_rule in C. unfold c in *. clear c.
  rewrite polynomial_is_homogeneous in *. cbn [on_level gamma homogeneous gradient_f hessian_f free] in *.
  injection V as Vx Vy Vz. injection C as Cx Cy Cz. rewrite Vx, Vy, Vz in Cx, Cy, Cz. now apply H.
Qed.

Lemma surface_by_position (P : forall K : differential_field, patch K -> Prop) :
  (forall (K : differential_field) (x y z w : K), commuting K -> w <> zero K ->
   P K (Patch (homogeneous s [x; y; z] w []))) -> every_surface P.
Proof. intros H K x y z w C Hw. rewrite rational_is_homogeneous by exact Hw. now apply H. Qed.

Lemma planar_map_by_position (P : forall K : differential_field, patch K -> Prop) :
  (forall (K : differential_field) (x y w : K), commuting K -> w <> zero K ->
   P K (Patch (homogeneous s [x; y] w []))) -> every_planar_map P.
Proof. intros H K x y w C Hw. rewrite rational_is_homogeneous by exact Hw. now apply H. Qed.

(** ** Roots *)

Section OneRoot.
Variable K : differential_field.
Add Field K2 : (field_axioms K).

Lemma root_nonzero (y square : K) : times K y y = square -> square <> zero K -> y <> zero K.
Proof. intros <- N Z. apply N. rewrite Z. ring. Qed.

Lemma root_inverse (y : K) : y <> zero K -> times K (quotient K (one K) y) y = one K.
Proof. intro N. field. exact N. Qed.

(** σ′ from σ² = S, and with it (1/σ)′; [half] is half of S′. *)
Lemma root_derivative (y square half : K) : times K y y = square -> y <> zero K -> integer K 2 <> zero K ->
  derivative K s square = plus K half half -> derivative K s y = times K half (quotient K (one K) y).
Proof.
  intros <- N T H. rewrite derivative_times in H.
  assert (E : integer K 2 = plus K (one K) (one K)) by reflexivity. rewrite E in T.
  assert (D : times K (plus K (one K) (one K)) (times K (derivative K s y) y)
              = times K (plus K (one K) (one K)) half) by (transitivity (plus K half half); [rewrite <- H|]; ring).
  transitivity (quotient K (times K (plus K (one K) (one K)) (times K (derivative K s y) y))
                           (times K (plus K (one K) (one K)) y)); [field; auto|].
  rewrite D. field. auto.
Qed.

Lemma inverse_derivative (y half : K) : y <> zero K -> derivative K s y = times K half (quotient K (one K) y) ->
  derivative K s (quotient K (one K) y) = opposite K (times K half (repeated K (quotient K (one K) y) 3)).
Proof.
  intros N H. rewrite derivative_quotient by exact N. rewrite H, derivative_one. simpl. field. exact N.
Qed.
End OneRoot.

(** ** Jets *)

Definition jets {K : differential_field} (q : parameter) (order : nat) (x : K) : list K :=
  map (fun k => ders q k x) (seq 0 (S order)).

(** The rules of so many variables, each the derivative of the one before. *)
Fixpoint chain (i : positive) (order : nat) : rules :=
  match order with 0 => [] | S n => (i, var (Pos.succ i)) :: chain (Pos.succ i) n end.

Definition constants (is : list positive) : rules := map (fun i => (i, num 0)) is.

Definition of_parameters (first second : rules) (q : parameter) : rules :=
  match q with s => first | s_bar => second | time => [] end.

Definition of_three_parameters (first second third : rules) (q : parameter) : rules :=
  match q with s => first | s_bar => second | time => third end.

(** The partial derivatives up to an order: row by row, in the n-th row first all by u, at last all by v. *)
Definition partials {K : differential_field} (order : nat) (x : K) : list K :=
  flat_map (fun n => map (fun j => ders s (n - j) (ders s_bar j x)) (seq 0 (S n))) (seq 0 (S order)).

(** Their rules: to the next row, to the place below ([right = 0], by u) or to that right of it ([right = 1], by v). *)
Definition grid (i : positive) (order right : nat) : rules :=
  let place n j := Pos.of_nat (Pos.to_nat i + Nat.div2 (n * S n) + j) in
  flat_map (fun n => map (fun j => (place n j, var (place (S n) (j + right)%nat))) (seq 0 (S n))) (seq 0 order).

(** Their rules along a curve on the surface, where u′ and v′ are variables: the chain rule. *)
Definition chained (i : positive) (order : nat) (u v : positive) : rules :=
  let place n j := Pos.of_nat (Pos.to_nat i + Nat.div2 (n * S n) + j) in
  flat_map (fun n => map (fun j =>
    (place n j, eadd (emul (var (place (S n) j)) (var u)) (emul (var (place (S n) (S j))) (var v)))) (seq 0 (S n)))
    (seq 0 order).

Lemma commuted (K : differential_field) (a : K) n : commuting K ->
  derivative K s_bar (ders s n a) = ders s n (derivative K s_bar a).
Proof.
  intro C. induction n as [|n IH]; [reflexivity|].
  change (ders s (S n) a) with (derivative K s (ders s n a)).
  change (ders s (S n) (derivative K s_bar a)) with (derivative K s (ders s n (derivative K s_bar a))).
  rewrite <- IH. symmetry. apply C.
Qed.

(** Along a curve the functions of u and v that obey the chain rule are a field. *)
Section Composed.
Variable K : differential_field.
Variable u v : K.
Add Field K_composed : (field_axioms K).

Lemma composed_once n a : composed u v n a -> composed u v 0 a.
Proof. destruct n as [|n]; [easy|]. intros [E _]. now split. Qed.

Lemma composed_less n : forall a, composed u v (S n) a -> composed u v n a.
Proof.
  induction n as [|n IH]; intros a [E [Hu Hv]]; (split; [exact E|]); [exact I|]. split; apply IH; assumption.
Qed.

Lemma composed_plus n : forall a b, composed u v n a -> composed u v n b -> composed u v n (plus K a b).
Proof.
  induction n as [|n IH]; intros a b [Ea Ha] [Eb Hb]; cbn [composed]; rewrite !derivative_plus, Ea, Eb;
    (split; [ring|]); [exact I|].
  split; apply IH; easy.
Qed.

Lemma composed_times n : forall a b, composed u v n a -> composed u v n b -> composed u v n (times K a b).
Proof.
  induction n as [|n IH]; intros a b Ha Hb.
  - destruct Ha as [Ea _], Hb as [Eb _]. split; [|exact I]. rewrite !derivative_times, Ea, Eb. ring.
  - pose proof (composed_less n a Ha). pose proof (composed_less n b Hb). destruct Ha as [Ea [Au Av]], Hb as [Eb [Bu Bv]].
    cbn [composed]. rewrite !derivative_times, Ea, Eb. split; [ring|].
    split; apply composed_plus; now apply IH.
Qed.

Lemma derivative_inverse q (b : K) : b <> zero K ->
  derivative K q (quotient K (one K) b) =
  times K (opposite K (derivative K q b)) (times K (quotient K (one K) b) (quotient K (one K) b)).
Proof. intro N. rewrite derivative_quotient by exact N. rewrite derivative_one. field. exact N. Qed.

Lemma composed_opposite n : forall a, composed u v n a -> composed u v n (opposite K a).
Proof.
  induction n as [|n IH]; intros a [Ea Ha]; cbn [composed]; rewrite !derivative_opposite, Ea; (split; [ring|]); [exact I|].
  split; now apply IH.
Qed.

Lemma composed_inverse (b : K) : b <> zero K -> forall n, composed u v n b -> composed u v n (quotient K (one K) b).
Proof.
  intros N n. induction n as [|n IH]; intro Hb.
  - destruct Hb as [E _]. split; [|exact I]. rewrite !derivative_inverse by exact N. rewrite E. ring.
  - pose proof (IH (composed_less n b Hb)) as Hi. destruct Hb as [E [Hu Hv]]. cbn [composed].
    rewrite !derivative_inverse by exact N. rewrite E. split; [ring|].
    split; apply composed_times; try (apply composed_times; exact Hi); now apply composed_opposite.
Qed.

Lemma composed_quotient n (a b : K) : b <> zero K -> composed u v n a -> composed u v n b ->
  composed u v n (quotient K a b).
Proof.
  intros N Ha Hb. replace (quotient K a b) with (times K a (quotient K (one K) b)) by (field; exact N).
  apply composed_times; [exact Ha | now apply composed_inverse].
Qed.

Lemma composed_by_v j : forall n a, composed u v (j + n) a -> composed u v n (ders s_bar j a).
Proof.
  induction j as [|j IH]; intros n a H; [exact H|].
  change (ders s_bar (S j) a) with (derivative K s_bar (ders s_bar j a)).
  apply (IH (S n) a). now rewrite Nat.add_succ_r.
Qed.

Lemma composed_by_u i : forall n a, composed u v (i + n) a -> composed u v n (ders s i a).
Proof.
  induction i as [|i IH]; intros n a H; [exact H|].
  change (ders s (S i) a) with (derivative K s (ders s i a)).
  apply (IH (S n) a). now rewrite Nat.add_succ_r.
Qed.

(** The chain rule for a partial derivative, where the derivatives by u and v commute. *)
Lemma along_the_curve (a : K) : commuting K -> (forall n, composed u v n a) -> forall i j,
  derivative K time (ders s i (ders s_bar j a)) =
  plus K (times K (ders s (S i) (ders s_bar j a)) (derivative K time u))
         (times K (ders s i (ders s_bar (S j) a)) (derivative K time v)).
Proof.
  intros C H i j.
  destruct (composed_by_u i 0 _ (composed_by_v j (i + 0) a (H _))) as [E _]. rewrite E.
  now rewrite (commuted K (ders s_bar j a) i C).
Qed.
End Composed.

Lemma curve_on_a_surface_by_position (P : forall K : differential_field, path K -> Prop) :
  (forall (K : differential_field) (u v x y z w : K), commuting K ->
   (forall n, composed u v n x) -> (forall n, composed u v n y) -> (forall n, composed u v n z) ->
   (forall n, composed u v n w) -> w <> zero K ->
   P K (Path (Patch (homogeneous time [x; y; z] w [])) [u; v])) -> every_curve_on_a_surface P.
Proof.
  intros H K u v x y z w C F Hw. rewrite rational_is_homogeneous by exact Hw.
  assert (G : forall n, (composed u v n x /\ composed u v n y) /\ composed u v n z /\ composed u v n w).
  { intro n. specialize (F n). repeat match goal with H : Forall _ (_ :: _) |- _ => inversion_clear H end. easy. }
  apply H; try assumption; intro n; try apply composed_quotient; try apply G; exact Hw.
Qed.

Ltac by_chain_rule :=
  match goal with C : commuting _, F : forall n, composed _ _ n _ |- _ => first
    [exact (along_the_curve _ _ _ _ C F 0 0) | exact (along_the_curve _ _ _ _ C F 1 0)
    | exact (along_the_curve _ _ _ _ C F 0 1) | exact (along_the_curve _ _ _ _ C F 2 0)
    | exact (along_the_curve _ _ _ _ C F 1 1) | exact (along_the_curve _ _ _ _ C F 0 2)] end.

Ltac rules_by_computation :=
  let q := fresh in intro q; destruct q; repeat (apply Forall_cons; [first [reflexivity | match goal with
    H : constant _ |- _ => exact (H _) | C : commuting _ |- _ => first
      [exact (commuted _ _ 1 C) | exact (commuted _ _ 2 C) | exact (commuted _ _ 3 C) | exact (commuted _ _ 4 C)]
    | H : _ = _ |- _ => exact H end | by_chain_rule]|]); apply Forall_nil.

(** ** Atoms *)

Section Atoms.
Variable K : differential_field.
Variable l : list K.
Variable r : parameter -> rules.
Hypothesis Hr : forall q, rules_hold K l q (r q).
Variable roots : list expr.
Hypothesis Hs : roots_hold K l roots.

Definition polynomial (e : expr) : poly := match norm [] [] [] r e with Some (a, []) => a | _ => Pc 0%Z end.
Definition is_polynomial (e : expr) : bool := match norm [] [] [] r e with Some (_, []) => true | _ => false end.

Definition all_nonzero (es : list expr) : Prop := Forall (fun e => value K l e <> zero K) es.

Lemma nonzero_polynomials es :
  forallb is_polynomial es = true -> all_nonzero es -> Forall (nonzero K l) (map polynomial es).
Proof.
  induction es as [|e es IH]; intros H N; [constructor|].
  simpl in H. apply andb_prop in H. destruct H as [He H]. inversion N; subst. constructor; [|now apply IH].
  unfold is_polynomial in He. unfold polynomial.
  destruct (norm [] [] [] r e) as [[a [|? ?]]|] eqn:E; try discriminate.
  exact (atom_nonzero K l [] [] [] r Hr I (Forall_nil _) e a E H2).
Qed.

Lemma and_nonzero es e : all_nonzero es -> value K l e <> zero K -> all_nonzero (es ++ [e]).
Proof. intros H N. apply Forall_app. split; [exact H | now constructor]. Qed.

Variable es : list expr.
Variable known : list (list nat * list nat).
Hypothesis Hes : all_nonzero es.

(** Two expressions are one. *)
Lemma one_value a b :
  forallb is_polynomial es && equal (map polynomial es) roots known r a b = true -> value K l a = value K l b.
Proof.
  intro H. apply andb_prop in H. destruct H as [P E].
  exact (equal_sound K l _ roots known r Hr Hs (nonzero_polynomials es P Hes) a b E).
Qed.

(** Two vectors are one. *)
Lemma one_vector a b :
  forallb is_polynomial es && all_equal (map polynomial es) roots known r a b = true ->
  map (value K l) a = map (value K l) b.
Proof.
  intro H. apply andb_prop in H. destruct H as [P E].
  exact (all_equal_sound K l _ roots known r Hr Hs (nonzero_polynomials es P Hes) a b E).
Qed.

(** What divides something that is not zero. *)
Lemma factor_nonzero e b a :
  forallb is_polynomial es && equal (map polynomial es) roots known r e (emul b a) = true ->
  value K l e <> zero K -> value K l a <> zero K.
Proof.
  intro H. apply andb_prop in H. destruct H as [P E].
  exact (divisor_nonzero K l _ roots known r Hr Hs (nonzero_polynomials es P Hes) e b a E).
Qed.

Add Field K' : (field_axioms K).

(** What would, with its derivative, make something vanish that does not. *)
Lemma differential_factor_nonzero e b c a :
  forallb is_polynomial es &&
    equal (map polynomial es) roots known r e (eadd (emul b a) (emul c (eder s a))) = true ->
  value K l e <> zero K -> value K l a <> zero K.
Proof.
  intro H. apply andb_prop in H. destruct H as [P E]. intros N Z. apply N.
  rewrite (equal_sound K l _ roots known r Hr Hs (nonzero_polynomials es P Hes) _ _ E). simpl. rewrite Z.
  rewrite derivative_zero. ring.
Qed.

(** What is a product of atoms. *)
Definition is_unit (e : expr) : bool :=
  match norm (map polynomial es) roots known r e with
  | Some b => match recognized (map polynomial es) roots b known with Some _ => true | None => false end
  | None => false
  end.

Lemma unit_nonzero e : forallb is_polynomial es && is_unit e = true -> value K l e <> zero K.
Proof.
  intro H. apply andb_prop in H. destruct H as [P E]. unfold is_unit in E.
  pose proof (nonzero_polynomials es P Hes) as N.
  destruct (norm (map polynomial es) roots known r e) as [b|] eqn:En; [|discriminate].
  destruct (recognized (map polynomial es) roots b known) as [[[positive top] bottom]|] eqn:Eb; [|discriminate].
  pose proof (recognized_sound K l _ roots known Hs N b positive top bottom Eb) as H.
  intro Z. rewrite <- (norm_sound K l _ roots known r Hr Hs N e b En) in Z.
  assert (Hb : at_point K l (fst b) = zero K).
  { transitivity (times K (quotient K (at_point K l (fst b)) (at_point K l (product (map polynomial es) (snd b))))
                          (at_point K l (product (map polynomial es) (snd b)))).
    - field. now apply den_nonzero.
    - rewrite Z. ring. }
  rewrite Hb in H.
  assert (NZ : times K (at_point K l (product (map polynomial es) top))
                       (at_point K l (product (map polynomial es) (snd b))) <> zero K)
    by (apply product_nonzero; now apply den_nonzero).
  apply NZ. destruct positive.
  - transitivity (times K (one K) (times K (at_point K l (product (map polynomial es) top))
      (at_point K l (product (map polynomial es) (snd b))))); [ring|]. rewrite <- H. ring.
  - transitivity (opposite K (times K (opposite K (one K)) (times K (at_point K l (product (map polynomial es) top))
      (at_point K l (product (map polynomial es) (snd b)))))); [ring|]. rewrite <- H. ring.
Qed.

End Atoms.

(** ** Ruled surfaces *)

Section Surfaces.
Variable K : differential_field.
Add Field K'' : (field_axioms K).

Lemma three (a b c x y z : K) : a = x -> b = y -> c = z -> [a; b; c] = [x; y; z].
Proof. now intros -> -> ->. Qed.

Lemma proportional (a b : list K) : length a = 3 -> length b = 3 ->
  (exists x : list K, length x = 3 /\ dot a x <> zero K) -> cross a b = [zero K; zero K; zero K] ->
  exists k, b = vmul k a.
Proof.
  intros La Lb [x [Lx N]] H.
  destruct a as [|a0 [|a1 [|a2 [|]]]]; try discriminate.
  destruct b as [|b0 [|b1 [|b2 [|]]]]; try discriminate.
  destruct x as [|x0 [|x1 [|x2 [|]]]]; try discriminate.
  unfold cross, dot, component, vmul in *. simpl in *. injection H as H0 H1 H2.
  set (n := plus K (plus K (times K a0 x0) (times K a1 x1)) (times K a2 x2)) in *.
  set (m := plus K (plus K (times K b0 x0) (times K b1 x1)) (times K b2 x2)).
  exists (quotient K m n).
  assert (E0 : times K a1 b2 = times K a2 b1).
  { transitivity (plus K (minus K (times K a1 b2) (times K a2 b1)) (times K a2 b1)); [ring|]. rewrite H0. ring. }
  assert (E1 : times K a2 b0 = times K a0 b2).
  { transitivity (plus K (minus K (times K a2 b0) (times K a0 b2)) (times K a0 b2)); [ring|]. rewrite H1. ring. }
  assert (E2 : times K a0 b1 = times K a1 b0).
  { transitivity (plus K (minus K (times K a0 b1) (times K a1 b0)) (times K a1 b0)); [ring|]. rewrite H2. ring. }
  assert (M0 : times K b0 n = times K a0 m).
  { unfold m, n. transitivity (plus K (plus K (times K (times K a0 b0) x0) (times K (times K a1 b0) x1))
                         (times K (times K a2 b0) x2)); [ring|]. rewrite <- E2, E1. ring. }
  assert (M1 : times K b1 n = times K a1 m).
  { unfold m, n. transitivity (plus K (plus K (times K (times K a0 b1) x0) (times K (times K a1 b1) x1))
                         (times K (times K a2 b1) x2)); [ring|]. rewrite E2, <- E0. ring. }
  assert (M2 : times K b2 n = times K a2 m).
  { unfold m, n. transitivity (plus K (plus K (times K (times K a0 b2) x0) (times K (times K a1 b2) x1))
                         (times K (times K a2 b2) x2)); [ring|]. rewrite <- E1, E0. ring. }
  clearbody m. apply three.
  - transitivity (quotient K (times K b0 n) n); [field; exact N|]. rewrite M0. field. exact N.
  - transitivity (quotient K (times K b1 n) n); [field; exact N|]. rewrite M1. field. exact N.
  - transitivity (quotient K (times K b2 n) n); [field; exact N|]. rewrite M2. field. exact N.
Qed.

(** Parallel generators, neither of them zero, and directrices that differ along them. *)
Lemma one_surface (d g e h : list K) :
  length d = 3 -> length g = 3 -> length e = 3 -> length h = 3 ->
  (exists x : list K, length x = 3 /\ dot g x <> zero K) -> (exists x : list K, length x = 3 /\ dot h x <> zero K) ->
  cross g h = [zero K; zero K; zero K] -> cross g (vsub e d) = [zero K; zero K; zero K] ->
  same_surface (d, g) (e, h).
Proof.
  intros Ld Lg Le Lh Ng Nh H1 H2.
  destruct (proportional g h Lg Lh Ng H1) as [k Hk].
  assert (Lv : length (vsub e d) = 3).
  { destruct d as [|? [|? [|? [|]]]]; try discriminate. destruct e as [|? [|? [|? [|]]]]; try discriminate.
    reflexivity. }
  destruct (proportional g (vsub e d) Lg Lv Ng H2) as [m Hm].
  destruct d as [|d0 [|d1 [|d2 [|]]]]; try discriminate.
  destruct e as [|e0 [|e1 [|e2 [|]]]]; try discriminate.
  destruct g as [|g0 [|g1 [|g2 [|]]]]; try discriminate.
  unfold vsub, vmul in *. simpl in Hm, Hk. subst h. injection Hm as M0 M1 M2.
  assert (E0 : e0 = plus K d0 (times K g0 m)) by (rewrite <- M0; ring).
  assert (E1 : e1 = plus K d1 (times K g1 m)) by (rewrite <- M1; ring).
  assert (E2 : e2 = plus K d2 (times K g2 m)) by (rewrite <- M2; ring).
  assert (Nk : k <> zero K).
  { intro Z. destruct Nh as [x [Lx N]]. apply N. destruct x as [|x0 [|x1 [|x2 [|]]]]; try discriminate.
    unfold dot. simpl. rewrite Z. ring. }
  intro x. unfold on_ruling, directrix, generator, vadd, vmul. simpl. split; intros [z ->].
  - exists (quotient K (minus K z m) k). rewrite E0, E1, E2. apply three; field; exact Nk.
  - exists (plus K m (times K z k)). rewrite E0, E1, E2. apply three; ring.
Qed.

End Surfaces.

(** ** One explicit curve *)

(** No integer but 0 vanishes. *)
Definition characteristic_zero (K : differential_field) : Prop :=
  forall z : Z, z <> 0%Z -> integer K z <> zero K.

Section Explicit.
Variable K : differential_field.
Variable t : K.
Hypothesis Hz : characteristic_zero K.
Hypothesis Ht : derivative K s t = one K.
Add Field K3 : (field_axioms K).

Definition explicit_rules : parameter -> rules := of_parameters [(1%positive, num 1)] [].

Lemma explicit_rules_hold q : rules_hold K [t] q (explicit_rules q).
Proof. destruct q; [apply Forall_cons; [exact Ht|] | |]; apply Forall_nil. Qed.

(** A polynomial that becomes a constant other than 0 after so many derivatives. *)
Fixpoint constant_after (n : nat) (a : poly) : bool :=
  match n with
  | 0 => match a with Pc z => negb (Z.eqb z 0) | _ => false end
  | S n => match dpoly (explicit_rules s) 0 a with Some a => constant_after n a | None => false end
  end.

Lemma constant_after_sound n : forall a, constant_after n a = true -> at_point K [t] a <> zero K.
Proof.
  induction n as [|n IH]; intros a H.
  - destruct a as [z| |]; try discriminate. apply Hz. intros ->. discriminate.
  - cbn [constant_after] in H. destruct (dpoly (explicit_rules s) 0 a) as [d|] eqn:E; [|discriminate].
    intro Z. apply (IH d H).
    rewrite <- (dpoly_sound K [t] s (explicit_rules s) (explicit_rules_hold s) a 0 d E).
    change (jumped K [t] 0) with [t]. unfold at_point in Z. rewrite Z. apply derivative_zero.
Qed.

Lemma explicit_nonzero n e : 
  is_polynomial explicit_rules e && constant_after n (polynomial explicit_rules e) = true ->
  value K [t] e <> zero K.
Proof.
  intro H. apply andb_prop in H. destruct H as [P C]. unfold is_polynomial in P. unfold polynomial in C.
  destruct (norm [] [] [] explicit_rules e) as [[a [|? ?]]|] eqn:E; try discriminate.
  rewrite <- (norm_sound K [t] [] [] [] explicit_rules explicit_rules_hold I (Forall_nil _) e _ E). cbn [fst snd].
  apply constant_after_sound in C. intro Z. apply C.
  rewrite den_nil in Z. rewrite <- Z. field. apply (F_1_neq_0 (field_axioms K)).
Qed.

Lemma different (a b : K) : minus K a b <> zero K -> a <> b.
Proof. intros N ->. apply N. ring. Qed.

Lemma different_vectors (i : nat) (a b : list K) :
  minus K (component i a) (component i b) <> zero K -> a <> b.
Proof. intros N ->. apply N. ring. Qed.

Lemma parallel_of_one_surface (d g e h : list K) :
  length d = 3 -> length g = 3 -> length e = 3 -> length h = 3 -> same_surface (d, g) (e, h) ->
  cross g h = [zero K; zero K; zero K] /\ cross g (vsub e d) = [zero K; zero K; zero K].
Proof.
  intros Ld Lg Le Lh H.
  destruct (proj2 (H (vadd e (vmul (zero K) h)))) as [m Hm]; [now exists (zero K)|].
  destruct (proj2 (H (vadd e (vmul (one K) h)))) as [n Hn]; [now exists (one K)|].
  destruct d as [|d0 [|d1 [|d2 [|]]]]; try discriminate.
  destruct e as [|e0 [|e1 [|e2 [|]]]]; try discriminate.
  destruct g as [|g0 [|g1 [|g2 [|]]]]; try discriminate.
  destruct h as [|h0 [|h1 [|h2 [|]]]]; try discriminate.
  unfold vadd, vmul, cross, vsub, component, directrix, generator in *. simpl in *.
  injection Hm as M0 M1 M2. injection Hn as N0 N1 N2.
  assert (E0 : e0 = plus K d0 (times K g0 m)) by (rewrite <- M0; ring).
  assert (E1 : e1 = plus K d1 (times K g1 m)) by (rewrite <- M1; ring).
  assert (E2 : e2 = plus K d2 (times K g2 m)) by (rewrite <- M2; ring).
  assert (F0 : h0 = times K g0 (minus K n m)).
  { transitivity (minus K (plus K e0 (times K h0 (one K))) e0); [ring|]. rewrite N0, E0. ring. }
  assert (F1 : h1 = times K g1 (minus K n m)).
  { transitivity (minus K (plus K e1 (times K h1 (one K))) e1); [ring|]. rewrite N1, E1. ring. }
  assert (F2 : h2 = times K g2 (minus K n m)).
  { transitivity (minus K (plus K e2 (times K h2 (one K))) e2); [ring|]. rewrite N2, E2. ring. }
  split; apply three; rewrite ?F0, ?F1, ?F2, ?E0, ?E1, ?E2; ring.
Qed.

End Explicit.

(** ** The osculating sphere *)

Section Sphere.
Variable K : differential_field.
Add Field K4 : (field_axioms K).
Local Open Scope formula_scope.

(** With a = γ′, k = κN, b = (κ²)′ and τ, of which k·a = 0 is all that is used: what remains of the radius. *)
Lemma radius_of_the_sphere (g1 g2 g3 a1 a2 a3 k1 k2 k3 b t : K) :
  let g := [g1; g2; g3] in
  let a := [a1; a2; a3] in
  let k := [k1; k2; k3] in
  let S := dot a a in
  let B := dot k k in
  let v := vsub (vsub (vadd g (vdiv k B)) (vmul (b / (number 2 * S * B ^ 2 * t)) (cross a k))) g in
  number 2 <> zero K -> dot k a = zero K -> S <> zero K -> B <> zero K -> t <> zero K ->
  b ^ 2 / S - number 4 * t ^ 2 * B ^ 2 * (B - number 1) = number 4 * B ^ 3 * t ^ 2 * (dot v v - number 1).
Proof.
  intros g a k S B v H2 O HS HB Ht.
  pose (q := b / (number 2 * S * B ^ 2 * t)).
  assert (E : dot v v = number 1 / B + S * B * q ^ 2).
  { assert (L : dot v v = B / (B * B) + (S * B - dot k a * dot k a) * q ^ 2).
    { unfold v. fold q. clearbody q. clear v. unfold vsub, vadd, vmul, vdiv, cross, component, g, k, a.
      cbn [map zip nth].
      assert (Z : times K B (number 1 / B) = one K) by (simpl; field; exact HB).
      set (i := number 1 / B) in *.
      assert (D : forall x : K, x / B = x * i) by (intro x; unfold i; simpl; field; exact HB).
      rewrite !D. unfold dot. cbn [sum_from].
      transitivity (plus K (times K (times K B i) i) (times K (minus K (times K S B)
        (times K (plus K (plus K (times K k1 a1) (times K k2 a2)) (times K k3 a3))
                 (plus K (plus K (times K k1 a1) (times K k2 a2)) (times K k3 a3)))) (times K q q))).
      - unfold B, S. simpl. ring.
      - rewrite Z. unfold i, k, a, dot. cbn [sum_from]. simpl. field. exact HB. }
    rewrite L, O. simpl. field. exact HB. }
  rewrite E. unfold q. clearbody S B. clear E v.
  change (number 4) with (times K (plus K (one K) (one K)) (plus K (one K) (one K))).
  change (number 2) with (plus K (one K) (one K)) in *. change (number 1) with (one K).
  cbn -[plus times minus quotient one] in *. field. repeat split; assumption.
Qed.
End Sphere.

(** ** The curvature of a curve on a surface *)

Section OnSurface.
Variable K : differential_field.
Add Field K5 : (field_axioms K).
Local Open Scope formula_scope.

(** With a = γ′, b = γ″ and a vector n at right angles to a, of which nothing else is used: Gram's determinant. *)
Lemma curvature_by_the_normal (a1 a2 a3 b1 b2 b3 n1 n2 n3 first second area : K) :
  let a := [a1; a2; a3] in
  let b := [b1; b2; b3] in
  let n := [n1; n2; n3] in
  dot a n = zero K -> dot a a = first -> dot b n = second -> dot n n = area -> first ^ 2 * area <> zero K ->
  dot (cross a b) (cross a b) / dot a a ^ 3 =
  second ^ 2 / (first ^ 2 * area) + det [a; b; n] ^ 2 / (first ^ 3 * area).
Proof.
  intros a b n O F S A N.
  assert (HF : first <> zero K) by (intro Z; apply N; rewrite Z; simpl; ring).
  assert (HA : area <> zero K) by (intro Z; apply N; rewrite Z; simpl; ring).
  assert (G : det [a; b; n] ^ 2 = dot (cross a b) (cross a b) * dot n n - dot b n ^ 2 * dot a a
    + dot a n * (number 2 * dot a b * dot b n - dot a n * dot b b)).
  { unfold a, b, n. cbv -[element plus times minus opposite zero one]. ring. }
  rewrite O, F, S, A in G. rewrite F, G.
  clear - HF HA. set (X := dot (cross a b) (cross a b)). clearbody X. simpl. field. easy.
Qed.
End OnSurface.
