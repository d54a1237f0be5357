(** What theorems assume can be fulfilled: a differential field of characteristic 0 with three derivations that commute,
    and a variable for each of them. It is that of the rational functions of three variables, made without any axiom.

    A polynomial is told by its values at integers; a rational function is the first fraction, in a list of all of them,
    among those that are one function. *)

Require Import ZArith List Bool Lia Ring Cantor Eqdep_dec Setoid Morphisms Field_theory.
From ExactSpline Require Import Base Reflection Proofs.
Import ListNotations.
Local Open Scope Z_scope.

(** ** Polynomials in [n] variables: lists of coefficients that are polynomials in one variable less *)

Fixpoint P (n : nat) : Type := match n with O => Z | S n => list (P n) end.
Fixpoint place (n : nat) : Type := match n with O => unit | S n => (place n * Z)%type end.

Fixpoint at_ {n : nat} : P n -> place n -> Z :=
  match n with
  | O => fun a _ => a
  | S n => fun a e => fold_right (fun c r => at_ c (fst e) + snd e * r) 0 a
  end.

Fixpoint of_integer (n : nat) (z : Z) : P n := match n with O => z | S n => [of_integer n z] end.

Definition paired {A : Type} (f : A -> A -> A) : list A -> list A -> list A :=
  fix go a b := match a, b with [], b => b | a, [] => a | x :: a, y :: b => f x y :: go a b end.

Fixpoint plus_ {n : nat} : P n -> P n -> P n :=
  match n with O => Z.add | S n => paired (@plus_ n) end.

Fixpoint opposite_ {n : nat} : P n -> P n :=
  match n with O => Z.opp | S n => map (@opposite_ n) end.

Fixpoint times_ {n : nat} : P n -> P n -> P n :=
  match n with
  | O => Z.mul
  | S n => fun a b => fold_right (fun c r => paired (@plus_ n) (map (times_ c) b) (of_integer n 0 :: r)) [] a
  end.

Fixpoint null {n : nat} : P n -> bool :=
  match n with O => Z.eqb 0 | S n => forallb (@null n) end.

(** The derivative by the last variable, and by any of them. *)
Fixpoint outer {n : nat} (a : list (P n)) : list (P n) :=
  match a with [] => [] | c :: a => paired (@plus_ n) a (of_integer n 0 :: outer a) end.

Fixpoint d_ {n : nat} (i : nat) : P n -> P n :=
  match n with
  | O => fun _ => 0
  | S n => if Nat.eqb i n then @outer n else map (@d_ n i)
  end.

Lemma at_integer n z e : at_ (of_integer n z) e = z.
Proof. induction n as [|n IH]; [reflexivity|]. cbn. rewrite IH. ring. Qed.

Lemma at_plus_ n : forall a b e, at_ (plus_ a b : P n) e = at_ a e + at_ b e.
Proof.
  induction n as [|n IH]; [reflexivity|]. intros a. change (list (P n)) in (type of a).
  induction a as [|x a IHa]; intros b e; [cbn; ring|]. destruct b as [|y b]; [cbn; ring|].
  specialize (IHa b e). cbn in *. rewrite IHa, IH. ring.
Qed.

Lemma at_opposite_ n : forall a e, at_ (opposite_ a : P n) e = - at_ a e.
Proof.
  induction n as [|n IH]; [reflexivity|]. intros a. change (list (P n)) in (type of a).
  induction a as [|x a IHa]; intros e; [reflexivity|]. specialize (IHa e). cbn in *. rewrite IHa, IH. ring.
Qed.

Lemma at_zero_first n (a : P (S n)) e : at_ (of_integer n 0 :: a : P (S n)) e = snd e * at_ a e.
Proof. cbn. rewrite at_integer. ring. Qed.

Lemma at_first n c (a : P (S n)) e : at_ (c :: a : P (S n)) e = at_ c (fst e) + snd e * at_ a e.
Proof. reflexivity. Qed.

Lemma times_first n c (a b : P (S n)) :
  times_ (c :: a : P (S n)) b = plus_ (map (times_ c) b : P (S n)) (of_integer n 0 :: times_ a b : P (S n)).
Proof. reflexivity. Qed.

Lemma at_times_ n : forall a b e, at_ (times_ a b : P n) e = at_ a e * at_ b e.
Proof.
  induction n as [|n IH]; [reflexivity|]. intros a b e. change (list (P n)) in (type of a).
  assert (M : forall c, at_ (map (times_ c) b : P (S n)) e = at_ c (fst e) * at_ b e).
  { intro c. change (list (P n)) in (type of b). induction b as [|y b IHb]; [cbn; ring|].
    cbn in *. rewrite IHb, IH. ring. }
  induction a as [|c a IHa]; [reflexivity|].
  rewrite times_first, at_plus_, M, at_zero_first, at_first. rewrite IHa. ring.
Qed.

(** *** Derivatives *)

Definition sum_rule {n : nat} (d : P n -> P n) : Prop :=
  forall a b e, at_ (d (plus_ a b)) e = at_ (d a) e + at_ (d b) e.

Lemma outer_plus n : sum_rule (@outer n : P (S n) -> P (S n)).
Proof.
  intros a. change (list (P n)) in (type of a). induction a as [|x a IH]; intros b e; [cbn; ring|].
  change (list (P n)) in (type of b). destruct b as [|y b]; [cbn; ring|].
  change (plus_ (x :: a : P (S n)) (y :: b : P (S n))) with (plus_ x y :: plus_ (a : P (S n)) (b : P (S n)) : P (S n)).
  cbn [outer]. change (paired plus_) with (@plus_ (S n)). rewrite !at_plus_, !at_zero_first, IH. ring.
Qed.

