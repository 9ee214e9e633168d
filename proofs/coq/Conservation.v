(* Equal and opposite impulses at a common point: momentum, angular momentum and the energy account. *)
Require Import Vec3 Laws Impulse.

(* One body of mass m and inertia I, 1/m and I^-1 as the impact sees them. *)
Definition movable m I (b : ImpactBody) := m <> 0 /\ inverse_mass b = / m /\ mm I (inverse_inertia b) = mid.

Lemma momentum_gain m I b u j : movable m I b -> linear_momentum m (linear (apply_impulse b u j)) = vadd (linear_momentum m (linear u)) j.
Proof. intros (Hm & E & _). unfold linear_momentum, apply_impulse; cbn [linear]. rewrite E. vfield; exact Hm. Qed.
Lemma spin_gain m I b u j : movable m I b ->
  mv I (angular (apply_impulse b u j)) = vadd (mv I (angular u)) (cross (arm b) j).
Proof. intros (_ & _ & E). unfold apply_impulse; cbn [angular]. rewrite mv_add, mv_mm, E, mv_id. reflexivity. Qed.

(*@ momentum.angular *)
(* Angular momentum about o changes by the moment of the impulse about o; x is the centre, x + arm the contact. *)
Theorem angular_momentum_gain m I b u j x o : movable m I b ->
  let L v := angular_momentum m I x (linear v) (angular v) o in
  L (apply_impulse b u j) = vadd (L u) (cross (vsub (vadd x (arm b)) o) j).
Proof.
  intros H L. unfold L, angular_momentum. rewrite (momentum_gain m I), (spin_gain m I) by exact H.
  generalize (mv I (angular u)). vring.
Qed.

(*@ momentum.angular *)
(* About the contact point an impulse, of whatever direction, has no moment: what remains true against the ground. *)
Theorem angular_momentum_about_the_contact m I b u j x : movable m I b ->
  let L v := angular_momentum m I x (linear v) (angular v) (vadd x (arm b)) in L (apply_impulse b u j) = L u.
Proof.
  intros H L. unfold L. rewrite (angular_momentum_gain m I b u j x _ H).
  generalize (angular_momentum m I x (linear u) (angular u) (vadd x (arm b))). vring.
Qed.

Section Pair.
Variables (mA mB : R) (IA IB : M) (A B : ImpactBody) (xA xB p : V).
Hypothesis HA : movable mA IA A. Hypothesis HB : movable mB IB B.
Hypothesis armA : arm A = vsub p xA. Hypothesis armB : arm B = vsub p xB.

Definition pair_momentum mA mB u :=
  vadd (linear_momentum mA (linear (of_A u))) (linear_momentum mB (linear (of_B u))).
Definition pair_angular_momentum mA mB IA IB xA xB o u :=
  vadd (angular_momentum mA IA xA (linear (of_A u)) (angular (of_A u)) o)
       (angular_momentum mB IB xB (linear (of_B u)) (angular (of_B u)) o).
Definition pair_energy mA mB IA IB u :=
  kinetic_energy mA IA (linear (of_A u)) (angular (of_A u)) + kinetic_energy mB IB (linear (of_B u)) (angular (of_B u)).

(*@ momentum.linear *)
(* An impulse between two movable bodies keeps the sum of their momenta. *)
Theorem pair_keeps_momentum u j : pair_momentum mA mB (apply_pair_impulse A B u j) = pair_momentum mA mB u.
Proof.
  unfold pair_momentum, apply_pair_impulse; cbn [of_A of_B].
  rewrite (momentum_gain mA IA), (momentum_gain mB IB) by assumption. unfold linear_momentum. vring.
Qed.

(*@ impulse.apply_pair *)
(* Two movable bodies: angular momentum about any point o is kept, for every impulse j, because both arms go to the
   same point p. *)
Theorem pair_keeps_angular_momentum o u j :
  pair_angular_momentum mA mB IA IB xA xB o (apply_pair_impulse A B u j) = pair_angular_momentum mA mB IA IB xA xB o u.
Proof.
  unfold pair_angular_momentum, apply_pair_impulse; cbn [of_A of_B].
  rewrite (angular_momentum_gain mA IA), (angular_momentum_gain mB IB) by assumption. rewrite armA, armB.
  match goal with |- vadd (vadd ?a _) (vadd ?b _) = _ => generalize a b end. clear. vring.
