(** Common points of two plane curves, over the real numbers: all of them, each in its box.

    Two forms f, g in s and t vanish at the pairs of parameters with the same point. Their resultant R in t and a
    combination [slope s + offset] of them vanish there, too; a power of [slope], times f or g, is a combination of
    [slope s + offset] and R. Hence the zeros of R at which [slope] is not zero have exactly one s each, and these pairs
    are all. The identities are checked by computation, the zeros of R as those of one form ([answer]). *)

Require Import ZArith QArith Qreals List Sorted Bool Lia Reals Lra.
From ExactSpline Require Import Base Answers.
Import ListNotations.
Local Open Scope R_scope.
Local Arguments Qred : simpl never.
Local Arguments Qplus : simpl never.
Local Arguments Qmult : simpl never.
Local Arguments Q2R : simpl never.
Local Arguments Qle_bool : simpl never.
Local Arguments Qeq_bool : simpl never.
Local Arguments one_sign : simpl never.
Local Arguments pscale : simpl never.

(** ** Polynomials in s whose coefficients are polynomials in t *)

Definition bipolynomial := list polynomial.

Fixpoint at2 (f : bipolynomial) (s t : R) : R :=
  match f with [] => 0 | c :: f => at_real c t + s * at2 f s t end.

Fixpoint add2 (f g : bipolynomial) : bipolynomial :=
  match f, g with
  | [], g => g
  | f, [] => f
  | a :: f, b :: g => padd a b :: add2 f g
  end.

Definition scale2 (a : polynomial) (f : bipolynomial) : bipolynomial := map (pmul a) f.

Fixpoint mul2 (f g : bipolynomial) : bipolynomial :=
  match f with [] => [] | c :: f => add2 (scale2 c g) ([] :: mul2 f g) end.

(** The product of a polynomial in s and one in t. *)
Definition outer (a b : polynomial) : bipolynomial := map (fun c => pscale c b) a.

Definition same2 (f g : bipolynomial) : bool := forallb pzero (add2 f (scale2 [(-1)%Q] g)).

Lemma at_add2 f s t : forall g, at2 (add2 f g) s t = at2 f s t + at2 g s t.
Proof.
  induction f as [|a f IH]; intros [|b g]; simpl; try lra. rewrite at_padd, IH. lra.
Qed.

Lemma at_scale2 a f s t : at2 (scale2 a f) s t = at_real a t * at2 f s t.
Proof.
  induction f as [|c f IH]; cbn [scale2 map at2]; [lra|]. fold (scale2 a f). rewrite at_pmul, IH. lra.
Qed.

Lemma at_mul2 f g s t : at2 (mul2 f g) s t = at2 f s t * at2 g s t.
Proof.
  induction f as [|c f IH]; cbn [mul2]; [simpl; lra|].
  rewrite at_add2, at_scale2. cbn [at2 at_real]. rewrite IH. lra.
Qed.

Lemma at_outer a b s t : at2 (outer a b) s t = at_real a s * at_real b t.
Proof.
  induction a as [|c a IH]; cbn [outer map at2 at_real]; [lra|]. fold (outer a b). rewrite at_pscale, IH. lra.
Qed.

Lemma minus_one t : at_real [(-1)%Q] t = -1.
Proof. simpl. unfold Q2R. simpl. lra. Qed.

Lemma same2_sound f g s t : same2 f g = true -> at2 f s t = at2 g s t.
Proof.
  unfold same2. intro H.
  assert (Z : at2 (add2 f (scale2 [(-1)%Q] g)) s t = 0).
  { induction (add2 f (scale2 [(-1)%Q] g)) as [|c h IH]; [reflexivity|].
    simpl in H. apply andb_prop in H. destruct H as [Hc H]. cbn [at2]. rewrite (pzero_sound c t Hc), (IH H). lra. }
  rewrite at_add2, at_scale2, minus_one in Z. lra.
Qed.

(** ** Elimination *)

