(* One contact, one impulse: what it does to the relative velocity, and the size that restitution asks for. *)
Require Import Vec3 Laws.

Ltac impulse_unfold := unfold relative_velocity, contact_velocity, apply_pair_impulse, apply_impulse,
  point_velocity, effective_inverse_mass, normal_inverse_mass, turn_response; cbn [of_A of_B linear angular].

(*@ motion.point_velocity *)
(* Two points of one rigid body: their distance does not change, (v_P - v_Q).(P - Q) = 0. *)
Theorem points_keep_their_distance v w p q :
  dot (vsub (point_velocity v w p) (point_velocity v w q)) (vsub p q) = 0.
Proof. unfold point_velocity. vring. Qed.

(*@ impulse.effective_mass *)
(* K is the response: v_r' = v_r + K j for every impulse j. No symmetry of the inertias is needed. *)
Theorem response A B u j :
  relative_velocity A B (apply_pair_impulse A B u j)
  = vadd (relative_velocity A B u) (mv (effective_inverse_mass A B) j).
Proof. impulse_unfold. vring. Qed.

(*@ impulse.effective_mass *)
(* It is the only matrix that does this. *)
Theorem response_unique A B u K :
  (forall j, relative_velocity A B (apply_pair_impulse A B u j) = vadd (relative_velocity A B u) (mv K j)) ->
  K = effective_inverse_mass A B.
Proof.
  intros H. apply mv_ext. intros j. specialize (H j). rewrite response in H. symmetry. exact (vadd_cancel _ _ _ H).
Qed.

(*@ impulse.effective_mass *)
Theorem K_symmetric A B : sym (inverse_inertia A) -> sym (inverse_inertia B) -> sym (effective_inverse_mass A B).
Proof.
  rewrite !sym_tr. intros HA HB. unfold effective_inverse_mass. rewrite <- HA at 2. rewrite <- HB at 2. vring.
Qed.

(*@ impulse.effective_mass *)
(* As a quadratic form: j.Kj = (1/m_A + 1/m_B)|j|^2 + (r_A x j).I_A^-1 (r_A x j) + the same of B. *)
Theorem K_quadratic A B j :
  dot j (mv (effective_inverse_mass A B) j)
  = (inverse_mass A + inverse_mass B) * dot j j
    + dot (cross (arm A) j) (mv (inverse_inertia A) (cross (arm A) j))
    + dot (cross (arm B) j) (mv (inverse_inertia B) (cross (arm B) j)).
Proof. unfold effective_inverse_mass. vring. Qed.

(*@ impulse.effective_mass *)
(* Positive definite as soon as one body is not immovable. *)
Theorem K_positive A B : 0 <= inverse_mass A -> 0 <= inverse_mass B -> 0 < inverse_mass A + inverse_mass B ->
  possemi (inverse_inertia A) -> possemi (inverse_inertia B) -> posdef (effective_inverse_mass A B).
Proof.
  intros _ _ Hw HA HB j Hj. rewrite K_quadratic.
  pose proof (HA (cross (arm A) j)). pose proof (HB (cross (arm B) j)).
  pose proof (dot_self_pos j Hj). nra.
Qed.

(*@ impulse.normal_effective_mass *)
(* The assignment's denominator is n.Kn. *)
Theorem normal_inverse_mass_is_nKn A B n : dot n n = 1 ->
  normal_inverse_mass A B n = dot n (mv (effective_inverse_mass A B) n).
Proof.
  intros Hn. rewrite K_quadratic, Hn. unfold normal_inverse_mass, turn_response. clear Hn. vring.
Qed.

(*@ impulse.normal_effective_mass *)
Theorem normal_inverse_mass_at_least A B n : dot n n = 1 ->
  possemi (inverse_inertia A) -> possemi (inverse_inertia B) ->
  inverse_mass A + inverse_mass B <= normal_inverse_mass A B n.
Proof.
  intros Hn HA HB. rewrite normal_inverse_mass_is_nKn by exact Hn. rewrite K_quadratic, Hn.
  pose proof (HA (cross (arm A) n)). pose proof (HB (cross (arm B) n)). lra.
Qed.

(*@ impulse.normal_effective_mass *)
(* The sign of n does not matter. *)
Theorem normal_inverse_mass_even A B n : normal_inverse_mass A B (smul (-1) n) = normal_inverse_mass A B n.
Proof. unfold normal_inverse_mass, turn_response. vring. Qed.

(*@ impulse.relative_velocity *)
(* Naming the bodies the other way round turns v_r about; a motion both share does not enter. *)
Theorem relative_velocity_swapped A B u :
  relative_velocity B A {| of_A := of_B u; of_B := of_A u |} = smul (-1) (relative_velocity A B u).
Proof. unfold relative_velocity, contact_velocity, point_velocity. cbn [of_A of_B linear angular]. vring. Qed.

(*@ impulse.relative_velocity *)
(* x_A, x_B the centres, p the contact: a rigid motion v + w x (point) of both bodies leaves v_r as it is. *)
Theorem relative_velocity_boost A B u v w xA xB p : arm A = vsub p xA -> arm B = vsub p xB ->
  let moved c x := {| linear := vadd (linear c) (vadd v (cross w x)); angular := vadd (angular c) w |} in
  relative_velocity A B {| of_A := moved (of_A u) xA; of_B := moved (of_B u) xB |} = relative_velocity A B u.
Proof.
  intros HA HB moved. unfold relative_velocity, contact_velocity, point_velocity. rewrite HA, HB.
  unfold moved. cbn [of_A of_B linear angular]. clear HA HB moved. vring.
Qed.

(* -- the normal impulse -- *)
Section Normal.
Variables (A B : ImpactBody) (u : PairVelocity) (n : V) (e : R).
Hypothesis Hn : dot n n = 1.
Let k := normal_inverse_mass A B n.
Let v_n := dot (relative_velocity A B u) n.
Let after j := dot (relative_velocity A B (apply_pair_impulse A B u (smul j n))) n.

Lemma normal_response j : after j = v_n + j * k.
Proof.
  unfold after, v_n, k. rewrite response, normal_inverse_mass_is_nKn by exact Hn.
  generalize (relative_velocity A B u) (effective_inverse_mass A B). clear. vring.
Qed.
End Normal.

(*@ impulse.normal *)
(* Newton's restitution: v_n' = -e v_n. *)
Theorem normal_impulse_restitution A B u n e : dot n n = 1 -> normal_inverse_mass A B n <> 0 ->
  let v_n := dot (relative_velocity A B u) n in
  let j := normal_impulse e v_n (normal_inverse_mass A B n) in
  dot (relative_velocity A B (apply_pair_impulse A B u (smul j n))) n = - e * v_n.
Proof. intros Hn Hk v_n j. rewrite normal_response by exact Hn. fold v_n. unfold j, normal_impulse. field. exact Hk. Qed.

(*@ impulse.normal *)
(* ... and no other size does it. *)
Theorem normal_impulse_unique A B u n e j : dot n n = 1 -> normal_inverse_mass A B n <> 0 ->
  let v_n := dot (relative_velocity A B u) n in
  dot (relative_velocity A B (apply_pair_impulse A B u (smul j n))) n = - e * v_n ->
  j = normal_impulse e v_n (normal_inverse_mass A B n).
Proof.
  intros Hn Hk v_n. rewrite normal_response by exact Hn. fold v_n. intros H. unfold normal_impulse.
  apply (Rmult_eq_reg_r (normal_inverse_mass A B n)); [|exact Hk]. field_simplify; [lra|exact Hk].
Qed.

(*@ impulse.normal *)
(* A push, never a pull, for bodies that approach. *)
Theorem normal_impulse_pushes e v_n k : 0 < k -> 0 <= e -> v_n < 0 -> 0 < normal_impulse e v_n k.
Proof. intros. unfold normal_impulse. apply Rdiv_lt_0_compat; nra. Qed.

(*@ impulse.normal_printed *)
(* The sheet's 1 - e leaves v_n' = +e v_n ... *)
Theorem printed_impulse_outcome A B u n e : dot n n = 1 -> normal_inverse_mass A B n <> 0 ->
  let v_n := dot (relative_velocity A B u) n in
  let j := normal_impulse_printed e v_n (normal_inverse_mass A B n) in
  dot (relative_velocity A B (apply_pair_impulse A B u (smul j n))) n = e * v_n.
Proof.
  intros Hn Hk v_n j. rewrite normal_response by exact Hn. fold v_n. unfold j, normal_impulse_printed. field. exact Hk.
Qed.

(*@ impulse.normal_printed *)
(* ... so approaching bodies never separate, whatever e >= 0. *)
Theorem printed_impulse_never_separates A B u n e : dot n n = 1 -> normal_inverse_mass A B n <> 0 -> 0 <= e ->
  let v_n := dot (relative_velocity A B u) n in
  let j := normal_impulse_printed e v_n (normal_inverse_mass A B n) in
  v_n < 0 -> dot (relative_velocity A B (apply_pair_impulse A B u (smul j n))) n <= 0.
Proof. intros Hn Hk He v_n j Hv. unfold j, v_n in *. rewrite printed_impulse_outcome by assumption. nra. Qed.

(*@ impulse.normal_printed *)
(* Conservation cannot see the misprint: both impulses go along n, and agree at e = 0. *)
Theorem printed_impulse_agrees_without_restitution v_n k : normal_impulse_printed 0 v_n k = normal_impulse 0 v_n k.
Proof. unfold normal_impulse_printed, normal_impulse. f_equal. ring. Qed.

(*@ impulse.apply *)
(* An immovable body stays as it is. *)
Theorem immovable_stays r u j :
  apply_impulse {| inverse_mass := 0; inverse_inertia := mzero; arm := r |} u j = u.
Proof. destruct u as [v w]. unfold apply_impulse; cbn [inverse_mass inverse_inertia arm linear angular]. f_equal; vring. Qed.

(*@ impulse.apply *)
(* Impulses at one point add, and their order does not matter. *)
Theorem impulses_add B u j i : apply_impulse B (apply_impulse B u j) i = apply_impulse B u (vadd j i).
Proof. unfold apply_impulse; cbn [linear angular]. f_equal; vring. Qed.

(*@ impulse.apply_pair *)
(* Which of the two is called A is a name: swap the bodies, turn j about, and the outcome is the same. *)
Theorem pair_symmetry A B u j :
  let swap p := {| of_A := of_B p; of_B := of_A p |} in
  apply_pair_impulse B A (swap u) (smul (-1) j) = swap (apply_pair_impulse A B u j).
Proof.
  unfold apply_pair_impulse, apply_impulse; cbn [of_A of_B linear angular]. do 2 f_equal; vring.
Qed.
