(** Answers about one curve, over the real numbers: where a polynomial form of a B-spline curve vanishes.

    Three facts carry everything: a form with Bernstein coefficients of one sign has no zero inside ([no_zero]), one with
    opposite signs at the ends has one ([a_zero]), and one whose derivative has Bernstein coefficients of one sign has at
    most one ([at_most_one]). What a certificate says is checked by computation in binary integers ([answer]). *)

Require Import ZArith QArith Qreals List Bool Lia Reals Lra.
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

Fixpoint padd (a b : polynomial) : polynomial :=
  match a, b with
  | [], b => b
  | a, [] => a
  | x :: a, y :: b => Qred (x + y) :: padd a b
  end.

Definition pscale (k : Q) (a : polynomial) : polynomial := map (fun c => Qred (k * c)) a.

Fixpoint pmul (a b : polynomial) : polynomial :=
  match a with [] => [] | c :: a => padd (pscale c b) (0%Q :: pmul a b) end.

Fixpoint ppow (a : polynomial) (n : nat) : polynomial :=
  match n with O => [1%Q] | S n => pmul a (ppow a n) end.

Fixpoint pder_from (k : Z) (a : polynomial) : polynomial :=
  match a with [] => [] | c :: a => Qred (inject_Z k * c) :: pder_from (k + 1) a end.

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

Lemma at_padd a t : forall b, at_real (padd a b) t = at_real a t + at_real b t.
Proof.
  induction a as [|x a IH]; intros [|y b]; simpl; try lra.
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_plus, IH. lra.
Qed.

Lemma at_pscale k a t : at_real (pscale k a) t = Q2R k * at_real a t.
Proof.
  induction a as [|x a IH]; simpl; [lra|].
  change (map (fun c => Qred (k * c)) a) with (pscale k a).
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_mult, IH. lra.
Qed.

Lemma at_pmul a b t : at_real (pmul a b) t = at_real a t * at_real b t.
Proof.
  induction a as [|x a IH]; simpl; [lra|]. rewrite at_padd, at_pscale. simpl. rewrite IH, Q2R_0. lra.
Qed.

Lemma at_ppow a n t : at_real (ppow a n) t = at_real a t ^ n.
Proof.
  induction n as [|n IH]; simpl; [rewrite Q2R_1; lra|]. now rewrite at_pmul, IH.
Qed.