Lemma d_plus n i : sum_rule (@d_ n i).
Proof.
  revert i. induction n as [|n IH]; intro i; [intros a b e; reflexivity|]. cbn [d_].
  destruct (Nat.eqb i n); [apply outer_plus|].
  intros a. change (list (P n)) in (type of a). induction a as [|x a IHa]; intros b e; [cbn; ring|].
  change (list (P n)) in (type of b). destruct b as [|y b]; [cbn; ring|].
  change (plus_ (x :: a : P (S n)) (y :: b : P (S n))) with (plus_ x y :: plus_ (a : P (S n)) (b : P (S n)) : P (S n)).
  cbn [map]. rewrite !at_first, IHa, IH. ring.
Qed.

Lemma d_integer n i z e : at_ (d_ i (of_integer n z)) e = 0.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [d_ of_integer]. destruct (Nat.eqb i n); cbn [outer map].
  - change (paired plus_) with (@plus_ (S n)). rewrite at_plus_, at_zero_first. cbn. ring.
  - rewrite at_first, IH. cbn. ring.
Qed.

Lemma d_times n i : forall a b e, at_ (d_ i (times_ a b : P n)) e = at_ (d_ i a) e * at_ b e + at_ a e * at_ (d_ i b) e.
Proof.
  induction n as [|n IH]; [intros a b e; cbn; ring|]. intros a b e.
  assert (M : forall c, at_ (map (times_ c) b : P (S n)) e = at_ c (fst e) * at_ b e).
  { intro c. change (list (P n)) in (type of b). induction b as [|y b IHb]; [cbn; ring|].
    cbn [map]. rewrite !at_first, IHb, at_times_. ring. }
  change (list (P n)) in (type of a).
  induction a as [|c a IHa]; [cbn [d_]; destruct (Nat.eqb i n); reflexivity|].
  rewrite times_first, (d_plus (S n) i), at_first. cbn [d_] in *. destruct (Nat.eqb i n) eqn:E.
  - assert (D : at_ (outer (map (times_ c) b) : P (S n)) e = at_ c (fst e) * at_ (outer b : P (S n)) e).
    { clear IHa M. change (list (P n)) in (type of b). induction b as [|y b IHb]; [cbn; ring|].
      assert (M : at_ (map (times_ c) b : P (S n)) e = at_ c (fst e) * at_ (b : P (S n)) e).
      { clear IHb. induction b as [|z b IHb]; [cbn; ring|]. cbn [map]. rewrite !at_first, IHb, at_times_. ring. }
      cbn [map outer]. change (paired plus_) with (@plus_ (S n)).
      rewrite !at_plus_, !at_zero_first, M, IHb. ring. }
    rewrite D. cbn [outer]. change (paired plus_) with (@plus_ (S n)).
    rewrite !at_plus_, !at_zero_first, at_times_, IHa. ring.
  - assert (D : at_ (map (d_ i) (map (times_ c) b) : P (S n)) e =
      at_ (d_ i c) (fst e) * at_ b e + at_ c (fst e) * at_ (map (d_ i) b : P (S n)) e).
    { clear IHa M. change (list (P n)) in (type of b). induction b as [|y b IHb]; [cbn; ring|].
      cbn [map]. rewrite !at_first, IHb, IH. ring. }
    rewrite D. cbn [map]. rewrite !at_first, d_integer, IHa. ring.
Qed.

Lemma d_opposite n i a e : at_ (d_ i (opposite_ a : P n)) e = - at_ (d_ i a) e.
Proof.
  revert a e. induction n as [|n IH]; intros a e; [reflexivity|]. cbn [d_ opposite_]. destruct (Nat.eqb i n).
  - change (list (P n)) in (type of a). induction a as [|c a IHa]; [reflexivity|].
    cbn [map outer]. change (paired plus_) with (@plus_ (S n)). rewrite !at_plus_, !at_zero_first, IHa.
    change (map (@opposite_ n) a) with (@opposite_ (S n) a). rewrite at_opposite_. ring.
  - change (list (P n)) in (type of a). induction a as [|c a IHa]; [reflexivity|].
    cbn [map]. rewrite !at_first, IHa, IH. ring.
Qed.

Lemma d_commutes n i j a e : at_ (d_ i (d_ j a : P n)) e = at_ (d_ j (d_ i a)) e.
Proof.
  revert a e. induction n as [|n IH]; intros a e; [reflexivity|].
  assert (C : forall k (a : P (S n)), at_ (outer (map (d_ k) a) : P (S n)) e = at_ (map (d_ k) (outer a) : P (S n)) e).
  { intros k b. change (list (P n)) in (type of b). induction b as [|c b IHb]; [reflexivity|].
    cbn [map outer]. change (paired plus_) with (@plus_ (S n)).
    assert (S1 : at_ (map (d_ k) (@plus_ (S n) b (of_integer n 0 :: outer b)) : P (S n)) e =
                 at_ (map (d_ k) b : P (S n)) e + at_ (map (d_ k) (of_integer n 0 :: outer b) : P (S n)) e).
    { generalize (of_integer n 0 :: outer b). clear. intro r. revert r.
      induction b as [|x b IH]; intro r; [cbn; ring|]. destruct r as [|y r]; [cbn; ring|].
      change (plus_ (x :: b : P (S n)) (y :: r : P (S n)))
        with (plus_ x y :: plus_ (b : P (S n)) (r : P (S n)) : P (S n)).
      cbn [map]. rewrite !at_first, IH, d_plus. ring. }
    rewrite S1, !at_plus_. cbn [map]. rewrite at_zero_first, IHb, at_first, d_integer. ring. }
  cbn [d_]. destruct (Nat.eqb i n) eqn:Ei, (Nat.eqb j n) eqn:Ej; try reflexivity.
  - apply C.
  - symmetry. apply C.
  - change (list (P n)) in (type of a). induction a as [|c a IHa]; [reflexivity|].
    cbn [map]. rewrite !at_first, IHa, IH. reflexivity.
Qed.

(** *** Which polynomials are zero *)

