(** A checker for equalities of formulas, and the proof that what it accepts holds in every differential field.

    A formula is read once more, as an expression; the expression is brought to the form [P / (A1^e1 … Ak^ek)], where P
    is a polynomial in numbered variables with integer coefficients and the A's, the atoms, are polynomials that do not
    vanish. Derivatives are carried out by Leibniz' rule. Nothing has to be trusted here: see [equal_sound]. *)

Require Import ZArith List Bool Lia Ring_theory Ring_polynom Field_theory Field InitialRing BinList.
From ExactSpline Require Import Base.
Import ListNotations.

(** ** Expressions *)

Inductive expr :=
  | var (i : positive)
  | num (z : Z)
  | eadd (a b : expr)
  | esub (a b : expr)
  | emul (a b : expr)
  | ediv (a b : expr)
  | eneg (a : expr)
  | epow (a : expr) (n : nat)
  | eder (q : parameter) (a : expr).

#[export] Instance expr_operations : operations expr := {
  number := num; add := eadd; sub := esub; mul := emul; div := ediv; neg := eneg; power := epow; der := eder
}.

(** ** Polynomials, as the standard library has them *)

Definition poly := Pol Z.
Definition padd : poly -> poly -> poly := Padd 0%Z Z.add Zeq_bool.
Definition psub : poly -> poly -> poly := Psub 0%Z Z.add Z.sub Z.opp Zeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0%Z 1%Z Z.add Z.mul Zeq_bool.
Definition popp : poly -> poly := Popp Z.opp.
Definition pvar (i : positive) : poly := mk_X 0%Z 1%Z i.
Definition peq : poly -> poly -> bool := Peq Zeq_bool.

Fixpoint ppow (a : poly) (n : nat) : poly :=
  match n with 0 => Pc 1%Z | 1 => a | S n => pmul (ppow a n) a end.

Definition lifted (j : N) (a : poly) : poly := match j with N0 => a | Npos k => mkPinj k a end.

(** An expression that neither divides nor differentiates is a polynomial. *)
Fixpoint simple (e : expr) : option poly :=
  match e with
  | var i => Some (pvar i)
  | num z => Some (Pc z)
  | eadd a b => match simple a, simple b with Some a, Some b => Some (padd a b) | _, _ => None end
  | esub a b => match simple a, simple b with Some a, Some b => Some (psub a b) | _, _ => None end
  | emul a b => match simple a, simple b with Some a, Some b => Some (pmul a b) | _, _ => None end
  | eneg a => match simple a with Some a => Some (popp a) | _ => None end
  | epow a n => match simple a with Some a => Some (ppow a n) | _ => None end
  | ediv _ _ | eder _ _ => None
  end.

(** The derivative of a variable: a polynomial, mostly another variable or a constant. *)
Definition rules := list (positive * expr).

Fixpoint rule (i : positive) (r : rules) : option poly :=
  match r with
  | [] => None
  | (k, target) :: r => if Pos.eqb i k then simple target else rule i r
  end.

(** The derivative of a polynomial whose first variable is the one after the [j]-th. *)
Fixpoint dpoly (r : rules) (j : N) (a : poly) : option poly :=
  match a with
  | Pc _ => Some (Pc 0%Z)
  | Pinj k a => dpoly r (j + Npos k) a
  | PX a i b =>
    match dpoly r j a, rule (N.succ_pos j) r, dpoly r (N.succ j) b with
    | Some da, Some dx, Some db =>
      let x := pvar (N.succ_pos j) in
      let inner := pmul (pmul (Pc (Zpos i)) (lifted j a)) dx in
      let below := match i with xH => inner | _ => pmul inner (ppow x (pred (Pos.to_nat i))) end in
      Some (padd (padd (pmul da (ppow x (Pos.to_nat i))) below) db)
    | _, _, _ => None
    end
  end.

