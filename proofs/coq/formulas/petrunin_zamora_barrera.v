(** What is differential geometry: curves and surfaces: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require lifted.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** chapter Signed curvature. `⟨γ″, γ′ turned left⟩`: the signed curvature times `|γ′|³`. *)
Definition turning_left (c : curve A) : A :=
  dot (vders (along c) 2 (gamma c)) (perp (vder (along c) (gamma c))).

(** eq:tau'. `γ″ − γ′ (|γ′|²)′/(2|γ′|²) − |γ′|k (γ′ turned left)`: zero if `T′ = kN`. *)
Definition frenet_equation_of_the_tangent (c : curve A) : list A :=
  vsub (vsub (vders (along c) 2 (gamma c)) (vmul (der (along c) (chen_riesenfeld_cohen_2007.speed_squared c) / (number 2 * chen_riesenfeld_cohen_2007.speed_squared c)) (vder (along c) (gamma c)))) (vmul (turning_left c / chen_riesenfeld_cohen_2007.speed_squared c) (perp (vder (along c) (gamma c)))).

(** eq:nu'. `n′ − n (|γ′|²)′/(2|γ′|²) + |γ′|k γ′` for n = γ′ turned left: zero if `N′ = −kT`. *)
Definition frenet_equation_of_the_left_normal (c : curve A) : list A :=
  vadd (vsub (vder (along c) (perp (vder (along c) (gamma c)))) (vmul (der (along c) (chen_riesenfeld_cohen_2007.speed_squared c) / (number 2 * chen_riesenfeld_cohen_2007.speed_squared c)) (perp (vder (along c) (gamma c))))) (vmul (turning_left c / chen_riesenfeld_cohen_2007.speed_squared c) (vder (along c) (gamma c))).

(** ex:curvature-graph. The derivative of y by x: the curve as a graph `y = f(x)`. *)
Definition graph_slope (c : curve A) : A :=
  component 1 (vder (along c) (gamma c)) / component 0 (vder (along c) (gamma c)).

(** ex:curvature-graph. Its derivative by x. *)
Definition graph_bend (c : curve A) : A :=
  der (along c) (graph_slope c) / component 0 (vder (along c) (gamma c)).

(** ex:curvature-graph. `f″² / (1 + f′²)³`. *)
Definition curvature_squared_of_graph (c : curve A) : A :=
  graph_bend c ^ 2 / (number 1 + graph_slope c ^ 2) ^ 3.

(** spiral lemma. `(1/k) N`: from the curve to its centre of curvature. *)
Definition towards_the_centre (c : curve A) : list A :=
  vmul (chen_riesenfeld_cohen_2007.speed_squared c / turning_left c) (perp (vder (along c) (gamma c))).

(** spiral lemma. `γ + (1/k) N`. *)
Definition centre_of_curvature (c : curve A) : list A :=
  vadd (gamma c) (towards_the_centre c).

(** osculating circline. The squared distance of the centre from the curve. *)
Definition radius_squared (c : curve A) : A :=
  dot (towards_the_centre c) (towards_the_centre c).

(** osculating circline. `1/k²`. *)
Definition inverse_curvature_squared (c : curve A) : A :=
  chen_riesenfeld_cohen_2007.speed_squared c ^ 3 / turning_left c ^ 2.

(** spiral lemma. `(1/k)′ N` by the parameter. *)
Definition evolute_velocity (c : curve A) : list A :=
  vmul (number 3 * der (along c) (chen_riesenfeld_cohen_2007.speed_squared c) / (number 2 * turning_left c) - chen_riesenfeld_cohen_2007.speed_squared c * der (along c) (turning_left c) / turning_left c ^ 2) (perp (vder (along c) (gamma c))).

(** spiral lemma. The derivative of the centre of curvature. *)
Definition centre_velocity (c : curve A) : list A :=
  vder (along c) (centre_of_curvature c).

(** osculating circline. `(ω − γ)·γ‴ − 3 γ′·γ″`: zero where the contact is of third order. *)
Definition circle_third_contact (c : curve A) : A :=
  dot (towards_the_centre c) (vders (along c) 3 (gamma c)) - number 3 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** supporting curves, vertex. The derivative of the signed curvature, times `|γ′|⁵`. *)
Definition signed_curvature_derivative (c : curve A) : A :=
  der (along c) (turning_left c) * chen_riesenfeld_cohen_2007.speed_squared c - turning_left c * der (along c) (chen_riesenfeld_cohen_2007.speed_squared c) * number 3 / number 2.

(** ex:inverse. The inversion of the curve with respect to the unit circle. *)
Definition inverse_curve (c : curve A) : list A :=
  vdiv (gamma c) (dot (gamma c) (gamma c)).

(** ex:inverse. The centre of curvature of the inverse curve. *)
Definition centre_of_the_inverse (c : curve A) : list A :=
  vadd (inverse_curve c) (vmul (dot (vder (along c) (inverse_curve c)) (vder (along c) (inverse_curve c)) / det [vder (along c) (inverse_curve c); vders (along c) 2 (inverse_curve c)]) (perp (vder (along c) (inverse_curve c)))).

(** ex:inverse. The centre of the inversion of the osculating circle: `ω / (|ω|² − r²)`. *)
Definition inverse_of_the_circle (c : curve A) : list A :=
  vdiv (centre_of_curvature c) (dot (centre_of_curvature c) (centre_of_curvature c) - radius_squared c).

(** ex:evolute. The squared curvature of the evolute. *)
Definition evolute_curvature_squared (c : curve A) : A :=
  det [vder (along c) (centre_of_curvature c); vders (along c) 2 (centre_of_curvature c)] ^ 2 / dot (vder (along c) (centre_of_curvature c)) (vder (along c) (centre_of_curvature c)) ^ 3.

(** ex:evolute. `(k³/k′)²` by arc length. *)
Definition evolute_curvature_squared_by_frenet (c : curve A) : A :=
  turning_left c ^ 6 / (signed_curvature_derivative c ^ 2 * chen_riesenfeld_cohen_2007.speed_squared c ^ 3).

(** chapter Curvature. `γ″` of the curve by arc length: `(γ′/‖γ′‖)′/‖γ′‖`. *)
Definition acceleration_by_arc_length (c : curve A) : list A :=
  vdiv (vsub (vmul (chen_riesenfeld_cohen_2007.speed_squared c) (vders (along c) 2 (gamma c))) (vdiv (vmul (der (along c) (chen_riesenfeld_cohen_2007.speed_squared c)) (vder (along c) (gamma c))) (number 2))) (chen_riesenfeld_cohen_2007.speed_squared c ^ 2).

(** Proposition \ref{prop:a'-pertp-a''}. `⟨γ′, γ″⟩` by arc length: zero at a right angle. *)
Definition acceleration_on_velocity (c : curve A) : A :=
  dot (acceleration_by_arc_length c) (vder (along c) (gamma c)).

(** chapter Curvature. `|γ″|²` by arc length: the square of the curvature. *)
Definition acceleration_squared (c : curve A) : A :=
  dot (acceleration_by_arc_length c) (acceleration_by_arc_length c).

(** ex:curvature-formulas, b. `|γ″ × γ′|² / |γ′|⁶`. *)
Definition curvature_squared_by_product (c : curve A) : A :=
  dot (cross (vders (along c) 2 (gamma c)) (vder (along c) (gamma c))) (cross (vders (along c) 2 (gamma c)) (vder (along c) (gamma c))) / chen_riesenfeld_cohen_2007.speed_squared c ^ 3.

(** ex:curvature-formulas, a. `w`: the projection of γ″ to the plane normal to γ′. *)
Definition normal_part (c : curve A) : list A :=
  vsub (vders (along c) 2 (gamma c)) (vmul (dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) / chen_riesenfeld_cohen_2007.speed_squared c) (vder (along c) (gamma c))).

(** ex:curvature-formulas, a. `|w|² / |γ′|⁴`. *)
Definition curvature_squared_by_projection (c : curve A) : A :=
  dot (normal_part c) (normal_part c) / chen_riesenfeld_cohen_2007.speed_squared c ^ 2.

(** eq:curvature. `|T′|²` for the tangent indicatrix `T = γ′/|γ′|`. *)
Definition indicatrix_speed_squared (c : curve A) : A :=
  (dot (vders (along c) 2 (gamma c)) (vders (along c) 2 (gamma c)) * chen_riesenfeld_cohen_2007.speed_squared c - dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) ^ 2) / chen_riesenfeld_cohen_2007.speed_squared c ^ 2.

(** chapter Torsion, Frenet frame. `γ′ × K`: the binormal `B = T × N` times `|γ′|κ`. *)
Definition binormal_by_arc_length (c : curve A) : list A :=
  cross (vder (along c) (gamma c)) (acceleration_by_arc_length c).

(** chapter Torsion. `τ = ⟨N′, B⟩` by arc length: `⟨K′, γ′ × K⟩ / (|γ′|²κ²)`. *)
Definition torsion_by_definition (c : curve A) : A :=
  dot (vder (along c) (acceleration_by_arc_length c)) (binormal_by_arc_length c) / (chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c).

(** ex:frenet. `⟨γ′ × γ″, γ‴⟩ / |γ′ × γ″|²`. *)
Definition torsion_by_derivatives (c : curve A) : A :=
  dot (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (vders (along c) 3 (gamma c)) / dot (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))).