Lemma null_is_zero n : forall a, null (a : P n) = true -> forall e, at_ a e = 0.
Proof.
  induction n as [|n IH]; intros a H e; [cbn in H; symmetry; now apply Z.eqb_eq|].
  change (list (P n)) in (type of a). induction a as [|c a IHa]; [reflexivity|].
  cbn in H. apply andb_prop in H. destruct H as [Hc Ha]. rewrite at_first, (IH c Hc), (IHa Ha). ring.
Qed.

Lemma null_d n i : forall a, null (a : P n) = true -> forall e, at_ (d_ i a) e = 0.
Proof.
  induction n as [|n IH]; intros a H e; [reflexivity|]. cbn [d_].
  change (list (P n)) in (type of a). destruct (Nat.eqb i n).
  - induction a as [|c a IHa]; [reflexivity|]. cbn in H. apply andb_prop in H. destruct H as [Hc Ha].
    cbn [outer]. change (paired plus_) with (@plus_ (S n)).
    rewrite at_plus_, at_zero_first, (IHa Ha), (null_is_zero (S n) a Ha). ring.
  - induction a as [|c a IHa]; [reflexivity|]. cbn in H. apply andb_prop in H. destruct H as [Hc Ha].
    cbn [map]. rewrite at_first, (IHa Ha), (IH c Hc). ring.
Qed.

(** For all large values of the last variable, each depending on the others, and so on. *)
Fixpoint eventually {n : nat} : (place n -> Prop) -> Prop :=
  match n with
  | O => fun p => p tt
  | S n => fun p => eventually (fun e => exists N, forall x, N < x -> p (e, x))
  end.

Lemma eventually_weaker n : forall p q : place n -> Prop, (forall e, p e -> q e) -> eventually p -> eventually q.
Proof.
  induction n as [|n IH]; intros p q H; [apply H|].
  apply IH. intros e [N HN]. exists N. intros x Hx. now apply H, HN.
Qed.

Lemma eventually_and n : forall p q : place n -> Prop, eventually p -> eventually q -> eventually (fun e => p e /\ q e).
Proof.
  induction n as [|n IH]; intros p q Hp Hq; [now split|].
  refine (eventually_weaker n _ _ _ (IH _ _ Hp Hq)). intros e [[N HN] [M HM]].
  exists (Z.max N M). intros x Hx. split; [apply HN | apply HM]; lia.
Qed.

Lemma eventually_not n : ~ eventually (fun _ : place n => False).
Proof.
  induction n as [|n IH]; [easy|]. intro H. apply IH. refine (eventually_weaker n _ _ _ H).
  intros e [N HN]. exact (HN (N + 1) ltac:(lia)).
Qed.

Lemma one_variable (a : list Z) : (exists c, In c a /\ c <> 0) ->
  exists N, forall x, N < x -> fold_right (fun c r => c + x * r) 0 a <> 0.
Proof.
  induction a as [|c a IH]; intros [k [I H]]; [destruct I|].
  destruct (forallb (Z.eqb 0) a) eqn:E.
  - assert (Z : forall x, fold_right (fun c r => c + x * r) 0 a = 0).
    { intro x. clear IH I. induction a as [|y a IHa]; [reflexivity|]. cbn [fold_right forallb] in *.
      apply andb_prop in E.
      destruct E as [E1 E2]. apply Z.eqb_eq in E1. rewrite IHa by exact E2. lia. }
    exists 0. intros x _. cbn. rewrite Z. destruct I as [->|I]; [lia|].
    exfalso. apply H. rewrite forallb_forall in E. specialize (E k I). apply Z.eqb_eq in E. lia.
  - destruct IH as [N HN].
    { clear I H. induction a as [|y a IHa]; [discriminate|]. cbn [forallb] in E. destruct (0 =? y) eqn:Ey.
      - destruct (IHa E) as [d [I H]]. exists d. split; [now right|exact H].
      - exists y. split; [now left|]. apply Z.eqb_neq in Ey. lia. }
    exists (Z.max N (Z.abs c)). intros x Hx. cbn. specialize (HN x ltac:(lia)). nia.
Qed.

Lemma not_null n : forall a, null (a : P n) = false -> eventually (fun e => at_ a e <> 0).
Proof.
  induction n as [|n IH]; intros a H; [cbn in *; intros E; rewrite E in H; discriminate|].
  assert (C : exists c, In c (a : list (P n)) /\ null c = false).
  { change (list (P n)) in (type of a). induction a as [|x a IHa]; [discriminate|]. cbn in H.
    destruct (null x) eqn:E; [|exists x; split; [now left|exact E]].
    destruct (IHa H) as [c [I Hc]]. exists c. split; [now right|exact Hc]. }
  destruct C as [c [I Hc]]. refine (eventually_weaker n _ _ _ (IH c Hc)). intros e N.
  destruct (one_variable (map (fun c => at_ c e) a)) as [M HM].
  { exists (at_ c e). split; [now apply (in_map (fun c => at_ c e)) | exact N]. }
  exists M. intros x Hx. specialize (HM x Hx). clear - HM. intro E. apply HM. clear HM.
  transitivity (at_ (a : P (S n)) (e, x)); [clear E|exact E].
  change (list (P n)) in (type of a). induction a as [|y a IHa]; [reflexivity|].
  cbn [map fold_right]. rewrite IHa. reflexivity.
Qed.

(** Two polynomials are one function. *)
Definition same_polynomial {n : nat} (a b : P n) : bool := null (plus_ a (opposite_ b)).

Lemma same_is_equal n (a b : P n) : same_polynomial a b = true <-> forall e, at_ a e = at_ b e.
Proof.
  unfold same_polynomial. split.
  - intros H e. pose proof (null_is_zero n _ H e) as Z. rewrite at_plus_, at_opposite_ in Z. lia.
  - intro H. destruct (null (plus_ a (opposite_ b))) eqn:E; [reflexivity|]. exfalso.
    apply (eventually_not n). refine (eventually_weaker n _ _ _ (not_null n _ E)).
    intros e N. apply N. rewrite at_plus_, at_opposite_, H. ring.
