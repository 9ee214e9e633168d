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
(* of the slip, else of the tangential force, else none; below the threshold 8 eps a projection is rounding *)
Definition counts eps t a := Rgt_dec (dot t t) ((16 * eps / 2) ^ 2 * dot a a).
Definition friction_tangent eps v_r f n :=
  if counts eps (tangential v_r n) v_r then unit (tangential v_r n)
  else if counts eps (tangential f n) f then unit (tangential f n)
  else vzero.

(* -- energy and momentum -- *)
Definition kinetic_energy m I v w := (m * dot v v + dot w (mv I w)) / 2.
Definition impulse_energy j v_r v_r' := dot j (vadd v_r v_r') / 2.
Definition linear_momentum m v := smul m v.
Definition angular_momentum m I p v w o := vadd (cross (vsub p o) (linear_momentum m v)) (mv I w).

(* -- friction: the sheet's rule -- *)
Definition sheet_friction_impulse m mu_s mu_d j_r slip :=
  if Rle_dec (m * slip) (mu_s * j_r) then m * slip else mu_d * j_r.
Definition sheet_literal_friction_impulse mu_d j_r slip := if Req_EM_T slip 0 then 0 else mu_d * j_r.

(* -- friction: Coulomb's law with Newton's restitution -- *)
Inductive FrictionOutcome := stuck | slid | slip_stopped_inside | jammed.
Record FrictionImpact := { impulse : V; outcome : FrictionOutcome }.

(* the impulse j with K j = -b, by Cramer's rule *)
Definition impulse_cancelling K b :=
  V3 (- dot b (cross (col2 K) (col3 K)) / det K)
     (- dot b (cross (col3 K) (col1 K)) / det K)
     (- dot b (cross (col1 K) (col2 K)) / det K).
Definition coulomb_stick K v_r n e := impulse_cancelling K (vadd v_r (smul (e * dot v_r n) n)).
Definition coulomb_slide K v_r n t e mu_d :=
  smul (normal_impulse e (dot v_r n) (dot n (mv K n) - mu_d * dot t (mv K n))) (vsub n (smul mu_d t)).
Definition coulomb_impulse K v_r n t e mu_s mu_d :=
  let frictionless := smul (normal_impulse e (dot v_r n) (dot n (mv K n))) n in
  let stick := coulomb_stick K v_r n e in
  let slide := coulomb_slide K v_r n t e mu_d in
  let sliding :=
    if Rgt_dec (dot n (mv K n) - mu_d * dot t (mv K n)) 0 then
      {| impulse := slide;
         outcome := if Rlt_dec (dot v_r t + dot t (mv K slide)) 0 then slip_stopped_inside else slid |}
    else {| impulse := frictionless; outcome := jammed |} in
  if Req_EM_T mu_s 0 then {| impulse := frictionless; outcome := slid |}
  else if Rge_dec (dot stick n) 0 then
    if Rle_dec (dot (tangential stick n) (tangential stick n)) (mu_s * mu_s * dot stick n * dot stick n)
    then {| impulse := stick; outcome := stuck |} else sliding
  else sliding.

(* -- friction in a plane: Routh's process, whose clock is the normal impulse p -- *)
Inductive PlanarMode := sliding | sticking | reversed.
Inductive Restitution := stronge | poisson | newton.
Record PlanarImpact := { k_nn : R; k_tt : R; k_tn : R; v_n : R; v_t : R; e : R; mu_s : R; mu_d : R }.
Record PlanarImpulse := { j_n : R; j_t : R; mode : PlanarMode }.

(* one leg: the tangential impulse per unit of p; then v_n and v_t change at these rates *)
Record Leg := { friction : R; leg_mode : PlanarMode }.
Definition dv_n i leg := k_nn i + friction leg * k_tn i.
Definition slip_leg i := {| friction := - mu_d i; leg_mode := sliding |}.
Definition leg_without_slip i :=
  if Rle_dec (Rabs (k_tn i)) (mu_s i * k_tt i) then {| friction := - k_tn i / k_tt i; leg_mode := sticking |}
  else if Rlt_dec (k_tn i) 0 then {| friction := mu_d i; leg_mode := reversed |}
  else {| friction := - mu_d i; leg_mode := sliding |}.

(* From p_c on, where v_n is 0 and grows at the rate a; w is the work of v_n during compression, u = v_n at p = 0. *)
Definition end_of_restitution rule e u p_c w a := match rule with
  | stronge => p_c + sqrt (2 * (- e * e * w) / a)
  | poisson => (1 + e) * p_c
  | newton => p_c + - e * u / a end.
(* The same when the slope changes from a to b at s > p_c, where v_n = v_s: the end, and whether it lies before s. *)
Definition end_on_first_leg rule e u p_c w p_s v_s := match rule with
  | stronge => if Rle_dec (- e * e * w) (v_s * (p_s - p_c) / 2) then true else false
  | poisson => if Rle_dec ((1 + e) * p_c) p_s then true else false
  | newton => if Rle_dec (- e * u) v_s then true else false end.
Definition end_on_second_leg rule e u p_c w p_s v_s b := match rule with
  | stronge => p_s + (sqrt (v_s * v_s + 2 * b * (- e * e * w - v_s * (p_s - p_c) / 2)) - v_s) / b
  | poisson => (1 + e) * p_c
  | newton => p_s + (- e * u - v_s) / b end.

Definition planar_impulse rule i :=
  let one leg p := {| j_n := p; j_t := friction leg * p; mode := leg_mode leg |} in
  let first := slip_leg i in
  let second := leg_without_slip i in
  let rate := k_tn i - mu_d i * k_tt i in           (* of the slip *)
  let p_s := - v_t i / rate in                      (* where it stops *)
  let v_s := v_n i + dv_n i first * p_s in
  let two p := {| j_n := p; j_t := friction first * p_s + friction second * (p - p_s); mode := leg_mode second |} in
  let on leg :=                                     (* one leg for the whole impact *)
    let p_c := - v_n i / dv_n i leg in
    one leg (end_of_restitution rule (e i) (v_n i) p_c (v_n i * p_c / 2) (dv_n i leg)) in
  if Rgt_dec (v_t i) 0 then
    if Rlt_dec rate 0 then
      if Rge_dec v_s 0 then                         (* compression ends while the contact slips *)
        let p_c := - v_n i / dv_n i first in
        let w := v_n i * p_c / 2 in
        if end_on_first_leg rule (e i) (v_n i) p_c w p_s v_s
        then one first (end_of_restitution rule (e i) (v_n i) p_c w (dv_n i first))
        else two (end_on_second_leg rule (e i) (v_n i) p_c w p_s v_s (dv_n i second))
      else                                          (* the slip stops during compression *)
        let p_c := p_s - v_s / dv_n i second in
        let w := (v_n i + v_s) * p_s / 2 + v_s * (p_c - p_s) / 2 in
        two (end_of_restitution rule (e i) (v_n i) p_c w (dv_n i second))
    else on first
  else on second.