Record elimination := {
  resultant : polynomial; slope : polynomial; offset : polynomial; exponent : nat;
  of_resultant : bipolynomial * bipolynomial; of_line : bipolynomial * bipolynomial;
  first_form : bipolynomial * bipolynomial; second_form : bipolynomial * bipolynomial
}.

Definition line (e : elimination) : bipolynomial := [offset e; slope e].

Definition combined (k : bipolynomial * bipolynomial) (f g : bipolynomial) : bipolynomial :=
  add2 (mul2 (fst k) f) (mul2 (snd k) g).

Definition eliminates (f g : bipolynomial) (e : elimination) : bool :=
  let power := ppow (slope e) (exponent e) in
  same2 (combined (of_resultant e) f g) [resultant e] && same2 (combined (of_line e) f g) (line e)
  && same2 (scale2 power f) (combined (first_form e) (line e) [resultant e])
  && same2 (scale2 power g) (combined (second_form e) (line e) [resultant e]).

Lemma at_combined k f g s t : at2 (combined k f g) s t = at2 (fst k) s t * at2 f s t + at2 (snd k) s t * at2 g s t.
Proof. unfold combined. now rewrite at_add2, !at_mul2. Qed.

Lemma at_line e s t : at2 (line e) s t = at_real (slope e) t * s + at_real (offset e) t.
Proof. unfold line. cbn [at2]. lra. Qed.

Lemma at_one a s t : at2 [a] s t = at_real a t.
Proof. cbn [at2]. lra. Qed.

Lemma eliminates_sound f g e s t : eliminates f g e = true ->
  (at2 f s t = 0 -> at2 g s t = 0 -> at_real (resultant e) t = 0 /\ at_real (slope e) t * s + at_real (offset e) t = 0)
  /\ (at_real (resultant e) t = 0 -> at_real (slope e) t <> 0 ->
      at_real (slope e) t * s + at_real (offset e) t = 0 -> at2 f s t = 0 /\ at2 g s t = 0).
Proof.
  unfold eliminates. intro H. do 3 (apply andb_prop in H; destruct H as [H ?]).
  apply (same2_sound _ _ s t) in H. apply (same2_sound _ _ s t) in H0.
  apply (same2_sound _ _ s t) in H1. apply (same2_sound _ _ s t) in H2.
  rewrite at_combined, at_one in H. rewrite at_combined, at_line in H2.
  rewrite at_scale2, at_combined, at_line, at_one, at_ppow in H0, H1.
  split.
  - intros F G. rewrite F, G in H, H2. split; lra.
  - intros Z N L. rewrite Z, L in H0, H1.
    assert (P : at_real (slope e) t ^ exponent e <> 0) by (apply pow_nonzero; exact N).
    split.
    + apply (Rmult_eq_reg_l (at_real (slope e) t ^ exponent e)); [lra | exact P].
    + apply (Rmult_eq_reg_l (at_real (slope e) t ^ exponent e)); [lra | exact P].
Qed.

(** ** Where s is at a zero of the resultant *)

Inductive place := Outside (u above : bool) | Inside (u : bool) (l h : Q).

(** A form has a sign on an interval, or at the point that it is shrunk to. *)
Definition positive_on (a : polynomial) (i : Q * Q) (u : bool) : bool :=
  if Qeq_bool (fst i) (snd i) then qpos (signed_value u a (fst i)) else one_sign a (fst i) (snd i) u.

Lemma positive_on_sound a i u t : positive_on a i u = true -> within t i -> 0 < sign u * at_real a t.
Proof.
  unfold positive_on, within. destruct i as [l h]. cbn [fst snd].
  destruct (Qeq_bool l h) eqn:E; intros H W.
  - apply Qeq_bool_eq, Qeq_eqR in E. apply signed_value_sound in H. destruct W as [W|[<- _]]; [lra | exact H].
  - destruct W as [W|[W1 W2]]; [exact (no_zero a l h u t H W)|].
    exfalso. assert (Q : (l == h)%Q) by (apply eqR_Qeq; lra). apply Qeq_bool_iff in Q. congruence.
Qed.