Qed.

Lemma no_divisor_of_zero n (a b : P n) : null b = false -> (forall e, at_ a e * at_ b e = 0) -> forall e, at_ a e = 0.
Proof.
  intros Hb H. destruct (null a) eqn:Ha; [now apply null_is_zero|]. exfalso.
  apply (eventually_not n).
  refine (eventually_weaker n _ _ _ (eventually_and n _ _ (not_null n a Ha) (not_null n b Hb))).
  intros e [A B]. specialize (H e). apply Z.mul_eq_0 in H. now destruct H.
Qed.

Lemma null_times n (a b : P n) : null a = false -> null b = false -> null (times_ a b) = false.
Proof.
  intros Ha Hb. destruct (null (times_ a b)) eqn:E; [|reflexivity]. exfalso.
  apply (eventually_not n). refine (eventually_weaker n _ _ _ (not_null n a Ha)). intros e N. apply N.
  apply (no_divisor_of_zero n a b Hb). intro e'. rewrite <- at_times_. now apply null_is_zero.
Qed.

Lemma d_respects n i (a b : P n) : (forall e, at_ a e = at_ b e) -> forall e, at_ (d_ i a) e = at_ (d_ i b) e.
Proof.
  intros H e. apply same_is_equal in H. pose proof (null_d n i _ H e) as Z.
  rewrite (d_plus n i), d_opposite in Z. lia.
Qed.

(** ** All polynomials in a list *)

Fixpoint coded {n : nat} : P n -> nat :=
  match n with
  | O => fun z => if z <? 0 then S (2 * Z.to_nat (- z)) else (2 * Z.to_nat z)%nat
  | S n => fold_right (fun c r => S (Cantor.to_nat (coded c, r))) 0%nat
  end.

Fixpoint list_of {A : Type} (f : nat -> A) (fuel k : nat) : list A :=
  match fuel, k with
  | S fuel, S k => f (fst (Cantor.of_nat k)) :: list_of f fuel (snd (Cantor.of_nat k))
  | _, _ => []
  end.

Fixpoint decoded {n : nat} : nat -> P n :=
  match n with
  | O => fun k => if Nat.even k then Z.of_nat (Nat.div2 k) else - Z.of_nat (Nat.div2 k)
  | S n => fun k => list_of (@decoded n) k k
  end.

Lemma decoded_coded n : forall a : P n, decoded (coded a) = a.
Proof.
  induction n as [|n IH].
  - intro z. cbn [coded decoded]. destruct (Z.ltb_spec z 0).
    + rewrite Nat.even_succ, Nat.odd_mul, Nat.div2_succ_double. cbn. lia.
    + rewrite Nat.even_mul, Nat.div2_double. cbn. lia.
  - intro a. change (list (P n)) in (type of a). cbn [decoded coded].
    set (code := fold_right (fun c r => S (Cantor.to_nat (coded c, r))) 0%nat : list (P n) -> nat).
    change (list_of decoded (code a) (code a) = a).
    assert (H : forall fuel, (code a <= fuel)%nat -> list_of (@decoded n) fuel (code a) = a); [|now apply H].
    induction a as [|c a IHa]; intros fuel L; [now destruct fuel|].
    change (code (c :: a)) with (S (Cantor.to_nat (coded c, code a))) in *.
    destruct fuel as [|fuel]; [lia|]. cbn [list_of]. rewrite Cantor.cancel_of_to. cbn [fst snd]. rewrite IH.
    f_equal. apply IHa. pose proof (Cantor.to_nat_non_decreasing (coded c) (code a)). lia.
Qed.

(** ** Fractions *)

Definition variables : nat := 3.
Notation polynomials := (P variables).

Record fraction_ := Fraction { top : polynomials; bottom : polynomials; proper : null bottom = false }.

Definition one_function (x y : fraction_) : Prop :=
  forall e, at_ (top x) e * at_ (bottom y) e = at_ (top y) e * at_ (bottom x) e.

Lemma one_function_transitive x y z : one_function x y -> one_function y z -> one_function x z.
Proof.
  intros H1 H2 e.
  pose proof (no_divisor_of_zero variables
    (plus_ (times_ (top x) (bottom z)) (opposite_ (times_ (top z) (bottom x)))) (bottom y) (proper y)) as Z.
  assert (D : forall e, at_ (plus_ (times_ (top x) (bottom z)) (opposite_ (times_ (top z) (bottom x)))) e
    * at_ (bottom y) e = 0).
  { intro f. rewrite at_plus_, at_opposite_, !at_times_. specialize (H1 f). specialize (H2 f).
    transitivity (at_ (top x) f * at_ (bottom y) f * at_ (bottom z) f
      - at_ (top z) f * at_ (bottom y) f * at_ (bottom x) f);
      [ring|]. rewrite H1, <- H2. ring. }
  specialize (Z D e). rewrite at_plus_, at_opposite_, !at_times_ in Z. lia.
Qed.

#[export] Instance one_function_equivalence : Equivalence one_function.
Proof.
  split; [intros x e; ring | intros x y H e; now rewrite H | exact one_function_transitive].
Qed.

(** The first fraction in the list that is the same function. *)
Definition is_nth (x : fraction_) (k : nat) : bool :=
  let a := @decoded variables (fst (Cantor.of_nat k)) in
  let b := @decoded variables (snd (Cantor.of_nat k)) in
  negb (null b) && same_polynomial (times_ a (bottom x)) (times_ (top x) b).