(** ** Square roots

    The first two variables may be [1/σ] and [σ], where [σ²] is a polynomial S in the variables that follow, and so on:
    the S's are the roots. Modulo these relations a polynomial is 0 if it is after clearing [1/σ] and replacing [σ²]. *)

(** The exponent of the first variable. *)
Fixpoint first_degree (a : poly) : nat :=
  match a with PX a i b => (Pos.to_nat i + first_degree a)%nat | _ => 0 end.

(** A polynomial in the second, third, … variable from one in the first, second, …: the first one does not occur. *)
Definition without_first (a : poly) : poly := match a with Pinj i a => lifted (Pos.pred_N i) a | a => a end.

(** A polynomial times the [n]-th power of σ, without [1/σ]. *)
Fixpoint cleared (n : nat) (a : poly) : poly :=
  match a with
  | PX a i b => padd (cleared (n - Pos.to_nat i) a) (pmul (ppow (pvar 1) n) b)
  | _ => pmul (ppow (pvar 1) n) (without_first a)
  end.

(** Parts P and Q with [a = P + σ Q], from [σ² = square]. *)
Fixpoint parted (square : poly) (a : poly) : poly * poly :=
  match a with
  | PX a i b =>
    let '(P, Q) := parted square a in
    let k := Pos.to_nat i in
    let half := ppow square (Nat.div2 k) in
    if Nat.even k then (padd (pmul half P) b, pmul half Q)
    else (padd (pmul (pmul half square) Q) b, pmul half P)
  | _ => (without_first a, Pc 0%Z)
  end.

Fixpoint vanishing (roots : list expr) (a : poly) : bool :=
  match roots with
  | [] => peq a (Pc 0%Z)
  | square :: roots =>
    match simple square with
    | None => false
    | Some square =>
      let '(P, Q) := parted square (cleared (first_degree a) a) in vanishing roots P && vanishing roots Q
    end
  end.

Definition same (roots : list expr) (a b : poly) : bool :=
  if peq a b then true else match roots with [] => false | _ => vanishing roots (psub a b) end.

(** ** Fractions whose denominators are products of atoms *)

Definition fraction : Type := poly * list nat.

Section Fractions.
Variable atoms : list poly.

Fixpoint product (atoms : list poly) (es : list nat) : poly :=
  match atoms, es with
  | a :: atoms, e :: es => pmul (ppow a e) (product atoms es)
  | _, _ => Pc 1%Z
  end.

(** What two denominators lack to their least common multiple, and that. *)
Fixpoint common (atoms : list poly) (d e : list nat) : poly * poly * list nat :=
  match atoms, d, e with
  | [], _, _ => (Pc 1%Z, Pc 1%Z, [])
  | _, [], e => (product atoms e, Pc 1%Z, e)
  | _, d, [] => (Pc 1%Z, product atoms d, d)
  | a :: atoms, i :: d, j :: e =>
    let '(l, r, m) := common atoms d e in (pmul (ppow a (j - i)) l, pmul (ppow a (i - j)) r, Nat.max i j :: m)
  end.

Fixpoint sums (d e : list nat) : list nat :=
  match d, e with
  | [], e => e
  | d, [] => d
  | i :: d, j :: e => (i + j)%nat :: sums d e
  end.

(** Exponents above and below, cancelled. *)
Fixpoint cancelled (d e : list nat) : list nat * list nat :=
  match d, e with
  | i :: d, j :: e => let '(d', e') := cancelled d e in ((i - j)%nat :: d', (j - i)%nat :: e')
  | d, e => (d, e)
  end.

(** [R] and [L] with [D′ R = L D] for a denominator D, and the exponents of D R. *)
Fixpoint logarithmic (r : rules) (atoms : list poly) (e : list nat) : option (poly * poly * list nat) :=
  match atoms, e with
  | a :: atoms, i :: e =>
    match logarithmic r atoms e, i with
    | None, _ => None
    | Some (R, L, m), 0 => Some (R, L, 0 :: m)
    | Some (R, L, m), _ =>
      match dpoly r 0 a with
      | None => None
      | Some da =>
        Some (pmul a R, padd (pmul (pmul (Pc (Z.of_nat i)) da) R) (pmul a L), S i :: m)
      end
    end
  | _, _ => Some (Pc 1%Z, Pc 0%Z, [])
  end.

(** What squares of roots are. *)
Variable roots : list expr.

(** What denominators are up to their sign: products of atoms over products of atoms. *)
Variable known : list (list nat * list nat).

Fixpoint recognized (b : fraction) (known : list (list nat * list nat)) : option (bool * list nat * list nat) :=
  match known with
  | [] => None
  | (top, bottom) :: known =>
    let '(l, r, _) := common atoms (sums top (snd b)) bottom in
    if same roots (pmul (fst b) l) r then Some (true, top, bottom)
    else if same roots (popp (pmul (fst b) l)) r then Some (false, top, bottom)
    else recognized b known
  end.

Definition fadd (minus : bool) (a b : fraction) : fraction :=
  let '(l, r, m) := common atoms (snd a) (snd b) in
  let x := pmul (fst a) l in
  let y := pmul (fst b) r in
  (if minus then psub x y else padd x y, m).

Definition fdiv (a b : fraction) : option fraction :=
  match recognized b known with
  | None => None
  | Some (positive, top, bottom) =>
    let '(above, below) := cancelled bottom (sums (snd a) top) in
    let n := pmul (fst a) (product atoms above) in
    Some (if positive then n else popp n, below)
  end.

Definition fder (r : rules) (a : fraction) : option fraction :=
  match dpoly r 0 (fst a), logarithmic r atoms (snd a) with
  | Some dn, Some (R, L, m) => Some (psub (pmul dn R) (pmul (fst a) L), m)
  | _, _ => None
  end.

Variable r : parameter -> rules.

Fixpoint norm (e : expr) : option fraction :=
  match e with
  | var i => Some (pvar i, [])
  | num z => Some (Pc z, [])
  | eadd a b => match norm a, norm b with Some a, Some b => Some (fadd false a b) | _, _ => None end
  | esub a b => match norm a, norm b with Some a, Some b => Some (fadd true a b) | _, _ => None end
  | emul a b =>
    match norm a, norm b with Some a, Some b => Some (pmul (fst a) (fst b), sums (snd a) (snd b)) | _, _ => None end
  | ediv a b => match norm a, norm b with Some a, Some b => fdiv a b | _, _ => None end
  | eneg a => match norm a with Some a => Some (popp (fst a), snd a) | _ => None end
  | epow a n => match norm a with Some a => Some (ppow (fst a) n, map (Nat.mul n) (snd a)) | _ => None end
  | eder q a => match norm a with Some a => fder (r q) a | _ => None end
  end.

Definition equal (a b : expr) : bool :=
  match norm a, norm b with
  | Some a, Some b => let '(l, r, _) := common atoms (snd a) (snd b) in same roots (pmul (fst a) l) (pmul (fst b) r)
  | _, _ => false
  end.

Fixpoint all_equal (a b : list expr) : bool :=
  match a, b with
  | [], [] => true
  | x :: a, y :: b => equal x y && all_equal a b
  | _, _ => false
  end.

End Fractions.

(** ** What is accepted holds *)

Section Soundness.
Variable K : differential_field.
Variable l : list K.
Add Field K : (field_axioms K).

Fixpoint value (e : expr) : K :=
  match e with
  | var i => nth (zero K) i l
  | num z => number z
  | eadd a b => add (value a) (value b)
  | esub a b => sub (value a) (value b)
  | emul a b => mul (value a) (value b)
  | ediv a b => div (value a) (value b)
  | eneg a => neg (value a)
  | epow a n => power (value a) n
  | eder q a => der q (value a)
  end.

Let phi := gen_phiZ (zero K) (one K) (plus K) (times K) (opposite K).
Let at_list := Pphi (zero K) (plus K) (times K) phi.
Definition at_point (a : poly) : K := at_list l a.

Let setoid := Eqsth K.
Let extension := Eq_ext (plus K) (times K) (opposite K).
Let ring_axioms := F_R (field_axioms K).
Let almost := Rth_ARth setoid extension ring_axioms.
Let morphism := gen_phiZ_morph setoid extension ring_axioms.

Lemma at_padd m a b : at_list m (padd a b) = plus K (at_list m a) (at_list m b).
Proof. exact (Padd_ok setoid extension almost morphism b a m). Qed.
Lemma at_psub m a b : at_list m (psub a b) = minus K (at_list m a) (at_list m b).
Proof. exact (Psub_ok setoid extension almost morphism b a m). Qed.
Lemma at_pmul m a b : at_list m (pmul a b) = times K (at_list m a) (at_list m b).
Proof. exact (Pmul_ok setoid extension almost morphism a b m). Qed.
Lemma at_popp m a : at_list m (popp a) = opposite K (at_list m a).
Proof. exact (Popp_ok setoid extension almost morphism a m). Qed.
Lemma at_pvar m i : at_list m (pvar i) = nth (zero K) i m.
Proof. symmetry. exact (mkX_ok setoid extension almost morphism i m). Qed.
Lemma at_equal m a b : peq a b = true -> at_list m a = at_list m b.
Proof. intro H. exact (Peq_ok setoid extension morphism a b H m). Qed.
Lemma at_constant m z : at_list m (Pc z) = integer K z.
Proof. reflexivity. Qed.

Lemma integer_0 : integer K 0 = zero K. Proof. reflexivity. Qed.
Lemma integer_1 : integer K 1 = one K. Proof. reflexivity. Qed.
Lemma integer_add a b : integer K (a + b) = plus K (integer K a) (integer K b).
Proof. exact (morph_add morphism a b). Qed.
Lemma integer_succ n : integer K (Z.of_nat (S n)) = plus K (integer K (Z.of_nat n)) (one K).
Proof. rewrite Nat2Z.inj_succ, <- Z.add_1_r. apply integer_add. Qed.

Lemma repeated_succ (a : K) n : repeated K a (S n) = times K (repeated K a n) a.
Proof. destruct n; simpl; [ring | reflexivity]. Qed.

Lemma at_ppow m a n : at_list m (ppow a n) = repeated K (at_list m a) n.
Proof.
  induction n as [|n IH]; [reflexivity|].
  rewrite repeated_succ. destruct n; [simpl; ring|].
  change (ppow a (S (S n))) with (pmul (ppow a (S n)) a). now rewrite at_pmul, IH.
Qed.

Lemma repeated_add (a : K) m n : repeated K a (m + n) = times K (repeated K a m) (repeated K a n).
Proof.
  induction n as [|n IH].
  - rewrite Nat.add_0_r. simpl. ring.
  - rewrite Nat.add_succ_r, !repeated_succ, IH. ring.
Qed.

Lemma repeated_mul (a : K) m n : repeated K a (m * n) = repeated K (repeated K a n) m.
Proof.
  induction m as [|m IH]; [reflexivity|].
  rewrite repeated_succ, <- IH. simpl Nat.mul. rewrite repeated_add. ring.
Qed.

Lemma repeated_times (a b : K) n : repeated K (times K a b) n = times K (repeated K a n) (repeated K b n).
Proof. induction n as [|n IH]; [simpl; ring|]. rewrite !repeated_succ, IH. ring. Qed.

Lemma product_nonzero (a b : K) : a <> zero K -> b <> zero K -> times K a b <> zero K.
Proof.
  intros Ha Hb H. apply Hb.
  transitivity (times K (inverse K a) (times K a b)); [field; exact Ha|]. rewrite H. ring.
Qed.

Lemma repeated_nonzero (a : K) n : a <> zero K -> repeated K a n <> zero K.
Proof.
  intro Ha. induction n as [|n IH]; [exact (F_1_neq_0 (field_axioms K))|].
  rewrite repeated_succ. now apply product_nonzero.
Qed.

(** *** Derivatives *)

Variable q : parameter.

Lemma derivative_one : derivative K q (one K) = zero K.
Proof.
  assert (H : derivative K q (times K (one K) (one K)) = derivative K q (one K)) by (f_equal; ring).
  rewrite derivative_times in H.
  transitivity (minus K (plus K (times K (derivative K q (one K)) (one K)) (times K (one K) (derivative K q (one K))))
                        (derivative K q (one K))); [ring | rewrite H; ring].
Qed.

Lemma derivative_zero : derivative K q (zero K) = zero K.
Proof.
  assert (H : derivative K q (plus K (zero K) (zero K)) = derivative K q (zero K)) by (f_equal; ring).
  rewrite derivative_plus in H.
  transitivity (minus K (plus K (derivative K q (zero K)) (derivative K q (zero K))) (derivative K q (zero K)));
    [ring | rewrite H; ring].
Qed.

Lemma derivative_opposite a : derivative K q (opposite K a) = opposite K (derivative K q a).
Proof.
  assert (H : plus K (derivative K q a) (derivative K q (opposite K a)) = zero K).
  { rewrite <- derivative_plus. rewrite <- derivative_zero. f_equal. ring. }
  transitivity (minus K (plus K (derivative K q a) (derivative K q (opposite K a))) (derivative K q a));
    [ring | rewrite H; ring].
Qed.

Lemma derivative_minus a b : derivative K q (minus K a b) = minus K (derivative K q a) (derivative K q b).
Proof.
  transitivity (derivative K q (plus K a (opposite K b))); [f_equal; ring|].
  rewrite derivative_plus, derivative_opposite. ring.
Qed.

Lemma derivative_of_natural n : derivative K q (integer K (Z.of_nat n)) = zero K.
Proof.
  induction n as [|n IH]; [exact derivative_zero|].
  rewrite integer_succ, derivative_plus, IH, derivative_one. ring.
Qed.

Lemma integer_opp z : integer K (- z) = opposite K (integer K z).
Proof. exact (morph_opp morphism z). Qed.

Lemma derivative_integer z : derivative K q (integer K z) = zero K.
Proof.
  destruct (Z.le_gt_cases 0 z).
  - rewrite <- (Z2Nat.id z) by assumption. apply derivative_of_natural.
  - replace z with (- - z)%Z by lia. rewrite integer_opp, derivative_opposite.
    rewrite <- (Z2Nat.id (- z)) by lia. rewrite derivative_of_natural. ring.
Qed.

Lemma derivative_quotient a b : b <> zero K ->
  derivative K q (quotient K a b) =
  quotient K (minus K (times K (derivative K q a) b) (times K a (derivative K q b))) (times K b b).
Proof.
  intro Hb.
  assert (H : derivative K q (times K (quotient K a b) b) = derivative K q a) by (f_equal; field; exact Hb).
  rewrite derivative_times in H. rewrite <- H. field. exact Hb.
Qed.

Lemma derivative_repeated a n :
  derivative K q (repeated K a (S n)) =
  times K (times K (integer K (Z.of_nat (S n))) (repeated K a n)) (derivative K q a).
Proof.
  induction n as [|n IH].
  - change (integer K (Z.of_nat 1)) with (one K). simpl. ring.
  - rewrite repeated_succ, derivative_times, IH, (integer_succ (S n)), !repeated_succ. ring.
Qed.

Lemma pow_pos_repeated (a : K) i : pow_pos (times K) a i = repeated K a (Pos.to_nat i).
Proof.
  induction i as [|i IH] using Pos.peano_ind; [reflexivity|].
  rewrite Pos2Nat.inj_succ, repeated_succ, <- IH.
  rewrite (pow_pos_succ setoid (Rmul_ext extension) (Rmul_assoc ring_axioms)). ring.
Qed.

Lemma simple_sound e : forall a, simple e = Some a -> at_point a = value e.
Proof.
  induction e as [i|z|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa|a IHa n|k a IHa]; intros d; cbn [simple value];
    unfold at_point in *.
  - intro E. injection E as <-. apply at_pvar.
  - intro E. injection E as <-. reflexivity.
  - destruct (simple a) as [x|]; [|discriminate]. destruct (simple b) as [y|]; [|discriminate].
    intro E. injection E as <-. now rewrite at_padd, (IHa x), (IHb y).
  - destruct (simple a) as [x|]; [|discriminate]. destruct (simple b) as [y|]; [|discriminate].
    intro E. injection E as <-. now rewrite at_psub, (IHa x), (IHb y).
  - destruct (simple a) as [x|]; [|discriminate]. destruct (simple b) as [y|]; [|discriminate].
    intro E. injection E as <-. now rewrite at_pmul, (IHa x), (IHb y).
  - discriminate.
  - destruct (simple a) as [x|]; [|discriminate]. intro E. injection E as <-. now rewrite at_popp, (IHa x).
  - destruct (simple a) as [x|]; [|discriminate]. intro E. injection E as <-. now rewrite at_ppow, (IHa x).
  - discriminate.
Qed.

(** The rules say what the derivatives of the variables are. *)
Definition rules_hold (r : rules) : Prop :=
  Forall (fun t => der q (nth (zero K) (fst t) l) = value (snd t)) r.

Lemma rule_sound r i a :
  rules_hold r -> rule i r = Some a -> derivative K q (nth (zero K) i l) = at_point a.
Proof.
  induction r as [|[k t] r IH]; [discriminate|].
  intro H. inversion H as [|x y Hk Hrest]; subst. simpl.
  destruct (Pos.eqb_spec i k) as [->|_]; [|now apply IH].
  intro E. simpl in Hk. rewrite Hk. symmetry. now apply simple_sound.
Qed.

Variable r : rules.
Hypothesis Hr : rules_hold r.

Definition jumped (j : N) : list K := match j with N0 => l | Npos k => jump k l end.

Lemma jumped_add j k : jump k (jumped j) = jumped (j + Npos k).
Proof. destruct j as [|j]; [reflexivity|]. change (jump k (jump j l) = jump (j + k) l). rewrite Pos.add_comm, jump_add. reflexivity. Qed.

Lemma tail_jumped j : tl (jumped j) = jumped (N.succ j).
Proof. destruct j as [|j]; [reflexivity|]. change (tl (jump j l) = jump (Pos.succ j) l). rewrite jump_succ. reflexivity. Qed.

Lemma nth_succ (A : Type) (d : A) (k : positive) (m : list A) : nth d (Pos.succ k) m = nth d k (tl m).
Proof.
  revert m. induction k as [k IH|k IH|]; intro m; simpl; try reflexivity.
  rewrite IH, jump_succ. simpl. rewrite !jump_tl. reflexivity.
Qed.

Lemma head_jumped j : hd (zero K) (jumped j) = nth (zero K) (N.succ_pos j) l.
Proof. destruct j as [|j]; [reflexivity|]. change (hd (zero K) (jump j l) = nth (zero K) (Pos.succ j) l).
  rewrite nth_succ, nth_jump. reflexivity. Qed.

Lemma at_lifted j a : at_point (lifted j a) = at_list (jumped j) a.
Proof. destruct j as [|j]; [reflexivity|]. exact (mkPinj_ok (zero K) (plus K) (times K) setoid phi j l a). Qed.

Lemma dpoly_sound a : forall j d, dpoly r j a = Some d -> derivative K q (at_list (jumped j) a) = at_point d.
Proof.
  induction a as [c|k a IH|a IHa i b IHb]; intros j d.
  - simpl. intro E. injection E as <-. unfold at_point. simpl. apply derivative_integer.
  - simpl dpoly. intro E. simpl at_list. change (Pphi _ _ _ phi ?m a) with (at_list m a).
    rewrite jumped_add. now apply IH.
  - simpl dpoly. destruct (dpoly r j a) as [da|] eqn:Ea; [|discriminate].
    destruct (rule (N.succ_pos j) r) as [dx|] eqn:Ex; [|discriminate].
    destruct (dpoly r (N.succ j) b) as [db|] eqn:Eb; [|discriminate].
    intro E. injection E as <-. apply IHa in Ea. apply IHb in Eb. apply (rule_sound _ _ _ Hr) in Ex.
    change (at_list (jumped j) (PX a i b)) with
      (plus K (times K (at_list (jumped j) a) (pow_pos (times K) (hd (zero K) (jumped j)) i))
              (at_list (tl (jumped j)) b)).
    rewrite derivative_plus, derivative_times, tail_jumped, Eb, Ea, head_jumped, pow_pos_repeated.
    set (x := N.succ_pos j) in *.
    unfold at_point. rewrite !at_padd, at_pmul, at_ppow, at_pvar. f_equal. f_equal.
    destruct (Pos.to_nat i) as [|n] eqn:En; [lia|].
    rewrite derivative_repeated, Ex.
    assert (Ei : integer K (Z.pos i) = integer K (Z.of_nat (S n))) by (f_equal; lia).
    rewrite <- (at_lifted j a).
    assert (below : at_list l (match i with
                    | xH => pmul (pmul (Pc (Z.pos i)) (lifted j a)) dx
                    | _ => pmul (pmul (pmul (Pc (Z.pos i)) (lifted j a)) dx) (ppow (pvar x) (pred (S n)))
                    end)
            = times K (times K (times K (integer K (Z.pos i)) (at_point (lifted j a))) (at_point dx))
                      (repeated K (nth (zero K) x l) n)).
    { destruct i; rewrite !at_pmul, ?at_ppow, ?at_pvar, at_constant; try reflexivity.
      assert (n = 0) as -> by lia. simpl. fold (at_point dx). fold (at_point (lifted j a)). ring. }
    etransitivity; [|symmetry; exact below]. rewrite Ei. ring.
Qed.

(** *** Denominators *)

Definition nonzero (a : poly) : Prop := at_point a <> zero K.
Let den (atoms : list poly) (e : list nat) : K := at_point (product atoms e).

Lemma at_times a b : at_point (pmul a b) = times K (at_point a) (at_point b).
Proof. apply at_pmul. Qed.
Lemma at_plus a b : at_point (padd a b) = plus K (at_point a) (at_point b).
Proof. apply at_padd. Qed.
Lemma at_minus a b : at_point (psub a b) = minus K (at_point a) (at_point b).
Proof. apply at_psub. Qed.
Lemma at_negated a : at_point (popp a) = opposite K (at_point a).
Proof. apply at_popp. Qed.
Lemma at_point_constant z : at_point (Pc z) = integer K z.
Proof. reflexivity. Qed.
Lemma at_power a n : at_point (ppow a n) = repeated K (at_point a) n.
Proof. apply at_ppow. Qed.
Lemma at_one : at_point (Pc 1%Z) = one K.
Proof. reflexivity. Qed.

Lemma den_nil atoms : den atoms [] = one K.
Proof. destruct atoms; reflexivity. Qed.
Lemma den_none e : den [] e = one K.
Proof. reflexivity. Qed.
Lemma den_cons a atoms i e : den (a :: atoms) (i :: e) = times K (repeated K (at_point a) i) (den atoms e).
Proof. unfold den. simpl product. now rewrite at_times, at_power. Qed.

Lemma den_nonzero atoms e : Forall nonzero atoms -> den atoms e <> zero K.
Proof.
  revert e. induction atoms as [|a atoms IH]; intros e H.
  - apply (F_1_neq_0 (field_axioms K)).
  - inversion H; subst. destruct e as [|i e]; [rewrite den_nil; apply (F_1_neq_0 (field_axioms K))|].
    rewrite den_cons. apply product_nonzero; [now apply repeated_nonzero | now apply IH].
Qed.

Lemma common_sound atoms : forall d e,
  let '(x, y, m) := common atoms d e in
  den atoms m = times K (den atoms d) (at_point x) /\ den atoms m = times K (den atoms e) (at_point y).
Proof.
  induction atoms as [|a atoms IH]; intros d e.
  - change (common [] d e) with (Pc 1%Z : poly, Pc 1%Z : poly, @nil nat).
    lazy beta iota. rewrite at_one, !den_none. split; ring.
  - destruct d as [|i d]; [|destruct e as [|j e]].
    + change (common (a :: atoms) [] e) with (product (a :: atoms) e, Pc 1%Z : poly, e).
      lazy beta iota. rewrite den_nil, at_one. fold (den (a :: atoms) e). split; ring.
    + change (common (a :: atoms) (i :: d) []) with
        (Pc 1%Z : poly, product (a :: atoms) (i :: d), i :: d).
      lazy beta iota. rewrite den_nil, at_one. fold (den (a :: atoms) (i :: d)). split; ring.
    + cbn [common]. specialize (IH d e). destruct (common atoms d e) as [[x y] m]. destruct IH as [Hx Hy].
      rewrite !den_cons, !at_times, !at_power.
      assert (Hi : repeated K (at_point a) (Nat.max i j)
                   = times K (repeated K (at_point a) i) (repeated K (at_point a) (j - i)))
        by (rewrite <- repeated_add; f_equal; lia).
      assert (Hj : repeated K (at_point a) (Nat.max i j)
                   = times K (repeated K (at_point a) j) (repeated K (at_point a) (i - j)))
        by (rewrite <- repeated_add; f_equal; lia).
      split; [rewrite Hi, Hx | rewrite Hj, Hy]; ring.
Qed.

Lemma sums_sound atoms : forall d e, den atoms (sums d e) = times K (den atoms d) (den atoms e).
Proof.
  induction atoms as [|a atoms IH]; intros d e.
  - rewrite !den_none. ring.
  - destruct d as [|i d]; [|destruct e as [|j e]]; cbn [sums]; rewrite ?den_nil, ?den_cons; try ring.
    rewrite IH, repeated_add. ring.
Qed.

Lemma repeated_one n : repeated K (one K) n = one K.
Proof. induction n as [|n IH]; [reflexivity|]. rewrite repeated_succ, IH. ring. Qed.

Lemma den_scaled n atoms : forall e, den atoms (map (Nat.mul n) e) = repeated K (den atoms e) n.
Proof.
  induction atoms as [|a atoms IH]; intro e.
  - rewrite !den_none. symmetry. apply repeated_one.
  - destruct e as [|i e]; cbn [map].
    + rewrite den_nil. symmetry. apply repeated_one.
    + rewrite !den_cons, IH, repeated_times, repeated_mul. reflexivity.
Qed.

Lemma cancelled_sound atoms : forall d e,
  let '(d', e') := cancelled d e in
  times K (den atoms d) (den atoms e') = times K (den atoms d') (den atoms e).
Proof.
  induction atoms as [|a atoms IH]; intros d e.
  - destruct (cancelled d e). rewrite !den_none. reflexivity.
  - destruct d as [|i d]; [|destruct e as [|j e]]; try reflexivity.
    cbn [cancelled]. specialize (IH d e). destruct (cancelled d e) as [d' e']. rewrite !den_cons.
    transitivity (times K (times K (repeated K (at_point a) i) (repeated K (at_point a) (j - i)))
                          (times K (den atoms d) (den atoms e'))); [ring|].
    rewrite IH, <- repeated_add. replace (i + (j - i)) with (i - j + j) by lia.
    rewrite repeated_add. ring.
Qed.

Lemma logarithmic_sound atoms : forall e R L m, logarithmic r atoms e = Some (R, L, m) ->
  times K (derivative K q (den atoms e)) (at_point R) = times K (at_point L) (den atoms e) /\
  den atoms m = times K (den atoms e) (at_point R).
Proof.
  assert (base : forall atoms, derivative K q (den atoms []) = zero K).
  { intro. rewrite den_nil. apply derivative_one. }
  induction atoms as [|a atoms IH]; intros e R L m.
  - cbn [logarithmic]. intro E. injection E as <- <- <-. rewrite !den_none, at_one, derivative_one.
    change (at_point (Pc 0%Z)) with (zero K). split; ring.
  - destruct e as [|i e].
    + cbn [logarithmic]. intro E. injection E as <- <- <-. rewrite base, den_nil, at_one.
      change (at_point (Pc 0%Z)) with (zero K). split; ring.
    + cbn [logarithmic]. destruct (logarithmic r atoms e) as [[[R0 L0] m0]|] eqn:E0; [|discriminate].
      destruct (IH _ _ _ _ E0) as [HL Hm]. destruct i as [|i].
      * intro E. injection E as <- <- <-. rewrite !den_cons. cbn [repeated].
        rewrite derivative_times, derivative_one, Hm. split; [|ring].
        transitivity (times K (derivative K q (den atoms e)) (at_point R0)); [ring|]. rewrite HL. ring.
      * destruct (dpoly r 0 a) as [da|] eqn:Ea; [|discriminate].
        intro E. injection E as <- <- <-.
        apply (dpoly_sound a 0) in Ea. change (at_list (jumped 0) a) with (at_point a) in Ea.
        rewrite !den_cons, derivative_times, derivative_repeated, Ea, Hm.
        rewrite at_plus, !at_times, at_point_constant, !repeated_succ. split; [|ring].
        transitivity (plus K
          (times K (times K (times K (integer K (Z.of_nat (S i))) (repeated K (at_point a) i)) (at_point da))
                   (times K (den atoms e) (times K (at_point a) (at_point R0))))
          (times K (times K (times K (repeated K (at_point a) i) (at_point a)) (at_point a))
                   (times K (derivative K q (den atoms e)) (at_point R0)))); [ring|].
        rewrite HL. change (Z.pos (Pos.of_succ_nat i)) with (Z.of_nat (S i)). ring.
Qed.

End Soundness.

(** *** Square roots *)

Section Roots.
Variable K : differential_field.
Add Field K : (field_axioms K).

(** The list begins with [1/σ] and [σ], for each of the roots. *)
Fixpoint roots_hold (l : list K) (roots : list expr) : Prop :=
  match roots with
  | [] => True
  | square :: roots =>
    let x := hd (zero K) l in
    let y := hd (zero K) (tl l) in
    let m := tl (tl l) in
    times K x y = one K /\ times K y y = value K m square /\ roots_hold m roots
  end.

Lemma at_sum l a i b : at_point K l (PX a i b)
  = plus K (times K (at_point K l a) (repeated K (hd (zero K) l) (Pos.to_nat i))) (at_point K (tl l) b).
Proof. unfold at_point. cbn [Pphi]. now rewrite pow_pos_repeated. Qed.

Lemma at_without_first l a : (forall b i d, a <> PX b i d) -> at_point K l a = at_point K (tl l) (without_first a).
Proof.
  destruct a as [c|i a|b i d]; intro H; [reflexivity| |now destruct (H b i d)].
  cbn [without_first]. rewrite at_lifted.
  assert (E : forall j, jump j (tl l) = jump (Pos.succ j) l) by (intro j; now rewrite jump_succ, <- jump_tl).
  destruct i as [i|i|]; [| |reflexivity]; unfold at_point; cbn [Pphi Pos.pred_N jumped]; rewrite E; [reflexivity|].
  now rewrite Pos.succ_pred_double.
Qed.

Lemma repeated_inverse x y n : times K x y = one K -> times K (repeated K y n) (repeated K x n) = one K.
Proof.
  intro H. rewrite <- repeated_times. assert (E : times K y x = one K) by (rewrite <- H; ring).
  rewrite E. apply repeated_one.
Qed.

Lemma at_first_power l n : at_point K l (ppow (pvar 1) n) = repeated K (hd (zero K) l) n.
Proof. rewrite at_power. unfold at_point. rewrite at_pvar. destruct l; reflexivity. Qed.

Lemma cleared_sound l a : times K (hd (zero K) l) (hd (zero K) (tl l)) = one K -> forall n, (first_degree a <= n)%nat ->
  times K (repeated K (hd (zero K) (tl l)) n) (at_point K l a) = at_point K (tl l) (cleared n a).
Proof.
  intro H. induction a as [c|i a IH|a IHa i b IHb]; intros n Hn.
  - cbn [cleared]. rewrite at_times, at_first_power. f_equal.
  - cbn [cleared]. rewrite at_times, at_first_power. f_equal. apply at_without_first. discriminate.
  - cbn [cleared]. cbn [first_degree] in Hn. rewrite at_plus, at_times, at_first_power, at_sum.
    rewrite <- IHa by lia. set (k := Pos.to_nat i) in *. replace n with (n - k + k) at 1 by lia.
    rewrite repeated_add. pose proof (repeated_inverse _ _ k H) as I.
    set (x := repeated K (hd (zero K) l) k) in *. set (y := repeated K (hd (zero K) (tl l)) k) in *.
    transitivity (plus K (times K (times K (repeated K (hd (zero K) (tl l)) (n - k)) (at_point K l a)) (times K y x))
                         (times K (times K (repeated K (hd (zero K) (tl l)) (n - k)) y) (at_point K (tl l) b))); [ring|].
    rewrite I. unfold y. rewrite <- repeated_add. replace (n - k + k) with n by lia. ring.
Qed.

Lemma repeated_halved (y z : K) k : times K y y = z ->
  repeated K y k = times K (repeated K z (Nat.div2 k)) (if Nat.even k then one K else y).
Proof.
  intro H. rewrite (Nat.div2_odd k) at 1. rewrite <- Nat.negb_even, Nat.mul_comm, repeated_add.
  assert (E : repeated K y (Nat.div2 k * 2) = repeated K z (Nat.div2 k)).
  { rewrite repeated_mul. f_equal. simpl. exact H. }
  rewrite E. destruct (Nat.even k); simpl; ring.
Qed.

Lemma parted_sound l square a : times K (hd (zero K) l) (hd (zero K) l) = at_point K (tl l) square ->
  forall P Q, parted square a = (P, Q) ->
  at_point K l a = plus K (at_point K (tl l) P) (times K (hd (zero K) l) (at_point K (tl l) Q)).
Proof.
  intro H. induction a as [c|i a IH|a IHa i b IHb]; intros P Q.
  - cbn [parted without_first]. intro E. injection E as <- <-.
    change (at_point K (tl l) (Pc 0%Z)) with (zero K).
    change (at_point K (tl l) (Pc c)) with (at_point K l (Pc c)). ring.
  - cbn [parted]. intro E. injection E as <- <-. change (at_point K (tl l) (Pc 0%Z)) with (zero K).
    rewrite (at_without_first l (Pinj i a)) by discriminate. cbn [without_first]. ring.
  - cbn [parted]. destruct (parted square a) as [P0 Q0]. specialize (IHa P0 Q0 eq_refl).
    rewrite at_sum, IHa, (repeated_halved _ _ (Pos.to_nat i) H).
    destruct (Nat.even (Pos.to_nat i)); intro E; injection E as <- <-; rewrite !at_plus, !at_times, at_power.
    + ring.
    + rewrite <- H. ring.
Qed.

Lemma vanishing_sound roots : forall l a, roots_hold l roots -> vanishing roots a = true -> at_point K l a = zero K.
Proof.
  induction roots as [|square roots IH]; intros l a; cbn [roots_hold vanishing].
  - intros _ H. apply (at_equal K l) in H. exact H.
  - intros [Hx [Hy Hm]]. destruct (simple square) as [T|] eqn:ES; [|discriminate].
    destruct (parted T (cleared (first_degree a) a)) as [P Q] eqn:EP.
    intro H. apply andb_prop in H. destruct H as [HP HQ].
    apply (IH _ _ Hm) in HP. apply (IH _ _ Hm) in HQ.
    apply (simple_sound K (tl (tl l))) in ES. rewrite <- ES in Hy.
    pose proof (parted_sound (tl l) T _ Hy P Q EP) as H.
    rewrite <- (cleared_sound l a Hx (first_degree a) (le_n _)), HP, HQ in H.
    assert (N : hd (zero K) (tl l) <> zero K).
    { intro Z. rewrite Z in Hx. apply (F_1_neq_0 (field_axioms K)). rewrite <- Hx. ring. }
    apply (repeated_nonzero K _ (first_degree a)) in N.
    set (y := repeated K (hd (zero K) (tl l)) (first_degree a)) in *.
    transitivity (quotient K (times K y (at_point K l a)) y); [field; exact N|]. rewrite H. field. exact N.
Qed.

Lemma same_sound roots l a b : roots_hold l roots -> same roots a b = true -> at_point K l a = at_point K l b.
Proof.
  intro Hr. unfold same. destruct (peq a b) eqn:E; [intros _; exact (at_equal K l a b E)|].
  destruct roots as [|square roots]; [discriminate|]. intro H. apply (vanishing_sound _ l _ Hr) in H.
  rewrite at_minus in H.
  transitivity (plus K (minus K (at_point K l a) (at_point K l b)) (at_point K l b)); [ring|]. rewrite H. ring.
Qed.

End Roots.

Section Norm.
Variable K : differential_field.
Variable l : list K.
Variable atoms : list poly.
Variable roots : list expr.
Variable known : list (list nat * list nat).
Variable r : parameter -> rules.
Hypothesis Hr : forall q, rules_hold K l q (r q).
Hypothesis Hs : roots_hold K l roots.
Hypothesis Ha : Forall (nonzero K l) atoms.
Add Field K' : (field_axioms K).

Let at_point := at_point K l.
Let den (e : list nat) : K := at_point (product atoms e).
Let meaning (f : fraction) : K := quotient K (at_point (fst f)) (den (snd f)).

Lemma den_not_zero e : den e <> zero K.
Proof. now apply den_nonzero. Qed.
Hint Resolve den_not_zero : core.

Lemma den_empty : den [] = one K.
Proof. apply den_nil. Qed.

Lemma fadd_sound minus a b :
  meaning (fadd atoms minus a b) =
  (if minus then Base.minus K (meaning a) (meaning b) else plus K (meaning a) (meaning b)).
Proof.
  unfold fadd, meaning. pose proof (common_sound K l atoms (snd a) (snd b)) as H.
  destruct (common atoms (snd a) (snd b)) as [[x y] m]. destruct H as [Hx Hy].
  change (den m = times K (den (snd a)) (at_point x)) in Hx.
  change (den m = times K (den (snd b)) (at_point y)) in Hy.
  pose proof (den_not_zero m) as Hm. pose proof (den_not_zero (snd a)). pose proof (den_not_zero (snd b)).
  assert (Nx : at_point x <> zero K) by (intro E; apply Hm; rewrite Hx, E; ring).
  assert (Ny : at_point y <> zero K) by (intro E; apply Hm; rewrite Hy, E; ring).
  assert (Fa : quotient K (at_point (fst a)) (den (snd a)) = quotient K (times K (at_point (fst a)) (at_point x)) (den m))
    by (rewrite Hx; field; auto).
  assert (Fb : quotient K (at_point (fst b)) (den (snd b)) = quotient K (times K (at_point (fst b)) (at_point y)) (den m))
    by (rewrite Hy; field; auto).
  rewrite Fa, Fb. simpl fst. simpl snd.
  destruct minus; unfold at_point; [rewrite at_minus | rewrite at_plus]; rewrite !at_times; field; exact Hm.
Qed.

Lemma recognized_sound b positive top bottom : recognized atoms roots b known = Some (positive, top, bottom) ->
  times K (at_point (fst b)) (den bottom) =
  times K (if positive then one K else opposite K (one K)) (times K (den top) (den (snd b))).
Proof.
  clear Hr. induction known as [|[t u] k IH]; [discriminate|].
  cbn [recognized]. pose proof (common_sound K l atoms (sums t (snd b)) u) as H.
  destruct (common atoms (sums t (snd b)) u) as [[x y] m]. destruct H as [Hx Hy].
  assert (Hm : den m <> zero K) by auto. rewrite sums_sound in Hx.
  change (den m = times K (times K (den t) (den (snd b))) (at_point x)) in Hx.
  change (den m = times K (den u) (at_point y)) in Hy.
  assert (Nx : at_point x <> zero K) by (intro E; apply Hm; rewrite Hx, E; ring).
  destruct (same roots (pmul (fst b) x) y) eqn:E1; [|destruct (same roots (popp (pmul (fst b) x)) y) eqn:E2; [|exact IH]];
    intro E; injection E as <- <- <-.
  - apply (same_sound K roots l _ _ Hs) in E1. change (at_point (pmul (fst b) x) = at_point y) in E1.
    unfold at_point in E1. rewrite at_times in E1. fold at_point in E1. rewrite <- E1 in Hy.
    assert (H : times K (times K (at_point (fst b)) (den u)) (at_point x)
                = times K (times K (den t) (den (snd b))) (at_point x)) by (rewrite <- Hx, Hy; ring).
    transitivity (quotient K (times K (times K (at_point (fst b)) (den u)) (at_point x)) (at_point x));
      [field; exact Nx|]. rewrite H. field. exact Nx.
  - apply (same_sound K roots l _ _ Hs) in E2. change (at_point (popp (pmul (fst b) x)) = at_point y) in E2.
    assert (E3 : opposite K (times K (at_point (fst b)) (at_point x)) = at_point y).
    { rewrite <- E2. unfold at_point. rewrite at_negated. now rewrite at_times. }
    rewrite <- E3 in Hy.
    assert (H : times K (times K (at_point (fst b)) (den u)) (at_point x)
                = opposite K (times K (times K (den t) (den (snd b))) (at_point x))) by (rewrite <- Hx, Hy; ring).
    transitivity (quotient K (times K (times K (at_point (fst b)) (den u)) (at_point x)) (at_point x));
      [field; exact Nx|]. rewrite H. field. exact Nx.
Qed.

Lemma fdiv_sound a b f : fdiv atoms roots known a b = Some f -> meaning f = quotient K (meaning a) (meaning b).
Proof.
  unfold fdiv. destruct (recognized atoms roots b known) as [[[positive top] bottom]|] eqn:Eb; [|discriminate].
  apply recognized_sound in Eb.
  pose proof (cancelled_sound K l atoms bottom (sums (snd a) top)) as H.
  destruct (cancelled bottom (sums (snd a) top)) as [above below]. rewrite sums_sound in H.
  change (times K (den bottom) (den below) = times K (den above) (times K (den (snd a)) (den top))) in H.
  intro E. injection E as <-. unfold meaning. cbn [fst snd].
  assert (Hsign : at_point (if positive then pmul (fst a) (product atoms above) else popp (pmul (fst a) (product atoms above)))
    = times K (if positive then one K else opposite K (one K)) (times K (at_point (fst a)) (den above))).
  { destruct positive; unfold at_point; rewrite ?at_negated, at_times; fold at_point;
      change (at_point (product atoms above)) with (den above); ring. }
  rewrite Hsign.
  set (sign := if positive then one K else opposite K (one K)) in *.
  assert (Ns : sign <> zero K).
  { unfold sign. pose proof (F_1_neq_0 (field_axioms K)) as H1. destruct positive; [exact H1|].
    intro E. apply H1. transitivity (opposite K (opposite K (one K))); [ring|]. rewrite E. ring. }
  pose proof (den_not_zero bottom). pose proof (den_not_zero below). pose proof (den_not_zero top).
  pose proof (den_not_zero (snd a)). pose proof (den_not_zero (snd b)).
  assert (Nb : at_point (fst b) <> zero K).
  { intro E. rewrite E in Eb.
    assert (Z : times K sign (times K (den top) (den (snd b))) <> zero K)
      by (apply product_nonzero; [exact Ns | apply product_nonzero; auto]).
    apply Z. rewrite <- Eb. ring. }
  assert (Bb : at_point (fst b) = quotient K (times K sign (times K (den top) (den (snd b)))) (den bottom))
    by (rewrite <- Eb; field; auto).
  assert (Bh : den above = quotient K (times K (den bottom) (den below)) (times K (den (snd a)) (den top)))
    by (rewrite H; field; auto).
  assert (S2 : times K sign sign = one K) by (unfold sign; destruct positive; ring).
  rewrite Bb, Bh.
  transitivity (quotient K (times K (times K sign sign) (times K (at_point (fst a)) (den bottom)))
                           (times K sign (times K (den (snd a)) (den top)))); [field; auto|].
  rewrite S2. field. repeat split; auto.
Qed.

Lemma fder_sound q a f : fder atoms (r q) a = Some f -> meaning f = derivative K q (meaning a).
Proof.
  unfold fder. destruct (dpoly (r q) 0 (fst a)) as [dn|] eqn:En; [|discriminate].
  destruct (logarithmic (r q) atoms (snd a)) as [[[R L] m]|] eqn:El; [|discriminate].
  intro E. injection E as <-.
  apply (dpoly_sound K l q (r q) (Hr q) (fst a) 0) in En.
  change (derivative K q (at_point (fst a)) = at_point dn) in En.
  apply (logarithmic_sound K l q (r q) (Hr q)) in El. destruct El as [HL Hm].
  change (times K (derivative K q (den (snd a))) (at_point R) = times K (at_point L) (den (snd a))) in HL.
  change (den m = times K (den (snd a)) (at_point R)) in Hm.
  pose proof (den_not_zero (snd a)) as Hd. pose proof (den_not_zero m) as Nm.
  assert (NR : at_point R <> zero K) by (intro E; apply Nm; rewrite Hm, E; ring).
  unfold meaning. cbn [fst snd]. rewrite derivative_quotient by exact Hd. rewrite En, Hm.
  unfold at_point. rewrite at_minus, !at_times. fold at_point.
  assert (HD : derivative K q (den (snd a)) = quotient K (times K (at_point L) (den (snd a))) (at_point R))
    by (rewrite <- HL; field; exact NR).
  rewrite HD. field. auto.
Qed.

Lemma norm_sound e : forall f, norm atoms roots known r e = Some f -> meaning f = value K l e.
Proof.
  induction e as [i|z|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa|a IHa n|q a IHa];
    intros f; cbn [norm value].
  - intro E. injection E as <-. unfold meaning. cbn [fst snd]. rewrite den_empty.
    transitivity (at_point (pvar i)); [field; apply (F_1_neq_0 (field_axioms K))|]. apply at_pvar.
  - intro E. injection E as <-. unfold meaning. cbn [fst snd]. rewrite den_empty.
    change (at_point (Pc z)) with (integer K z). simpl. field. apply (F_1_neq_0 (field_axioms K)).
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate]. destruct (norm atoms roots known r b) as [y|]; [|discriminate].
    intro E. injection E as <-. rewrite fadd_sound, (IHa x), (IHb y); reflexivity.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate]. destruct (norm atoms roots known r b) as [y|]; [|discriminate].
    intro E. injection E as <-. rewrite fadd_sound, (IHa x), (IHb y); reflexivity.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate]. destruct (norm atoms roots known r b) as [y|]; [|discriminate].
    intro E. injection E as <-. rewrite <- (IHa x), <- (IHb y) by reflexivity. unfold meaning. cbn [fst snd].
    unfold den, at_point. rewrite sums_sound, at_times. fold at_point.
    change (at_point (product atoms (snd x))) with (den (snd x)).
    change (at_point (product atoms (snd y))) with (den (snd y)).
    simpl. field. auto.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate]. destruct (norm atoms roots known r b) as [y|]; [|discriminate].
    intro E. rewrite (fdiv_sound _ _ _ E), (IHa x), (IHb y); reflexivity.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate].
    intro E. injection E as <-. rewrite <- (IHa x) by reflexivity. unfold meaning. cbn [fst snd].
    assert (H : at_point (popp (fst x)) = opposite K (at_point (fst x))) by apply at_negated.
    rewrite H. simpl. field. auto.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate].
    intro E. injection E as <-. rewrite <- (IHa x) by reflexivity. unfold meaning. cbn [fst snd].
    assert (H : den (map (Nat.mul n) (snd x)) = repeated K (den (snd x)) n).
    { apply den_scaled. }
    rewrite H. unfold at_point. rewrite at_power. fold at_point. simpl.
    pose proof (den_not_zero (snd x)) as N.
    assert (P : times K (repeated K (quotient K (at_point (fst x)) (den (snd x))) n) (repeated K (den (snd x)) n)
                = repeated K (at_point (fst x)) n).
    { rewrite <- repeated_times. f_equal. field. exact N. }
    rewrite <- P. field. now apply repeated_nonzero.
  - destruct (norm atoms roots known r a) as [x|]; [|discriminate].
    intro E. rewrite (fder_sound _ _ _ E), (IHa x); reflexivity.
