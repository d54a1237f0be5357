(** Answers about one curve, over the real numbers: where a polynomial form of a B-spline curve vanishes.

    Three facts carry everything: a form with Bernstein coefficients of one sign has no zero inside ([no_zero]), one with
    opposite signs at the ends has one ([a_zero]), and one whose derivative has Bernstein coefficients of one sign has at
    most one ([at_most_one]). What a certificate says is checked by computation in binary integers ([answer]). *)

Require Import ZArith QArith Qreals List Sorted Bool Lia Reals Lra.
From ExactSpline Require Import Base.
Import ListNotations.
Local Open Scope R_scope.
Local Arguments Qred : simpl never.
Local Arguments Qplus : simpl never.
Local Arguments Qmult : simpl never.
Local Arguments Q2R : simpl never.
Local Arguments Qle_bool : simpl never.
Local Arguments Qeq_bool : simpl never.

(** ** Polynomials with rational coefficients, the constant one first *)

Definition polynomial := list Q.

Fixpoint at_real (a : polynomial) (t : R) : R :=
  match a with [] => 0 | c :: a => Q2R c + t * at_real a t end.

Fixpoint at_rational (a : polynomial) (t : Q) : Q :=
  match a with [] => 0%Q | c :: a => Qred (c + t * at_rational a t) end.

(** Where two denominators are one, nothing is reduced: greatest common divisors are what costs most. *)
Definition qadd (x y : Q) : Q :=
  if Pos.eqb (Qden x) (Qden y) then (Qnum x + Qnum y) # Qden x else Qred (x + y).

Fixpoint padd (a b : polynomial) : polynomial :=
  match a, b with
  | [], b => b
  | a, [] => a
  | x :: a, y :: b => qadd x y :: padd a b
  end.

Definition pscale (k : Q) (a : polynomial) : polynomial := map (fun c => (k * c)%Q) a.

Fixpoint pmul (a b : polynomial) : polynomial :=
  match a with
  | [] => []
  | [c] => pscale c b
  | c :: a => match pscale c b with [] => [] | x :: d => x :: padd d (pmul a b) end
  end.

Fixpoint ppow (a : polynomial) (n : nat) : polynomial :=
  match n with O => [1%Q] | S n => pmul a (ppow a n) end.

Fixpoint pder_from (k : Z) (a : polynomial) : polynomial :=
  match a with [] => [] | c :: a => (inject_Z k * c)%Q :: pder_from (k + 1) a end.

Definition pder (a : polynomial) : polynomial := match a with [] => [] | _ :: a => pder_from 1 a end.

(** Formulas that do not divide are read on polynomials: these are the operations. *)
#[export] Instance polynomial_operations : operations polynomial := {
  number z := [inject_Z z];
  add := padd;
  sub a b := padd a (pscale (-1) b);
  mul := pmul;
  div a _ := a;
  neg := pscale (-1);
  power := ppow;
  der _ := pder
}.

Lemma Q2R_0 : Q2R 0 = 0. Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; simpl; lra. Qed.

Lemma at_real_rational a t : at_real a (Q2R t) = Q2R (at_rational a t).
Proof.
  induction a as [|c a IH]; simpl; [now rewrite Q2R_0|].
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_plus, Q2R_mult, IH. reflexivity.
Qed.

Lemma qadd_is x y : Q2R (qadd x y) = Q2R x + Q2R y.
Proof.
  unfold qadd. destruct (Pos.eqb (Qden x) (Qden y)) eqn:E.
  - apply Pos.eqb_eq in E. unfold Q2R. simpl. rewrite E, plus_IZR. lra.
  - rewrite (Qeq_eqR _ _ (Qred_correct _)). apply Q2R_plus.
Qed.

Lemma at_padd a t : forall b, at_real (padd a b) t = at_real a t + at_real b t.
Proof.
  induction a as [|x a IH]; intros [|y b]; simpl; try lra.
  rewrite qadd_is, IH. lra.
Qed.

Lemma at_pscale k a t : at_real (pscale k a) t = Q2R k * at_real a t.
Proof.
  induction a as [|x a IH]; simpl; [lra|].
  change (map (fun c => (k * c)%Q) a) with (pscale k a).
  rewrite Q2R_mult, IH. lra.
Qed.

Lemma at_pmul a b t : at_real (pmul a b) t = at_real a t * at_real b t.
Proof.
  induction a as [|x a IH]; [simpl; lra|].
  destruct a as [|y a]; [simpl pmul; rewrite at_pscale; simpl; lra|].
  change (at_real (match pscale x b with [] => [] | z :: d => z :: padd d (pmul (y :: a) b) end) t
          = (Q2R x + t * at_real (y :: a) t) * at_real b t).
  destruct b as [|z b]; [simpl; lra|].
  change (pscale x (z :: b)) with ((x * z)%Q :: pscale x b). cbn [at_real].
  rewrite at_padd, at_pscale, IH, Q2R_mult. simpl. lra.
Qed.

Lemma at_ppow a n t : at_real (ppow a n) t = at_real a t ^ n.
Proof.
  induction n as [|n IH]; simpl; [rewrite Q2R_1; lra|]. now rewrite at_pmul, IH.
Qed.

Lemma at_pder_from a t : forall k, at_real (pder_from k a) t = IZR k * at_real a t + t * at_real (pder a) t.
Proof.
  assert (shift : forall a k, at_real (pder_from (k + 1) a) t = at_real (pder_from k a) t + at_real a t).
  { clear a. induction a as [|c a IH]; intro k; simpl; [lra|].
    rewrite !Q2R_mult, IH.
    assert (Hz : forall z, Q2R (inject_Z z) = IZR z) by (intro z; unfold Q2R; simpl; lra).
    rewrite !Hz, plus_IZR. lra. }
  induction a as [|c a IH]; intro k; simpl; [lra|].
  rewrite Q2R_mult, shift, IH.
  assert (Hz : Q2R (inject_Z k) = IZR k) by (unfold Q2R; simpl; lra). rewrite Hz.
  assert (H1 : at_real (pder_from 1 a) t = at_real a t + t * at_real (pder a) t) by (rewrite IH; lra).
  rewrite H1. lra.
Qed.

(** The derivative of polynomials is the derivative. *)
Lemma derivative_is a t : derivable_pt_lim (at_real a) t (at_real (pder a) t).
Proof.
  induction a as [|c a IH].
  - simpl. apply derivable_pt_lim_const.
  - assert (H : at_real (pder (c :: a)) t = 0 + (1 * at_real a t + t * at_real (pder a) t)).
    { simpl. rewrite at_pder_from. lra. }
    rewrite H. change (at_real (c :: a)) with (fun t => Q2R c + t * at_real a t).
    apply (derivable_pt_lim_plus (fun _ => Q2R c) (fun t => t * at_real a t)); [apply derivable_pt_lim_const|].
    apply (derivable_pt_lim_mult (fun t => t) (at_real a)); [apply derivable_pt_lim_id | exact IH].
Qed.

Lemma continuous a : continuity (at_real a).
Proof.
  intro t. apply derivable_continuous_pt. exists (at_real (pder a) t). apply derivative_is.
Qed.

(** ** Bernstein coefficients, times binomial coefficients: [(1+s)^n a((l+hs)/(1+s))] *)

Fixpoint bernstein (l h : Q) (a : polynomial) : polynomial :=
  match a with
  | [] => []
  | c :: rest => padd (pscale c (ppow [1%Q; 1%Q] (length rest))) (pmul [l; h] (bernstein l h rest))
  end.