Lemma is_nth_respects x y k : one_function x y -> is_nth x k = is_nth y k.
Proof.
  intro H. unfold is_nth. set (a := decoded (fst _)). set (b := decoded (snd _)).
  destruct (null b) eqn:E; [reflexivity|]. cbn [negb andb].
  assert (S : forall u v, one_function u v -> same_polynomial (times_ a (bottom u)) (times_ (top u) b) = true ->
              same_polynomial (times_ a (bottom v)) (times_ (top v) b) = true).
  { intros u v Huv Hu. rewrite same_is_equal in *. intro e.
    assert (F : one_function (Fraction a b E) v).
    { transitivity u; [|exact Huv]. intro f. specialize (Hu f). rewrite !at_times_ in Hu. exact Hu. }
    specialize (F e). cbn [top bottom] in F. rewrite !at_times_. exact F. }
  destruct (same_polynomial (times_ a (bottom x)) (times_ (top x) b)) eqn:A,
           (same_polynomial (times_ a (bottom y)) (times_ (top y) b)) eqn:B; try reflexivity.
  - rewrite (S x y H A) in B. discriminate.
  - rewrite (S y x (symmetry H) B) in A. discriminate.
Qed.

Fixpoint least (p : nat -> bool) (n : nat) : nat :=
  match n with O => 0 | S n => if p 0%nat then 0 else S (least (fun k => p (S k)) n) end.

Lemma least_holds n : forall p, p n = true -> p (least p n) = true.
Proof.
  induction n as [|n IH]; intros p H; [exact H|]. cbn. destruct (p 0%nat) eqn:E; [exact E|].
  exact (IH (fun k => p (S k)) H).
Qed.

Lemma least_is_least n : forall p k, p k = true -> (least p n <= k)%nat.
Proof.
  induction n as [|n IH]; intros p k H; cbn; [lia|]. destruct (p 0%nat) eqn:E; [lia|].
  destruct k as [|k]; [congruence|]. specialize (IH (fun k => p (S k)) k H). lia.
Qed.

Definition number_of (x : fraction_) : nat := Cantor.to_nat (coded (top x), coded (bottom x)).
Definition first_number (x : fraction_) : nat := least (is_nth x) (number_of x).

Lemma is_its_own x : is_nth x (number_of x) = true.
Proof.
  unfold is_nth, number_of. rewrite Cantor.cancel_of_to. cbn [fst snd]. rewrite !decoded_coded, (proper x).
  cbn [negb andb]. now apply same_is_equal.
Qed.

Lemma first_number_respects x y : one_function x y -> first_number x = first_number y.
Proof.
  intro H.
  assert (L : forall u v, one_function u v -> (first_number u <= first_number v)%nat).
  { intros u v E. apply least_is_least. rewrite (is_nth_respects u v _ E). apply least_holds, is_its_own. }
  apply Nat.le_antisymm; now apply L.
Qed.

(** A rational function is a fraction that comes first. *)
Definition constant_fraction (z : Z) : fraction_ :=
  Fraction (of_integer variables z) (of_integer variables 1) eq_refl.

Definition nth_fraction (k : nat) : fraction_ :=
  let b := @decoded variables (snd (Cantor.of_nat k)) in
  match bool_dec (null b) false with
  | left H => Fraction (decoded (fst (Cantor.of_nat k))) b H
  | right _ => constant_fraction 0
  end.

Lemma nth_is_the_nth x k : is_nth x k = true -> one_function (nth_fraction k) x.
Proof.
  unfold is_nth, nth_fraction. destruct (bool_dec _ false) as [E|E].
  - intro H. apply andb_prop in H. destruct H as [_ H]. rewrite same_is_equal in H.
    intro e. specialize (H e). rewrite !at_times_ in H. exact H.
  - destruct (null _); [discriminate|]. now destruct E.
Qed.

Definition comes_first (k : nat) : bool := Nat.eqb (first_number (nth_fraction k)) k.
Definition rational_function : Type := { k : nat | comes_first k = true }.

Lemma first_comes_first x : comes_first (first_number x) = true.
Proof.
  apply Nat.eqb_eq. apply first_number_respects. apply nth_is_the_nth. apply least_holds, is_its_own.
Qed.

Definition made (x : fraction_) : rational_function := exist _ (first_number x) (first_comes_first x).
Definition shown (f : rational_function) : fraction_ := nth_fraction (proj1_sig f).

Lemma shown_made x : one_function (shown (made x)) x.
Proof. apply nth_is_the_nth. apply least_holds, is_its_own. Qed.

Lemma one_number (f g : rational_function) : proj1_sig f = proj1_sig g -> f = g.
Proof. destruct f as [k H], g as [l G]. cbn. intros ->. f_equal. apply UIP_dec, bool_dec. Qed.

Lemma made_equal x y : one_function x y -> made x = made y.
Proof. intro H. apply one_number. now apply first_number_respects. Qed.

Lemma made_shown f : made (shown f) = f.
Proof. apply one_number. destruct f as [k H]. cbn. now apply Nat.eqb_eq. Qed.

(** ** The field *)

Definition fraction_plus (x y : fraction_) : fraction_ :=
  Fraction (plus_ (times_ (top x) (bottom y)) (times_ (top y) (bottom x))) (times_ (bottom x) (bottom y))
    (null_times _ _ _ (proper x) (proper y)).

Definition fraction_times (x y : fraction_) : fraction_ :=
  Fraction (times_ (top x) (top y)) (times_ (bottom x) (bottom y)) (null_times _ _ _ (proper x) (proper y)).

Definition fraction_opposite (x : fraction_) : fraction_ := Fraction (opposite_ (top x)) (bottom x) (proper x).

Definition fraction_inverse (x : fraction_) : fraction_ :=
  match bool_dec (null (top x)) false with
  | left H => Fraction (bottom x) (top x) H
  | right _ => constant_fraction 0
  end.

