(** Geometric Tools: curves and implicit surfaces: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require petrunin_zamora_barrera.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** NURBSCurve.h, Evaluate. `(X′ − w′ jet[0]) / w`. *)
Definition jet_1 (c : curve A) : list A :=
  vdiv (vsub (vder (along c) (p c)) (vmul (der (along c) (w c)) (gamma c))) (w c).

(** NURBSCurve.h, Evaluate. `(X″ − 2 w′ jet[1] − w″ jet[0]) / w`. *)
Definition jet_2 (c : curve A) : list A :=
  vdiv (vsub (vsub (vders (along c) 2 (p c)) (vmul (number 2 * der (along c) (w c)) (jet_1 c))) (vmul (ders (along c) 2 (w c)) (gamma c))) (w c).

(** NURBSCurve.h, Evaluate. `(X‴ − 3 w′ jet[2] − 3 w″ jet[1] − w‴ jet[0]) / w`. *)
Definition jet_3 (c : curve A) : list A :=
  vdiv (vsub (vders (along c) 3 (p c)) (vadd (vadd (vmul (number 3 * der (along c) (w c)) (jet_2 c)) (vmul (number 3 * ders (along c) 2 (w c)) (jet_1 c))) (vmul (ders (along c) 3 (w c)) (gamma c)))) (w c).

(** FrenetFrame.h, FrenetFrame2. `Perp(tangent) = (y, −x)`, without its length. *)
Definition clockwise_normal (c : curve A) : list A :=
  ([component 1 (vder (along c) (gamma c))] ++ [- component 0 (vder (along c) (gamma c))]).

(** Vector2.h, DotPerp. `Dot(jet[1], Perp(jet[2]))`: the numerator of the curvature. *)
Definition dot_perp (c : curve A) : A :=
  component 0 (vder (along c) (gamma c)) * component 1 (vders (along c) 2 (gamma c)) + component 1 (vder (along c) (gamma c)) * - component 0 (vders (along c) 2 (gamma c)).

(** FrenetFrame.h, FrenetFrame2. `κN` of curvature and normal as they are computed. *)
Definition bending_along_the_clockwise_normal (c : curve A) : list A :=
  vmul (dot_perp c / dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) ^ 2) (clockwise_normal c).

(** Frenet equations. The derivative of the unit tangent by arc length. *)
Definition tangent_by_arc_length (c : curve A) : list A :=
  petrunin_zamora_barrera.acceleration_by_arc_length c.