Definition line_at (e : elimination) (s : Q) : polynomial := padd (pscale s (slope e)) (offset e).

Lemma at_line_at e s t : at_real (line_at e s) t = at_real (slope e) t * Q2R s + at_real (offset e) t.
Proof. unfold line_at. rewrite at_padd, at_pscale. lra. Qed.

Definition check_place (e : elimination) (from to : Q) (i : Q * Q) (p : place) : bool :=
  match p with
  | Outside u false => positive_on (slope e) i u && positive_on (line_at e from) i u
  | Outside u true => positive_on (slope e) i u && positive_on (line_at e to) i (negb u)
  | Inside u l h =>
    positive_on (slope e) i u && Qle_bool from l && Qle_bool h to
    && if Qeq_bool l h then Qeq_bool (fst i) (snd i) && zero_at (line_at e l) (fst i)
       else positive_on (line_at e l) i (negb u) && positive_on (line_at e h) i u
  end.

Lemma sign_cases u x : 0 < sign u * x -> x <> 0 /\ (u = true -> 0 < x) /\ (u = false -> x < 0).
Proof. destruct u; simpl; intro H; repeat split; intros; try discriminate; lra. Qed.

Lemma root_between a b l h u : 0 < sign u * a -> 0 < sign (negb u) * (a * l + b) -> 0 < sign u * (a * h + b) ->
  l < - b / a < h.