Definition fraction_derivative (i : nat) (x : fraction_) : fraction_ :=
  Fraction (plus_ (times_ (d_ i (top x)) (bottom x)) (opposite_ (times_ (top x) (d_ i (bottom x)))))
    (times_ (bottom x) (bottom x)) (null_times _ _ _ (proper x) (proper x)).

Ltac at_a_place :=
  cbn [top bottom fraction_plus fraction_times fraction_opposite fraction_derivative constant_fraction];
  repeat first [rewrite at_plus_ | rewrite at_opposite_ | rewrite at_times_ | rewrite at_integer].

#[export] Instance plus_respects : Proper (one_function ==> one_function ==> one_function) fraction_plus.
Proof.
  intros x x' Hx y y' Hy e. specialize (Hx e). specialize (Hy e). at_a_place.
  set (a := at_ (top x) e) in *. set (b := at_ (bottom x) e) in *. set (a' := at_ (top x') e) in *.
  set (b' := at_ (bottom x') e) in *. set (c := at_ (top y) e) in *. set (d := at_ (bottom y) e) in *.
  set (c' := at_ (top y') e) in *. set (d' := at_ (bottom y') e) in *.
  transitivity (a * b' * (d * d') + c * d' * (b * b')); [ring|]. rewrite Hx, Hy. ring.
Qed.

#[export] Instance times_respects : Proper (one_function ==> one_function ==> one_function) fraction_times.
Proof.
  intros x x' Hx y y' Hy e. specialize (Hx e). specialize (Hy e). at_a_place.
  transitivity ((at_ (top x) e * at_ (bottom x') e) * (at_ (top y) e * at_ (bottom y') e)); [ring|].
  rewrite Hx, Hy. ring.
Qed.

#[export] Instance opposite_respects : Proper (one_function ==> one_function) fraction_opposite.
Proof. intros x x' Hx e. specialize (Hx e). at_a_place. lia. Qed.

#[export] Instance derivative_respects i : Proper (one_function ==> one_function) (fraction_derivative i).
Proof.
  intros x y H e.
  assert (D : at_ (d_ i (times_ (top x) (bottom y))) e = at_ (d_ i (times_ (top y) (bottom x))) e).
  { apply d_respects. intro f. rewrite !at_times_. apply H. }
  specialize (H e). rewrite !d_times in D. at_a_place.
  set (a := at_ (top x) e) in *. set (b := at_ (bottom x) e) in *. set (c := at_ (top y) e) in *.
  set (d := at_ (bottom y) e) in *. set (a' := at_ (d_ i (top x)) e) in *. set (b' := at_ (d_ i (bottom x)) e) in *.
  set (c' := at_ (d_ i (top y)) e) in *. set (d' := at_ (d_ i (bottom y)) e) in *.
  transitivity (b * d * (a' * d + a * d') - a * d * (b * d') - a * d * (b' * d)); [ring|]. rewrite D, H. ring.
Qed.

Definition rational_plus f g := made (fraction_plus (shown f) (shown g)).
Definition rational_times f g := made (fraction_times (shown f) (shown g)).
Definition rational_opposite f := made (fraction_opposite (shown f)).
Definition rational_minus f g := rational_plus f (rational_opposite g).
Definition rational_inverse f := made (fraction_inverse (shown f)).
Definition rational_quotient f g := rational_times f (rational_inverse g).
Definition rational_constant z := made (constant_fraction z).
Definition rational_derivative i f := made (fraction_derivative i (shown f)).

(* these numbers are written in strokes: nothing may compute them *)
Local Opaque made shown.

Lemma rational_field : field_theory (rational_constant 0) (rational_constant 1) rational_plus rational_times
  rational_minus rational_opposite rational_quotient rational_inverse (@eq rational_function).
Proof.
  assert (Z : forall f g, one_function (shown f) (shown g) -> f = g).
  { intros f g H. rewrite <- (made_shown f), <- (made_shown g). now apply made_equal. }
  constructor; [constructor| | |].
  - intro f. apply Z. unfold rational_plus, rational_constant. rewrite !shown_made. intro e. at_a_place. ring.
  - intros f g. apply Z. unfold rational_plus. rewrite !shown_made. intro e. at_a_place. ring.
  - intros f g h. apply Z. unfold rational_plus. rewrite !shown_made. intro e. at_a_place. ring.
  - intro f. apply Z. unfold rational_times, rational_constant. rewrite !shown_made. intro e. at_a_place. ring.
  - intros f g. apply Z. unfold rational_times. rewrite !shown_made. intro e. at_a_place. ring.
  - intros f g h. apply Z. unfold rational_times. rewrite !shown_made. intro e. at_a_place. ring.
  - intros f g h. apply Z. unfold rational_times, rational_plus. rewrite !shown_made. intro e. at_a_place. ring.
  - reflexivity.
  - intro f. apply Z. unfold rational_plus, rational_opposite, rational_constant. rewrite !shown_made.
    intro e. at_a_place. ring.
  - intro H.
    assert (E : one_function (constant_fraction 1) (constant_fraction 0)).
    { rewrite <- (shown_made (constant_fraction 1)), <- (shown_made (constant_fraction 0)).
      change (one_function (shown (rational_constant 1)) (shown (rational_constant 0))). now rewrite H. }
    specialize (E (tt, 0, 0, 0)). discriminate.
  - reflexivity.
  - intros f N. apply Z. unfold rational_times, rational_inverse, rational_constant. rewrite !shown_made.
    unfold fraction_inverse. destruct (bool_dec (null (top (shown f))) false) as [E|E].
    + intro e. at_a_place. ring.
    + exfalso. apply N. apply Z. unfold rational_constant. rewrite shown_made. intro e. at_a_place.
      destruct (null (top (shown f))) eqn:T; [|now destruct E]. rewrite (null_is_zero _ _ T). ring.
Qed.

(** The first variable belongs to the derivation s, the second one to s_bar, the third one to time. *)
Definition axis_of (q : parameter) : nat := match q with s => 0 | s_bar => 1 | time => 2 end%nat.

