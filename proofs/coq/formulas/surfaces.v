(** Rational surfaces: the open question of the paper: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** first form. `EG − F²`. *)
Definition area_of_forms (c : accompanied A) : A :=
  E_of c * G_of c - F_of c ^ 2.

(** second form. `LN − M²`. *)
Definition parabolic_of_forms (c : accompanied A) : A :=
  L_of c * N_of c - M_of c ^ 2.

(** both forms. `EN − 2FM + GL`. *)
Definition minimality_of_forms (c : accompanied A) : A :=
  E_of c * N_of c - number 2 * F_of c * M_of c + G_of c * L_of c.

(** lines of curvature. `EM − FL`. *)
Definition line_uu_of_forms (c : accompanied A) : A :=
  E_of c * M_of c - F_of c * L_of c.

(** lines of curvature. `EN − GL`. *)
Definition line_uv_of_forms (c : accompanied A) : A :=
  E_of c * N_of c - G_of c * L_of c.

(** lines of curvature. `FN − GM`. *)
Definition line_vv_of_forms (c : accompanied A) : A :=
  F_of c * N_of c - G_of c * M_of c.

(** lines of curvature. `B² − 4AC`. *)
Definition line_discriminant_of_forms (c : accompanied A) : A :=
  line_uv_of_forms c ^ 2 - number 4 * line_uu_of_forms c * line_vv_of_forms c.

(** lines of curvature. `EC − FB + GA`: the lines of curvature are orthogonal where this is zero. *)
Definition line_relation_of_forms (c : accompanied A) : A :=
  E_of c * line_vv_of_forms c - F_of c * line_uv_of_forms c + G_of c * line_uu_of_forms c.

(** lines of curvature. `LC − MB + NA`: they are conjugate where this is zero. *)
Definition line_relation_of_second_form (c : accompanied A) : A :=
  L_of c * line_vv_of_forms c - M_of c * line_uv_of_forms c + N_of c * line_uu_of_forms c.

(** principal curvatures. `(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)`, the discriminant of the principal curvatures. *)
Definition umbilicity_of_forms (c : accompanied A) : A :=
  minimality_of_forms c ^ 2 - number 4 * area_of_forms c * parabolic_of_forms c.

(** principal curvatures. `E² Δ`. *)
Definition umbilicity_times_square (c : accompanied A) : A :=
  E_of c ^ 2 * umbilicity_of_forms c.

(** principal curvatures. `(EB − 2FA)² + (EG − F²)(2A)²`. *)
Definition umbilicity_as_squares (c : accompanied A) : A :=
  (E_of c * line_uv_of_forms c - number 2 * F_of c * line_uu_of_forms c) ^ 2 + area_of_forms c * (number 2 * line_uu_of_forms c) ^ 2.

(** stationary principal curvatures. What of `2 √Δ a^(5/2) κ_u` is free of √Δ, for `a = EG − F²`: `a Δ_u − 3 Δ a_u`. *)
Definition stationary_by_u (c : accompanied A) : A :=
  area_of_forms c * der s (umbilicity_of_forms c) - number 3 * umbilicity_of_forms c * der s (area_of_forms c).

(** stationary principal curvatures. The same for `κ_v`. *)
Definition stationary_by_v (c : accompanied A) : A :=
  area_of_forms c * der s_bar (umbilicity_of_forms c) - number 3 * umbilicity_of_forms c * der s_bar (area_of_forms c).

(** stationary principal curvatures. The factor of √Δ in the same, with `h = EN − 2FM + GL`: `2a h_u − 3h a_u`, zero where H_u is. *)
Definition stationary_root_by_u (c : accompanied A) : A :=
  number 2 * area_of_forms c * der s (minimality_of_forms c) - number 3 * minimality_of_forms c * der s (area_of_forms c).

(** stationary principal curvatures. The same for `κ_v`. *)
Definition stationary_root_by_v (c : accompanied A) : A :=
  number 2 * area_of_forms c * der s_bar (minimality_of_forms c) - number 3 * minimality_of_forms c * der s_bar (area_of_forms c).

(** ridges. What of the derivative of κ along its own line, `(2a M − (h + √Δ) F) κ_u + ((h + √Δ) E − 2a L) κ_v`, is free of √Δ. *)
Definition ridge_rational_part (c : accompanied A) : A :=
  stationary_by_u c * (number 2 * area_of_forms c * M_of c - minimality_of_forms c * F_of c) + stationary_by_v c * (minimality_of_forms c * E_of c - number 2 * area_of_forms c * L_of c) + umbilicity_of_forms c * (E_of c * stationary_root_by_v c - F_of c * stationary_root_by_u c).

(** ridges. The factor of √Δ in the same. *)
Definition ridge_root_part (c : accompanied A) : A :=
  stationary_root_by_u c * (number 2 * area_of_forms c * M_of c - minimality_of_forms c * F_of c) + stationary_root_by_v c * (minimality_of_forms c * E_of c - number 2 * area_of_forms c * L_of c) + E_of c * stationary_by_v c - F_of c * stationary_by_u c.

(** ridges. `U² − Δ V²`: zero where one of the principal curvatures is extremal along its own line, and elsewhere. *)
Definition ridges_by_definition (c : accompanied A) : A :=
  ridge_rational_part c ^ 2 - umbilicity_of_forms c * ridge_root_part c ^ 2.

(** ridges. The cubic form `(EG − F²) dII(t, t) − d(EG − F²) II(t, t)/2 − dI(t, s)` in the direction t along which d is taken: of a principal direction it is the derivative of κ along it, up to a factor without a zero. With `II t = κ I t` the derivative of `κ I(t, t) = II(t, t)` needs none of t, and `s` is `κ t` without κ. *)
Definition ridge_cubic (c : accompanied A) : list A :=
  ([area_of_forms c * der s (L_of c) - der s (area_of_forms c) * L_of c / number 2 - der s (E_of c) * (G_of c * L_of c - F_of c * M_of c) - der s (F_of c) * (E_of c * M_of c - F_of c * L_of c)] ++ [number 2 * area_of_forms c * der s (M_of c) - der s (area_of_forms c) * M_of c - der s (E_of c) * (G_of c * M_of c - F_of c * N_of c) - der s (F_of c) * (G_of c * L_of c - F_of c * M_of c + (E_of c * N_of c - F_of c * M_of c)) - der s (G_of c) * (E_of c * M_of c - F_of c * L_of c) + (area_of_forms c * der s_bar (L_of c) - der s_bar (area_of_forms c) * L_of c / number 2 - der s_bar (E_of c) * (G_of c * L_of c - F_of c * M_of c) - der s_bar (F_of c) * (E_of c * M_of c - F_of c * L_of c))] ++ [area_of_forms c * der s (N_of c) - der s (area_of_forms c) * N_of c / number 2 - der s (F_of c) * (G_of c * M_of c - F_of c * N_of c) - der s (G_of c) * (E_of c * N_of c - F_of c * M_of c) + (number 2 * area_of_forms c * der s_bar (M_of c) - der s_bar (area_of_forms c) * M_of c - der s_bar (E_of c) * (G_of c * M_of c - F_of c * N_of c) - der s_bar (F_of c) * (G_of c * L_of c - F_of c * M_of c + (E_of c * N_of c - F_of c * M_of c)) - der s_bar (G_of c) * (E_of c * M_of c - F_of c * L_of c))] ++ [area_of_forms c * der s_bar (N_of c) - der s_bar (area_of_forms c) * N_of c / number 2 - der s_bar (F_of c) * (G_of c * M_of c - F_of c * N_of c) - der s_bar (G_of c) * (E_of c * N_of c - F_of c * M_of c)]).