Qed.

Theorem equal_sound a b : equal atoms roots known r a b = true -> value K l a = value K l b.
Proof.
  unfold equal. destruct (norm atoms roots known r a) as [x|] eqn:Ea; [|discriminate].
  destruct (norm atoms roots known r b) as [y|] eqn:Eb; [|discriminate].
  rewrite <- (norm_sound _ _ Ea), <- (norm_sound _ _ Eb).
  pose proof (common_sound K l atoms (snd x) (snd y)) as H.
  destruct (common atoms (snd x) (snd y)) as [[u v] m]. destruct H as [Hu Hv].
  change (den m = times K (den (snd x)) (at_point u)) in Hu.
  change (den m = times K (den (snd y)) (at_point v)) in Hv.
  intro E. apply (same_sound K roots l _ _ Hs) in E. change (at_point (pmul (fst x) u) = at_point (pmul (fst y) v)) in E.
  unfold at_point in E. rewrite !at_times in E. fold at_point in E.
  pose proof (den_not_zero m) as Hm. pose proof (den_not_zero (snd x)). pose proof (den_not_zero (snd y)).
  assert (Nu : at_point u <> zero K) by (intro Z; apply Hm; rewrite Hu, Z; ring).
  assert (Nv : at_point v <> zero K) by (intro Z; apply Hm; rewrite Hv, Z; ring).
  unfold meaning.
  transitivity (quotient K (times K (at_point (fst x)) (at_point u)) (den m)); [rewrite Hu; field; auto|].
  rewrite E, Hv. field. auto.
Qed.

Theorem all_equal_sound a : forall b, all_equal atoms roots known r a b = true -> map (value K l) a = map (value K l) b.
Proof.
  induction a as [|x a IH]; intros [|y b]; try discriminate; [reflexivity|].
  cbn [all_equal]. intro H. apply andb_prop in H. destruct H as [H1 H2].
  simpl. f_equal; [now apply equal_sound | now apply IH].
Qed.

(** An element divides one that is not zero: it is not zero. *)
Theorem divisor_nonzero e q a : equal atoms roots known r e (emul q a) = true ->
  value K l e <> zero K -> value K l a <> zero K.
Proof.
  intros H N E. apply N. rewrite (equal_sound _ _ H). simpl. rewrite E. ring.
Qed.

(** The atoms are the polynomials that expressions come to. *)
Theorem atom_nonzero e a : norm atoms roots known r e = Some (a, []) -> value K l e <> zero K -> nonzero K l a.
Proof.
  intros H N E. apply N. rewrite <- (norm_sound _ _ H). unfold meaning. cbn [fst snd]. rewrite den_empty.
  change (at_point a = zero K) in E. rewrite E. field. apply (F_1_neq_0 (field_axioms K)).
Qed.

End Norm.