Definition rational_functions : differential_field.
Proof.
  refine {| field_axioms := rational_field; derivative q := rational_derivative (axis_of q) |}; intros q f g.
  - unfold rational_derivative, rational_plus. apply made_equal.
    rewrite !shown_made. intro e. at_a_place. rewrite !(d_plus variables), !d_times. at_a_place. ring.
  - unfold rational_derivative, rational_plus, rational_times. apply made_equal.
    rewrite !shown_made. intro e. at_a_place. rewrite !d_times. at_a_place. ring.
Defined.

Definition variable_of (q : parameter) : rational_functions :=
  made (Fraction (match q with
    | s => [[[0; 1]]] | s_bar => [[[0]; [1]]] | time => [[[0]]; [[1]]] end : polynomials)
    (of_integer variables 1) eq_refl).

(** Coordinates: each derivation differentiates its own variable, and no other one. *)
Definition coordinates {K : differential_field} (x : parameter -> K) : Prop :=
  forall q r, derivative K q (x r) =
    match q, r with s, s | s_bar, s_bar | time, time => one K | _, _ => zero K end.

Lemma integers_are_constants z : integer rational_functions z = rational_constant z.
Proof.
  assert (N : forall n, integer rational_functions (Z.of_nat n) = rational_constant (Z.of_nat n)).
  { induction n as [|n IH]; [reflexivity|]. rewrite integer_succ, IH.
    unfold rational_constant. apply one_number. cbn [plus rational_functions one]. unfold rational_plus.
    apply first_number_respects. unfold rational_constant. rewrite !shown_made. intro e. at_a_place. lia. }
  destruct (Z.le_ge_cases 0 z) as [H|H].
  - rewrite <- (Z2Nat.id z H). apply N.
  - replace z with (- Z.of_nat (Z.to_nat (- z))) by lia. rewrite integer_opp, N.
    apply one_number. cbn [opposite rational_functions]. unfold rational_opposite.
    apply first_number_respects. unfold rational_constant. rewrite shown_made. intro e. at_a_place. ring.
Qed.

(** There is a field of which the theorems about explicit curves speak. *)
Theorem rational_functions_exist : exists (K : differential_field) (x : parameter -> K),
  characteristic_zero K /\ coordinates x /\
  forall q r a, derivative K q (derivative K r a) = derivative K r (derivative K q a).
Proof.
  exists rational_functions, variable_of. repeat split.
  - intros z N H. rewrite integers_are_constants in H.
    assert (E : one_function (constant_fraction z) (constant_fraction 0)).
    { rewrite <- (shown_made (constant_fraction z)), <- (shown_made (constant_fraction 0)).
      change (one_function (shown (rational_constant z)) (shown (rational_constant 0))). now rewrite H. }
    specialize (E (tt, 0, 0, 0)). cbn in E. lia.
  - intros q r. destruct q, r; cbn [derivative rational_functions one zero]; unfold rational_derivative, variable_of;
      apply made_equal; rewrite shown_made; intros [[[[] x] y] z]; cbn -[Z.add Z.mul Z.opp]; ring.
  - intros q r f. cbn [derivative rational_functions]. unfold rational_derivative. apply made_equal.
    rewrite !shown_made. set (x := shown f). intro e. at_a_place.
    rewrite !(d_plus variables), !d_opposite, !d_times. at_a_place.
    rewrite (d_commutes variables (axis_of q) (axis_of r) (top x)).
    rewrite (d_commutes variables (axis_of q) (axis_of r) (bottom x)). ring.
Qed.

(** ** Arguments of theorems

    The functions of a curve or a surface are any elements. What stands beside some of them obeys equations, which hold
    for these. *)

Section Examples.
Variable K : differential_field.
Variable x : parameter -> K.
Hypothesis own : coordinates x.
Local Open Scope formula_scope.
Let t : K := x s.

Let variables_here : list K := [x s; x s_bar; x time].
Let one_of (i : positive) : rules := map (fun k => (k, num (if Pos.eqb k i then 1 else 0))) [1; 2; 3]%positive.
Let rules_here : parameter -> rules := of_three_parameters (one_of 1) (one_of 2) (one_of 3).

Lemma rules_here_hold q : rules_hold K variables_here q (rules_here q).
Proof. destruct q; repeat apply Forall_cons; try apply Forall_nil; apply own. Qed.

Let same_values := one_value K variables_here rules_here rules_here_hold [] I [] [] (Forall_nil _).
Let same_vectors := one_vector K variables_here rules_here rules_here_hold [] I [] [] (Forall_nil _).

(** γ′ = 3 (1 − t², 2t). *)
Theorem a_framed_plane_curve_exists :
  let c := rational_curve s [number 3 * t - t ^ 3; number 3 * t ^ 2] (number 1) [] in
  let sigma := number 3 * (number 1 + t ^ 2) in
  times K sigma sigma = dot (vder s (gamma c)) (vder s (gamma c)).
Proof.
  intros c sigma. unfold c. rewrite polynomial_is_homogeneous.
  pose (a := var 1). pose (d := homogeneous s [number 3 * a - a ^ 3; number 3 * a ^ 2] (number 1) []).
  pose (b := number 3 * (number 1 + a ^ 2)).
  exact (same_values (b * b) (dot (vder s (gamma d)) (vder s (gamma d))) eq_refl).
Qed.

(** γ′ = 3 (1, 2t, 2t²). *)
Theorem a_framed_space_curve_exists :
  let c := rational_curve s [number 3 * t; number 3 * t ^ 2; number 2 * t ^ 3] (number 1) [] in
  let sigma := number 3 * (number 1 + number 2 * t ^ 2) in
  let rho := number 18 * (number 1 + number 2 * t ^ 2) in
  let binormal := cross (vder s (gamma c)) (vders s 2 (gamma c)) in
  times K sigma sigma = dot (vder s (gamma c)) (vder s (gamma c)) /\ times K rho rho = dot binormal binormal.