Lemma bernstein_is l h a s : 0 < 1 + s -> (0 < length a)%nat ->
  at_real (bernstein l h a) s = (1 + s) ^ (length a - 1) * at_real a ((Q2R l + Q2R h * s) / (1 + s)).
Proof.
  intros Hs. induction a as [|c a IH]; intro La; [simpl in La; lia|].
  cbn [bernstein at_real length]. rewrite at_padd, at_pscale, at_ppow, at_pmul.
  replace (S (length a) - 1)%nat with (length a) by lia.
  assert (E : at_real [1%Q; 1%Q] s = 1 + s) by (simpl; rewrite Q2R_1; lra).
  assert (F : at_real [l; h] s = Q2R l + Q2R h * s) by (simpl; lra).
  rewrite E, F. destruct a as [|d a]; [simpl; lra|].
  rewrite IH by (simpl; lia).
  replace (length (d :: a)) with (S (length (d :: a) - 1)) at 1 3 by (simpl; lia).
  set (m := (length (d :: a) - 1)%nat). set (v := at_real (d :: a) _). simpl pow. field. lra.
Qed.

Definition positive_all (a : polynomial) : bool :=
  forallb (fun c => Qle_bool 0 c) a && existsb (fun c => negb (Qle_bool c 0)) a.

Lemma nonnegative_at a s : 0 < s -> forallb (fun c => Qle_bool 0 c) a = true -> 0 <= at_real a s.
Proof.
  intro Hs. induction a as [|c a IH]; simpl; intro H; [lra|].
  apply andb_prop in H. destruct H as [Hc H]. apply Qle_bool_iff, Qle_Rle in Hc. rewrite Q2R_0 in Hc.
  specialize (IH H). assert (0 <= s * at_real a s) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma positive_at a s : 0 < s -> positive_all a = true -> 0 < at_real a s.
Proof.
  intro Hs. unfold positive_all. induction a as [|c a IH]; simpl; intro H; [discriminate|].
  apply andb_prop in H. destruct H as [H E]. apply andb_prop in H. destruct H as [Hc H].
  apply Qle_bool_iff, Qle_Rle in Hc. rewrite Q2R_0 in Hc.
  destruct (Qle_bool c 0) eqn:C; simpl in E.
  - assert (0 < at_real a s) by (apply IH; now rewrite H, E).
    assert (0 < s * at_real a s) by (apply Rmult_lt_0_compat; lra). lra.
  - pose proof (nonnegative_at a s Hs H) as N.
    assert (0 <= s * at_real a s) by (apply Rmult_le_pos; lra).
    assert (0 < Q2R c).
    { rewrite <- Q2R_0. apply Qlt_Rlt. apply Qnot_le_lt. intro L. apply Qle_bool_iff in L. congruence. }
    lra.
Qed.

Definition signed (s : bool) (a : polynomial) : polynomial := if s then a else pscale (-1) a.
Definition sign (s : bool) : R := if s then 1 else -1.

Lemma at_signed s a t : at_real (signed s a) t = sign s * at_real a t.
Proof.
  destruct s; simpl; [lra|]. rewrite at_pscale. unfold Q2R; simpl. lra.
Qed.

(** Bernstein coefficients of one sign: no zero inside. *)
Definition one_sign (a : polynomial) (l h : Q) (s : bool) : bool :=
  negb (Qle_bool h l) && positive_all (bernstein l h (signed s a)).

Lemma no_zero a l h s t : one_sign a l h s = true -> Q2R l < t < Q2R h -> 0 < sign s * at_real a t.
Proof.
  unfold one_sign. intros H Ht. apply andb_prop in H. destruct H as [_ H].
  rewrite <- at_signed. set (b := signed s a) in *.
  set (x := (t - Q2R l) / (Q2R h - t)).
  assert (Hx : 0 < x) by (apply Rdiv_lt_0_compat; lra).
  pose proof (positive_at _ x Hx H) as P.
  assert (Lb : (0 < length b)%nat) by (destruct b; [discriminate | simpl; lia]).
  rewrite bernstein_is in P by (try assumption; lra).
  replace ((Q2R l + Q2R h * x) / (1 + x)) with t in P by (unfold x; field; lra).
  assert (W : 0 < (1 + x) ^ (length b - 1)) by (apply pow_lt; lra).
  destruct (Rle_or_lt (at_real b t) 0) as [N|N]; [|exact N].
  exfalso. assert ((1 + x) ^ (length b - 1) * at_real b t <= 0).
  { rewrite <- (Rmult_0_r ((1 + x) ^ (length b - 1))). apply Rmult_le_compat_l; lra. }
  lra.
Qed.

(** Opposite signs at the ends: a zero inside. *)
Lemma a_zero a l h s : l < h -> 0 < sign s * at_real a l -> sign s * at_real a h < 0 ->
  exists z, l < z < h /\ at_real a z = 0.
Proof.
  intros Hlh Hl Hh. set (g := fun t => - (sign s * at_real a t)).
  assert (C : continuity g).
  { apply continuity_opp, (continuity_scal (at_real a)), continuous. }
  destruct (IVT g l h C Hlh) as [z [[H1 H2] Hz]]; unfold g in *; [lra|lra|].
  assert (Z : at_real a z = 0) by (destruct s; simpl in Hz; lra).
  exists z. split; [|exact Z].
  split; (destruct H1 as [H1| <-]; destruct H2 as [H2| ->]); try lra; rewrite Z in *; lra.
Qed.

(** A derivative with Bernstein coefficients of one sign: strictly monotone, at most one zero. *)
Lemma at_most_one a l h s x y : one_sign (pder a) l h s = true ->
  Q2R l <= x -> x < y -> y <= Q2R h -> sign s * at_real a x < sign s * at_real a y.
Proof.
  intros H Hx Hxy Hy.
  destruct (MVT_cor2 (at_real a) (at_real (pder a)) x y Hxy) as [c [Hc Hcc]].
  { intros c _. apply derivative_is. }
  pose proof (no_zero _ _ _ _ c H) as P. assert (Q2R l < c < Q2R h) by lra. specialize (P H0).
  assert (0 < (sign s * at_real (pder a) c) * (y - x)) by (apply Rmult_lt_0_compat; lra).
  nra.
Qed.

(** ** Certificates: an interval in cells *)