(** eq:frenet-nu. `K′ − (κ²)′/(2κ²) K + κ²γ′ − τ γ′ × K`: zero if `N′ = −κT + τB`. *)
Definition frenet_equation_of_the_normal (c : curve A) : list A :=
  vadd (vsub (vder (along c) (acceleration_by_arc_length c)) (vmul (der (along c) (acceleration_squared c) / (number 2 * acceleration_squared c)) (acceleration_by_arc_length c))) (vsub (vmul (acceleration_squared c) (vder (along c) (gamma c))) (vmul (torsion_by_derivatives c) (binormal_by_arc_length c))).

(** eq:frenet-beta. `b′ − (|b|²)′/(2|b|²) b + |γ′|²τK` for `b = γ′ × K`: zero if `B′ = −τN`. *)
Definition frenet_equation_of_the_binormal (c : curve A) : list A :=
  vadd (vsub (vder (along c) (binormal_by_arc_length c)) (vmul (der (along c) (dot (binormal_by_arc_length c) (binormal_by_arc_length c)) / (number 2 * dot (binormal_by_arc_length c) (binormal_by_arc_length c))) (binormal_by_arc_length c))) (vmul (chen_riesenfeld_cohen_2007.speed_squared c * torsion_by_derivatives c) (acceleration_by_arc_length c)).