(** ridges. The resultant of the lines of curvature `A t_u² + B t_u t_v + C t_v² = 0` and that cubic form: zero on the ridges of both principal curvatures. *)
Definition ridges_of_forms (c : accompanied A) : A :=
  det [([line_uu_of_forms c] ++ [line_uv_of_forms c] ++ [line_vv_of_forms c] ++ [number 0] ++ [number 0]); ([number 0] ++ [line_uu_of_forms c] ++ [line_uv_of_forms c] ++ [line_vv_of_forms c] ++ [number 0]); ([number 0] ++ [number 0] ++ [line_uu_of_forms c] ++ [line_uv_of_forms c] ++ [line_vv_of_forms c]); (ridge_cubic c ++ [number 0]); ([number 0] ++ ridge_cubic c)].

(** ridges. The cubic form of both fundamental forms divided by `w⁴`. *)
Definition ridge_cubic_over_weight (c : accompanied A) : list A :=
  ([(E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s (L_of c / w c ^ 4) - der s (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (L_of c / w c ^ 4) / number 2 - der s (E_of c / w c ^ 4) * (G_of c / w c ^ 4 * (L_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4)) - der s (F_of c / w c ^ 4) * (E_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (L_of c / w c ^ 4))] ++ [number 2 * (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s (M_of c / w c ^ 4) - der s (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (M_of c / w c ^ 4) - der s (E_of c / w c ^ 4) * (G_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (N_of c / w c ^ 4)) - der s (F_of c / w c ^ 4) * (G_of c / w c ^ 4 * (L_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4) + (E_of c / w c ^ 4 * (N_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4))) - der s (G_of c / w c ^ 4) * (E_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (L_of c / w c ^ 4)) + ((E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s_bar (L_of c / w c ^ 4) - der s_bar (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (L_of c / w c ^ 4) / number 2 - der s_bar (E_of c / w c ^ 4) * (G_of c / w c ^ 4 * (L_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4)) - der s_bar (F_of c / w c ^ 4) * (E_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (L_of c / w c ^ 4)))] ++ [(E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s (N_of c / w c ^ 4) - der s (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (N_of c / w c ^ 4) / number 2 - der s (F_of c / w c ^ 4) * (G_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (N_of c / w c ^ 4)) - der s (G_of c / w c ^ 4) * (E_of c / w c ^ 4 * (N_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4)) + (number 2 * (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s_bar (M_of c / w c ^ 4) - der s_bar (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (M_of c / w c ^ 4) - der s_bar (E_of c / w c ^ 4) * (G_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (N_of c / w c ^ 4)) - der s_bar (F_of c / w c ^ 4) * (G_of c / w c ^ 4 * (L_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4) + (E_of c / w c ^ 4 * (N_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4))) - der s_bar (G_of c / w c ^ 4) * (E_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (L_of c / w c ^ 4)))] ++ [(E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * der s_bar (N_of c / w c ^ 4) - der s_bar (E_of c / w c ^ 4 * (G_of c / w c ^ 4) - (F_of c / w c ^ 4) ^ 2) * (N_of c / w c ^ 4) / number 2 - der s_bar (F_of c / w c ^ 4) * (G_of c / w c ^ 4 * (M_of c / w c ^ 4) - F_of c / w c ^ 4 * (N_of c / w c ^ 4)) - der s_bar (G_of c / w c ^ 4) * (E_of c / w c ^ 4 * (N_of c / w c ^ 4) - F_of c / w c ^ 4 * (M_of c / w c ^ 4))]).

(** ridges. `w T + 4 (EG − F²) dw II(t, t)`. *)
Definition ridge_cubic_weighted (c : accompanied A) : list A :=
  vadd (vmul (w c) (ridge_cubic c)) (vmul (number 4 * area_of_forms c) (([der s (w c) * L_of c] ++ [number 2 * der s (w c) * M_of c + der s_bar (w c) * L_of c] ++ [der s (w c) * N_of c + number 2 * der s_bar (w c) * M_of c] ++ [der s_bar (w c) * N_of c]))).

(** derivatives. The derivative by u. *)
Definition S_u (c : patch A) : list A :=
  vder s (S_of c).

(** derivatives. The derivative by v. *)
Definition S_v (c : patch A) : list A :=
  vder s_bar (S_of c).

(** derivatives. The second derivative by u. *)
Definition S_uu (c : patch A) : list A :=
  vders s 2 (S_of c).

(** derivatives. The mixed derivative. *)
Definition S_uv (c : patch A) : list A :=
  vder s_bar (vder s (S_of c)).

(** derivatives. The second derivative by v. *)
Definition S_vv (c : patch A) : list A :=
  vders s_bar 2 (S_of c).

(** first fundamental form. `‖S_u‖²`. *)
Definition E_ (c : patch A) : A :=
  dot (S_u c) (S_u c).

(** first fundamental form. `S_u · S_v`. *)
Definition F (c : patch A) : A :=
  dot (S_u c) (S_v c).

(** first fundamental form. `‖S_v‖²`. *)
Definition G (c : patch A) : A :=
  dot (S_v c) (S_v c).

(** normal. `S_u × S_v`, not normalized. *)
Definition normal (c : patch A) : list A :=
  cross (S_u c) (S_v c).

(** second fundamental form. `S_uu · n`. *)
Definition L (c : patch A) : A :=
  dot (S_uu c) (normal c).

(** second fundamental form. `S_uv · n`. *)
Definition M (c : patch A) : A :=
  dot (S_uv c) (normal c).

(** second fundamental form. `S_vv · n`. *)
Definition N_ (c : patch A) : A :=
  dot (S_vv c) (normal c).

(** reduced. `w² S_u`, the numerator of the quotient rule. *)
Definition D_u (c : patch A) : list A :=
  vsub (vmul (w c) (vder s (p c))) (vmul (der s (w c)) (p c)).

(** reduced. `w² S_v`. *)
Definition D_v (c : patch A) : list A :=
  vsub (vmul (w c) (vder s_bar (p c))) (vmul (der s_bar (w c)) (p c)).

(** reduced. `w⁴ E`. *)
Definition E_reduced (c : patch A) : A :=
  dot (D_u c) (D_u c).

(** reduced. `w⁴ F`. *)
Definition F_reduced (c : patch A) : A :=
  dot (D_u c) (D_v c).

(** reduced. `w⁴ G`. *)
Definition G_reduced (c : patch A) : A :=
  dot (D_v c) (D_v c).

(** reduced. `w³ S_uu`. *)
Definition D_uu (c : patch A) : list A :=
  vsub (vmul (w c) (vder s (D_u c))) (vmul (number 2 * der s (w c)) (D_u c)).

(** reduced. `w³ S_uv`. *)
Definition D_uv (c : patch A) : list A :=
  vsub (vmul (w c) (vder s_bar (D_u c))) (vmul (number 2 * der s_bar (w c)) (D_u c)).

(** reduced. `w³ S_vv`. *)
Definition D_vv (c : patch A) : list A :=
  vsub (vmul (w c) (vder s_bar (D_v c))) (vmul (number 2 * der s_bar (w c)) (D_v c)).

(** reduced. `w⁷ L`. *)
Definition L_reduced (c : patch A) : A :=
  det [D_u c; D_v c; D_uu c].

(** reduced. `w⁷ M`. *)
Definition M_reduced (c : patch A) : A :=
  det [D_u c; D_v c; D_uv c].

(** reduced. `w⁷ N`. *)
Definition N_reduced (c : patch A) : A :=
  det [D_u c; D_v c; D_vv c].

(** planar maps. `[S_u S_v]`, by which areas are multiplied: a map of the plane has an inverse near where it is not zero. *)
Definition jacobian (c : patch A) : A :=
  det [vder s (S_of c); vder s_bar (S_of c)].

(** planar maps. `w³ [S_u S_v]`, the determinant of `P = (w, p)`. *)
Definition jacobian_lifted (c : patch A) : A :=
  det [([w c] ++ p c); vder s (([w c] ++ p c)); vder s_bar (([w c] ++ p c))].

(** normal. `‖S_u × S_v‖²`. *)
Definition normal_squared (c : patch A) : A :=
  dot (normal c) (normal c).

(** first fundamental form. `EG − F²`, the square of the element of area. *)
Definition area_squared (c : patch A) : A :=
  E_ c * G c - F c ^ 2.

(** Gaussian curvature. `LN − M²`: positive at elliptic points, negative at hyperbolic ones, zero on the parabolic curve. *)
Definition parabolic (c : patch A) : A :=
  L c * N_ c - M c ^ 2.

(** Gaussian curvature. `(LN − M²)/(EG − F²)²`. *)
Definition gaussian_curvature (c : patch A) : A :=
  parabolic c / area_squared c ^ 2.

(** mean curvature. `EN − 2FM + GL`: zero on minimal surfaces. *)
Definition minimality (c : patch A) : A :=
  E_ c * N_ c - number 2 * F c * M c + G c * L c.

(** mean curvature. `(EN − 2FM + GL)²/(4 (EG − F²)³)`. *)
Definition mean_curvature_squared (c : patch A) : A :=
  minimality c ^ 2 / (number 4 * area_squared c ^ 3).

(** principal curvatures. `(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)`: never negative, zero at the umbilics. *)
Definition umbilicity (c : patch A) : A :=
  (E_ c * N_ c - number 2 * F c * M c + G c * L c) ^ 2 - number 4 * (E_ c * G c - F c ^ 2) * (L c * N_ c - M c ^ 2).

(** reduced. `w⁸ (EG − F²)`. *)
Definition area_squared_reduced (c : patch A) : A :=
  E_reduced c * G_reduced c - F_reduced c ^ 2.

(** reduced. `w¹⁴ (LN − M²)`. *)
Definition parabolic_reduced (c : patch A) : A :=
  L_reduced c * N_reduced c - M_reduced c ^ 2.

(** reduced. `w¹¹ (EN − 2FM + GL)`. *)
Definition minimality_reduced (c : patch A) : A :=
  E_reduced c * N_reduced c - number 2 * F_reduced c * M_reduced c + G_reduced c * L_reduced c.

(** reduced. `w² · w¹⁴ (LN − M²)/(w⁸ (EG − F²))²`. *)
Definition gaussian_curvature_reduced (c : patch A) : A :=
  parabolic_reduced c * w c ^ 2 / area_squared_reduced c ^ 2.

(** reduced. `w² (w¹¹ (EN − 2FM + GL))²/(4 (w⁸ (EG − F²))³)`. *)
Definition mean_curvature_squared_reduced (c : patch A) : A :=
  minimality_reduced c ^ 2 * w c ^ 2 / (number 4 * area_squared_reduced c ^ 3).

(** F. Brioschi 1852, after C. F. Gauss, Disquisitiones generales circa superficies curvas, 11. `K (EG − F²)²` from E, F, G and their derivatives alone. *)
Definition brioschi (c : patch A) : A :=
  det [([der s_bar (der s (F c)) - der s_bar (der s_bar (E_ c)) / number 2 - der s (der s (G c)) / number 2] ++ [der s (E_ c) / number 2] ++ [der s (F c) - der s_bar (E_ c) / number 2]); ([der s_bar (F c) - der s (G c) / number 2] ++ [E_ c] ++ [F c]); ([der s_bar (G c) / number 2] ++ [F c] ++ [G c])] - det [([number 0] ++ [der s_bar (E_ c) / number 2] ++ [der s (G c) / number 2]); ([der s_bar (E_ c) / number 2] ++ [E_ c] ++ [F c]); ([der s (G c) / number 2] ++ [F c] ++ [G c])].

(** principal curvatures. What of κ_u is free of the root: `a Δ_u − 3 Δ a_u` with `a = EG − F²` and `Δ` zero at the umbilics. *)
Definition stationary_curvature (c : patch A) : A :=
  (E_ c * G c - F c ^ 2) * der s ((E_ c * N_ c - number 2 * F c * M c + G c * L c) ^ 2 - number 4 * (E_ c * G c - F c ^ 2) * (L c * N_ c - M c ^ 2)) - number 3 * ((E_ c * N_ c - number 2 * F c * M c + G c * L c) ^ 2 - number 4 * (E_ c * G c - F c ^ 2) * (L c * N_ c - M c ^ 2)) * der s (E_ c * G c - F c ^ 2).

(** principal curvatures. `2a h_u − 3h a_u` with `h = EN − 2FM + GL`: zero where H_u is. *)
Definition stationary_mean_curvature (c : patch A) : A :=
  number 2 * (E_ c * G c - F c ^ 2) * der s (E_ c * N_ c - number 2 * F c * M c + G c * L c) - number 3 * (E_ c * N_ c - number 2 * F c * M c + G c * L c) * der s (E_ c * G c - F c ^ 2).

(** ridges. The cubic form of the ridges, in the coefficients of both fundamental forms. *)
Definition ridge_cubic_of_surface (c : patch A) : list A :=
  ([(E_ c * G c - F c ^ 2) * der s (L c) - der s (E_ c * G c - F c ^ 2) * L c / number 2 - der s (E_ c) * (G c * L c - F c * M c) - der s (F c) * (E_ c * M c - F c * L c)] ++ [number 2 * (E_ c * G c - F c ^ 2) * der s (M c) - der s (E_ c * G c - F c ^ 2) * M c - der s (E_ c) * (G c * M c - F c * N_ c) - der s (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s (G c) * (E_ c * M c - F c * L c) + ((E_ c * G c - F c ^ 2) * der s_bar (L c) - der s_bar (E_ c * G c - F c ^ 2) * L c / number 2 - der s_bar (E_ c) * (G c * L c - F c * M c) - der s_bar (F c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s (N_ c) - der s (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s (F c) * (G c * M c - F c * N_ c) - der s (G c) * (E_ c * N_ c - F c * M c) + (number 2 * (E_ c * G c - F c ^ 2) * der s_bar (M c) - der s_bar (E_ c * G c - F c ^ 2) * M c - der s_bar (E_ c) * (G c * M c - F c * N_ c) - der s_bar (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s_bar (G c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s_bar (N_ c) - der s_bar (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s_bar (F c) * (G c * M c - F c * N_ c) - der s_bar (G c) * (E_ c * N_ c - F c * M c)]).

(** ridges. Zero where a principal curvature is extremal along its own line of curvature. *)
Definition ridges (c : patch A) : A :=
  det [([E_ c * M c - F c * L c] ++ [E_ c * N_ c - G c * L c] ++ [F c * N_ c - G c * M c] ++ [number 0] ++ [number 0]); ([number 0] ++ [E_ c * M c - F c * L c] ++ [E_ c * N_ c - G c * L c] ++ [F c * N_ c - G c * M c] ++ [number 0]); ([number 0] ++ [number 0] ++ [E_ c * M c - F c * L c] ++ [E_ c * N_ c - G c * L c] ++ [F c * N_ c - G c * M c]); (([(E_ c * G c - F c ^ 2) * der s (L c) - der s (E_ c * G c - F c ^ 2) * L c / number 2 - der s (E_ c) * (G c * L c - F c * M c) - der s (F c) * (E_ c * M c - F c * L c)] ++ [number 2 * (E_ c * G c - F c ^ 2) * der s (M c) - der s (E_ c * G c - F c ^ 2) * M c - der s (E_ c) * (G c * M c - F c * N_ c) - der s (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s (G c) * (E_ c * M c - F c * L c) + ((E_ c * G c - F c ^ 2) * der s_bar (L c) - der s_bar (E_ c * G c - F c ^ 2) * L c / number 2 - der s_bar (E_ c) * (G c * L c - F c * M c) - der s_bar (F c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s (N_ c) - der s (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s (F c) * (G c * M c - F c * N_ c) - der s (G c) * (E_ c * N_ c - F c * M c) + (number 2 * (E_ c * G c - F c ^ 2) * der s_bar (M c) - der s_bar (E_ c * G c - F c ^ 2) * M c - der s_bar (E_ c) * (G c * M c - F c * N_ c) - der s_bar (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s_bar (G c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s_bar (N_ c) - der s_bar (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s_bar (F c) * (G c * M c - F c * N_ c) - der s_bar (G c) * (E_ c * N_ c - F c * M c)]) ++ [number 0]); ([number 0] ++ ([(E_ c * G c - F c ^ 2) * der s (L c) - der s (E_ c * G c - F c ^ 2) * L c / number 2 - der s (E_ c) * (G c * L c - F c * M c) - der s (F c) * (E_ c * M c - F c * L c)] ++ [number 2 * (E_ c * G c - F c ^ 2) * der s (M c) - der s (E_ c * G c - F c ^ 2) * M c - der s (E_ c) * (G c * M c - F c * N_ c) - der s (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s (G c) * (E_ c * M c - F c * L c) + ((E_ c * G c - F c ^ 2) * der s_bar (L c) - der s_bar (E_ c * G c - F c ^ 2) * L c / number 2 - der s_bar (E_ c) * (G c * L c - F c * M c) - der s_bar (F c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s (N_ c) - der s (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s (F c) * (G c * M c - F c * N_ c) - der s (G c) * (E_ c * N_ c - F c * M c) + (number 2 * (E_ c * G c - F c ^ 2) * der s_bar (M c) - der s_bar (E_ c * G c - F c ^ 2) * M c - der s_bar (E_ c) * (G c * M c - F c * N_ c) - der s_bar (F c) * (G c * L c - F c * M c + (E_ c * N_ c - F c * M c)) - der s_bar (G c) * (E_ c * M c - F c * L c))] ++ [(E_ c * G c - F c ^ 2) * der s_bar (N_ c) - der s_bar (E_ c * G c - F c ^ 2) * N_ c / number 2 - der s_bar (F c) * (G c * M c - F c * N_ c) - der s_bar (G c) * (E_ c * N_ c - F c * M c)]))].

(** normals. `[n n_u n_v]`: how the Gauss map multiplies areas, up to powers of `EG − F²`. *)
Definition gauss_map_area (c : patch A) : A :=
  det [normal c; vder s (normal c); vder s_bar (normal c)].

(** normals. `[n n_u S_v] + [n S_u n_v]`, the coefficient of t in `[n (S + tn)_u (S + tn)_v]`. *)
Definition focal_linear_coefficient (c : patch A) : A :=
  det [normal c; vder s (normal c); S_v c] + det [normal c; S_u c; vder s_bar (normal c)].

(** normals. `[n S_u S_v]`. *)
Definition focal_constant_coefficient (c : patch A) : A :=
  det [normal c; S_u c; S_v c].

(** lines of curvature. `EM − FL`, the coefficient of du². *)
Definition line_coefficient_uu (c : patch A) : A :=
  E_ c * M c - F c * L c.

(** lines of curvature. `EN − GL`, the coefficient of du dv. *)
Definition line_coefficient_uv (c : patch A) : A :=
  E_ c * N_ c - G c * L c.

(** lines of curvature. `FN − GM`, the coefficient of dv². *)
Definition line_coefficient_vv (c : patch A) : A :=
  F c * N_ c - G c * M c.

(** O. Rodrigues 1816. `[n n_u S_u]`: zero where the normal turns towards the line along which it is carried. *)
Definition turning_uu (c : patch A) : A :=
  det [normal c; vder s (normal c); S_u c].

(** O. Rodrigues 1816. `[n n_u S_v] + [n n_v S_u]`. *)
Definition turning_uv (c : patch A) : A :=
  det [normal c; vder s (normal c); S_v c] + det [normal c; vder s_bar (normal c); S_u c].

(** O. Rodrigues 1816. `[n n_v S_v]`. *)
Definition turning_vv (c : patch A) : A :=
  det [normal c; vder s_bar (normal c); S_v c].

(** reduced. `w¹¹ (EM − FL)`. *)
Definition line_coefficient_uu_reduced (c : patch A) : A :=
  E_reduced c * M_reduced c - F_reduced c * L_reduced c.

(** reduced. `w¹¹ (EN − GL)`. *)
Definition line_coefficient_uv_reduced (c : patch A) : A :=
  E_reduced c * N_reduced c - G_reduced c * L_reduced c.

(** reduced. `w¹¹ (FN − GM)`. *)
Definition line_coefficient_vv_reduced (c : patch A) : A :=
  F_reduced c * N_reduced c - G_reduced c * M_reduced c.

(** projective lift. `(w, p)`; w first, so that determinants have the sign of those of the surface. *)
Definition projective_lift_of_surface (c : patch A) : list A :=
  ([w c] ++ p c).

(** conformal lift. `(‖p‖², w p, w²)`. *)
Definition conformal_lift_of_surface (c : patch A) : list A :=
  ([dot (p c) (p c)] ++ vmul (w c) (p c) ++ [w c ^ 2]).

(** lifted. The plane through P, P_u, P_v: its first coordinate, then its normal, `w³ n`. *)
Definition tangent_plane (c : patch A) : list A :=
  generalized_cross [projective_lift_of_surface c; vder s (projective_lift_of_surface c); vder s_bar (projective_lift_of_surface c)].

(** lifted. The normal of the tangent plane. *)
Definition normal_lifted_of_surface (c : patch A) : list A :=
  components 1 4 (tangent_plane c).

(** lifted. `w⁴ L`. *)
Definition L_lifted (c : patch A) : A :=
  det [projective_lift_of_surface c; vder s (projective_lift_of_surface c); vder s_bar (projective_lift_of_surface c); vders s 2 (projective_lift_of_surface c)].

(** lifted. `w⁴ M`. *)
Definition M_lifted (c : patch A) : A :=
  det [projective_lift_of_surface c; vder s (projective_lift_of_surface c); vder s_bar (projective_lift_of_surface c); vder s_bar (vder s (projective_lift_of_surface c))].

(** lifted. `w⁴ N`. *)
Definition N_lifted (c : patch A) : A :=
  det [projective_lift_of_surface c; vder s (projective_lift_of_surface c); vder s_bar (projective_lift_of_surface c); vders s_bar 2 (projective_lift_of_surface c)].

(** lifted. `w⁸ (LN − M²)`, with the determinants of P. *)
Definition parabolic_lifted (c : patch A) : A :=
  L_lifted c * N_lifted c - M_lifted c ^ 2.

(** lifted. `w⁶ (EG − F²)`, the squared length of the normal of the tangent plane. *)
Definition area_squared_lifted (c : patch A) : A :=
  dot (normal_lifted_of_surface c) (normal_lifted_of_surface c).

(** lifted. Gaussian curvature from the determinants of P: `w⁴ ([…uu][…vv] − […uv]²)/‖Π_n‖⁴`. *)
Definition gaussian_curvature_lifted (c : patch A) : A :=
  parabolic_lifted c * w c ^ 4 / area_squared_lifted c ^ 2.

(** lifted. `w⁸ (EN − 2FM + GL)`. *)
Definition minimality_lifted (c : patch A) : A :=
  E_reduced c * N_lifted c - number 2 * F_reduced c * M_lifted c + G_reduced c * L_lifted c.

(** lifted. `2 w¹⁰ (EM − FL)`: zero where one sphere has contact of second order along both. *)
Definition line_coefficient_uu_lifted (c : patch A) : A :=
  det [conformal_lift_of_surface c; vder s (conformal_lift_of_surface c); vder s_bar (conformal_lift_of_surface c); vders s 2 (conformal_lift_of_surface c); vder s_bar (vder s (conformal_lift_of_surface c))].

(** lifted. `2 w¹⁰ (EN − GL)`. *)
Definition line_coefficient_uv_lifted (c : patch A) : A :=
  det [conformal_lift_of_surface c; vder s (conformal_lift_of_surface c); vder s_bar (conformal_lift_of_surface c); vders s 2 (conformal_lift_of_surface c); vders s_bar 2 (conformal_lift_of_surface c)].

(** lifted. `2 w¹⁰ (FN − GM)`. *)
Definition line_coefficient_vv_lifted (c : patch A) : A :=
  det [conformal_lift_of_surface c; vder s (conformal_lift_of_surface c); vder s_bar (conformal_lift_of_surface c); vder s_bar (vder s (conformal_lift_of_surface c)); vders s_bar 2 (conformal_lift_of_surface c)].

(** lifted. `w⁸ (EM − FL)`, with determinants of P: of lower degree than that of X. *)
Definition line_coefficient_uu_projective (c : patch A) : A :=
  E_reduced c * M_lifted c - F_reduced c * L_lifted c.

(** lifted. `w⁸ (EN − GL)`. *)
Definition line_coefficient_uv_projective (c : patch A) : A :=
  E_reduced c * N_lifted c - G_reduced c * L_lifted c.

(** lifted. `w⁸ (FN − GM)`. *)
Definition line_coefficient_vv_projective (c : patch A) : A :=
  F_reduced c * N_lifted c - G_reduced c * M_lifted c.

(** lifted. Squared mean curvature from the determinants of P: `w² (eN − 2fM + gL)²/(4 ‖Π_n‖⁶)`. *)
Definition mean_curvature_squared_lifted (c : patch A) : A :=
  minimality_lifted c ^ 2 * w c ^ 2 / (number 4 * area_squared_lifted c ^ 3).

(** lifted. `[I X X_u X_v Y]` with the point at infinity `I = (1, 0, 0, 0, 0)` and `Y = e X_vv − 2 f X_uv + g X_uu`. *)
Definition minimality_of_spheres (c : patch A) : A :=
  det [components 1 5 (conformal_lift_of_surface c); vder s (components 1 5 (conformal_lift_of_surface c)); vder s_bar (components 1 5 (conformal_lift_of_surface c)); vadd (vsub (vmul (E_reduced c) (vders s_bar 2 (components 1 5 (conformal_lift_of_surface c)))) (vmul (number 2 * F_reduced c) (vder s_bar (vder s (components 1 5 (conformal_lift_of_surface c)))))) (vmul (G_reduced c) (vders s 2 (components 1 5 (conformal_lift_of_surface c))))].

(** lifted. The discriminant of `w² k σ² − h σ + ‖Π_n‖² = 0`, for `k = w⁸ (LN − M²)` and `h = w⁸ (EN − 2FM + GL)`: its roots are the centres of curvature `(p + σ Π_n)/w`. *)
Definition focal_discriminant_lifted (c : patch A) : A :=
  minimality_lifted c ^ 2 - number 4 * w c ^ 2 * area_squared_lifted c * parabolic_lifted c.

(** lifted. `w¹²` times the cubic form of the ridges: that of `w⁴ I` and `w⁴ II`, corrected by `4 w ‖Π_n‖² dw II`. *)
Definition ridge_cubic_lifted (c : patch A) : list A :=
  vadd (([(E_reduced c * G_reduced c - F_reduced c ^ 2) * der s (L_lifted c) - der s (E_reduced c * G_reduced c - F_reduced c ^ 2) * L_lifted c / number 2 - der s (E_reduced c) * (G_reduced c * L_lifted c - F_reduced c * M_lifted c) - der s (F_reduced c) * (E_reduced c * M_lifted c - F_reduced c * L_lifted c)] ++ [number 2 * (E_reduced c * G_reduced c - F_reduced c ^ 2) * der s (M_lifted c) - der s (E_reduced c * G_reduced c - F_reduced c ^ 2) * M_lifted c - der s (E_reduced c) * (G_reduced c * M_lifted c - F_reduced c * N_lifted c) - der s (F_reduced c) * (G_reduced c * L_lifted c - F_reduced c * M_lifted c + (E_reduced c * N_lifted c - F_reduced c * M_lifted c)) - der s (G_reduced c) * (E_reduced c * M_lifted c - F_reduced c * L_lifted c) + ((E_reduced c * G_reduced c - F_reduced c ^ 2) * der s_bar (L_lifted c) - der s_bar (E_reduced c * G_reduced c - F_reduced c ^ 2) * L_lifted c / number 2 - der s_bar (E_reduced c) * (G_reduced c * L_lifted c - F_reduced c * M_lifted c) - der s_bar (F_reduced c) * (E_reduced c * M_lifted c - F_reduced c * L_lifted c))] ++ [(E_reduced c * G_reduced c - F_reduced c ^ 2) * der s (N_lifted c) - der s (E_reduced c * G_reduced c - F_reduced c ^ 2) * N_lifted c / number 2 - der s (F_reduced c) * (G_reduced c * M_lifted c - F_reduced c * N_lifted c) - der s (G_reduced c) * (E_reduced c * N_lifted c - F_reduced c * M_lifted c) + (number 2 * (E_reduced c * G_reduced c - F_reduced c ^ 2) * der s_bar (M_lifted c) - der s_bar (E_reduced c * G_reduced c - F_reduced c ^ 2) * M_lifted c - der s_bar (E_reduced c) * (G_reduced c * M_lifted c - F_reduced c * N_lifted c) - der s_bar (F_reduced c) * (G_reduced c * L_lifted c - F_reduced c * M_lifted c + (E_reduced c * N_lifted c - F_reduced c * M_lifted c)) - der s_bar (G_reduced c) * (E_reduced c * M_lifted c - F_reduced c * L_lifted c))] ++ [(E_reduced c * G_reduced c - F_reduced c ^ 2) * der s_bar (N_lifted c) - der s_bar (E_reduced c * G_reduced c - F_reduced c ^ 2) * N_lifted c / number 2 - der s_bar (F_reduced c) * (G_reduced c * M_lifted c - F_reduced c * N_lifted c) - der s_bar (G_reduced c) * (E_reduced c * N_lifted c - F_reduced c * M_lifted c)])) (vmul (number 4 * w c * area_squared_lifted c) (([der s (w c) * L_lifted c] ++ [number 2 * der s (w c) * M_lifted c + der s_bar (w c) * L_lifted c] ++ [der s (w c) * N_lifted c + number 2 * der s_bar (w c) * M_lifted c] ++ [der s_bar (w c) * N_lifted c]))).

(** lifted. `w⁴⁸` times the polynomial of the ridges. *)
Definition ridges_lifted (c : patch A) : A :=
  det [([E_reduced c * M_lifted c - F_reduced c * L_lifted c] ++ [E_reduced c * N_lifted c - G_reduced c * L_lifted c] ++ [F_reduced c * N_lifted c - G_reduced c * M_lifted c] ++ [number 0] ++ [number 0]); ([number 0] ++ [E_reduced c * M_lifted c - F_reduced c * L_lifted c] ++ [E_reduced c * N_lifted c - G_reduced c * L_lifted c] ++ [F_reduced c * N_lifted c - G_reduced c * M_lifted c] ++ [number 0]); ([number 0] ++ [number 0] ++ [E_reduced c * M_lifted c - F_reduced c * L_lifted c] ++ [E_reduced c * N_lifted c - G_reduced c * L_lifted c] ++ [F_reduced c * N_lifted c - G_reduced c * M_lifted c]); (ridge_cubic_lifted c ++ [number 0]); ([number 0] ++ ridge_cubic_lifted c)].

(** lifted. `EG − F²` of `w⁴ I`. *)
Definition area_of_lifted_forms (c : patch A) : A :=
  E_reduced c * G_reduced c - F_reduced c ^ 2.

(** first fundamental form. `E u′² + 2F u′v′ + G v′²`. *)
Definition first_form (c : path A) : A :=
  E_ c * der (along c) (u_of c) ^ 2 + number 2 * F c * der (along c) (u_of c) * der (along c) (v_of c) + G c * der (along c) (v_of c) ^ 2.

(** second fundamental form. `L u′² + 2M u′v′ + N v′²`. *)
Definition second_form (c : path A) : A :=
  L c * der (along c) (u_of c) ^ 2 + number 2 * M c * der (along c) (u_of c) * der (along c) (v_of c) + N_ c * der (along c) (v_of c) ^ 2.

(** J. B. Meusnier 1776. `γ″ · n`. *)
Definition acceleration_on_normal (c : path A) : A :=
  dot (vders (along c) 2 (gamma c)) (normal c).

(** normal curvature. `II²/(I² (EG − F²))`, the same for all curves of one direction. *)
Definition normal_curvature_squared (c : path A) : A :=
  second_form c ^ 2 / (first_form c ^ 2 * area_squared c).

(** geodesic curvature. `[γ′ γ″ n]`: zero where the curve is straight on the surface. *)
Definition geodesic_determinant (c : path A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c); normal c].

(** geodesic curvature. `(γ′·S_u)(γ″·S_v) − (γ′·S_v)(γ″·S_u)`, each product from E, F, G and their derivatives. *)
Definition geodesic_determinant_of_first_form (c : path A) : A :=
  (E_ c * der (along c) (u_of c) + F c * der (along c) (v_of c)) * (F c * ders (along c) 2 (u_of c) + G c * ders (along c) 2 (v_of c) + ((der s (F c) - der s_bar (E_ c) / number 2) * der (along c) (u_of c) ^ 2 + der s (G c) * der (along c) (u_of c) * der (along c) (v_of c) + der s_bar (G c) / number 2 * der (along c) (v_of c) ^ 2)) - (F c * der (along c) (u_of c) + G c * der (along c) (v_of c)) * (E_ c * ders (along c) 2 (u_of c) + F c * ders (along c) 2 (v_of c) + (der s (E_ c) / number 2 * der (along c) (u_of c) ^ 2 + der s_bar (E_ c) * der (along c) (u_of c) * der (along c) (v_of c) + (der s_bar (F c) - der s (G c) / number 2) * der (along c) (v_of c) ^ 2)).

(** geodesic curvature. `[γ′ γ″ n]²/(I³ (EG − F²))`. *)
Definition geodesic_curvature_squared (c : path A) : A :=
  geodesic_determinant c ^ 2 / (first_form c ^ 3 * area_squared c).

(** curvature. `κ_n² + κ_g²`. *)
Definition curvature_from_surface (c : path A) : A :=
  normal_curvature_squared c + geodesic_curvature_squared c.

(** lines of curvature. `A u′² + B u′v′ + C v′²`. *)
Definition line_form (c : path A) : A :=
  line_coefficient_uu c * der (along c) (u_of c) ^ 2 + line_coefficient_uv c * der (along c) (u_of c) * der (along c) (v_of c) + line_coefficient_vv c * der (along c) (v_of c) ^ 2.

(** O. Rodrigues 1816. `[n n′ γ′]`: zero where the normals along the curve form a developable surface. *)
Definition turning_of_normal (c : path A) : A :=
  det [normal c; vder (along c) (normal c); vder (along c) (gamma c)].

(** lifted. The osculating plane of the curve against the tangent plane of the surface. *)
Definition second_form_lifted (c : path A) : A :=
  det [projective_lift_of_surface c; vder s (projective_lift_of_surface c); vder s_bar (projective_lift_of_surface c); vders (along c) 2 (projective_lift_of_surface c)].

(** asymptotic lines. `M² − LN`: two asymptotic directions where it is positive, one where it is zero, none where it is negative. *)
Definition asymptotic_discriminant (c : accompanied A) : A :=
  M_of c ^ 2 - L_of c * N_of c.

(** asymptotic lines. `II(t, t)` for the direction `t = (√δ − M, L)`: its two parts, without √δ and with it. *)
Definition second_form_of_asymptotic (c : accompanied A) : list A :=
  ([(L_of c * (number 0 + M_of c * number (-1)) + number 0 * (number 1 + number 0 * number (-1)) * asymptotic_discriminant c) * (number 0 + M_of c * number (-1)) + (L_of c * (number 1 + number 0 * number (-1)) + number 0 * (number 0 + M_of c * number (-1))) * (number 1 + number 0 * number (-1)) * asymptotic_discriminant c + (((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * (number 0 + M_of c * number (-1)) + (M_of c * number 0 + number 0 * number 2) * (number 1 + number 0 * number (-1)) * asymptotic_discriminant c) * L_of c + ((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * (number 1 + number 0 * number (-1)) + (M_of c * number 0 + number 0 * number 2) * (number 0 + M_of c * number (-1))) * number 0 * asymptotic_discriminant c) + ((N_of c * L_of c + number 0 * number 0 * asymptotic_discriminant c) * L_of c + (N_of c * number 0 + number 0 * L_of c) * number 0 * asymptotic_discriminant c)] ++ [(L_of c * (number 0 + M_of c * number (-1)) + number 0 * (number 1 + number 0 * number (-1)) * asymptotic_discriminant c) * (number 1 + number 0 * number (-1)) + (L_of c * (number 1 + number 0 * number (-1)) + number 0 * (number 0 + M_of c * number (-1))) * (number 0 + M_of c * number (-1)) + (((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * (number 0 + M_of c * number (-1)) + (M_of c * number 0 + number 0 * number 2) * (number 1 + number 0 * number (-1)) * asymptotic_discriminant c) * number 0 + ((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * (number 1 + number 0 * number (-1)) + (M_of c * number 0 + number 0 * number 2) * (number 0 + M_of c * number (-1))) * L_of c) + ((N_of c * L_of c + number 0 * number 0 * asymptotic_discriminant c) * number 0 + (N_of c * number 0 + number 0 * L_of c) * L_of c)]).

(** asymptotic lines. `II(t, t)` for `t = (N, −M − √δ)`, in the same way. *)
Definition second_form_of_other_asymptotic (c : accompanied A) : list A :=
  ([(L_of c * N_of c + number 0 * number 0 * asymptotic_discriminant c) * N_of c + (L_of c * number 0 + number 0 * N_of c) * number 0 * asymptotic_discriminant c + (((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * N_of c + (M_of c * number 0 + number 0 * number 2) * number 0 * asymptotic_discriminant c) * (M_of c * number (-1) + number 0 * number (-1)) + ((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * number 0 + (M_of c * number 0 + number 0 * number 2) * N_of c) * (number 0 * number (-1) + number 1 * number (-1)) * asymptotic_discriminant c) + ((N_of c * (M_of c * number (-1) + number 0 * number (-1)) + number 0 * (number 0 * number (-1) + number 1 * number (-1)) * asymptotic_discriminant c) * (M_of c * number (-1) + number 0 * number (-1)) + (N_of c * (number 0 * number (-1) + number 1 * number (-1)) + number 0 * (M_of c * number (-1) + number 0 * number (-1))) * (number 0 * number (-1) + number 1 * number (-1)) * asymptotic_discriminant c)] ++ [(L_of c * N_of c + number 0 * number 0 * asymptotic_discriminant c) * number 0 + (L_of c * number 0 + number 0 * N_of c) * N_of c + (((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * N_of c + (M_of c * number 0 + number 0 * number 2) * number 0 * asymptotic_discriminant c) * (number 0 * number (-1) + number 1 * number (-1)) + ((M_of c * number 2 + number 0 * number 0 * asymptotic_discriminant c) * number 0 + (M_of c * number 0 + number 0 * number 2) * N_of c) * (M_of c * number (-1) + number 0 * number (-1))) + ((N_of c * (M_of c * number (-1) + number 0 * number (-1)) + number 0 * (number 0 * number (-1) + number 1 * number (-1)) * asymptotic_discriminant c) * (number 0 * number (-1) + number 1 * number (-1)) + (N_of c * (number 0 * number (-1) + number 1 * number (-1)) + number 0 * (M_of c * number (-1) + number 0 * number (-1))) * (M_of c * number (-1) + number 0 * number (-1)))]).

(** asymptotic lines. The determinant of `(√δ − M, L)` and `(N, −M − √δ)`: both are one direction where it vanishes. *)
Definition asymptotic_charts (c : accompanied A) : list A :=
  ([(number 0 + M_of c * number (-1)) * (M_of c * number (-1) + number 0 * number (-1)) + (number 1 + number 0 * number (-1)) * (number 0 * number (-1) + number 1 * number (-1)) * asymptotic_discriminant c + (L_of c * N_of c + number 0 * number 0 * asymptotic_discriminant c) * number (-1)] ++ [(number 0 + M_of c * number (-1)) * (number 0 * number (-1) + number 1 * number (-1)) + (number 1 + number 0 * number (-1)) * (M_of c * number (-1) + number 0 * number (-1)) + (L_of c * number 0 + number 0 * N_of c) * number (-1)]).

(** asymptotic lines. The squared determinant of `(√δ − M, L)` and `(−√δ − M, L)`: zero where both are one. *)
Definition asymptotic_pair_squared (c : accompanied A) : A :=
  ((number 0 + M_of c * number (-1)) * L_of c + (number 1 + number 0 * number (-1)) * number 0 * asymptotic_discriminant c + (L_of c * (number 0 * number (-1) + M_of c * number (-1)) + number 0 * (number 1 * number (-1) + number 0 * number (-1)) * asymptotic_discriminant c) * number (-1)) * ((number 0 + M_of c * number (-1)) * L_of c + (number 1 + number 0 * number (-1)) * number 0 * asymptotic_discriminant c + (L_of c * (number 0 * number (-1) + M_of c * number (-1)) + number 0 * (number 1 * number (-1) + number 0 * number (-1)) * asymptotic_discriminant c) * number (-1)) + ((number 0 + M_of c * number (-1)) * number 0 + (number 1 + number 0 * number (-1)) * L_of c + (L_of c * (number 1 * number (-1) + number 0 * number (-1)) + number 0 * (number 0 * number (-1) + M_of c * number (-1))) * number (-1)) * ((number 0 + M_of c * number (-1)) * number 0 + (number 1 + number 0 * number (-1)) * L_of c + (L_of c * (number 1 * number (-1) + number 0 * number (-1)) + number 0 * (number 0 * number (-1) + M_of c * number (-1))) * number (-1)) * asymptotic_discriminant c.

(** asymptotic lines. `−4 L² (LN − M²)`. *)
Definition asymptotic_pair_by_parabolic (c : accompanied A) : A :=
  number (-4) * L_of c ^ 2 * (L_of c * N_of c - M_of c ^ 2).

(** asymptotic lines. `L II`. *)
Definition second_form_times_L (c : path A) : A :=
  L c * second_form c.

(** asymptotic lines. `(L u′ + M v′)² + (LN − M²) v′²`: zero for real directions only where `LN ≤ M²`. *)
Definition second_form_as_squares (c : path A) : A :=
  (L c * der (along c) (u_of c) + M c * der (along c) (v_of c)) ^ 2 + (L c * N_ c - M c ^ 2) * der (along c) (v_of c) ^ 2.

(** asymptotic lines. `S_v · (S_uu × S_u)`: zero where the u-line is straight. *)
Definition bending_of_u_line (c : patch A) : A :=
  dot (S_v c) (cross (S_uu c) (S_u c)).

(** asymptotic lines. `S_u · (S_v × S_vv)`: zero where the v-line is straight, as rulings are. *)
Definition bending_of_v_line (c : patch A) : A :=
  dot (S_u c) (cross (S_v c) (S_vv c)).

(** asymptotic lines. `(γ′ × γ″) · (n × γ′)`: zero where the curve is straight. *)
Definition bending_off_surface (c : path A) : A :=
  dot (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (cross (normal c) (vder (along c) (gamma c))).

(** asymptotic lines. `−‖γ′‖² II`. *)
Definition second_form_times_speed (c : path A) : A :=
  - dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) * second_form c.

(** lifted. `w⁴` times the first fundamental form along the curve. *)
Definition first_form_lifted (c : path A) : A :=
  E_reduced c * der (along c) (u_of c) * der (along c) (u_of c) + number 2 * F_reduced c * der (along c) (u_of c) * der (along c) (v_of c) + G_reduced c * der (along c) (v_of c) * der (along c) (v_of c).

(** lifted. `w⁴` times the second one, with the determinants of P. *)
Definition second_form_of_lifted (c : path A) : A :=
  L_lifted c * der (along c) (u_of c) * der (along c) (u_of c) + number 2 * M_lifted c * der (along c) (u_of c) * der (along c) (v_of c) + N_lifted c * der (along c) (v_of c) * der (along c) (v_of c).

(** lifted. `w⁶ [P P_u P_v P″]²/((w⁴ I)² ‖Π_n‖²)`. *)
Definition normal_curvature_squared_lifted (c : path A) : A :=
  w c ^ 6 * second_form_lifted c ^ 2 / (first_form_lifted c ^ 2 * area_squared_lifted c).

(** Gaussian curvature. `(LN − M²)/(EG − F²)²`. *)
Definition gaussian_of_forms (c : accompanied A) : A :=
  parabolic_of_forms c / area_of_forms c ^ 2.

(** Gaussian curvature. Its derivative by u. *)
Definition gaussian_of_forms_by_u (c : accompanied A) : A :=
  der s (gaussian_of_forms c).

(** Gaussian curvature. Its derivative by v. *)
Definition gaussian_of_forms_by_v (c : accompanied A) : A :=
  der s_bar (gaussian_of_forms c).

(** constant curvature. `a k_u − 2 k a_u` with `a = EG − F²` and `k = LN − M²`: zero where K_u is. *)
Definition change_of_forms_by_u (c : accompanied A) : A :=
  area_of_forms c * der s (parabolic_of_forms c) - number 2 * parabolic_of_forms c * der s (area_of_forms c).

(** constant curvature. The same for `K_v`. *)
Definition change_of_forms_by_v (c : accompanied A) : A :=
  area_of_forms c * der s_bar (parabolic_of_forms c) - number 2 * parabolic_of_forms c * der s_bar (area_of_forms c).

(** constant curvature. The derivative by u of `w⁴ (LN − M²)/(EG − F²)²`, where the coefficients are those of both lifted forms. *)
Definition gaussian_weighted_by_u (c : accompanied A) : A :=
  der s (gaussian_of_forms c * w c ^ 4).

(** constant curvature. The derivative by v. *)
Definition gaussian_weighted_by_v (c : accompanied A) : A :=
  der s_bar (gaussian_of_forms c * w c ^ 4).

(** constant curvature. `w (a k_u − 2 k a_u) + 4 w_u k a`. *)
Definition change_weighted_by_u (c : accompanied A) : A :=
  w c * (area_of_forms c * der s (parabolic_of_forms c) - number 2 * parabolic_of_forms c * der s (area_of_forms c)) + number 4 * der s (w c) * parabolic_of_forms c * area_of_forms c.

(** constant curvature. `w (a k_v − 2 k a_v) + 4 w_v k a`. *)
Definition change_weighted_by_v (c : accompanied A) : A :=
  w c * (area_of_forms c * der s_bar (parabolic_of_forms c) - number 2 * parabolic_of_forms c * der s_bar (area_of_forms c)) + number 4 * der s_bar (w c) * parabolic_of_forms c * area_of_forms c.

(** constant curvature. `‖Π_n‖⁶/w³` times `K_u`: with `k = w⁸ (LN − M²)` and `a = ‖Π_n‖²` it is `w (a k_u − 2 k a_u) + 4 w_u k a`. *)
Definition gaussian_change_by_u_lifted (c : patch A) : A :=
  w c * (area_squared_lifted c * der s (parabolic_lifted c) - number 2 * parabolic_lifted c * der s (area_squared_lifted c)) + number 4 * der s (w c) * parabolic_lifted c * area_squared_lifted c.

(** constant curvature. `‖Π_n‖⁶/w³` times `K_v`. *)
Definition gaussian_change_by_v_lifted (c : patch A) : A :=
  w c * (area_squared_lifted c * der s_bar (parabolic_lifted c) - number 2 * parabolic_lifted c * der s_bar (area_squared_lifted c)) + number 4 * der s_bar (w c) * parabolic_lifted c * area_squared_lifted c.

End Formulas.
