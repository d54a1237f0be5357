(** Lifted forms: the lowest degrees, and why: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** projective lift. `(w, p)`; w first, so that the signs of Wronskians are those of `[γ′ γ″]` and `[γ′ γ″ γ‴]`. *)
Definition projective_lift (c : curve A) : list A :=
  ([w c] ++ p c).

(** conformal lift. `(‖p‖², w p, w²)`. *)
Definition conformal_lift (c : curve A) : list A :=
  ([dot (p c) (p c)] ++ vmul (w c) (p c) ++ [w c ^ 2]).

(** lifted. The Wronskian of P: zero where the tangent meets the curve to third order. *)
Definition inflections_lifted (c : curve A) : A :=
  det [projective_lift c; vder (along c) (projective_lift c); vders (along c) 2 (projective_lift c)].

(** lifted. Squared curvature, with the Wronskian of P. *)
Definition curvature_squared_lifted (c : curve A) : A :=
  (inflections_lifted c * w c ^ 3) ^ 2 / chen_riesenfeld_cohen_2007.D1_squared c ^ 3.

(** lifted. The Wronskian of X: zero where a circle meets the curve to fourth order, where κ′ is zero. *)
Definition vertices_lifted (c : curve A) : A :=
  det [conformal_lift c; vder (along c) (conformal_lift c); vders (along c) 2 (conformal_lift c); vders (along c) 3 (conformal_lift c)].

(** lifted. The circle through three consecutive points of the curve, `(a, b, c)` as above. *)
Definition osculating_circle (c : curve A) : list A :=
  generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); vders (along c) 2 (conformal_lift c)].

(** lifted. The centre of the osculating circle. *)
Definition evolute_lifted (c : curve A) : list A :=
  vdiv (vneg (components 1 3 (osculating_circle c))) (number 2 * component 0 (osculating_circle c)).

(** lifted. The Wronskian of P: zero where the osculating plane meets the curve to fourth order. *)
Definition torsion_zeros_lifted (c : curve A) : A :=
  det [projective_lift c; vder (along c) (projective_lift c); vders (along c) 2 (projective_lift c); vders (along c) 3 (projective_lift c)].

(** lifted. The plane through three consecutive points of the curve: its normal, after its first coordinate, is `D1 × D2 / w`. *)
Definition osculating_plane (c : curve A) : list A :=
  generalized_cross [projective_lift c; vder (along c) (projective_lift c); vders (along c) 2 (projective_lift c)].

(** lifted. The normal of the osculating plane. *)
Definition binormal_lifted (c : curve A) : list A :=
  components 1 4 (osculating_plane c).

(** lifted. Torsion: the Wronskian of P over the squared length of the binormal. *)
Definition torsion_lifted (c : curve A) : A :=
  torsion_zeros_lifted c * w c ^ 2 / dot (binormal_lifted c) (binormal_lifted c).

(** lifted. Squared curvature from the binormal of the osculating plane. *)
Definition space_curvature_squared_lifted (c : curve A) : A :=
  dot (binormal_lifted c) (binormal_lifted c) * w c ^ 6 / chen_riesenfeld_cohen_2007.D1_squared c ^ 3.

(** lifted. The Jacobian of the two covariants whose quotient is κ², without the factors they share. *)
Definition space_critical_curvature_lifted (c : curve A) : A :=
  der (along c) (dot (binormal_lifted c) (binormal_lifted c)) * (w c * chen_riesenfeld_cohen_2007.D1_squared c) + dot (binormal_lifted c) (binormal_lifted c) * (number 6 * der (along c) (w c) * chen_riesenfeld_cohen_2007.D1_squared c) - dot (binormal_lifted c) (binormal_lifted c) * (number 3 * w c * der (along c) (chen_riesenfeld_cohen_2007.D1_squared c)).

(** lifted. The sphere through four consecutive points of the curve. *)
Definition osculating_sphere (c : curve A) : list A :=
  generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); vders (along c) 2 (conformal_lift c); vders (along c) 3 (conformal_lift c)].

(** lifted. The centre of the osculating sphere. *)
Definition focal_curve_lifted (c : curve A) : list A :=
  vdiv (vneg (components 1 4 (osculating_sphere c))) (number 2 * component 0 (osculating_sphere c)).

(** lifted. The sphere through three consecutive points with its centre in their plane, orthogonal to `(2 Π_0, −Π, 0)`. *)
Definition circle_sphere (c : curve A) : list A :=
  generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); vders (along c) 2 (conformal_lift c); ([number 2 * component 0 (osculating_plane c)] ++ vneg (components 1 4 (osculating_plane c)) ++ [number 0])].

(** lifted. The centre of the osculating circle of a space curve. *)
Definition circle_centre_lifted (c : curve A) : list A :=
  vdiv (vneg (components 1 4 (circle_sphere c))) (number 2 * component 0 (circle_sphere c)).

(** lifted. The principal normal direction: across the tangent, in the osculating plane. *)
Definition normal_lifted (c : curve A) : list A :=
  cross (binormal_lifted c) (chen_riesenfeld_cohen_2007.D1 c).

(** lifted. The direction of `τT + κB` without denominators. *)
Definition rectifying_generator_lifted (c : curve A) : list A :=
  vadd (vmul (torsion_zeros_lifted c * chen_riesenfeld_cohen_2007.D1_squared c) (chen_riesenfeld_cohen_2007.D1 c)) (vmul (w c * dot (binormal_lifted c) (binormal_lifted c)) (binormal_lifted c)).