(** ex:lancret, b. `|γ′|κ (τ/κ T + B)`. *)
Definition lancret_vector (c : curve A) : list A :=
  vadd (vmul (torsion_by_derivatives c) (vder (along c) (gamma c))) (binormal_by_arc_length c).

(** ex:lancret, b. What is left of the derivative of `w = τ/κ T + B` beside `(τ/κ)′ T`, times `|γ′|κ`. *)
Definition lancret_derivative (c : curve A) : list A :=
  vsub (vsub (vder (along c) (lancret_vector c)) (vmul (der (along c) (chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c) / (number 2 * (chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c))) (lancret_vector c))) (vmul (der (along c) (torsion_by_derivatives c) - torsion_by_derivatives c * (der (along c) (acceleration_squared c) / (number 2 * acceleration_squared c))) (vder (along c) (gamma c))).

(** section Spherical curves. `κ′/(κ²τ) B` for the derivative by arc length. *)
Definition sphere_offset_along_binormal (c : curve A) : list A :=
  vmul (der (along c) (acceleration_squared c) / (number 2 * chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c ^ 2 * torsion_by_derivatives c)) (binormal_by_arc_length c).

(** section Spherical curves. `(1/κ) N`: from the curve to the centre of its osculating circle. *)
Definition towards_the_circle (c : curve A) : list A :=
  vdiv (acceleration_by_arc_length c) (acceleration_squared c).

(** section Spherical curves. `γ + (1/κ)N − κ′/(κ²τ) B`. *)
Definition sphere_centre_meant (c : curve A) : list A :=
  vsub (vadd (gamma c) (towards_the_circle c)) (sphere_offset_along_binormal c).

(** section Spherical curves. The squared distance of that centre from the curve. *)
Definition sphere_radius_squared (c : curve A) : A :=
  dot (vsub (sphere_centre_meant c) (gamma c)) (vsub (sphere_centre_meant c) (gamma c)).

(** section Spherical curves, Theorem. `κ′² − τ²κ²(κ² − 1)` by arc length, times `4κ²`: zero where `|κ′/τ| = κ√(κ² − 1)`. *)
Definition spherical_identity (c : curve A) : A :=
  der (along c) (acceleration_squared c) ^ 2 / chen_riesenfeld_cohen_2007.speed_squared c - number 4 * torsion_by_derivatives c ^ 2 * acceleration_squared c ^ 2 * (acceleration_squared c - number 1).

(** section Spherical curves, Theorem. The squared radius of the osculating sphere less 1. *)
Definition off_the_unit_sphere (c : curve A) : A :=
  sphere_radius_squared c - number 1.

(** section Spherical curves. `(2x, 2y, x² + y² − 1) / (x² + y² + 1)`: a curve on the unit sphere. *)
Definition spherical_curve (c : curve A) : list A :=
  vdiv ((vmul (number 2 * w c) (p c) ++ [dot (p c) (p c) - w c ^ 2])) (dot (p c) (p c) + w c ^ 2).

(** section Spherical curves. `|S|² − 1`. *)
Definition spherical_distance (c : curve A) : A :=
  dot (spherical_curve c) (spherical_curve c) - number 1.

(** ex:spherical-frenet, tau. `⟨S′, S⟩`. *)
Definition spherical_tangent_on_radius (c : curve A) : A :=
  dot (vder (along c) (spherical_curve c)) (spherical_curve c).