(** FrenetFrame.h, FrenetFrame3. `VDotV · A − VDotA · V`. *)
Definition normal_of_the_frame (c : curve A) : list A :=
  vsub (vmul (dot (vder (along c) (gamma c)) (vder (along c) (gamma c))) (vders (along c) 2 (gamma c))) (vmul (dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (vder (along c) (gamma c))).

(** ImplicitCurve2.h, GetCurvature. `−Fy²Fxx + 2FxFyFxy − Fx²Fyy`. *)
Definition implicit_curvature_numerator (c : implicit A) : A :=
  - fy_of c * fy_of c * fxx_of c + number 2 * fx_of c * fy_of c * fxy_of c - fx_of c * fx_of c * fyy_of c.

(** ImplicitCurve2.h, GetCurvature. `Fx² + Fy²`. *)
Definition gradient_squared (c : implicit A) : A :=
  fx_of c * fx_of c + fy_of c * fy_of c.

(** ImplicitCurve2.h, GetCurvature. The square of the curvature. *)
Definition implicit_curvature_squared (c : implicit A) : A :=
  implicit_curvature_numerator c ^ 2 / gradient_squared c ^ 3.

(** ImplicitCurve2.h. How fast the curve runs along `(−Fy, Fx)`. *)
Definition pace_of_the_curve (c : implicit A) : A :=
  pace_of c.

(** ImplicitCurve2.h, GetFrame. `−Perp(∇F) = (−Fy, Fx)`, without its length: what ComputeOrthogonalComplement makes of the gradient. *)
Definition implicit_tangent (c : implicit A) : list A :=
  ([- fy_of c] ++ [fx_of c]).

(** ImplicitCurve2.h, GetFrame. The gradient, without its length. *)
Definition implicit_normal (c : implicit A) : list A :=
  gradient_f c.

(** ImplicitCurve2.h, GetFrame. `[T N]`: positive for a right-handed pair. *)
Definition tangent_then_normal (c : implicit A) : A :=
  det [implicit_tangent c; implicit_normal c].

(** ImplicitCurve2.h, GetFrame. `T·N`. *)
Definition tangent_on_normal (c : implicit A) : A :=
  dot (implicit_tangent c) (implicit_normal c).

(** ImplicitCurve2.h, GetFrame. `[T γ′]`: zero if T is tangent to the curve. *)
Definition tangent_off_the_curve (c : implicit A) : A :=
  det [implicit_tangent c; vder (along c) (gamma c)].

(** ImplicitCurve2.h, GetCurvature. `κN` of curvature and normal as they are computed. *)
Definition implicit_bending (c : implicit A) : list A :=
  vmul (implicit_curvature_numerator c / gradient_squared c ^ 2) (implicit_normal c).

(** ImplicitCurve2.h, GetHessian. `Tᵀ D²F T` for the matrix of GetHessian. *)
Definition hessian_on_the_tangent (c : implicit A) : A :=
  dot (implicit_tangent c) (([dot (hessian_fx_of c) (implicit_tangent c)] ++ [dot (hessian_fy_of c) (implicit_tangent c)])).

(** ImplicitCurve2.h. `∇F·γ″`. *)
Definition height_of_the_acceleration (c : implicit A) : A :=
  dot (gradient_f c) (vders (along c) 2 (gamma c)).

(** ImplicitCurve2.h. `‖γ′‖²`. *)
Definition implicit_speed_squared (c : implicit A) : A :=
  dot (vder (along c) (gamma c)) (vder (along c) (gamma c)).

(** ImplicitSurface3.h, GetPrincipalInformation. `L²`. *)
Definition length_squared (c : implicit A) : A :=
  dot (gradient_f c) (gradient_f c).

(** ImplicitSurface3.h, GetPrincipalInformation. `D²F DF`. *)
Definition hessian_on_gradient (c : implicit A) : list A :=
  ([dot (hessian_fx_of c) (gradient_f c)] ++ [dot (hessian_fy_of c) (gradient_f c)] ++ [dot (hessian_fz_of c) (gradient_f c)]).

(** ImplicitSurface3.h, GetPrincipalInformation. `2L³` times `0.5 [trace(D²F)/L − (DFᵀ D²F DF)/L³]`. *)
Definition mean_in_the_comment (c : implicit A) : A :=
  (fxx_of c + fyy_of c + fzz_of c) * length_squared c - dot (gradient_f c) (hessian_on_gradient c).

(** ImplicitSurface3.h, GetPrincipalInformation. `2L³` times `meanCurv`. *)
Definition mean_in_the_code (c : implicit A) : A :=
  fxx_of c * (fy_of c * fy_of c + fz_of c * fz_of c) + fyy_of c * (fx_of c * fx_of c + fz_of c * fz_of c) + fzz_of c * (fx_of c * fx_of c + fy_of c * fy_of c) - number 2 * (fxy_of c * (fx_of c * fy_of c) + fxz_of c * (fx_of c * fz_of c) + fyz_of c * (fy_of c * fz_of c)).

(** ImplicitSurface3.h, GetPrincipalInformation. The first row of `adj(D²F)`, as the comment has it. *)
Definition adjugate_1 (c : implicit A) : list A :=
  ([fyy_of c * fzz_of c - fyz_of c * fyz_of c] ++ [fyz_of c * fxz_of c - fxy_of c * fzz_of c] ++ [fxy_of c * fyz_of c - fxz_of c * fyy_of c]).

(** ImplicitSurface3.h, GetPrincipalInformation. The second row. *)
Definition adjugate_2 (c : implicit A) : list A :=
  ([fyz_of c * fxz_of c - fxy_of c * fzz_of c] ++ [fxx_of c * fzz_of c - fxz_of c * fxz_of c] ++ [fxy_of c * fxz_of c - fxx_of c * fyz_of c]).

(** ImplicitSurface3.h, GetPrincipalInformation. The third row. *)
Definition adjugate_3 (c : implicit A) : list A :=
  ([fxy_of c * fyz_of c - fxz_of c * fyy_of c] ++ [fxy_of c * fxz_of c - fxx_of c * fyz_of c] ++ [fxx_of c * fyy_of c - fxy_of c * fxy_of c]).

(** Hessian matrix. The first row of the adjugate by vector products of rows. *)
Definition minors_1 (c : implicit A) : list A :=
  cross (hessian_fy_of c) (hessian_fz_of c).

(** Hessian matrix. The second row. *)
Definition minors_2 (c : implicit A) : list A :=
  cross (hessian_fz_of c) (hessian_fx_of c).

(** Hessian matrix. The third row. *)
Definition minors_3 (c : implicit A) : list A :=
  cross (hessian_fx_of c) (hessian_fy_of c).

(** ImplicitSurface3.h, GetPrincipalInformation. `L⁴` times `[DFᵀ adj(D²F) DF]/L⁴`. *)
Definition gauss_in_the_comment (c : implicit A) : A :=
  fx_of c * dot (adjugate_1 c) (gradient_f c) + fy_of c * dot (adjugate_2 c) (gradient_f c) + fz_of c * dot (adjugate_3 c) (gradient_f c).

(** ImplicitSurface3.h, GetPrincipalInformation. `L⁴` times `gaussCurv`. *)
Definition gauss_in_the_code (c : implicit A) : A :=
  fx_of c * fx_of c * (fyy_of c * fzz_of c - fyz_of c * fyz_of c) + fy_of c * fy_of c * (fxx_of c * fzz_of c - fxz_of c * fxz_of c) + fz_of c * fz_of c * (fxx_of c * fyy_of c - fxy_of c * fxy_of c) + number 2 * (fx_of c * fy_of c * (fxz_of c * fyz_of c - fxy_of c * fzz_of c) + fx_of c * fz_of c * (fxy_of c * fyz_of c - fxz_of c * fyy_of c) + fy_of c * fz_of c * (fxy_of c * fxz_of c - fxx_of c * fyz_of c)).

(** second fundamental form. `b = DF × γ′`: tangent to the surface, at a right angle to the curve. *)
Definition across (c : implicit A) : list A :=
  cross (gradient_f c) (vder (along c) (gamma c)).

(** second fundamental form. `[DF γ′ b]`: DF, γ′ and b are a right-handed frame where it is positive. *)
Definition right_handed (c : implicit A) : A :=
  det [gradient_f c; vder (along c) (gamma c); across c].

(** second fundamental form. `aᵀ D²F a` for a = γ′. *)
Definition form_along (c : implicit A) : A :=
  dot (vder (along c) (gamma c)) (([dot (hessian_fx_of c) (vder (along c) (gamma c))] ++ [dot (hessian_fy_of c) (vder (along c) (gamma c))] ++ [dot (hessian_fz_of c) (vder (along c) (gamma c))])).

(** second fundamental form. `bᵀ D²F b`. *)
Definition form_across (c : implicit A) : A :=
  dot (across c) (([dot (hessian_fx_of c) (across c)] ++ [dot (hessian_fy_of c) (across c)] ++ [dot (hessian_fz_of c) (across c)])).

(** second fundamental form. `aᵀ D²F b`. *)
Definition form_mixed (c : implicit A) : A :=
  dot (vder (along c) (gamma c)) (([dot (hessian_fx_of c) (across c)] ++ [dot (hessian_fy_of c) (across c)] ++ [dot (hessian_fz_of c) (across c)])).

(** second fundamental form. `−DF·γ″`: the normal curvature of γ times `−L ‖γ′‖²`. *)
Definition height_over_the_surface (c : implicit A) : A :=
  - dot (gradient_f c) (vders (along c) 2 (gamma c)).

(** Euler's theorem. `L² aᵀD²Fa + bᵀD²Fb`: the sum of two orthogonal normal curvatures times `L³‖γ′‖²`. *)
Definition sum_of_the_form (c : implicit A) : A :=
  form_along c * length_squared c + form_across c.

(** Theorema egregium. `(aᵀD²Fa)(bᵀD²Fb) − (aᵀD²Fb)²`. *)
Definition determinant_of_the_form (c : implicit A) : A :=
  form_along c * form_across c - form_mixed c ^ 2.

(** ImplicitSurface3.h, GetPrincipalInformation. `L³ (m00, m01, m02)`: the sum of the terms of the code over one power of L. *)
Definition shape_row_0 (c : implicit A) : list A :=
  ([dot (([fx_of c * fx_of c - length_squared c] ++ [fx_of c * fy_of c] ++ [fx_of c * fz_of c])) (hessian_fx_of c)] ++ [dot (([fx_of c * fx_of c - length_squared c] ++ [fx_of c * fy_of c] ++ [fx_of c * fz_of c])) (hessian_fy_of c)] ++ [dot (([fx_of c * fx_of c - length_squared c] ++ [fx_of c * fy_of c] ++ [fx_of c * fz_of c])) (hessian_fz_of c)]).

(** ImplicitSurface3.h, GetPrincipalInformation. `L³ (m10, m11, m12)`. *)
Definition shape_row_1 (c : implicit A) : list A :=
  ([dot (([fy_of c * fx_of c] ++ [fy_of c * fy_of c - length_squared c] ++ [fy_of c * fz_of c])) (hessian_fx_of c)] ++ [dot (([fy_of c * fx_of c] ++ [fy_of c * fy_of c - length_squared c] ++ [fy_of c * fz_of c])) (hessian_fy_of c)] ++ [dot (([fy_of c * fx_of c] ++ [fy_of c * fy_of c - length_squared c] ++ [fy_of c * fz_of c])) (hessian_fz_of c)]).

(** ImplicitSurface3.h, GetPrincipalInformation. `L³ (m20, m21, m22)`. *)
Definition shape_row_2 (c : implicit A) : list A :=
  ([dot (([fz_of c * fx_of c] ++ [fz_of c * fy_of c] ++ [fz_of c * fz_of c - length_squared c])) (hessian_fx_of c)] ++ [dot (([fz_of c * fx_of c] ++ [fz_of c * fy_of c] ++ [fz_of c * fz_of c - length_squared c])) (hessian_fy_of c)] ++ [dot (([fz_of c * fx_of c] ++ [fz_of c * fy_of c] ++ [fz_of c * fz_of c - length_squared c])) (hessian_fz_of c)]).

(** ImplicitSurface3.h, GetPrincipalInformation. `DFᵀ m`: zero, so that m has the eigenvalue 0. *)
Definition gradient_on_shape (c : implicit A) : list A :=
  vadd (vadd (vmul (fx_of c) (shape_row_0 c)) (vmul (fy_of c) (shape_row_1 c))) (vmul (fz_of c) (shape_row_2 c)).

(** ImplicitSurface3.h, GetPrincipalInformation. `L³` times the trace of m. *)
Definition trace_of_shape (c : implicit A) : A :=
  component 0 (shape_row_0 c) + component 1 (shape_row_1 c) + component 2 (shape_row_2 c).

(** ImplicitSurface3.h, GetPrincipalInformation. `L⁶` times the sum of the principal minors of m. *)
Definition minors_of_shape (c : implicit A) : A :=
  component 0 (shape_row_0 c) * component 1 (shape_row_1 c) - component 1 (shape_row_0 c) * component 0 (shape_row_1 c) + component 0 (shape_row_0 c) * component 2 (shape_row_2 c) - component 2 (shape_row_0 c) * component 0 (shape_row_2 c) + component 1 (shape_row_1 c) * component 2 (shape_row_2 c) - component 2 (shape_row_1 c) * component 1 (shape_row_2 c).

(** ImplicitSurface3.h, GetPrincipalInformation. `4L⁶ (meanCurv² − gaussCurv)`: what stands under the root for the principal curvatures. *)
Definition principal_discriminant (c : implicit A) : A :=
  mean_in_the_code c ^ 2 - number 4 * length_squared c * gauss_in_the_code c.

(** Euler's theorem. `L² aᵀD²Fa − bᵀD²Fb`: the difference of the two normal curvatures, times `L³‖γ′‖²`. *)
Definition form_difference (c : implicit A) : A :=
  form_along c * length_squared c - form_across c.

(** Euler's theorem. `2 (aᵀD²Fb) DF`, of the length `2L |aᵀD²Fb|`. *)
Definition form_mixed_on_gradient (c : implicit A) : list A :=
  vmul (number 2 * form_mixed c) (gradient_f c).

End Formulas.
