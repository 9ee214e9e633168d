(* Planar impact with friction by Routh's process, and the energetic law in three dimensions. *)
Require Import Vec3 Laws Calculus.

Section Planar.
Variable i : PlanarImpact.
Hypothesis Hnn : 0 < k_nn i. Hypothesis Htt : 0 < k_tt i. Hypothesis Hdet : k_tn i ^ 2 < k_nn i * k_tt i.
Hypothesis approach : v_n i < 0. Hypothesis slip : 0 <= v_t i.
Hypothesis He : 0 <= e i <= 1. Hypothesis Hmu : 0 <= mu_d i <= mu_s i.

Definition dv_t i leg := k_tn i + friction leg * k_tt i.
Let first := slip_leg i. Let second := leg_without_slip i.
Let rate := k_tn i - mu_d i * k_tt i.
Definition stops i := 0 < v_t i /\ k_tn i - mu_d i * k_tt i < 0.
Definition p_s i := - v_t i / (k_tn i - mu_d i * k_tt i).

(* -- the legs -- *)
(* On the leg without slip: normal speed grows; friction opposes the slip it lets start, or there is none; it stays
   in the cone. *)
Lemma second_leg : 0 < dv_n i second /\ friction second * dv_t i second <= 0 /\ Rabs (friction second) <= mu_s i.
Proof.
  unfold second, leg_without_slip, dv_n, dv_t.
  assert (Hi : 0 < / k_tt i) by (apply Rinv_0_lt_compat, Htt).
  assert (Q : k_tn i * k_tn i / k_tt i < k_nn i).
  { apply (Rmult_lt_reg_r (k_tt i)); [exact Htt|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. nra. }
  (* a friction coefficient below |k_tn|/k_tt cannot turn the slope *)
  assert (W : forall x, 0 <= x -> x * k_tt i < Rabs (k_tn i) -> x * Rabs (k_tn i) < k_nn i).
  { intros x Hx L. eapply Rle_lt_trans; [|exact Q].
    assert (A : Rabs (k_tn i) * Rabs (k_tn i) = k_tn i * k_tn i)
      by (unfold Rabs; destruct (Rcase_abs (k_tn i)); ring).
    rewrite <- A. apply (Rmult_le_reg_r (k_tt i)); [exact Htt|].
    replace (Rabs (k_tn i) * Rabs (k_tn i) / k_tt i * k_tt i) with (Rabs (k_tn i) * Rabs (k_tn i)) by (field; lra).
    pose proof (Rabs_pos (k_tn i)). nra. }
  destruct (Rle_dec (Rabs (k_tn i)) (mu_s i * k_tt i)) as [S|S]; cbn [friction].
  - split; [|split].
    + replace (k_nn i + - k_tn i / k_tt i * k_tn i) with (k_nn i - k_tn i * k_tn i / k_tt i) by (field; lra). lra.
    + right. field. lra.
    + replace (- k_tn i / k_tt i) with (- (k_tn i * / k_tt i)) by (field; lra).
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (/ k_tt i)) by lra.
      apply (Rmult_le_reg_r (k_tt i)); [exact Htt|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact S.
  - assert (L : mu_d i * k_tt i < Rabs (k_tn i)) by nra.
    specialize (W (mu_d i) (proj1 Hmu) L).
    destruct (Rlt_dec (k_tn i) 0) as [N|N]; cbn [friction].
    + rewrite Rabs_left in * by exact N. rewrite Rabs_pos_eq by lra. split; [|split]; nra.
    + rewrite (Rabs_pos_eq (k_tn i)) in * by lra. rewrite Rabs_Ropp, Rabs_pos_eq by lra. split; [|split]; nra.
Qed.
(* A slip that is not slowed cannot jam. *)
Lemma lasting_slip : 0 <= rate -> 0 < dv_n i first.
Proof.
  intros L. unfold rate in L. unfold dv_n, first, slip_leg; cbn [friction].
  assert (0 <= mu_d i * k_tt i) by nra.
  apply (Rmult_lt_reg_r (k_tt i)); [exact Htt|]. rewrite Rmult_0_l. nra.
Qed.
Lemma p_s_pos : stops i -> 0 < p_s i.
Proof.
  intros [V L]. unfold p_s. replace (- v_t i / (k_tn i - mu_d i * k_tt i)) with (v_t i / - (k_tn i - mu_d i * k_tt i)) by (field; lra).
  apply Rdiv_lt_0_compat; lra.
Qed.
Lemma slip_at_p_s : stops i -> v_t i + dv_t i first * p_s i = 0.
Proof. intros [V L]. unfold dv_t, first, slip_leg, p_s; cbn [friction]. field. lra. Qed.

(* -- the process: tangential impulse, velocities and normal work after the normal impulse p -- *)
Definition single i := if Rgt_dec (v_t i) 0 then slip_leg i else leg_without_slip i.
Definition stops_dec : {stops i} + {~ stops i}.
Proof.
  unfold stops. destruct (Rlt_dec 0 (v_t i)); [|right; tauto]. destruct (Rlt_dec (k_tn i - mu_d i * k_tt i) 0); [left|right]; tauto.
Defined.
Definition on_second_leg p := stops i /\ p_s i < p.
Lemma on_second_leg_dec p : {on_second_leg p} + {~ on_second_leg p}.
Proof. unfold on_second_leg. destruct stops_dec; [|right; tauto]. destruct (Rlt_dec (p_s i) p); [left|right]; tauto. Qed.
Definition start_leg := if stops_dec then first else single i.
Definition tangential_impulse p :=
  if on_second_leg_dec p then friction first * p_s i + friction second * (p - p_s i) else friction start_leg * p.
Definition normal_speed p := v_n i + k_nn i * p + k_tn i * tangential_impulse p.
Definition slip_speed p := v_t i + k_tn i * p + k_tt i * tangential_impulse p.
(* normal speed is linear in p on each leg, so its integral from 0 is a sum of trapezia *)
Definition normal_work p :=
  if on_second_leg_dec p then (v_n i + normal_speed (p_s i)) / 2 * p_s i + (normal_speed (p_s i) + normal_speed p) / 2 * (p - p_s i)
  else (v_n i + normal_speed p) / 2 * p.
(* what the impulse so far has added to the kinetic energy: j.(v + v')/2 *)
Definition energy_gain p :=
  p * (v_n i + normal_speed p) / 2 + tangential_impulse p * (v_t i + slip_speed p) / 2.

Lemma at_p_s : ~ on_second_leg (p_s i). Proof. unfold on_second_leg. lra. Qed.
Lemma start_leg_speed p : ~ on_second_leg p -> normal_speed p = v_n i + dv_n i start_leg * p.
Proof. intros N. unfold normal_speed, tangential_impulse. destruct (on_second_leg_dec p); [contradiction|]. unfold dv_n. ring. Qed.
Lemma start_leg_slip p : ~ on_second_leg p -> slip_speed p = v_t i + dv_t i start_leg * p.
Proof. intros N. unfold slip_speed, tangential_impulse. destruct (on_second_leg_dec p); [contradiction|]. unfold dv_t. ring. Qed.
Lemma start_leg_is : stops i -> start_leg = first.
Proof. intros S. unfold start_leg. destruct stops_dec; [reflexivity|contradiction]. Qed.
Lemma second_leg_speed p : on_second_leg p -> normal_speed p = normal_speed (p_s i) + dv_n i second * (p - p_s i).
Proof.
  intros O. rewrite (start_leg_speed _ at_p_s), (start_leg_is (proj1 O)). unfold normal_speed, tangential_impulse.
  destruct (on_second_leg_dec p); [|contradiction]. unfold dv_n. ring.
Qed.
Lemma second_leg_slip p : on_second_leg p -> slip_speed p = dv_t i second * (p - p_s i).
Proof.
  intros O. pose proof (slip_at_p_s (proj1 O)) as Z. unfold slip_speed, tangential_impulse.
  destruct (on_second_leg_dec p); [|contradiction]. unfold dv_t in *. lra.
Qed.
Lemma slip_goes_on p : 0 <= p -> ~ on_second_leg p -> friction start_leg * (v_t i + slip_speed p) <= 0.
Proof.
  intros Hp N. rewrite (start_leg_slip p N). unfold start_leg. destruct stops_dec as [S|S].
  - pose proof (slip_at_p_s S) as Z. destruct S as [V L]. unfold on_second_leg, stops in N.
    assert (B : p <= p_s i) by (apply Rnot_lt_le; intros X; apply N; repeat split; assumption).
    unfold first, slip_leg, dv_t in *; cbn [friction] in *.
    assert (0 <= (k_tn i - mu_d i * k_tt i) * (p - p_s i)) by nra.
    assert (0 <= v_t i + (k_tn i + - mu_d i * k_tt i) * p) by lra.
    assert (0 <= mu_d i * (v_t i + (v_t i + (k_tn i + - mu_d i * k_tt i) * p))) by (apply Rmult_le_pos; lra). lra.
  - unfold single. destruct (Rgt_dec (v_t i) 0) as [V|V].
    + assert (L : 0 <= rate) by (unfold rate; apply Rnot_lt_le; intros X; apply S; split; lra).
      unfold rate in L. unfold slip_leg, dv_t; cbn [friction].
      assert (0 <= (k_tn i - mu_d i * k_tt i) * p) by (apply Rmult_le_pos; assumption).
      assert (0 <= mu_d i * (v_t i + (v_t i + (k_tn i + - mu_d i * k_tt i) * p))) by (apply Rmult_le_pos; lra). lra.
    + apply Rnot_gt_le in V. replace (v_t i) with 0 by lra. pose proof second_leg as (_ & D & _). unfold second in D.
      set (g := friction (leg_without_slip i)) in *. set (d := dv_t i (leg_without_slip i)) in *.
      assert (0 <= - (g * d) * p) by (apply Rmult_le_pos; lra). lra.
Qed.

(*@ friction.stronge_planar *)
(* In the docstring's domain. Friction only takes: at any moment p of the process the energy gained is at most what the
   normal direction has done. *)
Theorem friction_only_takes p : 0 <= p -> energy_gain p <= normal_work p.
Proof.
  intros Hp. unfold energy_gain, normal_work. destruct (on_second_leg_dec p) as [O|O].
  - pose proof (second_leg_speed p O) as N. pose proof (second_leg_slip p O) as T. rewrite T.
    pose proof (slip_goes_on (p_s i) (Rlt_le _ _ (p_s_pos (proj1 O))) at_p_s) as F.
    pose proof (start_leg_speed _ at_p_s) as N0. pose proof (start_leg_slip _ at_p_s) as T0.
    pose proof (slip_at_p_s (proj1 O)) as Z. pose proof (start_leg_is (proj1 O)) as Es. rewrite Es in *.
    assert (J : tangential_impulse p = friction first * p_s i + friction second * (p - p_s i))
      by (unfold tangential_impulse; destruct (on_second_leg_dec p); [reflexivity|contradiction]).
    rewrite J. rewrite T0, Z in F.
    pose proof second_leg as (_ & D & _). pose proof (p_s_pos (proj1 O)) as P. destruct O as [S B].
    rewrite N, N0. unfold dv_n, dv_t in *.
    set (f := friction first) in *. set (g := friction second) in *. set (s := p_s i) in *. set (x := p - s) in *.
    assert (X : 0 < x) by (unfold x; lra). replace p with (s + x) by (unfold x; ring).
    assert (F' : f * v_t i * s <= 0) by nra.
    assert (D' : g * (k_tn i + g * k_tt i) * x ^ 2 <= 0) by (pose proof (pow2_ge_0 x); nra).
    (* the two sides differ by the two legs' friction work *)
    assert (E : (s + x) * (v_n i + (v_n i + (k_nn i + f * k_tn i) * s + (k_nn i + g * k_tn i) * x)) / 2
        + (f * s + g * x) * (v_t i + (k_tn i + g * k_tt i) * x) / 2
      = (v_n i + (v_n i + (k_nn i + f * k_tn i) * s)) / 2 * s
        + ((v_n i + (k_nn i + f * k_tn i) * s) + (v_n i + (k_nn i + f * k_tn i) * s + (k_nn i + g * k_tn i) * x)) / 2 * x
        + f * v_t i * s / 2 + g * (k_tn i + g * k_tt i) * x ^ 2 / 2
        + g * x * (v_t i + (k_tn i + f * k_tt i) * s) / 2).
    { field. }
    rewrite E, Z. lra.
  - pose proof (slip_goes_on p Hp O) as F.
    assert (J : tangential_impulse p = friction start_leg * p)
      by (unfold tangential_impulse; destruct (on_second_leg_dec p); [contradiction|reflexivity]).
    rewrite J. nra.
Qed.

(*@ friction.stronge_planar *)
(* In the docstring's domain: the impulse never leaves the cone of mu_s. *)
Theorem planar_in_the_cone p : 0 <= p -> Rabs (tangential_impulse p) <= mu_s i * p.
Proof.
  intros Hp. pose proof second_leg as (_ & _ & C).
  assert (C1 : Rabs (friction first) <= mu_s i) by (unfold first, slip_leg; cbn; rewrite Rabs_Ropp, Rabs_pos_eq; lra).
  unfold tangential_impulse. destruct (on_second_leg_dec p) as [O|O].
  - pose proof (p_s_pos (proj1 O)). destruct O as [_ B].
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_pos_eq (p_s i)), (Rabs_pos_eq (p - p_s i)) by lra. nra.
  - rewrite Rabs_mult, (Rabs_pos_eq p) by exact Hp. apply Rmult_le_compat_r; [exact Hp|].
    unfold start_leg, single. destruct stops_dec; [exact C1|]. destruct (Rgt_dec (v_t i) 0); [exact C1|exact C].
Qed.

(* -- where the three rules end -- *)
(* What each rule asks of the end p, given the end p_c of compression. *)
Definition ends rule p_c p := match rule with
  | stronge => normal_work p - normal_work p_c = - e i ^ 2 * normal_work p_c
  | poisson => p = (1 + e i) * p_c
  | newton => normal_speed p = - e i * v_n i end.

Lemma half_slope a x : 0 < a -> 0 <= x -> a * sqrt (2 * x / a) * sqrt (2 * x / a) / 2 = x.
Proof.
  intros Ha Hx. rewrite Rmult_assoc, sqrt_sqrt by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat, Ha]). field. lra.
Qed.

Lemma end_after rule p_c w a : 0 < a -> 0 < p_c -> w <= 0 -> p_c <= end_of_restitution rule (e i) (v_n i) p_c w a.
Proof.
  intros Ha Hp Hw. destruct rule; cbn [end_of_restitution].
  - pose proof (sqrt_pos (2 * (- e i * e i * w) / a)). lra.
  - nra.
  - assert (0 <= - e i * v_n i / a) by (unfold Rdiv; apply Rmult_le_pos; [nra|left; apply Rinv_0_lt_compat, Ha]). lra.
Qed.
(* the end on a leg of slope a that already carries the end of compression *)
Lemma finish rule p_c a : 0 < a -> 0 < p_c -> normal_work p_c <= 0 ->
  let p := end_of_restitution rule (e i) (v_n i) p_c (normal_work p_c) a in
  normal_speed p = a * (p - p_c) -> normal_work p - normal_work p_c = a * (p - p_c) ^ 2 / 2 ->
  0 <= normal_speed p /\ ends rule p_c p.
Proof.
  intros Ha Hp Hw p V W. pose proof (end_after rule p_c (normal_work p_c) a Ha Hp Hw) as L. fold p in L.
  split; [rewrite V; nra|].
  unfold ends. destruct rule; cbn [end_of_restitution] in p.
  - rewrite W. replace (p - p_c) with (sqrt (2 * (- e i * e i * normal_work p_c) / a)) by (unfold p; ring).
    pose proof (half_slope a (- e i * e i * normal_work p_c) Ha ltac:(nra)) as S. lra.
  - reflexivity.
  - rewrite V. unfold p. field. lra.
Qed.

(* Every rule on the leg the impact starts on, as long as the end lies on it. *)
Lemma start_leg_end rule a : a = dv_n i start_leg -> 0 < a ->
  let p_c := - v_n i / a in
  let p := end_of_restitution rule (e i) (v_n i) p_c (v_n i * p_c / 2) a in
  ~ on_second_leg p ->
  0 < p_c <= p /\ normal_speed p_c = 0 /\ normal_work p_c <= 0 /\ 0 <= normal_speed p /\ ends rule p_c p
  /\ tangential_impulse p = friction start_leg * p.
Proof.
  intros Ea Ha p_c p N.
  assert (C : 0 < p_c) by (unfold p_c; apply Rdiv_lt_0_compat; lra).
  assert (A : a * p_c = - v_n i) by (unfold p_c; field; lra).
  assert (L : p_c <= p) by (apply end_after; [exact Ha|exact C|nra]).
  assert (NC : ~ on_second_leg p_c) by (intros [S B]; apply N; split; [exact S|lra]).
  assert (V0 : normal_speed p_c = 0) by (rewrite start_leg_speed, <- Ea by exact NC; lra).
  assert (W0 : normal_work p_c = v_n i * p_c / 2).
  { unfold normal_work. destruct (on_second_leg_dec p_c); [contradiction|]. rewrite V0. field. }
  assert (V : normal_speed p = a * (p - p_c)) by (rewrite start_leg_speed, <- Ea by exact N; lra).
  assert (W : normal_work p - normal_work p_c = a * (p - p_c) ^ 2 / 2).
  { rewrite W0. unfold normal_work. destruct (on_second_leg_dec p); [contradiction|]. rewrite V.
    replace (v_n i) with (- (a * p_c)) by lra. field. }
  pose proof (finish rule p_c a Ha C) as F. rewrite W0 in F. fold p in F. rewrite W0 in W.
  destruct (F ltac:(nra) V W) as [F1 F2].
  repeat split; try assumption.
  - rewrite W0. nra.
  - unfold tangential_impulse. destruct (on_second_leg_dec p); [contradiction|reflexivity].
Qed.

(*@ friction.stronge_planar *)
(* In the docstring's domain. The closed form is the process: the impulse returned lies on it, compression ends where v_n = 0, restitution where
   the rule says, with the bodies separating. *)
Theorem planar_impulse_is_the_process rule :
  let j := planar_impulse rule i in exists p_c, 0 < p_c <= j_n j
    /\ j_t j = tangential_impulse (j_n j)
    /\ normal_speed p_c = 0 /\ normal_work p_c <= 0
    /\ 0 <= normal_speed (j_n j) /\ ends rule p_c (j_n j).
Proof.
  cbv zeta. unfold planar_impulse. cbv zeta. fold first second rate.
  destruct (Rgt_dec (v_t i) 0) as [V|V]; [destruct (Rlt_dec rate 0) as [L|L]|].
  - (* the slip stops at p_s *)
    assert (S : stops i) by (split; [lra|exact L]). pose proof (p_s_pos S) as P.
    change (- v_t i / rate) with (p_s i).
    pose proof (start_leg_is S) as Es.
    pose proof (start_leg_speed _ at_p_s) as Vs. rewrite Es in Vs. rewrite <- Vs.
    pose proof second_leg as (Hb & _ & _). set (b := dv_n i second) in *. set (s := p_s i) in *.
    destruct (Rge_dec (normal_speed s) 0) as [G|G].
    + (* compression ends while the contact slips *)
      set (a := dv_n i first) in *.
      assert (Ha : 0 < a) by (apply (Rmult_lt_reg_r s); [exact P|lra]).
      set (p_c := - v_n i / a).
      assert (C : 0 < p_c) by (unfold p_c; apply Rdiv_lt_0_compat; lra).
      assert (A : a * p_c = - v_n i) by (unfold p_c; field; lra).
      assert (Vs' : normal_speed s = a * (s - p_c)) by lra.
      assert (Cs : p_c <= s) by (apply (Rmult_le_reg_l a); lra).
      destruct (end_on_first_leg rule (e i) (v_n i) p_c (v_n i * p_c / 2) s (normal_speed s)) eqn:F.
      * pose proof (start_leg_end rule a ltac:(unfold a; rewrite Es; reflexivity) Ha) as E. cbv zeta in E. fold p_c in E.
        cbn [j_n j_t]. set (p := end_of_restitution rule (e i) (v_n i) p_c (v_n i * p_c / 2) a) in *.
        assert (B : p <= s).
        { unfold p. destruct rule; cbn [end_of_restitution end_on_first_leg] in *.
          - destruct (Rle_dec (- e i * e i * (v_n i * p_c / 2)) (normal_speed s * (s - p_c) / 2)) as [Q|Q]; [|discriminate].
            assert (X : sqrt (2 * (- e i * e i * (v_n i * p_c / 2)) / a) <= s - p_c); [|lra].
            rewrite <- (sqrt_pow2 (s - p_c)) by lra. apply sqrt_le_1_alt.
            apply (Rmult_le_reg_l a); [exact Ha|].
            replace (a * (2 * (- e i * e i * (v_n i * p_c / 2)) / a)) with (2 * (- e i * e i * (v_n i * p_c / 2))) by (field; lra).
            rewrite Vs' in Q. lra.
          - destruct (Rle_dec ((1 + e i) * p_c) s); [assumption|discriminate].
          - destruct (Rle_dec (- e i * v_n i) (normal_speed s)) as [Q|Q]; [|discriminate].
            apply (Rmult_le_reg_l a); [exact Ha|].
            replace (a * (p_c + - e i * v_n i / a)) with (a * p_c + - e i * v_n i) by (field; lra). lra. }
        destruct (E ltac:(intros [_ X]; unfold s in B; lra)) as (E1 & E2 & E3 & E4 & E5 & E6).
        exists p_c. repeat split; try tauto; try lra. rewrite E6, Es. reflexivity.
      * set (p := end_on_second_leg rule (e i) (v_n i) p_c (v_n i * p_c / 2) s (normal_speed s) b). cbn [j_n j_t].
        assert (NC : ~ on_second_leg p_c) by (intros [_ X]; unfold s in Cs; lra).
        assert (V0 : normal_speed p_c = 0) by (rewrite start_leg_speed, Es by exact NC; fold a; lra).
        assert (W0 : normal_work p_c = v_n i * p_c / 2).
        { unfold normal_work. destruct (on_second_leg_dec p_c); [contradiction|]. rewrite V0. field. }
        set (W := - e i * e i * (v_n i * p_c / 2)).
        set (D := normal_speed s * normal_speed s + 2 * b * (W - normal_speed s * (s - p_c) / 2)).
        assert (B : s < p).
        { unfold p. destruct rule; cbn [end_on_second_leg end_on_first_leg] in *; fold W in F |- *.
          - destruct (Rle_dec W (normal_speed s * (s - p_c) / 2)) as [Q|Q]; [discriminate|]. fold D.
            assert (X : normal_speed s < sqrt D).
            { rewrite <- (sqrt_pow2 (normal_speed s)) by lra. apply sqrt_lt_1_alt. split; [apply pow2_ge_0|]. unfold D. nra. }
            assert (0 < (sqrt D - normal_speed s) / b) by (apply Rdiv_lt_0_compat; lra). lra.
          - destruct (Rle_dec ((1 + e i) * p_c) s); [discriminate|lra].
          - destruct (Rle_dec (- e i * v_n i) (normal_speed s)); [discriminate|].
            assert (0 < (- e i * v_n i - normal_speed s) / b) by (apply Rdiv_lt_0_compat; lra). lra. }
        assert (O : on_second_leg p) by (split; [exact S|exact B]).
        pose proof (second_leg_speed p O) as Vp. fold b s in Vp.
        exists p_c. repeat split; try lra.
        -- unfold tangential_impulse. destruct (on_second_leg_dec p); [reflexivity|contradiction].
        -- rewrite W0. nra.
        -- rewrite Vp. nra.
        -- unfold ends. destruct rule; [|reflexivity|].
           ++ assert (Wp : normal_work p = (v_n i + normal_speed s) / 2 * s + (normal_speed s + normal_speed p) / 2 * (p - s)).
              { unfold normal_work. destruct (on_second_leg_dec p); [reflexivity|contradiction]. }
              rewrite Wp, Vp, W0.
              assert (HD : 0 <= D).
              { destruct (Rle_dec W (normal_speed s * (s - p_c) / 2)) as [Q|Q];
                  [|unfold D; pose proof (Rle_0_sqr (normal_speed s)); unfold Rsqr in *; nra].
                exfalso. cbn [end_on_first_leg] in F. fold W in F. destruct (Rle_dec W (normal_speed s * (s - p_c) / 2)); [discriminate|contradiction]. }
              assert (X : b * (p - s) = sqrt D - normal_speed s).
              { unfold p; cbn [end_on_second_leg]. fold W D. field. lra. }
              assert (Y : b * ((normal_speed s + (normal_speed s + b * (p - s))) / 2 * (p - s)) = b * (W - normal_speed s * (s - p_c) / 2)).
              { replace (b * ((normal_speed s + (normal_speed s + b * (p - s))) / 2 * (p - s)))
                  with ((normal_speed s + (normal_speed s + b * (p - s))) / 2 * (b * (p - s))) by ring.
                rewrite X. replace ((normal_speed s + (normal_speed s + (sqrt D - normal_speed s))) / 2 * (sqrt D - normal_speed s))
                  with ((sqrt D * sqrt D - normal_speed s * normal_speed s) / 2) by field.
                rewrite sqrt_sqrt by exact HD. unfold D. field. }
              apply Rmult_eq_reg_l in Y; [|lra]. rewrite Y.
              (* the first leg alone: v_n s/2 + v_s s/2 = w + v_s (s - p_c)/2 *)
              assert (Z : (v_n i + normal_speed s) / 2 * s = v_n i * p_c / 2 + normal_speed s * (s - p_c) / 2).
              { rewrite Vs'. replace (v_n i) with (- (a * p_c)) by lra. field. }
              rewrite Z. unfold W. ring.
           ++ rewrite Vp. unfold p; cbn [end_on_second_leg]. field. lra.
    + (* the slip stops during compression *)
      apply Rnot_ge_lt in G. cbn [j_n j_t].
      set (p_c := s - normal_speed s / b).
      set (w := (v_n i + normal_speed s) * s / 2 + normal_speed s * (p_c - s) / 2).
      assert (Bc : b * (p_c - s) = - normal_speed s) by (unfold p_c; field; lra).
      assert (Cs : s < p_c) by (apply (Rmult_lt_reg_l b); lra).
      assert (Oc : on_second_leg p_c) by (split; [exact S|exact Cs]).
      pose proof (second_leg_speed p_c Oc) as Vc. fold b s in Vc.
      assert (V0 : normal_speed p_c = 0) by lra.
      assert (W0 : normal_work p_c = w).
      { unfold normal_work. destruct (on_second_leg_dec p_c); [|contradiction]. fold s. rewrite V0. unfold w. field. }
      assert (Hw : w <= 0) by (unfold w; nra).
      set (p := end_of_restitution rule (e i) (v_n i) p_c w b).
      assert (Lp : p_c <= p) by (apply end_after; lra).
      assert (O : on_second_leg p) by (split; [exact S|unfold s in *; lra]).
      pose proof (second_leg_speed p O) as Vp. fold b s in Vp.
      assert (Vp' : normal_speed p = b * (p - p_c)) by lra.
      assert (Wp : normal_work p - normal_work p_c = b * (p - p_c) ^ 2 / 2).
      { rewrite W0. unfold normal_work. destruct (on_second_leg_dec p); [|contradiction]. fold s. rewrite Vp'. unfold w.
        replace (normal_speed s) with (- (b * (p_c - s))) by lra. field. }
      pose proof (finish rule p_c b Hb ltac:(lra)) as F. rewrite W0 in F. fold p in F. rewrite W0 in Wp.
      destruct (F Hw Vp' Wp) as [F1 F2].
      exists p_c. repeat split; try lra; try assumption.
      unfold tangential_impulse. destruct (on_second_leg_dec p); [reflexivity|contradiction].
  - (* the slip never stops *)
    assert (NS : ~ stops i) by (intros [_ X]; apply L; exact X).
    assert (Es : start_leg = first).
    { unfold start_leg, single. destruct stops_dec; [reflexivity|]. destruct (Rgt_dec (v_t i) 0); [reflexivity|contradiction]. }
    pose proof (start_leg_end rule (dv_n i first) ltac:(rewrite Es; reflexivity) (lasting_slip ltac:(lra))) as E. cbv zeta in E.
    destruct E as (E1 & E2 & E3 & E4 & E5 & E6); [intros [X _]; exact (NS X)|].
    exists (- v_n i / dv_n i first). cbn [j_n j_t]. rewrite E6, Es. repeat split; tauto.
  - (* no slip to begin with *)
    assert (NS : ~ stops i) by (intros [X _]; apply V; exact X).
    assert (Es : start_leg = second).
    { unfold start_leg, single. destruct stops_dec; [contradiction|]. destruct (Rgt_dec (v_t i) 0); [contradiction|reflexivity]. }
    pose proof second_leg as (Hb & _ & _).
    pose proof (start_leg_end rule (dv_n i second) ltac:(rewrite Es; reflexivity) Hb) as E. cbv zeta in E.
    destruct E as (E1 & E2 & E3 & E4 & E5 & E6); [intros [X _]; exact (NS X)|].
    exists (- v_n i / dv_n i second). cbn [j_n j_t]. rewrite E6, Es. repeat split; tauto.
Qed.

(*@ friction.stronge_planar *)
(* In the docstring's domain. Stronge's rule never adds energy: what the whole impact gains is at most (1 - e^2) times the work of compression,
   which is negative. *)
Theorem stronge_never_adds_energy :
  let j := planar_impulse stronge i in
  let v_n' := v_n i + k_nn i * j_n j + k_tn i * j_t j in
  let v_t' := v_t i + k_tn i * j_n j + k_tt i * j_t j in
  j_n j * (v_n i + v_n') / 2 + j_t j * (v_t i + v_t') / 2 <= 0.
Proof.
  intros j v_n' v_t'. destruct (planar_impulse_is_the_process stronge) as (p_c & [C L] & T & V0 & W0 & _ & E). fold j in L, T, E.
  pose proof (friction_only_takes (j_n j) ltac:(lra)) as G. unfold energy_gain, normal_speed, slip_speed in G. rewrite <- T in G.
  fold v_n' v_t' in G. cbn [ends] in E. eapply Rle_trans; [exact G|].
  assert (0 <= (1 - e i ^ 2) * - normal_work p_c) by (apply Rmult_le_pos; nra). lra.
Qed.

(*@ friction.stronge_planar *)
(* In the docstring's domain: Newton's rule leaves v_n' = -e v_n, Poisson's has (1 + e) times the impulse of compression. *)
Theorem newton_and_poisson :
  (let j := planar_impulse newton i in v_n i + k_nn i * j_n j + k_tn i * j_t j = - e i * v_n i)
  /\ (let j := planar_impulse poisson i in exists p_c, j_n j = (1 + e i) * p_c
       /\ v_n i + k_nn i * p_c + k_tn i * tangential_impulse p_c = 0).
Proof.
  split; intros j.
  - destruct (planar_impulse_is_the_process newton) as (p_c & _ & T & _ & _ & _ & E). fold j in T, E.
    cbn [ends] in E. unfold normal_speed in E. rewrite <- T in E. exact E.
  - destruct (planar_impulse_is_the_process poisson) as (p_c & _ & _ & V0 & _ & _ & E). exists p_c. split; [exact E|exact V0].
Qed.
End Planar.

(* -- three dimensions: the same account along any process -- *)
(*@ friction.stronge *)
(* The contact velocity v(p) follows v' = K (n - mu s), s a unit tangent (or zero) that never opposes the slip, over
   the normal impulse p. Then the energy E gained so far changes at the rate v.(n - mu s), the normal work W at the
   rate v.n, and E - W never grows. So where restitution ends by W(p_f) = (1 - e^2) W(p_c), W(p_c) <= 0, the impact has
   not added energy, however the slip turned, stopped or started again. *)
Theorem energetic_restitution_never_adds_energy (n : V) mu e (v s : R -> V) (E W : R -> R) p_c p_f :
  0 <= mu -> 0 <= e <= 1 -> 0 <= p_f -> E 0 = 0 -> W 0 = 0 ->
  (forall p, 0 <= dot (v p) (s p)) ->
  (forall p, deriv E p (dot (v p) (vsub n (smul mu (s p))))) ->
  (forall p, deriv W p (dot (v p) n)) ->
  W p_f = (1 - e ^ 2) * W p_c -> W p_c <= 0 -> E p_f <= 0.
Proof.
  intros Hmu He Hp E0 W0 Hs DE DW R C.
  set (f := fun p => W p - E p).
  assert (D : forall p, deriv f p (mu * dot (v p) (s p))).
  { intros p. eapply deriv_is; [apply deriv_minus; [apply DW|apply DE]|]. clear. vring. }
  assert (pr : derivable f) by (intros p; exists (mu * dot (v p) (s p)); apply D).
  assert (I : increasing f).
  { apply (nonneg_derivative_1 f pr). intros p.
    replace (derive_pt f p (pr p)) with (mu * dot (v p) (s p)) by (symmetry; apply derive_pt_eq_0, D).
    apply Rmult_le_pos; [exact Hmu|apply Hs]. }
  specialize (I 0 p_f Hp). unfold f in I.
  assert (0 <= (1 - e ^ 2) * - W p_c) by (apply Rmult_le_pos; nra). lra.
Qed.

(*@ friction.stronge *)
(* The energy gained is j.(v + v')/2 along the process: with v = v_0 + K j it is v_0.j + j.Kj/2, whose rate is v.j'. *)
Theorem energy_along_a_process (K : M) (v0 : V) (j dj : R -> V) p : sym K -> (forall q, vderiv j q (dj q)) ->
  let v q := vadd v0 (mv K (j q)) in
  deriv (fun q => impulse_energy (j q) v0 (v q)) p (dot (v p) (dj p)).
Proof.
  intros S D v.
  apply (deriv_ext (fun q => dot v0 (j q) + dot (j q) (mv K (j q)) * / 2)).
  { intros q. unfold impulse_energy, v. generalize (j q). clear. vfield. }
  eapply deriv_is.
  - apply deriv_plus; [apply deriv_dot; [apply vderiv_const|apply D]|].
    apply deriv_mult; [apply deriv_dot; [apply D|apply vderiv_mv; [apply mderiv_const|apply D]]|apply deriv_const].
  - assert (Q : dot (j p) (mv K (dj p)) = dot (dj p) (mv K (j p))) by (apply sym_dot, S).
    unfold v. cbn beta. rewrite dot_add_l, (dot_comm (mv K (j p))).
    replace (vadd (mv mzero (j p)) (mv K (dj p))) with (mv K (dj p)) by vring. rewrite Q.
    replace (dot vzero (j p)) with 0 by vring. rewrite (dot_comm v0). field.
Qed.

(*@ friction.stronge *)
(* A slip that starts again after a stop goes straight on along s, where the tangential part of K (n - mu s) is
   kappa s with kappa > 0. On such a leg the bodies part: v_n grows faster than mu kappa, so the impact ends. *)
Theorem restarted_slip_parts_the_bodies (K : M) (n s : V) mu kappa : posdef K -> dot n n = 1 -> dot s s = 1 -> dot s n = 0 ->
  0 <= mu -> 0 < kappa -> let q := vsub n (smul mu s) in
  dot s (mv K q) = kappa -> mu * kappa < dot n (mv K q).
Proof.
  intros P Hn Hs Hsn Hmu Hk q E.
  assert (N : q <> vzero).
  { intros Z. assert (X : dot q n = 1) by (unfold q; rewrite dot_sub_l, dot_smul_l, Hn, Hsn; ring).
    rewrite Z in X. revert X. vunfold. lra. }
  specialize (P q N). unfold q in P at 1. rewrite dot_sub_l, dot_smul_l, E in P. lra.
Qed.

(*@ friction.stronge *)
(* While nothing slips, the impulse q with Kq = v_n' n turns v_n at a positive rate: the stop, too, parts the bodies. *)
Theorem sticking_parts_the_bodies (K : M) (n q : V) rate : posdef K -> dot n n = 1 -> dot q n = 1 ->
  mv K q = smul rate n -> 0 < rate.
Proof.
  intros P Hn Hq E. assert (N : q <> vzero) by (intros Z; rewrite Z in Hq; revert Hq; vunfold; lra).
  specialize (P q N). rewrite E, dot_smul_r, Hq in P. lra.
Qed.