Qed.
End Pair.

(* -- energy, for an arbitrary impulse vector -- *)
(* What an impulse does to the energy of one body: the work at the mean velocity of its contact point. *)
Lemma body_energy_gain m I b u j : movable m I b -> sym I ->
  let T v := kinetic_energy m I (linear v) (angular v) in
  T (apply_impulse b u j) - T u = dot j (vadd (contact_velocity b u) (contact_velocity b (apply_impulse b u j))) / 2.
Proof.
  intros (Hm & Ew & EI) HS T. unfold T, kinetic_energy, contact_velocity, point_velocity, apply_impulse; cbn [linear angular].
  set (h := cross (arm b) j). set (w := angular u). set (v := linear u). rewrite Ew.
  assert (S : dot (vadd w (mv (inverse_inertia b) h)) (mv I (vadd w (mv (inverse_inertia b) h)))
              = dot w (mv I w) + 2 * dot w h + dot h (mv (inverse_inertia b) h)).
  { rewrite mv_add, dot_add_l, 2!dot_add_r.
    assert (E : mv I (mv (inverse_inertia b) h) = h) by (rewrite mv_mm, EI; apply mv_id).
    rewrite E, (sym_dot I (mv (inverse_inertia b) h) w HS), E, (dot_comm (mv (inverse_inertia b) h) h). ring. }
  rewrite S. generalize (dot w (mv I w)). unfold h. clear S HS EI Ew h T. vfield; exact Hm.
Qed.