Lemma at_pder_from a t : forall k, at_real (pder_from k a) t = IZR k * at_real a t + t * at_real (pder a) t.
Proof.
  assert (shift : forall a k, at_real (pder_from (k + 1) a) t = at_real (pder_from k a) t + at_real a t).
  { clear a. induction a as [|c a IH]; intro k; simpl; [lra|].
    rewrite !(Qeq_eqR _ _ (Qred_correct _)), !Q2R_mult, IH.
    assert (Hz : forall z, Q2R (inject_Z z) = IZR z) by (intro z; unfold Q2R; simpl; lra).
    rewrite !Hz, plus_IZR. lra. }
  induction a as [|c a IH]; intro k; simpl; [lra|].
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_mult, shift, IH.
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
  | Multiple (l h : Q) (s : bool) (factor : polynomial) (s' : bool) (n : nat) (rest : polynomial) (s'' : bool)
  | Null (l h : Q).

Definition low (c : cell) : Q := match c with Sign l _ _ | One l _ _ | Multiple l _ _ _ _ _ _ _ | Null l _ => l end.
Definition high (c : cell) : Q := match c with Sign _ h _ | One _ h _ | Multiple _ h _ _ _ _ _ _ | Null _ h => h end.

(** What a cell says of a function: its sign, its one zero with the sign to the left and to the right, that it is 0. *)
Definition says (f : R -> R) (c : cell) : Prop :=
  match c with
  | Sign l h u => forall t, Q2R l < t < Q2R h -> 0 < sign u * f t
  | One l h u => exists z, Q2R l < z < Q2R h /\ f z = 0 /\
      (forall t, Q2R l <= t < z -> 0 < sign u * f t) /\ (forall t, z < t <= Q2R h -> sign u * f t < 0)
  | Multiple l h _ _ _ _ _ _ => exists z, Q2R l < z < Q2R h /\ f z = 0 /\
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
  | Multiple l h _ g u n r v =>
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
  destruct c as [l h s|l h s|l h s0 g s n r s'|l h]; cbn [cell_holds].
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
    ++ (match c with One l h _ | Multiple l h _ _ _ _ _ _ => [(l, h)] | _ => [] end)
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

Definition within (z : R) (i : Q * Q) : Prop := Q2R (fst i) <= z <= Q2R (snd i).
Definition inside (closed : bool) (from to : Q) (t : R) : Prop :=
  Q2R from <= t /\ (if closed then t <= Q2R to else t < Q2R to).

(** A function vanishes on an interval at exactly so many points, one in each of the intervals (or points) named. *)
Definition exactly (f : R -> R) (closed : bool) (from to : Q) (where_ : list (Q * Q)) : Prop :=
  exists zs, Forall2 within zs where_ /\ forall t, inside closed from to t -> (f t = 0 <-> In t zs).

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
  - exists [Q2R t]. split; [constructor; [unfold within; simpl; lra | constructor]|].
    intros x ->. apply zero_at_sound in E. simpl. tauto.
  - exists []. split; [constructor|]. intros x ->. split; [|simpl; tauto].
    intro Z. apply zero_at_sound in Z. congruence.
Qed.

(** The zeros of one cell inside it. *)
Definition own (c : cell) : list (Q * Q) :=
  match c with One l h _ | Multiple l h _ _ _ _ _ _ => [(l, h)] | _ => [] end.

Lemma cell_zeros a c : cell_holds a c = true -> is_null c = false ->
  exists zs, Forall2 within zs (own c) /\ (forall z, In z zs -> Q2R (low c) < z < Q2R (high c)) /\
  forall t, Q2R (low c) < t < Q2R (high c) -> (at_real a t = 0 <-> In t zs).
Proof.
  intros H N. apply cell_sound in H. destruct c as [l h s|l h s|l h s0 g s n r s'|l h]; simpl in *; try discriminate.
  - exists []. split; [constructor|]. split; [simpl; tauto|]. intros t Ht. split; [|simpl; tauto].
    intro Z. specialize (H t Ht). rewrite Z in H. lra.
  - destruct H as [z [Hz [Z [Hl Hh]]]]. exists [z]. split; [constructor; [unfold within; simpl; lra | constructor]|].
    split; [intros y [<-|[]]; exact Hz|].
    intros t Ht. simpl. split; [|intros [<-|[]]; exact Z]. intro Y. left.
    destruct (Rtotal_order t z) as [L|[L|L]]; [|lra|].
    + specialize (Hl t). rewrite Y in Hl. lra.
    + specialize (Hh t). rewrite Y in Hh. lra.
  - destruct H as [z [Hz [Z Hn]]]. exists [z]. split; [constructor; [unfold within; simpl; lra | constructor]|].
    split; [intros y [<-|[]]; exact Hz|].
    intros t Ht. simpl. split; [|intros [<-|[]]; exact Z]. intro Y. left.
    destruct (Req_dec t z) as [->|D]; [reflexivity|]. exfalso. apply (Hn t); [lra | exact D | exact Y].
Qed.

Lemma zeros_after closed a to cells : forall from, chained from cells to = true ->
  forall zs, Forall2 within zs (zeros closed a cells) -> forall z, In z zs -> Q2R from <= z.
Proof.
  induction cells as [|e cells IH]; intros from; [intros _ zs W; inversion W; simpl; tauto|].
  simpl. intros H zs W. apply andb_prop in H. destruct H as [H Hn]. apply andb_prop in H. destruct H as [He Hl].
  apply Qeq_bool_eq, Qeq_eqR in He.
  assert (Le : Q2R (low e) < Q2R (high e)).
  { apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. rewrite L in Hl. discriminate. }
  apply Forall2_app_inv_r in W. destruct W as [z1 [z' [W1 [W' ->]]]].
  apply Forall2_app_inv_r in W'. destruct W' as [z2 [z'' [W2 [W'' ->]]]].
  apply Forall2_app_inv_r in W''. destruct W'' as [z3 [z4 [W3 [W4 ->]]]].
  intros z I. rewrite !in_app_iff in I. rewrite <- He. destruct I as [I|[I|[I|I]]].
  - destruct (zero_at a (low e)); inversion W1 as [|? ? ? ? V1 V2]; subst; [|destruct I].
    inversion V2; subst. unfold within in V1. simpl in V1. destruct I as [<-|[]]. lra.
  - assert (own_low : forall i, In i (own e) -> fst i = low e) by (destruct e; simpl; intuition (subst; reflexivity)).
    fold (own e) in W2. clear -W2 I own_low.
    induction W2 as [|x i zs is V W IHW]; [destruct I|]. destruct I as [<-|I].
    + unfold within in V. rewrite (own_low i) in V by now left. lra.
    + apply IHW; [exact I|]. intros j J. apply own_low. now right.
  - destruct cells; [destruct (closed && zero_at a (high e))|];
      inversion W3 as [|? ? ? ? V1 V2]; subst; try (destruct I; fail).
    inversion V2; subst. unfold within in V1. simpl in V1. destruct I as [<-|[]]. lra.
  - apply (IH (high e) Hn z4 W4) in I. lra.
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
      * intros t [T1 T2]. simpl in T2. rewrite !in_app_iff.
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
      * intros t [T1 T2]. simpl in T2. rewrite in_app_iff.
        destruct (Rtotal_order t (Q2R (low c))) as [L|[L|L]]; [lra| |].
        -- rewrite (Pl t L). split; [tauto|]. intros [I|I]; [exact I|]. specialize (Ic t I). lra.
        -- assert (M : t < Q2R (high c)) by lra. rewrite (Pc t (conj L M)). split; [tauto|].
           intros [I|I]; [|exact I]. specialize (Il t I). lra.
  - assert (Ar : answer a (high c) to (d :: rest) = true) by (unfold answer; now rewrite Hchain, Hr).
    destruct (IH (high c) to) as [zr [Wr Pr]]; [discriminate | exact Nr | exact Ar |].
    (* the zeros of the rest that lie to the right of this cell *)
    assert (Order : forall z, In z zr -> Q2R (high c) <= z) by exact (zeros_after closed a _ _ _ Hchain _ Wr).
    exists (zl ++ zc ++ zr). split.
    + change (zeros closed a (c :: d :: rest)) with
        ((if zero_at a (low c) then [(low c, low c)] else []) ++ own c ++ [] ++ zeros closed a (d :: rest)).
      simpl app at 3. repeat apply Forall2_app; assumption.
    + intros t [T1 T2]. rewrite !in_app_iff.
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