(** definition of a developable. `[D1 G G′] / ‖G‖²` for the generator without denominators: zero when the rectifying developable is one. *)
Definition rectifying_development (c : curve A) : A :=
  det [chen_riesenfeld_cohen_2007.D1 c; rectifying_generator_lifted c; vder (along c) (rectifying_generator_lifted c)] / dot (rectifying_generator_lifted c) (rectifying_generator_lifted c).

(** lifted. `p/w + λ D1`. *)
Definition tangent_developable_lifted (c : curve A) : surface A :=
  ruled (gamma c) (chen_riesenfeld_cohen_2007.D1 c).

(** lifted. `p/w + λ Π`: along the normal of the osculating plane. *)
Definition binormal_scroll_lifted (c : curve A) : surface A :=
  ruled (gamma c) (binormal_lifted c).

(** lifted. `p/w` along the principal normal. *)
Definition normal_scroll_lifted (c : curve A) : surface A :=
  ruled (gamma c) (normal_lifted c).

(** lifted. `p/w` along the direction of `τT + κB`. *)
Definition rectifying_developable_lifted (c : curve A) : surface A :=
  ruled (gamma c) (rectifying_generator_lifted c).

(** lifted. The centre of the osculating circle, along the normal of the osculating plane. *)
Definition focal_surface_lifted (c : curve A) : surface A :=
  ruled (circle_centre_lifted c) (binormal_lifted c).

(** projective lift of the point. `(1, Q)`. *)
Definition projective_point (c : curve A) : list A :=
  ([number 1] ++ point c).

(** conformal lift of the point. `(‖Q‖², Q, 1)`. *)
Definition conformal_point (c : curve A) : list A :=
  ([dot (point c) (point c)] ++ point c ++ [number 1]).

(** lifted. The sphere through one point of each curve that touches both there. *)
Definition bisector_sphere (c : pair A) : list A :=
  generalized_cross [conformal_lift (first c); vder (along (first c)) (conformal_lift (first c)); conformal_lift (second c); vder (along (second c)) (conformal_lift (second c))].

(** lifted. The centre of the sphere that touches both curves. *)
Definition bisector_lifted (c : pair A) : list A :=
  vdiv (vneg (components 1 4 (bisector_sphere c))) (number 2 * component 0 (bisector_sphere c)).

(** lifted. The centre of the circle through Q that touches the curve. *)
Definition plane_bisector_lifted (c : curve A) : list A :=
  vdiv (vneg (components 1 3 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c]))) (number 2 * component 0 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c])).

(** lifted. The plane through the tangent and Q; its normal is the direction of the centres of the spheres through Q that touch the curve. *)
Definition tangent_plane_through_point (c : curve A) : list A :=
  generalized_cross [projective_lift c; vder (along c) (projective_lift c); projective_point c].

(** lifted. The point/curve bisector, its directrix in the plane of the tangent and Q. *)
Definition point_bisector_lifted (c : curve A) : surface A :=
  ruled (vdiv (vneg (components 1 4 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 2 * component 0 (tangent_plane_through_point c)] ++ vneg (components 1 4 (tangent_plane_through_point c)) ++ [number 0])]))) (number 2 * component 0 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 2 * component 0 (tangent_plane_through_point c)] ++ vneg (components 1 4 (tangent_plane_through_point c)) ++ [number 0])]))) (components 1 4 (tangent_plane_through_point c)).

(** lifted. The point/curve bisector, its directrix in the plane z = 0. *)
Definition point_bisector_direct_lifted (c : curve A) : surface A :=
  ruled (vdiv (vneg (components 1 4 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 0] ++ axis 2 (length (p c)) ++ [number 0])]))) (number 2 * component 0 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 0] ++ axis 2 (length (p c)) ++ [number 0])]))) (components 1 4 (tangent_plane_through_point c)).

(** lifted. `Π·(1, δ)`: zero where the directrix lies in the plane of the tangent and Q. *)
Definition lifted_directrix_in_tangent_plane (c : curve A) : A :=
  component 0 (tangent_plane_through_point c) + dot (components 1 4 (tangent_plane_through_point c)) (directrix (point_bisector_lifted c)).

(** lifted. The third component of the directrix of the direct form. *)
Definition lifted_directrix_height (c : curve A) : A :=
  dot (axis 2 (length (p c))) (directrix (point_bisector_direct_lifted c)).

(** lifted. The coefficient of `‖x‖²` in the osculating circle: zero where it is a line. *)
Definition osculating_circle_coefficient (c : curve A) : A :=
  component 0 (osculating_circle c).

(** lifted. The coefficient of `‖x‖²` in the osculating sphere: zero where it is a plane. *)
Definition osculating_sphere_coefficient (c : curve A) : A :=
  component 0 (osculating_sphere c).

(** lifted. The coefficient of `‖x‖²` in the sphere whose great circle osculates. *)
Definition circle_sphere_coefficient (c : curve A) : A :=
  component 0 (circle_sphere c).

(** lifted. The coefficient of `‖x‖²` in the sphere that touches two curves. *)
Definition bisector_sphere_coefficient (c : pair A) : A :=
  component 0 (bisector_sphere c).

(** lifted. `‖Π‖²` for the normal of the osculating plane. *)
Definition binormal_lifted_squared (c : curve A) : A :=
  dot (binormal_lifted c) (binormal_lifted c).

(** lifted. The directrix in the plane of the tangent and Q. *)
Definition point_bisector_lifted_directrix (c : curve A) : list A :=
  directrix (point_bisector_lifted c).

(** lifted. The normal of that plane. *)
Definition point_bisector_lifted_generator (c : curve A) : list A :=
  generator (point_bisector_lifted c).

(** lifted. The directrix in the plane z = 0. *)
Definition point_bisector_direct_lifted_directrix (c : curve A) : list A :=
  directrix (point_bisector_direct_lifted c).

End Formulas.