Inductive cell :=
  | Sign (l h : Q) (s : bool)
  | One (l h : Q) (s : bool)
  | Multiple (l h : Q) (factor : polynomial) (s : bool) (n : nat) (rest : polynomial) (s' : bool)
  | Null (l h : Q).

Definition low (c : cell) : Q := match c with Sign l _ _ | One l _ _ | Multiple l _ _ _ _ _ _ | Null l _ => l end.
Definition high (c : cell) : Q := match c with Sign _ h _ | One _ h _ | Multiple _ h _ _ _ _ _ | Null _ h => h end.

(** What a cell says of a function: its sign, its one zero with the sign to the left and to the right, that it is 0. *)
Definition says (f : R -> R) (c : cell) : Prop :=
  match c with
  | Sign l h u => forall t, Q2R l < t < Q2R h -> 0 < sign u * f t
  | One l h u => exists z, Q2R l < z < Q2R h /\ f z = 0 /\
      (forall t, Q2R l <= t < z -> 0 < sign u * f t) /\ (forall t, z < t <= Q2R h -> sign u * f t < 0)
  | Multiple l h _ _ _ _ _ => exists z, Q2R l < z < Q2R h /\ f z = 0 /\
      (forall t, Q2R l <= t <= Q2R h -> t <> z -> f t <> 0)
  | Null l h => forall t, Q2R l <= t <= Q2R h -> f t = 0
  end.

Definition qpos (x : Q) : bool := negb (Qle_bool x 0).
Definition signed_value (s : bool) (a : polynomial) (t : Q) : Q := at_rational (signed s a) t.

Definition one_zero (a : polynomial) (l h : Q) (s : bool) : bool :=
  negb (Qle_bool h l) && qpos (signed_value s a l) && qpos (signed_value (negb s) a h)
  && one_sign (pder a) l h (negb s).

Definition nowhere_zero (a : polynomial) (l h : Q) (s : bool) : bool :=
  one_sign a l h s && qpos (signed_value s a l) && qpos (signed_value s a h).

Definition pzero (a : polynomial) : bool := forallb (fun c => Qeq_bool c 0) a.

Fixpoint peq (a b : polynomial) : bool :=
  match a, b with
  | [], b => pzero b
  | a, [] => pzero a
  | x :: a, y :: b => Qeq_bool x y && peq a b
  end.

Definition cell_holds (a : polynomial) (c : cell) : bool :=
  match c with
  | Sign l h u => one_sign a l h u
  | One l h u => one_zero a l h u
  | Multiple l h g u n r v =>
    one_zero g l h u && nowhere_zero r l h v && negb (Nat.eqb n 0) && peq a (pmul (ppow g n) r)
  | Null l h => pzero a && negb (Qle_bool h l)
  end.

Lemma qpos_sound x : qpos x = true -> 0 < Q2R x.
Proof.
  unfold qpos. intro H. rewrite <- Q2R_0. apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L.
  rewrite L in H. discriminate.
Qed.

Lemma signed_value_sound s a t : qpos (signed_value s a t) = true -> 0 < sign s * at_real a (Q2R t).
Proof. intro H. apply qpos_sound in H. unfold signed_value in H. rewrite <- at_real_rational, at_signed in H. exact H. Qed.

Lemma sign_negb s x : sign (negb s) * x = - (sign s * x).
Proof. destruct s; simpl; lra. Qed.

Lemma pzero_sound a t : pzero a = true -> at_real a t = 0.
Proof.
  induction a as [|x a IH]; simpl; intro H; [reflexivity|].
  apply andb_prop in H. destruct H as [H1 H2]. apply Qeq_bool_eq, Qeq_eqR in H1. rewrite Q2R_0 in H1.
  rewrite (IH H2). lra.
Qed.

Lemma peq_sound a t : forall b, peq a b = true -> at_real a t = at_real b t.
Proof.
  induction a as [|x a IH]; intros [|y b] H; try reflexivity.
  - symmetry. exact (pzero_sound _ t H).
  - exact (pzero_sound _ t H).
  - simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply Qeq_bool_eq, Qeq_eqR in H1.
    simpl. now rewrite H1, (IH b H2).
Qed.

Lemma one_zero_sound a l h s : one_zero a l h s = true -> says (at_real a) (One l h s).
Proof.
  unfold one_zero. intro H. repeat (apply andb_prop in H; destruct H as [H ?]).
  assert (Hlh : Q2R l < Q2R h).
  { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in H. discriminate. }
  apply signed_value_sound in H2. apply signed_value_sound in H1. rewrite sign_negb in H1.
  destruct (a_zero a (Q2R l) (Q2R h) s Hlh H2) as [z [Hz Z]]; [lra|].
  exists z. split; [exact Hz|]. split; [exact Z|]. split; intros t Ht.
  - pose proof (at_most_one a l h (negb s) t z H0) as M. rewrite !sign_negb, Z in M. lra.
  - pose proof (at_most_one a l h (negb s) z t H0) as M. rewrite !sign_negb, Z in M. lra.
Qed.

Lemma nowhere_zero_sound a l h s t : nowhere_zero a l h s = true -> Q2R l <= t <= Q2R h -> at_real a t <> 0.
Proof.
  unfold nowhere_zero. intros H Ht. apply andb_prop in H. destruct H as [H H0].
  apply andb_prop in H. destruct H as [H H1].
  apply signed_value_sound in H0. apply signed_value_sound in H1. intro Z.
  destruct (Req_dec t (Q2R l)) as [E|Nl]; [rewrite <- E, Z in H1; lra|].
  destruct (Req_dec t (Q2R h)) as [E|Nh]; [rewrite <- E, Z in H0; lra|].
  assert (I : Q2R l < t < Q2R h) by lra.
  pose proof (no_zero a l h s t H I) as P. rewrite Z in P. lra.
Qed.

Lemma cell_sound a c : cell_holds a c = true -> says (at_real a) c.
Proof.
  destruct c as [l h s|l h s|l h g s n r s'|l h]; cbn [cell_holds].
  - intros H t Ht. exact (no_zero a l h s t H Ht).
  - apply one_zero_sound.
  - intro H. do 3 (apply andb_prop in H; destruct H as [H ?]).
    destruct (one_zero_sound _ _ _ _ H) as [z [Hz [Z [Hl Hh]]]].
    assert (E : forall t, at_real a t = at_real g t ^ n * at_real r t).
    { intro t. rewrite (peq_sound _ t _ H0), at_pmul, at_ppow. reflexivity. }
    assert (Hn : n <> O) by (intros ->; discriminate).
    exists z. split; [exact Hz|]. split.
    + rewrite E, Z, pow_i by lia. lra.
    + intros t Ht Nt. rewrite E. apply Rmult_integral_contrapositive. split.
      * apply pow_nonzero. destruct (Rtotal_order t z) as [L|[L|L]]; [|lra|].
        -- specialize (Hl t). intro Y. rewrite Y in Hl. lra.
        -- specialize (Hh t). intro Y. rewrite Y in Hh. lra.
      * exact (nowhere_zero_sound r l h s' t H2 Ht).
  - intros H t Ht. apply andb_prop in H. destruct H as [H _]. exact (pzero_sound a t H).
Qed.

(** ** The zeros on an interval *)

(** Where the zeros are that a chain of cells from [l] to [b] tells of: in intervals, at points; the zeros at [b] only
    where [b] belongs to it. *)
Definition zero_at (a : polynomial) (t : Q) : bool := Qeq_bool (at_rational a t) 0.

Definition is_null (c : cell) : bool := match c with Null _ _ => true | _ => false end.

Fixpoint zeros (closed : bool) (a : polynomial) (cells : list cell) : list (Q * Q) :=
  match cells with
  | [] => []
  | c :: rest =>
    (if zero_at a (low c) then [(low c, low c)] else [])
    ++ (match c with One l h _ | Multiple l h _ _ _ _ _ => [(l, h)] | _ => [] end)
    ++ (match rest with [] => if closed && zero_at a (high c) then [(high c, high c)] else [] | _ => [] end)
    ++ zeros closed a rest
  end.

Fixpoint chained (from : Q) (cells : list cell) (to : Q) : bool :=
  match cells with
  | [] => Qeq_bool from to
  | c :: rest => Qeq_bool (low c) from && negb (Qle_bool (high c) (low c)) && chained (high c) rest to
  end.

(** What is checked: cells without a gap, each of which holds; a form that is 0 has one cell. *)
Definition answer (a : polynomial) (from to : Q) (cells : list cell) : bool :=
  chained from cells to && forallb (cell_holds a) cells.

(** A number is inside an interval, or the point that it is shrunk to. *)
Definition within (z : R) (i : Q * Q) : Prop :=
  Q2R (fst i) < z < Q2R (snd i) \/ (Q2R (fst i) = z /\ z = Q2R (snd i)).
Definition inside (closed : bool) (from to : Q) (t : R) : Prop :=
  Q2R from <= t /\ (if closed then t <= Q2R to else t < Q2R to).

(** A function vanishes on an interval at exactly so many points, one in each of the intervals (or points) named. *)
Definition exactly (f : R -> R) (closed : bool) (from to : Q) (where_ : list (Q * Q)) : Prop :=
  exists zs, Forall2 within zs where_ /\ (forall z, In z zs -> inside closed from to z) /\
  forall t, inside closed from to t -> (f t = 0 <-> In t zs).

Lemma zero_at_sound a t : zero_at a t = true <-> at_real a (Q2R t) = 0.
Proof.
  unfold zero_at. rewrite at_real_rational. split; intro H.
  - apply Qeq_bool_eq, Qeq_eqR in H. now rewrite Q2R_0 in H.
  - apply Qeq_bool_iff. apply eqR_Qeq. now rewrite Q2R_0.
Qed.

Lemma point a t : exists zs, Forall2 within zs (if zero_at a t then [(t, t)] else []) /\
  forall x, x = Q2R t -> (at_real a x = 0 <-> In x zs).
Proof.
  destruct (zero_at a t) eqn:E.
  - exists [Q2R t]. split; [constructor; [unfold within; simpl; first [left; lra | right; lra] | constructor]|].
    intros x ->. apply zero_at_sound in E. simpl. tauto.
  - exists []. split; [constructor|]. intros x ->. split; [|simpl; tauto].
    intro Z. apply zero_at_sound in Z. congruence.
Qed.

(** The zeros of one cell inside it. *)
Definition own (c : cell) : list (Q * Q) :=
  match c with One l h _ | Multiple l h _ _ _ _ _ => [(l, h)] | _ => [] end.

Lemma cell_zeros a c : cell_holds a c = true -> is_null c = false ->
  exists zs, Forall2 within zs (own c) /\ (forall z, In z zs -> Q2R (low c) < z < Q2R (high c)) /\
  forall t, Q2R (low c) < t < Q2R (high c) -> (at_real a t = 0 <-> In t zs).
Proof.
  intros H N. apply cell_sound in H. destruct c as [l h s|l h s|l h g s n r s'|l h]; simpl in *; try discriminate.
  - exists []. split; [constructor|]. split; [simpl; tauto|]. intros t Ht. split; [|simpl; tauto].
    intro Z. specialize (H t Ht). rewrite Z in H. lra.
  - destruct H as [z [Hz [Z [Hl Hh]]]]. exists [z]. split; [constructor; [unfold within; simpl; first [left; lra | right; lra] | constructor]|].
    split; [intros y [<-|[]]; exact Hz|].
    intros t Ht. simpl. split; [|intros [<-|[]]; exact Z]. intro Y. left.
    destruct (Rtotal_order t z) as [L|[L|L]]; [|lra|].
    + specialize (Hl t). rewrite Y in Hl. lra.
    + specialize (Hh t). rewrite Y in Hh. lra.
  - destruct H as [z [Hz [Z Hn]]]. exists [z]. split; [constructor; [unfold within; simpl; first [left; lra | right; lra] | constructor]|].
    split; [intros y [<-|[]]; exact Hz|].
    intros t Ht. simpl. split; [|intros [<-|[]]; exact Z]. intro Y. left.
    destruct (Req_dec t z) as [->|D]; [reflexivity|]. exfalso. apply (Hn t); [lra | exact D | exact Y].
Qed.

Lemma chained_ends cells to : cells <> [] -> forall from, chained from cells to = true -> Q2R from < Q2R to.
Proof.
  induction cells as [|c cells IH]; intros N from H; [congruence|].
  simpl in H. apply andb_prop in H. destruct H as [H Hn]. apply andb_prop in H. destruct H as [Hl Hh].
  apply Qeq_bool_eq, Qeq_eqR in Hl.
  assert (Lt : Q2R (low c) < Q2R (high c)).
  { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in Hh. discriminate. }
  destruct cells as [|d cells].
  - simpl in Hn. apply Qeq_bool_eq, Qeq_eqR in Hn. lra.
  - assert (Q2R (high c) < Q2R to) by (apply IH; [discriminate | exact Hn]). lra.
Qed.

Theorem answer_sound closed a cells : forall from to, cells <> [] ->
  forallb (fun c => negb (is_null c)) cells = true -> answer a from to cells = true ->
  exactly (at_real a) closed from to (zeros closed a cells).
Proof.
  induction cells as [|c rest IH]; intros from to Ne Nn H; [congruence|].
  simpl in Nn. apply andb_prop in Nn. destruct Nn as [Nc Nr]. apply negb_true_iff in Nc.
  unfold answer in H. simpl in H. apply andb_prop in H. destruct H as [Hc H].
  apply andb_prop in H. destruct H as [Hh Hr].
  apply andb_prop in Hc. destruct Hc as [Hc Hchain]. apply andb_prop in Hc. destruct Hc as [Hlow Hlt].
  apply Qeq_bool_eq, Qeq_eqR in Hlow.
  assert (Lt : Q2R (low c) < Q2R (high c)).
  { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in Hlt. discriminate. }
  destruct (point a (low c)) as [zl [Wl Pl]].
  destruct (cell_zeros a c Hh Nc) as [zc [Wc [Ic Pc]]].
  assert (Il : forall z, In z zl -> z = Q2R (low c)).
  { intros z I. destruct (zero_at a (low c)); inversion Wl as [|? ? ? ? W1 W2]; subst; [|destruct I].
    inversion W2; subst. unfold within in W1. simpl in W1. destruct I as [<-|[]]. lra. }
  destruct rest as [|d rest].
  - simpl in Hchain. apply Qeq_bool_eq, Qeq_eqR in Hchain.
    destruct closed.
    + destruct (point a (high c)) as [zh [Wh Ph]].
      assert (Ih : forall z, In z zh -> z = Q2R (high c)).
      { intros z I. destruct (zero_at a (high c)); inversion Wh as [|? ? ? ? W1 W2]; subst; [|destruct I].
        inversion W2; subst. unfold within in W1. simpl in W1. destruct I as [<-|[]]. lra. }
      exists (zl ++ zc ++ zh). split.
      * cbn [zeros andb]. rewrite app_nil_r. repeat apply Forall2_app; assumption.
      * split.
        { intros z I. rewrite !in_app_iff in I. unfold inside. simpl.
          destruct I as [I|[I|I]]; [specialize (Il z I) | specialize (Ic z I) | specialize (Ih z I)]; lra. }
        intros t [T1 T2]. simpl in T2. rewrite !in_app_iff.
        destruct (Rtotal_order t (Q2R (low c))) as [L|[L|L]]; [lra| |].
        -- rewrite (Pl t L). split; [tauto|]. intros [I|[I|I]]; [exact I| |].
           ++ specialize (Ic t I). lra.
           ++ specialize (Ih t I). lra.
        -- destruct (Rtotal_order t (Q2R (high c))) as [M|[M|M]]; [| |lra].
           ++ rewrite (Pc t (conj L M)). split; [tauto|]. intros [I|[I|I]]; [|exact I|].
              ** specialize (Il t I). lra.
              ** specialize (Ih t I). lra.
           ++ rewrite (Ph t M). split; [tauto|]. intros [I|[I|I]]; [| |exact I].
              ** specialize (Il t I). lra.
              ** specialize (Ic t I). lra.
    + exists (zl ++ zc). split.
      * cbn [zeros andb]. rewrite !app_nil_r. apply Forall2_app; assumption.
      * split.
        { intros z I. rewrite in_app_iff in I. unfold inside. simpl.
          destruct I as [I|I]; [specialize (Il z I) | specialize (Ic z I)]; lra. }
        intros t [T1 T2]. simpl in T2. rewrite in_app_iff.
        destruct (Rtotal_order t (Q2R (low c))) as [L|[L|L]]; [lra| |].
        -- rewrite (Pl t L). split; [tauto|]. intros [I|I]; [exact I|]. specialize (Ic t I). lra.
        -- assert (M : t < Q2R (high c)) by lra. rewrite (Pc t (conj L M)). split; [tauto|].
           intros [I|I]; [|exact I]. specialize (Il t I). lra.
  - assert (Ar : answer a (high c) to (d :: rest) = true) by (unfold answer; now rewrite Hchain, Hr).
    destruct (IH (high c) to) as [zr [Wr [Ir Pr]]]; [discriminate | exact Nr | exact Ar |].
    assert (Order : forall z, In z zr -> Q2R (high c) <= z) by (intros z I; apply (Ir z I)).
    assert (End : Q2R (high c) < Q2R to).
    { apply (chained_ends (d :: rest)); [discriminate | exact Hchain]. }
    exists (zl ++ zc ++ zr). split.
    + change (zeros closed a (c :: d :: rest)) with
        ((if zero_at a (low c) then [(low c, low c)] else []) ++ own c ++ [] ++ zeros closed a (d :: rest)).
      simpl app at 3. repeat apply Forall2_app; assumption.
    + split.
      { intros z I. rewrite !in_app_iff in I. destruct I as [I|[I|I]].
        - specialize (Il z I). split; [lra | destruct closed; lra].
        - specialize (Ic z I). split; [lra | destruct closed; lra].
        - destruct (Ir z I) as [I1 I2]. split; [lra | exact I2]. }
      intros t [T1 T2]. rewrite !in_app_iff.
      destruct (Rtotal_order t (Q2R (low c))) as [L|[L|L]]; [lra| |].
      * rewrite (Pl t L). split; [tauto|]. intros [I|[I|I]]; [exact I| |].
        -- specialize (Ic t I). lra.
        -- specialize (Order t I). lra.
      * destruct (Rlt_or_le t (Q2R (high c))) as [M|M].
        -- rewrite (Pc t (conj L M)). split; [tauto|]. intros [I|[I|I]]; [|exact I|].
           ++ specialize (Il t I). lra.
           ++ specialize (Order t I). lra.
        -- assert (T : inside closed (high c) to t) by (split; assumption).
           rewrite (Pr t T). split; [tauto|]. intros [I|[I|I]]; [| |exact I].
           ++ specialize (Il t I). lra.
           ++ specialize (Ic t I). lra.
Qed.

(** ** B-splines *)

(** A quotient, 0 where it does not exist: the convention of Cox and de Boor. *)
Definition over (a b : R) : R := if Req_EM_T b 0 then 0 else a / b.

Definition knot (u : list Q) (i : nat) : R := Q2R (nth i u 0%Q).

(** The B-spline basis function of degree [d] that begins at the knot [i], by the recursion of Cox and de Boor. *)
Fixpoint basis (u : list Q) (d i : nat) (t : R) : R :=
  match d with
  | O => if Rle_dec (knot u i) t then if Rlt_dec t (knot u (S i)) then 1 else 0 else 0
  | S d =>
    over (t - knot u i) (knot u (i + d + 1) - knot u i) * basis u d i t
    + over (knot u (i + d + 2) - t) (knot u (i + d + 2) - knot u (i + 1)) * basis u d (S i) t
  end.

(** The spline with given coefficients, those from the index [i] on. *)
Fixpoint spline_from (u : list Q) (d i : nat) (c : list Q) (t : R) : R :=
  match c with [] => 0 | x :: c => Q2R x * basis u d i t + spline_from u d (S i) c t end.

Definition spline (u : list Q) (d : nat) (c : list Q) : R -> R := spline_from u d 0 c.

(** The same between the knots [j] and [j + 1], where it is a polynomial. *)
Definition ramp (a b : Q) (rising : bool) : polynomial :=
  let w := Qred (b - a) in
  if Qeq_bool w 0 then []
  else if rising then [Qred (- a / w); Qred (1 / w)] else [Qred (b / w); Qred (- (1) / w)].

Fixpoint basis_piece (u : list Q) (j d i : nat) : polynomial :=
  if (i <=? j) && (j <=? i + d) then
    match d with
    | O => [1%Q]
    | S d =>
      padd (pmul (ramp (nth i u 0%Q) (nth (i + d + 1) u 0%Q) true) (basis_piece u j d i))
           (pmul (ramp (nth (i + 1) u 0%Q) (nth (i + d + 2) u 0%Q) false) (basis_piece u j d (S i)))
    end
  else [].

Fixpoint piece_from (u : list Q) (j d i : nat) (c : list Q) : polynomial :=
  match c with [] => [] | x :: c => padd (pscale x (basis_piece u j d i)) (piece_from u j d (S i) c) end.

Definition piece (u : list Q) (d : nat) (c : list Q) (j : nat) : polynomial := piece_from u j d 0 c.

Fixpoint increasing (u : list Q) : bool :=
  match u with x :: ((y :: _) as r) => Qle_bool x y && increasing r | _ => true end.

Lemma increasing_sound u : increasing u = true -> forall i k, (i <= k < length u)%nat -> knot u i <= knot u k.
Proof.
  unfold knot. induction u as [|x u IH]; intros H i k Hk; [simpl in Hk; lia|].
  assert (H' : increasing u = true).
  { destruct u; [reflexivity|]. simpl in H. apply andb_prop in H. apply H. }
  destruct k as [|k]; [assert (i = 0)%nat as -> by lia; lra|].
  simpl in Hk. destruct i as [|i]; [|simpl; apply IH; [exact H' | lia]].
  destruct u as [|y u]; [simpl in Hk; lia|].
  assert (B : Q2R x <= Q2R y).
  { simpl in H. apply andb_prop in H. destruct H as [H _]. apply Qle_Rle. now apply Qle_bool_iff. }
  specialize (IH H' 0%nat k). simpl in IH |- *. assert (0 <= k < S (length u))%nat as Hk' by (simpl in Hk; lia).
  specialize (IH Hk'). lra.
Qed.

Lemma at_ramp_rising a b t : at_real (ramp a b true) t = over (t - Q2R a) (Q2R b - Q2R a).
Proof.
  unfold ramp, over. assert (W : Q2R (Qred (b - a)) = Q2R b - Q2R a)
    by (rewrite (Qeq_eqR _ _ (Qred_correct _)); apply Q2R_minus).
  destruct (Qeq_bool (Qred (b - a)) 0) eqn:E.
  - apply Qeq_bool_eq, Qeq_eqR in E. rewrite W, Q2R_0 in E. destruct (Req_EM_T _ 0); [reflexivity | contradiction].
  - assert (N : Q2R b - Q2R a <> 0).
    { rewrite <- W. intro Z. rewrite <- Q2R_0 in Z. apply eqR_Qeq, Qeq_bool_iff in Z. congruence. }
    assert (Nq : ~ Qred (b - a) == 0) by (intro Z; apply Qeq_bool_iff in Z; congruence).
    destruct (Req_EM_T _ 0); [contradiction|]. simpl.
    rewrite !(Qeq_eqR _ _ (Qred_correct (_ / _))). rewrite !Q2R_div, Q2R_opp, W, Q2R_1 by exact Nq. field. exact N.
Qed.

Lemma at_ramp_falling a b t : at_real (ramp a b false) t = over (Q2R b - t) (Q2R b - Q2R a).
Proof.
  unfold ramp, over. assert (W : Q2R (Qred (b - a)) = Q2R b - Q2R a)
    by (rewrite (Qeq_eqR _ _ (Qred_correct _)); apply Q2R_minus).
  destruct (Qeq_bool (Qred (b - a)) 0) eqn:E.
  - apply Qeq_bool_eq, Qeq_eqR in E. rewrite W, Q2R_0 in E. destruct (Req_EM_T _ 0); [reflexivity | contradiction].
  - assert (N : Q2R b - Q2R a <> 0).
    { rewrite <- W. intro Z. rewrite <- Q2R_0 in Z. apply eqR_Qeq, Qeq_bool_iff in Z. congruence. }
    assert (Nq : ~ Qred (b - a) == 0) by (intro Z; apply Qeq_bool_iff in Z; congruence).
    destruct (Req_EM_T _ 0); [contradiction|]. simpl.
    rewrite !(Qeq_eqR _ _ (Qred_correct (_ / _))). rewrite !Q2R_div, Q2R_opp, W, Q2R_1 by exact Nq. field. exact N.
Qed.

Section Pieces.
Variable u : list Q.
Variable j : nat.
Hypothesis Hu : increasing u = true.
Variable t : R.
Hypothesis Ht : knot u j <= t < knot u (S j).

Lemma basis_outside d : forall i, (i + d + 1 < length u)%nat -> (S j < length u)%nat -> (j < i \/ i + d < j)%nat ->
  basis u d i t = 0.
Proof.
  induction d as [|d IH]; intros i Hi Hj O.
  - simpl. destruct (Rle_dec (knot u i) t) as [L|]; [|reflexivity].
    destruct (Rlt_dec t (knot u (S i))) as [G|]; [|reflexivity]. exfalso.
    destruct O as [O|O].
    + pose proof (increasing_sound u Hu (S j) i). assert (knot u (S j) <= knot u i) by (apply H; lia). lra.
    + pose proof (increasing_sound u Hu (S i) j). assert (knot u (S i) <= knot u j) by (apply H; lia). lra.
  - simpl. rewrite (IH i), (IH (S i)) by lia. lra.
Qed.

Lemma basis_is d : forall i, (i + d + 1 < length u)%nat -> (S j < length u)%nat ->
  basis u d i t = at_real (basis_piece u j d i) t.
Proof.
  induction d as [|d IH]; intros i Hi Hj.
  - simpl basis_piece. rewrite Nat.add_0_r.
    destruct ((i <=? j) && (j <=? i)) eqn:E.
    + apply andb_prop in E. destruct E as [A B]. apply Nat.leb_le in A. apply Nat.leb_le in B.
      assert (i = j) as -> by lia. simpl. rewrite Q2R_1.
      destruct (Rle_dec (knot u j) t); [|lra]. destruct (Rlt_dec t (knot u (S j))); lra.
    + rewrite (basis_outside 0 i); [reflexivity | lia | lia |].
      apply andb_false_iff in E. destruct E as [E|E]; apply Nat.leb_gt in E; lia.
  - cbn [basis_piece]. destruct ((i <=? j) && (j <=? i + S d)) eqn:E.
    + rewrite at_padd, !at_pmul, at_ramp_rising, at_ramp_falling. cbn [basis].
      rewrite (IH i), (IH (S i)) by lia. unfold knot. reflexivity.
    + rewrite (basis_outside (S d) i); [reflexivity | lia | lia |].
      apply andb_false_iff in E. destruct E as [E|E]; apply Nat.leb_gt in E; lia.
Qed.

Lemma spline_from_is d c : forall i, (i + length c + d < length u)%nat -> (S j < length u)%nat ->
  spline_from u d i c t = at_real (piece_from u j d i c) t.
Proof.
  induction c as [|x c IH]; intros i Hi Hj; [reflexivity|].
  simpl in *. rewrite at_padd, at_pscale, (basis_is d i), (IH (S i)) by lia. reflexivity.
Qed.

End Pieces.

(** ** A curve *)

(** Knots, degree, and the control points times their weights: coordinate by coordinate, and the weights. *)
Record nurbs := { knots : list Q; degree : nat; coordinates : list (list Q); weights : list Q }.

Definition sound (c : nurbs) : bool :=
  increasing (knots c) &&
  forallb (fun x => Nat.eqb (length x + degree c + 1) (length (knots c))) (weights c :: coordinates c).

(** Coefficients over one denominator. *)
Definition denominator (as_ : list polynomial) : positive :=
  fold_right (fun c d => Z.to_pos (Z.lcm (Zpos (Qden c)) (Zpos d))) 1%positive (concat as_).

Definition over_one (d : positive) (c : Q) : Q :=
  let e := (Qnum c * (Zpos d / Zpos (Qden c)))%Z # d in if Qeq_bool e c then e else c.

Lemma at_over_one d a t : at_real (map (over_one d) a) t = at_real a t.
Proof.
  induction a as [|c a IH]; [reflexivity|]. simpl. rewrite IH. f_equal. unfold over_one.
  destruct (Qeq_bool _ c) eqn:E; [now apply Qeq_eqR, Qeq_bool_eq | reflexivity].
Qed.

(** The curve between the knots [j] and [j + 1], as formulas are handed it. *)
Definition curve_piece (c : nurbs) (j : nat) : curve polynomial :=
  let x := map (fun x => piece (knots c) (degree c) x j) (coordinates c) in
  let y := piece (knots c) (degree c) (weights c) j in
  let d := denominator (y :: x) in
  Curve s (map (map (over_one d)) x) (map (over_one d) y) [] [].

(** The pieces are those of the B-splines by the recursion of Cox and de Boor. *)
Theorem pieces_are_splines (c : nurbs) (j : nat) (t : R) :
  sound c = true -> (S j < length (knots c))%nat -> knot (knots c) j <= t < knot (knots c) (S j) ->
  Forall2 (fun x a => spline (knots c) (degree c) x t = at_real a t) (coordinates c) (p (curve_piece c j)) /\
  spline (knots c) (degree c) (weights c) t = at_real (w (curve_piece c j)) t.
Proof.
  intros H Hj Ht. unfold sound in H. apply andb_prop in H. destruct H as [Hu H]. simpl in H.
  apply andb_prop in H. destruct H as [Hw Hc]. apply Nat.eqb_eq in Hw. split.
  - unfold curve_piece. cbn [p]. set (d := denominator _). clearbody d.
    induction (coordinates c) as [|x xs IH]; constructor.
    + simpl in Hc. apply andb_prop in Hc. destruct Hc as [Hx _]. apply Nat.eqb_eq in Hx. rewrite at_over_one.
      apply (spline_from_is (knots c) j Hu t Ht); lia.
    + apply IH. simpl in Hc. now apply andb_prop in Hc.
  - unfold curve_piece. cbn [w]. rewrite at_over_one. apply (spline_from_is (knots c) j Hu t Ht); lia.
Qed.

(** ** What is said of a form of a curve *)

(** The spans of the knots that are not empty, between the first and the last one at which the curve is complete. *)
Definition spans (c : nurbs) : list nat :=
  filter (fun j => negb (Qle_bool (nth (S j) (knots c) 0%Q) (nth j (knots c) 0%Q)))
         (seq (degree c) (length (knots c) - 2 * degree c - 1)).

(** A form in pieces: the right end of each, and its polynomial; the last one holds at its right end, too. *)
Definition pieces : Type := list (Q * polynomial).

(** Without zeros at the end, which change nothing. *)
Fixpoint trimmed (a : polynomial) : polynomial :=
  match a with
  | [] => []
  | c :: a => match trimmed a with [] => if Qeq_bool c 0 then [] else [c] | b => c :: b end
  end.

Lemma at_trimmed a t : at_real (trimmed a) t = at_real a t.
Proof.
  induction a as [|c a IH]; [reflexivity|]. simpl. rewrite <- IH. destruct (trimmed a) as [|d b]; [|reflexivity].
  destruct (Qeq_bool c 0) eqn:E; [|reflexivity]. apply Qeq_bool_eq, Qeq_eqR in E. rewrite Q2R_0 in E. simpl. lra.
Qed.

Definition form_pieces (form : curve polynomial -> polynomial) (c : nurbs) : pieces :=
  map (fun j => (nth (S j) (knots c) 0%Q, trimmed (form (curve_piece c j)))) (spans c).

Fixpoint form_value (f : pieces) (t : R) : R :=
  match f with
  | [] => 0
  | [(_, a)] => at_real a t
  | (b, a) :: f => if Rlt_dec t (Q2R b) then at_real a t else form_value f t
  end.

(** A function vanishes, on an interval with its ends, at exactly so many points, each after the one before, one in each
    of the intervals (or at the points) named, and on the stretches named. *)
Definition vanishes_exactly (f : R -> R) (from to : Q) (points stretches : list (Q * Q)) : Prop :=
  exists zs, Sorted Rlt zs /\ Forall2 within zs points /\ forall t, Q2R from <= t <= Q2R to ->
  (f t = 0 <-> In t zs \/ Exists (fun i => Q2R (fst i) <= t < Q2R (snd i)) stretches).

(** Intervals of which each begins where the one before has ended; two are not one point. *)
Fixpoint separated (points : list (Q * Q)) : bool :=
  match points with
  | i :: ((j :: _) as rest) => Qle_bool (snd i) (fst j) && negb (Qle_bool (snd j) (fst i)) && separated rest
  | _ => true
  end.

Lemma separated_sorted points : separated points = true -> forall zs, Forall2 within zs points -> Sorted Rlt zs.
Proof.
  induction points as [|i points IH]; intros H zs W; inversion W; subst; [constructor|].
  destruct points as [|j points].
  - inversion H4; subst. repeat constructor.
  - simpl in H. apply andb_prop in H. destruct H as [H Hrest]. apply andb_prop in H. destruct H as [Hij Hji].
    constructor; [exact (IH Hrest _ H4)|]. inversion H4; subst. constructor.
    apply Qle_bool_iff, Qle_Rle in Hij.
    assert (L : Q2R (fst i) < Q2R (snd j)).
    { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in Hji. discriminate. }
    unfold within in *. lra.
Qed.

(** The domain of a curve: from the first to the last knot between which all B-splines are there. *)
Definition domain (c : nurbs) : Q * Q :=
  (nth (degree c) (knots c) 0%Q, nth (length (knots c) - degree c - 1) (knots c) 0%Q).

Definition null_span (cells : list cell) : bool := match cells with [Null _ _] => true | _ => false end.

Definition span_zeros (closed : bool) (a : polynomial) (cells : list cell) : list (Q * Q) :=
  if null_span cells then match cells with c :: _ => if closed then [(high c, high c)] else [] | [] => [] end
  else zeros closed a cells.

Fixpoint all_zeros (f : pieces) (cells : list (list cell)) : list (Q * Q) :=
  match f, cells with
  | [(_, a)], [c] => span_zeros true a c
  | (_, a) :: f, c :: cells => span_zeros false a c ++ all_zeros f cells
  | _, _ => []
  end.

Definition stretch (cells : list cell) : list (Q * Q) :=
  if null_span cells then match cells with c :: _ => [(low c, high c)] | [] => [] end else [].

Definition all_stretches (cells : list (list cell)) : list (Q * Q) := flat_map stretch cells.

Definition span_answer (a : polynomial) (from to : Q) (cells : list cell) : bool :=
  answer a from to cells && (null_span cells || (negb (match cells with [] => true | _ => false end)
                                                 && forallb (fun c => negb (is_null c)) cells)).

Fixpoint answers (f : pieces) (from : Q) (cells : list (list cell)) : bool :=
  match f, cells with
  | [(b, a)], [c] => span_answer a from b c
  | (b, a) :: f, c :: cells => span_answer a from b c && answers f b cells
  | _, _ => false
  end.

Lemma span_sound closed a from to cells : span_answer a from to cells = true ->
  Q2R from < Q2R to /\
  (forall i, In i (stretch cells) -> Q2R from <= Q2R (fst i) /\ Q2R (snd i) <= Q2R to) /\
  exists zs, Forall2 within zs (span_zeros closed a cells) /\
  (forall z, In z zs -> inside closed from to z) /\
  forall t, inside closed from to t ->
  (at_real a t = 0 <-> In t zs \/ Exists (fun i => Q2R (fst i) <= t < Q2R (snd i)) (stretch cells)).
Proof.
  intro H. unfold span_answer in H. apply andb_prop in H. destruct H as [Ha H].
  assert (Ne : cells <> []) by (intros ->; discriminate).
  pose proof Ha as Hchain. unfold answer in Hchain. apply andb_prop in Hchain. destruct Hchain as [Hchain Hall].
  split; [exact (chained_ends _ _ Ne _ Hchain)|].
  unfold span_zeros, stretch. destruct (null_span cells) eqn:N.
  - destruct cells as [|[| | |l h] [|]]; try discriminate. simpl in Hchain, Hall |- *.
    apply andb_prop in Hchain. destruct Hchain as [Hc Ht]. apply andb_prop in Hc. destruct Hc as [Hf Hl].
    apply Qeq_bool_eq, Qeq_eqR in Hf. apply Qeq_bool_eq, Qeq_eqR in Ht.
    apply andb_prop in Hall. destruct Hall as [Hz _]. apply andb_prop in Hz. destruct Hz as [Hz _].
    assert (Lt : Q2R l < Q2R h).
    { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in Hl. discriminate. }
    split; [intros i [<-|[]]; simpl; lra|].
    exists (if closed then [Q2R h] else []). split; [|split].
    + destruct closed; repeat constructor; unfold within; simpl; first [left; lra | right; lra].
    + intros z I. destruct closed; [destruct I as [<-|[]]; unfold inside; lra | destruct I].
    + intros t [T1 T2]. rewrite (pzero_sound a t Hz). split; [intros _|reflexivity].
      destruct closed; simpl in T2.
      * destruct (Req_dec t (Q2R h)) as [->|D]; [left; now left|]. right. apply Exists_cons_hd. simpl. lra.
      * right. apply Exists_cons_hd. simpl. lra.
  - simpl in H. apply andb_prop in H. destruct H as [_ Hnull]. split; [intros i []|].
    destruct (answer_sound closed a cells from to Ne Hnull Ha) as [zs [W [I P]]].
    exists zs. split; [exact W|]. split; [exact I|].
    intros t T. rewrite (P t T). split; [now left|]. intros [J|J]; [exact J | inversion J].
Qed.

Definition right_end (from : Q) (f : pieces) : Q := fst (last f (from, [])).

(** What is checked by computation holds. *)
Lemma answers_hold f : forall from cells, answers f from cells = true ->
  Q2R from < Q2R (right_end from f) /\
  (forall i, In i (all_stretches cells) -> Q2R from <= Q2R (fst i)) /\
  exists zs, Forall2 within zs (all_zeros f cells) /\ (forall z, In z zs -> Q2R from <= z) /\
  forall t, Q2R from <= t <= Q2R (right_end from f) ->
  (form_value f t = 0 <-> In t zs \/ Exists (fun i => Q2R (fst i) <= t < Q2R (snd i)) (all_stretches cells)).
Proof.
  induction f as [|[b a] f IH]; intros from cells H; [discriminate|].
  destruct f as [|q f].
  - destruct cells as [|c [|]]; [discriminate | | simpl in H; rewrite andb_false_r in H; discriminate]. simpl in H.
    destruct (span_sound true a from b c H) as [E [S [zs [W [I P]]]]].
    unfold right_end, all_stretches. simpl. rewrite app_nil_r.
    split; [exact E|]. split; [intros i J; exact (proj1 (S i J))|].
    exists zs. split; [exact W|]. split; [intros z J; exact (proj1 (I z J))|]. intros t T. apply P. exact T.
  - destruct cells as [|c cells]; [discriminate|].
    change (span_answer a from b c && answers (q :: f) b cells = true) in H.
    apply andb_prop in H. destruct H as [H1 H2].
    destruct (span_sound false a from b c H1) as [E [S [zs [W [I P]]]]].
    destruct (IH b cells H2) as [E' [S' [ys [V [J Q]]]]].
    assert (L : right_end from ((b, a) :: q :: f) = right_end b (q :: f)).
    { unfold right_end. clear. change (last ((b, a) :: q :: f) (from, [])) with (last (q :: f) (from, [] : polynomial)).
      revert q. induction f as [|r f IHf]; intro q; [reflexivity|]. exact (IHf r). }
    rewrite L. split; [lra|]. unfold all_stretches in *. simpl flat_map.
    split.
    { intros i K. apply in_app_iff in K. destruct K as [K|K]; [apply (S i K)|]. specialize (S' i K). lra. }
    exists (zs ++ ys). split; [now apply Forall2_app|]. split.
    { intros z K. apply in_app_iff in K. destruct K as [K|K]; [apply (I z K)|]. specialize (J z K). lra. }
    intros t T.
    change (form_value ((b, a) :: q :: f) t) with (if Rlt_dec t (Q2R b) then at_real a t else form_value (q :: f) t).
    rewrite in_app_iff, Exists_app. destruct (Rlt_dec t (Q2R b)) as [B|B].
    + assert (T' : inside false from b t) by (split; simpl; lra). rewrite (P t T'). split; [tauto|].
      intros [[K|K]|[K|K]]; [now left | specialize (J t K); lra | now right |].
      apply Exists_exists in K. destruct K as [i [Ki Kt]]. specialize (S' i Ki). lra.
    + assert (T' : Q2R b <= t <= Q2R (right_end b (q :: f))) by lra. rewrite (Q t T'). split; [tauto|].
      intros [[K|K]|[K|K]]; [destruct (I t K); simpl in *; lra | now left | | now right].
      apply Exists_exists in K. destruct K as [i [Ki Kt]]. destruct (S i Ki). lra.
Qed.

Theorem answers_sound f from cells : answers f from cells && separated (all_zeros f cells) = true ->
  vanishes_exactly (form_value f) from (right_end from f) (all_zeros f cells) (all_stretches cells).
Proof.
  intro H. apply andb_prop in H. destruct H as [H D]. destruct (answers_hold f from cells H) as [_ [_ [zs [W [_ P]]]]].
  exists zs. split; [exact (separated_sorted _ D zs W) | now split].
Qed.

(** The same pieces, whether or not fractions are reduced. *)
Fixpoint same_pieces (f g : pieces) : bool :=
  match f, g with
  | [], [] => true
  | (b, x) :: f, (c, y) :: g => Qeq_bool b c && peq x y && same_pieces f g
  | _, _ => false
  end.

Lemma same_value f : forall g t, same_pieces f g = true -> form_value f t = form_value g t.
Proof.
  induction f as [|[b x] f IH]; intros [|[c y] g] t H; try discriminate; [reflexivity|].
  simpl in H. apply andb_prop in H. destruct H as [H1 H3]. apply andb_prop in H1. destruct H1 as [H1 H2].
  apply Qeq_bool_eq, Qeq_eqR in H1. pose proof (peq_sound x t y H2) as E. specialize (IH g t H3).
  destruct f as [|[qb qx] f]; destruct g as [|[rb rx] g]; try discriminate; [exact E|].
  change (form_value ((b, x) :: (qb, qx) :: f) t)
    with (if Rlt_dec t (Q2R b) then at_real x t else form_value ((qb, qx) :: f) t).
  change (form_value ((c, y) :: (rb, rx) :: g) t)
    with (if Rlt_dec t (Q2R c) then at_real y t else form_value ((rb, rx) :: g) t).
  rewrite H1, E. destruct (Rlt_dec t (Q2R c)); [reflexivity | exact IH].
Qed.

Lemma says_same (f g : R -> R) c : (forall t, f t = g t) -> says f c -> says g c.
Proof.
  intros E. destruct c as [l h u|l h u|l h a u n r v|l h]; simpl.
  - intros H t Ht. rewrite <- E. now apply H.
  - intros [z [Hz [Z [A B]]]]. exists z. rewrite <- E.
    split; [exact Hz|]. split; [exact Z|]. split; intros t Ht; rewrite <- E; auto.
  - intros [z [Hz [Z A]]]. exists z. rewrite <- E. split; [exact Hz|]. split; [exact Z|].
    intros t Ht N. rewrite <- E. auto.
  - intros H t Ht. rewrite <- E. auto.
Qed.

(** What is said of the form of a curve, and of its sign cell by cell; [f] is the form, fractions reduced. *)
Theorem curve_answers (form : curve polynomial -> polynomial) (c : nurbs) (from to : Q) (cells : list (list cell))
    (points stretches : list (Q * Q)) (f : pieces) :
  same_pieces f (form_pieces form c) = true ->
  (answers f from cells && separated (all_zeros f cells), right_end from f, all_zeros f cells, all_stretches cells)
    = (true, to, points, stretches) ->
  vanishes_exactly (form_value (form_pieces form c)) from to points stretches /\
  Forall2 (fun b own => Forall (says (at_real (snd b))) own) (form_pieces form c) cells.
Proof.
  intros S H. injection H as H <- <- <-. split.
  - destruct (answers_sound f from cells H) as [zs [D [W P]]]. exists zs. split; [exact D|]. split; [exact W|].
    intros t T. rewrite <- (same_value f _ t S). now apply P.
  - apply andb_prop in H. destruct H as [H _]. revert S. generalize (form_pieces form c). revert from cells H.
    induction f as [|[b a] f IH]; intros from cells H g S; [discriminate|].
    destruct g as [|[b' a'] g]; [discriminate|].
    simpl in S. apply andb_prop in S. destruct S as [S1 S2]. apply andb_prop in S1. destruct S1 as [_ S1].
    assert (own : forall from b cells, span_answer a from b cells = true -> Forall (says (at_real a')) cells).
    { clear -S1. intros from b cells H. apply andb_prop in H. destruct H as [H _]. apply andb_prop in H.
      destruct H as [_ H]. induction cells as [|c cells IH]; constructor.
      - simpl in H. apply andb_prop in H. apply (says_same (at_real a)); [|now apply cell_sound].
        intro t. exact (peq_sound a t a' S1).
      - apply IH. simpl in H. now apply andb_prop in H. }
    destruct f as [|q f].
    + destruct g; [|discriminate].
      destruct cells as [|e [|]]; [discriminate | | simpl in H; rewrite andb_false_r in H; discriminate].
      constructor; [exact (own _ _ _ H) | constructor].
    + destruct cells as [|e cells]; [discriminate|].
      change (span_answer a from b e && answers (q :: f) b cells = true) in H.
      apply andb_prop in H. destruct H as [H1 H2].
      constructor; [exact (own _ _ _ H1) | exact (IH b cells H2 g S2)].
Qed.
