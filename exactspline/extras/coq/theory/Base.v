(** What the theorems are about: formulas over anything that knows + - * / and derivatives, and abstract
    differential fields, in which they are equalities.

    Nothing is assumed but the axioms of a field and that a derivation is additive and obeys Leibniz' rule. *)

Require Import ZArith List Ring_theory Field_theory InitialRing.
Import ListNotations.

(** ** Operations *)

(** The parameters of two curves, s and s̄; what depends on one parameter alone uses the first. Of a surface u is s and
    v is s_bar; a curve on it has its own. *)
Inductive parameter := s | s_bar | time.

(** What a formula needs: every reading of a formula is an instance of this. *)
Class operations (A : Type) := {
  number : Z -> A;
  add : A -> A -> A;
  sub : A -> A -> A;
  mul : A -> A -> A;
  div : A -> A -> A;
  neg : A -> A;
  power : A -> nat -> A;
  der : parameter -> A -> A
}.

Declare Scope formula_scope.
Delimit Scope formula_scope with formula.
Infix "+" := add : formula_scope.
Infix "-" := sub : formula_scope.
Infix "*" := mul : formula_scope.
Infix "/" := div : formula_scope.
Notation "- a" := (neg a) : formula_scope.
Infix "^" := power : formula_scope.

(** ** Vectors: lists of components *)

Section Vectors.
Context {A : Type} {o : operations A}.
Local Open Scope formula_scope.

Fixpoint zip (f : A -> A -> A) (a b : list A) : list A :=
  match a, b with
  | x :: a, y :: b => f x y :: zip f a b
  | _, _ => []
  end.

Definition vadd (a b : list A) := zip add a b.
Definition vsub (a b : list A) := zip sub a b.
Definition vneg (a : list A) := map neg a.
Definition vmul (k : A) (a : list A) := map (fun x => x * k) a.
Definition vdiv (a : list A) (k : A) := map (fun x => x / k) a.
Definition vder (q : parameter) (a : list A) := map (der q) a.
Definition component (i : nat) (a : list A) := nth i a (number 0).
Definition components (i j : nat) (a : list A) := firstn (j - i) (skipn i a).

(** The derivative of an order. *)
Definition ders (q : parameter) (order : nat) (a : A) := Nat.iter order (der q) a.
Definition vders (q : parameter) (order : nat) (a : list A) := map (ders q order) a.

Fixpoint sum_from (x : A) (a b : list A) : A :=
  match a, b with
  | y :: a, z :: b => sum_from (x + y * z) a b
  | _, _ => x
  end.

(** Scalar product. *)
Definition dot (a b : list A) : A :=
  match a, b with
  | x :: a, y :: b => sum_from (x * y) a b
  | _, _ => number 0
  end.

(** The plane vector turned by a right angle to the left. *)
Definition perp (a : list A) := [- component 1 a; component 0 a].

(** Cross product in space. *)
Definition cross (a b : list A) : list A :=
  [component 1 a * component 2 b - component 2 a * component 1 b;
   component 2 a * component 0 b - component 0 a * component 2 b;
   component 0 a * component 1 b - component 1 a * component 0 b].

(** The elements of a list, each with those that are left without it. *)
Fixpoint each {B : Type} (before rest : list B) : list (B * list B) :=
  match rest with
  | [] => []
  | x :: rest => (x, before ++ rest) :: each (before ++ [x]) rest
  end.

Fixpoint alternating (a : list A) : A :=
  match a with
  | [] => number 0
  | [x] => x
  | x :: a => x - alternating a
  end.

(** The minor of rows in some columns: Laplace's expansion along the first row. *)
Fixpoint minor (rows : list (list A)) (columns : list nat) : A :=
  match rows with
  | [] => number 1
  | [row] => component (hd 0%nat columns) row
  | row :: rows => alternating (map (fun c => component (fst c) row * minor rows (snd c)) (each [] columns))
  end.

(** Determinant of n vectors in n dimensions. *)
Definition det (rows : list (list A)) : A := minor rows (seq 0 (length rows)).

(** The vector v with [det (rows, x) = v·x] for all x. *)
Definition generalized_cross (rows : list (list A)) : list A :=
  let n := length rows in
  map (fun c => if Nat.even (n + fst c) then minor rows (snd c) else - minor rows (snd c)) (each [] (seq 0 (S n))).

(** The unit vector of a coordinate. *)
Definition axis (i n : nat) : list A := map (fun j => number (if Nat.eqb i j then 1 else 0)) (seq 0 n).

End Vectors.

(** ** What formulas are handed *)

(** A curve by its parameter, numerators, denominator and itself, and a point beside it. *)
Record curve (A : Type) := Curve { along : parameter; p : list A; w : A; gamma : list A; point : list A }.
Record pair (A : Type) := Pair { first : curve A; second : curve A }.
Record table (A : Type) := Table { p1 : A; w1 : A; v1 : list A; p2 : A; w2 : A; v2 : list A }.
Arguments Curve {A} _ _ _ _ _. Arguments along {A} _. Arguments p {A} _. Arguments w {A} _. Arguments gamma {A} _. Arguments point {A} _.
Arguments Pair {A} _ _. Arguments first {A} _. Arguments second {A} _.
Arguments Table {A} _ _ _ _ _ _. Arguments p1 {A} _. Arguments w1 {A} _. Arguments v1 {A} _.
Arguments p2 {A} _. Arguments w2 {A} _. Arguments v2 {A} _.

(** A curve with more beside it: constants, or functions on which it depends. *)
Record accompanied (A : Type) := Accompanied { plain : curve A; beside : list A }.
Arguments Accompanied {A} _ _. Arguments plain {A} _. Arguments beside {A} _.
Coercion plain : accompanied >-> curve.

(** A curve with σ = ‖γ′‖ and, in space, ρ = ‖γ′ × γ″‖. *)
Record framed (A : Type) := Framed { bare : curve A; sigma : A; rho : A }.
Arguments Framed {A} _ _ _. Arguments bare {A} _. Arguments sigma {A} _. Arguments rho {A} _.
Coercion bare : framed >-> curve.

(** A curve in the zero set of a function F: what is free (its pace, or the direction in which a surface is cut), the
    first partial derivatives of F along the curve, and the rows of the second ones. *)
Record implicit (A : Type) :=
  Implicit { on_level : curve A; free : list A; gradient_f : list A; hessian_f : list (list A) }.
Arguments Implicit {A} _ _ _ _. Arguments on_level {A} _. Arguments free {A} _.
Arguments gradient_f {A} _. Arguments hessian_f {A} _.
Coercion on_level : implicit >-> curve.

(** A surface S(u, v), its numerators and denominator in the fields of a curve; s is u, and s_bar is v. *)
Record patch (A : Type) := Patch { net : curve A }.
Arguments Patch {A} _. Arguments net {A} _.
Coercion net : patch >-> curve.

(** A curve on a surface, γ(t) = S(u(t), v(t)): the surface, and its parameters as functions of t. *)
Record path (A : Type) := Path { under : patch A; route : list A }.
Arguments Path {A} _ _. Arguments under {A} _. Arguments route {A} _.
Coercion under : path >-> patch.
Definition with_route {A : Type} (c : path A) : accompanied A := Accompanied (net c) (route c).
Coercion with_route : path >-> accompanied.

Section Arguments.
Context {A : Type} {o : operations A}.
Local Open Scope formula_scope.

(** What stands beside a curve: u, v and h of the hodograph (u² − v², 2uv) h; the parameters u and v of a curve on a
    surface. *)
Definition u_of (c : accompanied A) := component 0 (beside c).
Definition v_of (c : accompanied A) := component 1 (beside c).
Definition h_of (c : accompanied A) := component 2 (beside c).
Definition speed_of (c : accompanied A) := (u_of c * u_of c + v_of c * v_of c) * h_of c.
Definition velocity_of (c : accompanied A) :=
  vmul (h_of c) [u_of c * u_of c - v_of c * v_of c; u_of c * v_of c + u_of c * v_of c].

(** The partial derivatives of F. *)
Definition pace_of (c : implicit A) := component 0 (free c).
Definition cut_of (c : implicit A) := free c.
Definition fx_of (c : implicit A) := component 0 (gradient_f c).
Definition fy_of (c : implicit A) := component 1 (gradient_f c).
Definition fz_of (c : implicit A) := component 2 (gradient_f c).
Definition hessian_fx_of (c : implicit A) := nth 0 (hessian_f c) [].
Definition hessian_fy_of (c : implicit A) := nth 1 (hessian_f c) [].
Definition hessian_fz_of (c : implicit A) := nth 2 (hessian_f c) [].
Definition fxx_of (c : implicit A) := component 0 (hessian_fx_of c).
Definition fxy_of (c : implicit A) := component 1 (hessian_fx_of c).
Definition fxz_of (c : implicit A) := component 2 (hessian_fx_of c).
Definition fyy_of (c : implicit A) := component 1 (hessian_fy_of c).
Definition fyz_of (c : implicit A) := component 2 (hessian_fy_of c).
Definition fzz_of (c : implicit A) := component 2 (hessian_fz_of c).

(** The surface itself; two quadratic forms E, F, G and L, M, N, and the function w beside them. *)
Definition S_of (c : patch A) := gamma c.
Definition E_of (c : accompanied A) := component 0 (beside c).
Definition F_of (c : accompanied A) := component 1 (beside c).
Definition G_of (c : accompanied A) := component 2 (beside c).
Definition L_of (c : accompanied A) := component 3 (beside c).
Definition M_of (c : accompanied A) := component 4 (beside c).
Definition N_of (c : accompanied A) := component 5 (beside c).

(** The curve [γ = p/w], with a point (empty for none). *)
Definition rational_curve (q : parameter) (p : list A) (w : A) (point : list A) : curve A :=
  Curve q p w (vdiv p w) point.

(** The curve [γ] with the numerators [w γ]. *)
Definition homogeneous (q : parameter) (gamma : list A) (w : A) (point : list A) : curve A :=
  Curve q (vmul w gamma) w gamma point.

(** A plane curve (and its point) in the plane z = 0 of space. *)
Definition embedded (c : curve A) : curve A :=
  Curve (along c) (p c ++ [number 0]) (w c) (gamma c ++ [number 0]) (point c ++ [number 0]).

(** A ruled surface: directrix and generator. *)
Definition surface : Type := list A * list A.
Definition directrix (f : surface) : list A := fst f.
Definition generator (f : surface) : list A := snd f.
Definition ruled (directrix generator : list A) : surface := (directrix, generator).

(** A point is on the ruling of a surface (at the parameter in question). *)
Definition on_ruling (f : surface) (x : list A) : Prop := exists z, x = vadd (directrix f) (vmul z (generator f)).

(** Two ruled surfaces are one: their rulings are the same lines. *)
Definition same_surface (f g : surface) : Prop := forall x, on_ruling f x <-> on_ruling g x.

End Arguments.
Arguments surface A : clear implicits.

(** ** Differential fields *)

Record differential_field := {
  element :> Type;
  zero : element;
  one : element;
  plus : element -> element -> element;
  times : element -> element -> element;
  minus : element -> element -> element;
  opposite : element -> element;
  quotient : element -> element -> element;
  inverse : element -> element;
  derivative : parameter -> element -> element;
  field_axioms : field_theory zero one plus times minus opposite quotient inverse (@eq element);
  derivative_plus : forall q a b, derivative q (plus a b) = plus (derivative q a) (derivative q b);
  derivative_times : forall q a b,
    derivative q (times a b) = plus (times (derivative q a) b) (times a (derivative q b))
}.

Fixpoint repeated (K : differential_field) (a : K) (n : nat) : K :=
  match n with
  | 0 => one K
  | 1 => a
  | S n => times K (repeated K a n) a
  end.

(** The integers of a field. *)
Definition integer (K : differential_field) : Z -> K := gen_phiZ (zero K) (one K) (plus K) (times K) (opposite K).

(** The reading in which equalities hold: formulas are elements of a differential field. *)
#[export] Instance field_operations (K : differential_field) : operations K := {
  number := integer K;
  add := plus K;
  sub := minus K;
  mul := times K;
  div := quotient K;
  neg := opposite K;
  power := repeated K;
  der := derivative K
}.

(** A point is a vector of constants. *)
Definition constant {K : differential_field} (a : K) : Prop := forall q, derivative K q a = zero K.

(** ** What theorems speak of *)

(** Every rational plane curve, γ = (x, y)/w, over every differential field. *)
Definition every_plane_curve (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y w : K), w <> zero K -> P K (rational_curve s [x; y] w []).

(** Every rational space curve, γ = (x, y, z)/w. *)
Definition every_space_curve (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w : K), w <> zero K -> P K (rational_curve s [x; y; z] w []).

(** Every rational plane curve with a point Q = (a, b) beside it. *)
Definition every_plane_curve_with_point (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y w a b : K), constant a -> constant b -> w <> zero K ->
  P K (rational_curve s [x; y] w [a; b]).

(** Every rational space curve with a point Q = (a, b, c) beside it. *)
Definition every_space_curve_with_point (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w a b c : K), constant a -> constant b -> constant c -> w <> zero K ->
  P K (rational_curve s [x; y; z] w [a; b; c]).

(** Every two rational space curves, of the parameters s and s̄. *)
Definition every_two_curves (P : forall K : differential_field, pair K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w X Y Z W : K), w <> zero K -> W <> zero K ->
  P K (Pair (rational_curve s [x; y; z] w []) (rational_curve s_bar [X; Y; Z] W [])).

(** Every two rational plane curves. *)
Definition every_two_plane_curves (P : forall K : differential_field, pair K -> Prop) : Prop :=
  forall (K : differential_field) (x y w X Y W : K), w <> zero K -> W <> zero K ->
  P K (Pair (rational_curve s [x; y] w []) (rational_curve s_bar [X; Y] W [])).

(** All operands of Table 1. *)
Definition every_table (P : forall K : differential_field, table K -> Prop) : Prop :=
  forall (K : differential_field) (p1 w1 x1 y1 z1 p2 w2 x2 y2 z2 : K), w1 <> zero K -> w2 <> zero K ->
  P K (Table p1 w1 [x1; y1; z1] p2 w2 [x2; y2; z2]).

(** *** Polynomial curves: the denominator is 1 *)

Definition every_polynomial_plane_curve (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y : K), P K (rational_curve s [x; y] (number 1) []).

Definition every_polynomial_space_curve (P : forall K : differential_field, curve K -> Prop) : Prop :=
  forall (K : differential_field) (x y z : K), P K (rational_curve s [x; y; z] (number 1) []).

(** *** Curves with constants beside them *)

Fixpoint every_constants {K : differential_field} (n : nat) (P : list K -> Prop) : Prop :=
  match n with
  | 0 => P []
  | S n => forall k : K, constant k -> every_constants n (fun ks => P (k :: ks))
  end.

(** Every rational plane curve with so many constants. *)
Definition every_plane_curve_with (n : nat) (P : forall K : differential_field, accompanied K -> Prop) : Prop :=
  forall (K : differential_field) (x y w : K), w <> zero K ->
  every_constants n (fun ks => P K (Accompanied (rational_curve s [x; y] w []) ks)).

(** Every rational space curve with so many constants. *)
Definition every_space_curve_with (n : nat) (P : forall K : differential_field, accompanied K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w : K), w <> zero K ->
  every_constants n (fun ks => P K (Accompanied (rational_curve s [x; y; z] w []) ks)).

(** *** Curves with the roots of their frames *)

(** Every rational plane curve with σ, σ² = γ′·γ′. *)
Definition every_framed_plane_curve (P : forall K : differential_field, framed K -> Prop) : Prop :=
  forall (K : differential_field) (x y w sigma : K), w <> zero K ->
  let c := rational_curve s [x; y] w [] in
  let velocity := vder s (gamma c) in
  times K sigma sigma = dot velocity velocity -> P K (Framed c sigma (zero K)).

(** Every rational space curve with σ and ρ, ρ² = (γ′ × γ″)·(γ′ × γ″). *)
Definition every_framed_space_curve (P : forall K : differential_field, framed K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w sigma rho : K), w <> zero K ->
  let c := rational_curve s [x; y; z] w [] in
  let velocity := vder s (gamma c) in
  let binormal := cross velocity (vders s 2 (gamma c)) in
  times K sigma sigma = dot velocity velocity -> times K rho rho = dot binormal binormal -> P K (Framed c sigma rho).

(** *** Curves whose speed is no root *)

(** Every polynomial plane curve with γ′ = (u² − v², 2uv) h. *)
Definition every_hodograph (P : forall K : differential_field, accompanied K -> Prop) : Prop :=
  forall (K : differential_field) (x y u v h : K),
  let c := Accompanied (rational_curve s [x; y] (number 1) []) [u; v; h] in
  [derivative K s x; derivative K s y] = velocity_of c -> P K c.

(** Every polynomial plane curve with γ′ = (u² − v², 2uv). *)
Definition every_primitive_hodograph (P : forall K : differential_field, accompanied K -> Prop) : Prop :=
  forall (K : differential_field) (x y u v : K),
  let c := Accompanied (rational_curve s [x; y] (number 1) []) [u; v; number 1] in
  [derivative K s x; derivative K s y] = velocity_of c -> P K c.

(** *** Curves along which a function is constant *)

(** The chain rule for the partial derivatives of F along a curve. *)
Definition chain_rule {K : differential_field} (c : implicit K) : Prop :=
  vder s (gradient_f c) = map (fun row => dot row (vder s (gamma c))) (hessian_f c).

(** Every curve that runs along F = constant in the plane, at any pace. *)
Definition every_implicit_curve (P : forall K : differential_field, implicit K -> Prop) : Prop :=
  forall (K : differential_field) (x y pace fx fy fxx fxy fyy : K),
  let c := Implicit (rational_curve s [x; y] (number 1) []) [pace] [fx; fy] [[fxx; fxy]; [fxy; fyy]] in
  vder s (gamma c) = vmul pace (perp (gradient_f c)) -> chain_rule c -> P K c.

(** Every curve on F = constant in space: it runs along ∇F × cut, for any cut. *)
Definition every_implicit_surface (P : forall K : differential_field, implicit K -> Prop) : Prop :=
  forall (K : differential_field) (x y z l m n fx fy fz fxx fxy fxz fyy fyz fzz : K),
  let c := Implicit (rational_curve s [x; y; z] (number 1) []) [l; m; n] [fx; fy; fz]
    [[fxx; fxy; fxz]; [fxy; fyy; fyz]; [fxz; fyz; fzz]] in
  vder s (gamma c) = cross (gradient_f c) (free c) -> chain_rule c -> P K c.

(** *** Surfaces: functions of u and v, whose derivatives commute *)

Definition commuting (K : differential_field) : Prop :=
  forall a : K, derivative K s (derivative K s_bar a) = derivative K s_bar (derivative K s a).

(** Every rational surface in space. *)
Definition every_surface (P : forall K : differential_field, patch K -> Prop) : Prop :=
  forall (K : differential_field) (x y z w : K), commuting K -> w <> zero K ->
  P K (Patch (rational_curve s [x; y; z] w [])).

(** Every rational map of the plane. *)
Definition every_planar_map (P : forall K : differential_field, patch K -> Prop) : Prop :=
  forall (K : differential_field) (x y w : K), commuting K -> w <> zero K -> P K (Patch (rational_curve s [x; y] w [])).

(** Every two quadratic forms. *)
Definition every_two_forms (P : forall K : differential_field, accompanied K -> Prop) : Prop :=
  forall (K : differential_field) (E F G L M N w : K), commuting K ->
  P K (Accompanied (rational_curve s [] w []) [E; F; G; L; M; N]).

(** *** Curves on a surface *)

(** A function a of u and v, and its partial derivatives up to an order, obey the chain rule along the curve with the
    parameters u(t), v(t): da/dt = a_u u′ + a_v v′. *)
Fixpoint composed {K : differential_field} (u v : K) (order : nat) (a : K) : Prop :=
  derivative K time a =
    plus K (times K (derivative K s a) (derivative K time u)) (times K (derivative K s_bar a) (derivative K time v)) /\
  match order with
  | 0 => True
  | S n => composed u v n (derivative K s a) /\ composed u v n (derivative K s_bar a)
  end.

(** Every curve on every rational surface. *)
Definition every_curve_on_a_surface (P : forall K : differential_field, path K -> Prop) : Prop :=
  forall (K : differential_field) (u v x y z w : K), commuting K ->
  (forall order, Forall (composed u v order) [x; y; z; w]) -> w <> zero K ->
  P K (Path (Patch (rational_curve time [x; y; z] w [])) [u; v]).