(*@ energy.impulse *)
(* Two movable bodies: the energy an impulse adds is j.(v_r + v_r')/2, friction or not. *)
Theorem pair_energy_gain mA mB IA IB A B u j : movable mA IA A -> movable mB IB B -> sym IA -> sym IB ->
  pair_energy mA mB IA IB (apply_pair_impulse A B u j) - pair_energy mA mB IA IB u
  = impulse_energy j (relative_velocity A B u) (relative_velocity A B (apply_pair_impulse A B u j)).
Proof.
  intros HA HB SA SB. unfold pair_energy.
  pose proof (body_energy_gain mA IA A (of_A u) (smul (-1) j) HA SA) as EA.
  pose proof (body_energy_gain mB IB B (of_B u) j HB SB) as EB. cbv zeta in EA, EB.
  unfold apply_pair_impulse, relative_velocity, impulse_energy; cbn [of_A of_B].
  match goal with |- ?x + ?y - (?z + ?w) = _ => replace (x + y - (z + w)) with ((x - z) + (y - w)) by ring end.
  rewrite EA, EB. generalize (contact_velocity A (of_A u)) (contact_velocity B (of_B u))
    (contact_velocity A (apply_impulse A (of_A u) (smul (-1) j))) (contact_velocity B (apply_impulse B (of_B u) j)).
  clear. vfield.
Qed.

(* An immovable body A: only B's energy counts. *)
Definition immovable (A : ImpactBody) := inverse_mass A = 0 /\ inverse_inertia A = mzero.
Lemma immovable_kept A u j : immovable A -> apply_impulse A u j = u.
Proof. intros (E & F). destruct A as [w C r]. cbn in *. subst. apply immovable_stays. Qed.

(*@ energy.impulse *)
(* Against the ground: A immovable and at rest, one movable body B. *)
Theorem ground_energy_gain m I A B u j : immovable A -> linear (of_A u) = vzero -> angular (of_A u) = vzero ->
  movable m I B -> sym I ->
  let T p := kinetic_energy m I (linear (of_B p)) (angular (of_B p)) in
  T (apply_pair_impulse A B u j) - T u
  = impulse_energy j (relative_velocity A B u) (relative_velocity A B (apply_pair_impulse A B u j)).
Proof.
  intros HA V0 W0 HB S T. unfold T. pose proof (body_energy_gain m I B (of_B u) j HB S) as E. cbv zeta in E.
  unfold apply_pair_impulse, relative_velocity, impulse_energy; cbn [of_A of_B]. rewrite E.
  rewrite (immovable_kept A) by exact HA.
  assert (R : contact_velocity A (of_A u) = vzero).
  { unfold contact_velocity, point_velocity. rewrite V0, W0. vring. }
  rewrite R. generalize (contact_velocity B (of_B u)) (contact_velocity B (apply_impulse B (of_B u) j)). clear. vfield.
Qed.

(* The energy of a contact changes by impulse_energy, in either case; so the rest needs no bodies. *)
Section Account.
Variables (A B : ImpactBody) (u : PairVelocity).
Definition gain A B u j := impulse_energy j (relative_velocity A B u) (relative_velocity A B (apply_pair_impulse A B u j)).

(*@ energy.impulse *)
(* In terms of K alone, whatever the bodies: gain is impulse_energy at the velocities before and after j. *)
Theorem gain_by_K j :
  gain A B u j = dot j (relative_velocity A B u) + dot j (mv (effective_inverse_mass A B) j) / 2.
Proof.
  set (v_r := relative_velocity A B u). unfold gain, impulse_energy. rewrite response. fold v_r. generalize (effective_inverse_mass A B) v_r. clear. vfield.
Qed.

(*@ impulse.normal *)
(* Case P-05, and for two bodies alike: the normal impulse takes (1 - e^2) v_n^2 / (2 k_nn) from the energy. *)
Theorem normal_impulse_energy n e : dot n n = 1 -> normal_inverse_mass A B n <> 0 ->
  let v_n := dot (relative_velocity A B u) n in let k := normal_inverse_mass A B n in
  gain A B u (smul (normal_impulse e v_n k) n) = - (1 - e ^ 2) * v_n ^ 2 / (2 * k).
Proof.
  intros Hn Hk v_n k. unfold gain, impulse_energy. rewrite dot_smul_l, dot_add_r, !(dot_comm n).
  pose proof (normal_impulse_restitution A B u n e Hn Hk) as E. cbv zeta in E. fold v_n k in E.
  rewrite E. fold v_n. unfold normal_impulse. field. exact Hk.
Qed.

(*@ impulse.normal *)
Theorem normal_impulse_never_adds_energy n e : dot n n = 1 -> 0 < normal_inverse_mass A B n -> 0 <= e <= 1 ->
  gain A B u (smul (normal_impulse e (dot (relative_velocity A B u) n) (normal_inverse_mass A B n)) n) <= 0.
Proof.
  intros Hn Hk He. pose proof (normal_impulse_energy n e Hn (Rgt_not_eq _ _ Hk)) as E. cbv zeta in E. rewrite E.
  set (k := normal_inverse_mass A B n) in *. set (v_r := relative_velocity A B u).
  replace (- (1 - e ^ 2) * (dot v_r n) ^ 2 / (2 * k)) with (- ((1 - e ^ 2) * (dot v_r n) ^ 2 * / (2 * k))) by (field; lra).
  assert (0 <= (1 - e ^ 2) * (dot v_r n) ^ 2 * / (2 * k)); [|lra].
  apply Rmult_le_pos; [apply Rmult_le_pos; [nra|apply pow2_ge_0]|left; apply Rinv_0_lt_compat; lra].
Qed.

(*@ impulse.normal_printed *)
(* The misprint loses exactly as much energy: an energy balance cannot tell the two apart. *)
Theorem printed_impulse_energy n e : dot n n = 1 -> normal_inverse_mass A B n <> 0 ->
  let v_n := dot (relative_velocity A B u) n in let k := normal_inverse_mass A B n in
  gain A B u (smul (normal_impulse_printed e v_n k) n) = - (1 - e ^ 2) * v_n ^ 2 / (2 * k).
Proof.
  intros Hn Hk v_n k. unfold gain, impulse_energy. rewrite dot_smul_l, dot_add_r, !(dot_comm n).
  pose proof (printed_impulse_outcome A B u n e Hn Hk) as E. cbv zeta in E. fold v_n k in E.
  rewrite E. fold v_n. unfold normal_impulse_printed. field. exact Hk.
Qed.

(*@ energy.impulse *)
(* An impulse that opposes the velocity before and the velocity after never adds energy. *)
Theorem opposing_impulse_never_adds_energy j : dot j (relative_velocity A B u) <= 0 ->
  dot j (relative_velocity A B (apply_pair_impulse A B u j)) <= 0 -> gain A B u j <= 0.
Proof. intros. unfold gain, impulse_energy. rewrite dot_add_r. lra. Qed.
End Account.