Proof.
  intros A L H. rewrite sign_negb in L.
  assert (N : a <> 0) by (intros ->; lra).
  assert (El : a * l + b = a * (l - - b / a)) by (field; exact N).
  assert (Eh : a * h + b = a * (h - - b / a)) by (field; exact N).
  rewrite El in L. rewrite Eh in H.
  assert (L' : (sign u * a) * (l - - b / a) < 0) by lra.
  assert (H' : 0 < (sign u * a) * (h - - b / a)) by lra.
  split; apply Rnot_le_lt; intro C.
  - assert (0 <= (sign u * a) * (l - - b / a)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= (sign u * a) * (- b / a - h)) by (apply Rmult_le_pos; lra).
    assert ((sign u * a) * (- b / a - h) = - ((sign u * a) * (h - - b / a))) by ring. lra.
Qed.

Definition has (e : elimination) (from to : Q) (t s : R) : Prop :=
  Q2R from <= s <= Q2R to /\ at_real (slope e) t * s + at_real (offset e) t = 0.

Lemma place_sound e from to i p t : check_place e from to i p = true -> within t i ->
  at_real (slope e) t <> 0 /\
  match p with
  | Outside _ _ => forall s, ~ has e from to t s
  | Inside _ l h => exists s, within s (l, h) /\ has e from to t s
  end.
Proof.
  intros H W. destruct p as [u above|u l h]; cbn [check_place] in H.
  - destruct above; apply andb_prop in H; destruct H as [A B];
      apply (positive_on_sound _ _ _ t) in A; trivial; apply (positive_on_sound _ _ _ t) in B; trivial;
      rewrite at_line_at in B; try rewrite sign_negb in B;
      (split; [intros Z; rewrite Z in A; lra|]); intros s [[S1 S2] Z].
    + assert (E : at_real (slope e) t * Q2R to + at_real (offset e) t = at_real (slope e) t * (Q2R to - s)) by lra.
      rewrite E in B. assert (0 <= (sign u * at_real (slope e) t) * (Q2R to - s)) by (apply Rmult_le_pos; lra). lra.
    + assert (E : at_real (slope e) t * Q2R from + at_real (offset e) t = at_real (slope e) t * (Q2R from - s)) by lra.
      rewrite E in B.
      assert (0 <= (sign u * at_real (slope e) t) * (s - Q2R from)) by (apply Rmult_le_pos; lra). lra.
  - apply andb_prop in H. destruct H as [H B]. apply andb_prop in H. destruct H as [H T].
    apply andb_prop in H. destruct H as [A F].
    apply (positive_on_sound _ _ _ t) in A; trivial.
    apply Qle_bool_iff, Qle_Rle in F. apply Qle_bool_iff, Qle_Rle in T.
    split; [intros Z; rewrite Z in A; lra|].
    destruct (Qeq_bool l h) eqn:E; apply andb_prop in B; destruct B as [B C].
    + apply Qeq_bool_eq, Qeq_eqR in E. apply Qeq_bool_eq, Qeq_eqR in B.
      apply zero_at_sound in C. rewrite at_line_at in C.
      assert (t = Q2R (fst i)) by (unfold within in W; lra). subst t.
      exists (Q2R l). split; [right; cbn [fst snd]; lra|]. split; [lra | exact C].
    + apply (positive_on_sound _ _ _ t) in B; trivial. apply (positive_on_sound _ _ _ t) in C; trivial.
      rewrite at_line_at in B, C. pose proof (root_between _ _ _ _ _ A B C) as I.
      exists (- at_real (offset e) t / at_real (slope e) t). split; [left; exact I|].
      split; [lra|]. field. intros Z; rewrite Z in A; lra.
Qed.

(** ** All of them *)

Definition box := ((Q * Q) * (Q * Q))%type.
Definition in_box (z : R * R) (b : box) : Prop := within (fst z) (fst b) /\ within (snd z) (snd b).

Fixpoint boxes (places : list ((Q * Q) * place)) : list box :=
  match places with
  | [] => []
  | (i, Inside _ l h) :: rest => ((l, h), i) :: boxes rest
  | (_, Outside _ _) :: rest => boxes rest
  end.

(** The pairs of parameters at which a relation holds are exactly so many, one in each box, each second
    parameter after the one before: no pair is told twice. *)
Definition hold_exactly (same : R -> R -> Prop) (from to from' to' : Q) (bs : list box) : Prop :=
  exists zs, Forall2 in_box zs bs /\ Sorted Rlt (map snd zs) /\
  forall s t, Q2R from <= s <= Q2R to -> Q2R from' <= t <= Q2R to' -> (same s t <-> In (s, t) zs).

Lemma pairs e from to places : forall ts,
  forallb (fun ip => check_place e from to (fst ip) (snd ip)) places = true -> Forall2 within ts (map fst places) ->
  (forall t, In t ts -> at_real (slope e) t <> 0) /\
  exists zs, Forall2 in_box zs (boxes places) /\ (forall s t, In (s, t) zs <-> In t ts /\ has e from to t s).
Proof.
  induction places as [|[i p] places IH]; intros ts H W; inversion W as [|t ? ts' ? Wt Ws]; subst.
  - split; [intros t []|]. exists []. split; [constructor|]. intros s t. simpl. tauto.
  - simpl in H. apply andb_prop in H. destruct H as [Hp H]. destruct (IH ts' H Ws) as [N [zs [B Z]]].
    destruct (place_sound e from to i p t Hp Wt) as [Nt P].
    split; [intros x [<-|I]; [exact Nt | exact (N x I)]|].
    destruct p as [u above|u l h]; cbn [boxes].
    + exists zs. split; [exact B|]. intros s x. rewrite Z. simpl. split; [tauto|].
      intros [[<-|I] A]; [exfalso; exact (P s A) | tauto].
    + destruct P as [s0 [Ws0 Hs0]]. exists ((s0, t) :: zs). split; [constructor; [split; assumption | exact B]|].
      intros s x. simpl. rewrite Z. split.
      * intros [E|[I A]]; [injection E as <- <-; tauto | tauto].
      * intros [[<-|I] A]; [left|tauto]. f_equal.
        destruct A as [_ A]. destruct Hs0 as [_ A0].
        assert (E : at_real (slope e) t * (s0 - s) = 0) by lra.
        apply Rmult_integral in E. destruct E as [E|E]; [contradiction | lra].
Qed.

Lemma second_within bs : forall zs, Forall2 in_box zs bs -> Forall2 within (map snd zs) (map snd bs).
Proof. induction bs as [|b bs IH]; intros zs F; inversion F as [|z ? zs' ? [_ W] Fs]; subst; constructor; auto. Qed.

Theorem meetings_sound (f g : bipolynomial) (e : elimination) (from to from' to' : Q) (cells : list cell)
    (places : list ((Q * Q) * place)) :
  eliminates f g e = true -> cells <> [] -> forallb (fun c => negb (is_null c)) cells = true ->
  answer (resultant e) from' to' cells = true -> map fst places = zeros true (resultant e) cells ->
  forallb (fun ip => check_place e from to (fst ip) (snd ip)) places = true ->
  separated (map snd (boxes places)) = true ->
  hold_exactly (fun s t => at2 f s t = 0 /\ at2 g s t = 0) from to from' to' (boxes places).
Proof.
  intros E Nc Nn A M P S.
  destruct (answer_sound true (resultant e) cells from' to' Nc Nn A) as [ts [W [I Z]]]. rewrite <- M in W.
  destruct (pairs e from to places ts P W) as [N [zs [B In_]]].
  exists zs. split; [exact B|]. split; [exact (separated_sorted _ S _ (second_within _ _ B))|].
  intros s t Hs Ht. rewrite In_. destruct (eliminates_sound f g e s t E) as [There Back].
  split.
  - intros [F G]. destruct (There F G) as [R L]. split; [apply Z; [exact Ht | exact R] | split; assumption].
  - intros [T [_ L]]. apply Back; [apply Z; [exact Ht | exact T] | exact (N t T) | exact L].
Qed.

(** ** Of two curves *)

Definition cross (x w y v : polynomial) : bipolynomial := add2 (outer x v) (scale2 [(-1)%Q] (outer w y)).

Lemma at_cross x w y v s t : at2 (cross x w y v) s t = at_real x s * at_real v t - at_real w s * at_real y t.
Proof. unfold cross. rewrite at_add2, at_scale2, !at_outer, minus_one. lra. Qed.

Definition coordinate (c : curve polynomial) (k : nat) : polynomial := nth k (p c) [].

(** The point of one plane curve at s is that of the other at t: by coordinates times weights, which are not zero. *)
Definition same_point (a b : curve polynomial) (s t : R) : Prop :=
  at_real (coordinate a 0) s * at_real (w b) t = at_real (w a) s * at_real (coordinate b 0) t /\
  at_real (coordinate a 1) s * at_real (w b) t = at_real (w a) s * at_real (coordinate b 1) t.

Definition difference (a b : curve polynomial) (k : nat) : bipolynomial :=
  cross (coordinate a k) (w a) (coordinate b k) (w b).

(** What is checked, and the boxes. *)
Definition meetings (a b : curve polynomial) (e : elimination) (from to from' to' : Q) (cells : list cell)
    (places : list ((Q * Q) * place)) : bool :=
  eliminates (difference a b 0) (difference a b 1) e && negb (Nat.eqb (length cells) 0)
  && forallb (fun c => negb (is_null c)) cells && answer (resultant e) from' to' cells
  && forallb (fun ip => check_place e from to (fst ip) (snd ip)) places && separated (map snd (boxes places)).

Theorem curves_meet_exactly (a b : curve polynomial) (e : elimination) (from to from' to' : Q) (cells : list cell)
    (places : list ((Q * Q) * place)) (bs : list box) :
  (meetings a b e from to from' to' cells places, map fst places, boxes places)
    = (true, zeros true (resultant e) cells, bs) ->
  hold_exactly (same_point a b) from to from' to' bs.
Proof.
  intro H. injection H as H M <-. unfold meetings in H. do 5 (apply andb_prop in H; destruct H as [H ?]).
  destruct (meetings_sound (difference a b 0) (difference a b 1) e from to from' to' cells places) as [zs [B [S Z]]];
    trivial.
  - intros ->. discriminate.
  - exists zs. split; [exact B|]. split; [exact S|]. intros s t Hs Ht. rewrite <- (Z s t Hs Ht).
    unfold same_point, difference. rewrite !at_cross. lra.
Qed.