(** ex:spherical-frenet, nu. The second derivative of S by arc length. *)
Definition spherical_acceleration (c : curve A) : list A :=
  vdiv (vsub (vmul (dot (vder (along c) (spherical_curve c)) (vder (along c) (spherical_curve c))) (vders (along c) 2 (spherical_curve c))) (vmul (dot (vder (along c) (spherical_curve c)) (vders (along c) 2 (spherical_curve c))) (vder (along c) (spherical_curve c)))) (dot (vder (along c) (spherical_curve c)) (vder (along c) (spherical_curve c)) ^ 2).

(** ex:spherical-frenet, nu. `κ⟨N, S⟩ + 1`: zero if `⟨N, S⟩ = −1/κ`. *)
Definition spherical_normal_on_radius (c : curve A) : A :=
  dot (spherical_acceleration c) (spherical_curve c) + number 1.

(** ex:curvature-of-spherical-curve. `κ² − 1`. *)
Definition spherical_curvature_excess (c : curve A) : A :=
  dot (spherical_acceleration c) (spherical_acceleration c) - number 1.

(** ex:curvature-of-spherical-curve. `|S′|²`. *)
Definition spherical_speed_squared (c : curve A) : A :=
  dot (vder (along c) (spherical_curve c)) (vder (along c) (spherical_curve c)).

(** ex:curvature-of-spherical-curve. `[S S′ S″] S′`, of the length `|[S S′ S″]| |S′|`. *)
Definition geodesic_bending (c : curve A) : list A :=
  vmul (det [spherical_curve c; vder (along c) (spherical_curve c); vders (along c) 2 (spherical_curve c)]) (vder (along c) (spherical_curve c)).

(** ex:spherical-frenet, tau. `⟨N, S⟩² + ⟨B, S⟩² − 1` times κ². *)
Definition spherical_frame_sum (c : curve A) : A :=
  dot (spherical_acceleration c) (spherical_curve c) ^ 2 + dot (cross (vder (along c) (spherical_curve c)) (spherical_acceleration c)) (spherical_curve c) ^ 2 / dot (vder (along c) (spherical_curve c)) (vder (along c) (spherical_curve c)) - dot (spherical_acceleration c) (spherical_acceleration c).

(** ch. Curvature, § Tangents. `γ′ × (γ(s̄) − γ)`. *)
Definition off_the_tangent_line (c : pair A) : list A :=
  cross (vder (along (first c)) (gamma (first c))) (vsub (gamma (second c)) (gamma (first c))).

(** ch. Torsion, § Frenet frame. `⟨B, γ(s̄) − γ⟩` times `|γ′|κ`. *)
Definition off_the_osculating_plane (c : pair A) : A :=
  dot (binormal_by_arc_length (first c)) (vsub (gamma (second c)) (gamma (first c))).

(** ch. Signed curvature, § Osculating circline. `|γ(s̄) − ω|² − |γ − ω|²` for the centre ω of curvature: `|v|² − 2 v·(ω − γ)` with `v = γ(s̄) − γ`. *)
Definition off_the_osculating_circle (c : pair A) : A :=
  dot (vsub (gamma (second c)) (gamma (first c))) (vsub (gamma (second c)) (gamma (first c))) - number 2 * dot (vsub (gamma (second c)) (gamma (first c))) (towards_the_centre (first c)).

(** ch. Torsion, § Spherical curves. `|γ(s̄) − p|² − |γ − p|²` for the centre that is printed. *)
Definition off_the_printed_sphere (c : pair A) : A :=
  dot (vsub (gamma (second c)) (gamma (first c))) (vsub (gamma (second c)) (gamma (first c))) - number 2 * dot (vsub (gamma (second c)) (gamma (first c))) (vadd (towards_the_circle (first c)) (sphere_offset_along_binormal (first c))).

(** ch. Torsion, § Spherical curves. The same for the centre with the other sign. *)
Definition off_the_osculating_sphere (c : pair A) : A :=
  dot (vsub (gamma (second c)) (gamma (first c))) (vsub (gamma (second c)) (gamma (first c))) - number 2 * dot (vsub (gamma (second c)) (gamma (first c))) (vsub (towards_the_circle (first c)) (sphere_offset_along_binormal (first c))).

(** ch. Torsion, § Spherical curves. What the centre with the other sign gives, less what the printed one gives. *)
Definition between_the_spheres (c : pair A) : A :=
  off_the_osculating_sphere c - off_the_printed_sphere c.

(** ch. Torsion, § Spherical curves. `v·o` with `v = γ(s̄) − γ` and the offset o of the centre along B. *)
Definition along_the_offset (c : pair A) : A :=
  dot (vsub (gamma (second c)) (gamma (first c))) (sphere_offset_along_binormal (first c)).

End Formulas.
