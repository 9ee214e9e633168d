(* The formulas of the assignment as a page prints them: what the theorems are about. Bridge.v proves that the
   templates of src/formulas compute exactly these, as real numbers.
   n points from body A to body B, v_r = v_B - v_A at the contact, an impulse j acts +j on B and -j on A.
   Every vector and matrix is in world axes; arms go from the centre of mass to the contact. *)
Require Import Vec3.

(* what one body brings to an impact; an immovable one has zeros *)
Record ImpactBody := { inverse_mass : R; inverse_inertia : M; arm : V }.
Record Velocity := { linear : V; angular : V }.
Record PairVelocity := { of_A : Velocity; of_B : Velocity }.
Record Wrench := { force : V; torque : V }.
Record State := { position : V; orientation : M; velocity : V; spin : V }.

(* -- inertia -- *)
Definition cuboid_inertia m s :=
  V3 (m / 12 * (vy s ^ 2 + vz s ^ 2)) (m / 12 * (vx s ^ 2 + vz s ^ 2)) (m / 12 * (vx s ^ 2 + vy s ^ 2)).
Definition cuboid_inverse_inertia I := V3 (1 / vx I) (1 / vy I) (1 / vz I).
Definition world_tensor Rot I := mm Rot (mm (diag I) (tr Rot)).

(* -- forces and motion -- *)
Definition torque_of_force r f := cross r f.
Definition add_force sum r f :=
  {| force := vadd (force sum) f; torque := vadd (torque sum) (torque_of_force r f) |}.
Definition linear_acceleration w f := smul w f.
Definition angular_acceleration I inverse_I w tau := mv inverse_I (vsub tau (cross w (mv I w))).
Definition point_velocity v w r := vadd v (cross w r).

(* -- rotation and stepping -- *)
Definition rotation_rate w Rot := mm (hat w) Rot.
Definition naive_rotation_step h w Rot := madd Rot (mscale h (rotation_rate w Rot)).
Definition without a u := vsub a (smul (dot u a) u).
Definition u1 A := unit (col1 A).
Definition u2 A := unit (without (col2 A) (u1 A)).
Definition u3 A := unit (without (without (col3 A) (u1 A)) (u2 A)).
Definition gram_schmidt A := cols (u1 A) (u2 A) (u3 A).
Definition semi_implicit_step h s a alpha :=
  let v := vadd (velocity s) (smul h a) in
  let w := vadd (spin s) (smul h alpha) in
  {| position := vadd (position s) (smul h v);
     orientation := gram_schmidt (naive_rotation_step h w (orientation s));
     velocity := v; spin := w |}.

(* -- impulses -- *)
(* how a unit impulse along j turns the body, seen at its contact point *)
Definition turn_response B j := cross (mv (inverse_inertia B) (cross (arm B) j)) (arm B).
Definition effective_inverse_mass A B :=
  madd (mscale (inverse_mass A + inverse_mass B) mid)
       (mscale (-1) (madd (mm (hat (arm A)) (mm (inverse_inertia A) (hat (arm A))))
                          (mm (hat (arm B)) (mm (inverse_inertia B) (hat (arm B)))))).
Definition normal_inverse_mass A B n :=
  inverse_mass A + inverse_mass B + dot (vadd (turn_response A n) (turn_response B n)) n.
Definition contact_velocity B u := point_velocity (linear u) (angular u) (arm B).
Definition relative_velocity A B u := vsub (contact_velocity B (of_B u)) (contact_velocity A (of_A u)).
Definition normal_impulse e v_n k_nn := - (1 + e) * v_n / k_nn.
Definition normal_impulse_printed e v_n k_nn := - (1 - e) * v_n / k_nn.
Definition apply_impulse B u j :=
  {| linear := vadd (linear u) (smul (inverse_mass B) j);
     angular := vadd (angular u) (mv (inverse_inertia B) (cross (arm B) j)) |}.
Definition apply_pair_impulse A B u j :=
  {| of_A := apply_impulse A (of_A u) (smul (-1) j); of_B := apply_impulse B (of_B u) j |}.

(* -- contact and friction -- *)
Definition positional_correction depth n := smul (Rmax 0 depth) n.
Definition tangential a n := vsub a (smul (dot a n) n).
(* of the slip, else of the tangential force, else none; below the threshold 2 eps a projection is rounding *)
Definition counts eps t a := Rgt_dec (dot t t) ((4 * eps / 2) ^ 2 * dot a a).
Definition friction_tangent eps v_r f n :=
  if counts eps (tangential v_r n) v_r then unit (tangential v_r n)
  else if counts eps (tangential f n) f then unit (tangential f n)
  else vzero.

(* -- energy and momentum -- *)
Definition kinetic_energy m I v w := (m * dot v v + dot w (mv I w)) / 2.
Definition impulse_energy j v_r v_r' := dot j (vadd v_r v_r') / 2.
Definition linear_momentum m v := smul m v.
Definition angular_momentum m I p v w o := vadd (cross (vsub p o) (linear_momentum m v)) (mv I w).