Proof.
  intros c sigma rho binormal. unfold binormal, c. rewrite polynomial_is_homogeneous.
  pose (a := var 1). pose (d := homogeneous s [number 3 * a; number 3 * a ^ 2; number 2 * a ^ 3] (number 1) []).
  pose (b := number 1 + number 2 * a ^ 2). pose (n := cross (vder s (gamma d)) (vders s 2 (gamma d))). split.
  - exact (same_values (number 3 * b * (number 3 * b)) (dot (vder s (gamma d)) (vder s (gamma d))) eq_refl).
  - exact (same_values (number 18 * b * (number 18 * b)) (dot n n) eq_refl).
Qed.

(** u = t, v = 1, h = 3. *)
Theorem a_hodograph_exists :
  let c := Accompanied (rational_curve s [t ^ 3 - number 3 * t; number 3 * t ^ 2] (number 1) [])
    [t; number 1; number 3] in
  [der s (t ^ 3 - number 3 * t); der s (number 3 * t ^ 2)] = velocity_of c.
Proof.
  intro c. pose (a := var 1).
  pose (d := Accompanied (rational_curve s [a ^ 3 - number 3 * a; number 3 * a ^ 2] (number 1) [])
    [a; number 1; number 3]).
  exact (same_vectors [der s (a ^ 3 - number 3 * a); der s (number 3 * a ^ 2)] (velocity_of d) eq_refl).
Qed.

(** The parabola, along which F = y − x² is 0. *)
Theorem an_implicit_curve_exists :
  let c := Implicit (rational_curve s [t; t ^ 2] (number 1) []) [- number 1] [- (number 2 * t); number 1]
    [[- number 2; number 0]; [number 0; number 0]] in
  vder s (gamma c) = vmul (pace_of c) (perp (gradient_f c)) /\ chain_rule c.
Proof.
  intro c. unfold c, chain_rule. rewrite polynomial_is_homogeneous. pose (a := var 1).
  pose (d := Implicit (homogeneous s [a; a ^ 2] (number 1) []) [- number 1] [- (number 2 * a); number 1]
    [[- number 2; number 0]; [number 0; number 0]]). split.
  - exact (same_vectors (vder s (gamma d)) (vmul (pace_of d) (perp (gradient_f d))) eq_refl).
  - exact (same_vectors (vder s (gradient_f d)) (map (fun row => dot row (vder s (gamma d))) (hessian_f d)) eq_refl).
Qed.

(** The line (2, t, 2t), along which F = z − xy is 0: the cut with the plane x = 2. *)
Theorem an_implicit_surface_exists :
  let c := Implicit (rational_curve s [number 2; t; number 2 * t] (number 1) []) [number 1; number 0; number 0]
    [- t; - number 2; number 1]
    [[number 0; - number 1; number 0]; [- number 1; number 0; number 0]; [number 0; number 0; number 0]] in
  vder s (gamma c) = cross (gradient_f c) (free c) /\ chain_rule c.
Proof.
  intro c. unfold c, chain_rule. rewrite polynomial_is_homogeneous. pose (a := var 1).
  pose (d := Implicit (homogeneous s [number 2; a; number 2 * a] (number 1) []) [number 1; number 0; number 0]
    [- a; - number 2; number 1]
    [[number 0; - number 1; number 0]; [- number 1; number 0; number 0]; [number 0; number 0; number 0]]). split.
  - exact (same_vectors (vder s (gamma d)) (cross (gradient_f d) (free d)) eq_refl).
  - exact (same_vectors (vder s (gradient_f d)) (map (fun row => dot row (vder s (gamma d))) (hessian_f d)) eq_refl).
Qed.

Add Field K_examples : (field_axioms K).

Lemma composed_constant (u v : K) n : forall a : K, constant a -> composed u v n a.
Proof.
  induction n as [|n IH]; intros a C; cbn [composed]; rewrite !C; (split; [ring|]); [exact I|].
  split; apply IH; intro q; apply derivative_zero.
Qed.

(** The surface (u, v, uv) and on it the curves u = a + t, v = b + t², a and b the first two variables. *)
Theorem a_curve_on_a_surface_exists :
  let u := x s + x time in
  let v := x s_bar + x time ^ 2 in
  forall order, Forall (composed u v order) [u; v; u * v; number 1].
Proof.
  intros u v order.
  assert (Z : constant (zero K)) by (intro q; apply derivative_zero).
  assert (O : constant (one K)) by (intro q; apply derivative_one).
  pose (a := eadd (var 1) (var 3)). pose (b := eadd (var 2) (epow (var 3) 2)).
  assert (Du : forall q, derivative K q u = match q with s_bar => zero K | _ => one K end).
  { intros []; [exact (same_values (eder s a) (num 1) eq_refl) | exact (same_values (eder s_bar a) (num 0) eq_refl)
    | exact (same_values (eder time a) (num 1) eq_refl)]. }
  assert (Dv : derivative K s v = zero K /\ derivative K s_bar v = one K).
  { split; [exact (same_values (eder s b) (num 0) eq_refl) | exact (same_values (eder s_bar b) (num 1) eq_refl)]. }
  destruct Dv as [Dv Dw].
  assert (Cu : forall n, composed u v n u).
  { intros [|n]; cbn [composed]; rewrite !Du; (split; [ring|]); [exact I|]. split; now apply composed_constant. }
  assert (Cv : forall n, composed u v n v).
  { intros [|n]; cbn [composed]; rewrite !Dv, !Dw; (split; [ring|]); [exact I|]. split; now apply composed_constant. }
  repeat apply Forall_cons; try apply Forall_nil; trivial.
  - apply composed_times; trivial.
  - now apply composed_constant.
Qed.
End Examples.
