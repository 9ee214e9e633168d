(* The direction of friction, and what a tangential impulse may do. *)
Require Import Vec3 Laws Impulse Conservation GramSchmidt.

Lemma tangential_across a n : dot n n = 1 -> dot (tangential a n) n = 0.
Proof. intros H. unfold tangential. rewrite dot_sub_l, dot_smul_l, H. ring. Qed.

(*@ friction.tangent *)
(* Zero, or a unit vector across the normal. *)
Theorem tangent_is_unit_or_zero eps v_r f n : dot n n = 1 ->
  let t := friction_tangent eps v_r f n in t = vzero \/ (dot t t = 1 /\ dot t n = 0).
Proof.
  intros Hn t. unfold t, friction_tangent.
  assert (U : forall a, dot (tangential a n) (tangential a n) > (16 * eps / 2) ^ 2 * dot a a ->
    dot (unit (tangential a n)) (unit (tangential a n)) = 1 /\ dot (unit (tangential a n)) n = 0).
  { intros a G. split.
    - apply unit_unit. pose proof (dot_self_nonneg a). pose proof (pow2_ge_0 (16 * eps / 2)). nra.
    - unfold unit. rewrite dot_smul_l, tangential_across by exact Hn. ring. }
  destruct (counts eps (tangential v_r n) v_r) as [G|_]; [right; apply U, G|].
  destruct (counts eps (tangential f n) f) as [G|_]; [right; apply U, G|left; reflexivity].
Qed.

(*@ friction.tangent *)
(* With an exact scalar (eps = 0) and slip, it is the direction of the slip: v_t = |v_t| t. *)
Theorem tangent_along_the_slip v_r f n : tangential v_r n <> vzero ->
  let v_t := tangential v_r n in v_t = smul (norm v_t) (friction_tangent 0 v_r f n) /\ 0 < dot v_t (friction_tangent 0 v_r f n).
Proof.
  intros S v_t. pose proof (dot_self_pos _ S) as P. fold v_t in P. pose proof (norm_pos _ P) as N.
  unfold friction_tangent, counts. fold v_t.
  replace ((16 * 0 / 2) ^ 2 * dot v_r v_r) with 0 by field.
  destruct (Rgt_dec (dot v_t v_t) 0) as [_|G]; [|lra].
  split.
  - unfold unit. revert N. generalize (norm v_t). intros. vfield; lra.
  - unfold unit. rewrite dot_smul_r. apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat, N|exact P].
Qed.

(*@ friction.tangent *)
(* Without slip it is the direction in which the force would start one; without either there is none. *)
Theorem tangent_without_slip v_r f n : tangential v_r n = vzero ->
  (tangential f n <> vzero -> friction_tangent 0 v_r f n = unit (tangential f n))
  /\ (tangential f n = vzero -> friction_tangent 0 v_r f n = vzero).
Proof.
  intros S. unfold friction_tangent, counts. rewrite S.
  replace ((16 * 0 / 2) ^ 2 * dot v_r v_r) with 0 by field. replace ((16 * 0 / 2) ^ 2 * dot f f) with 0 by field.
  destruct (Rgt_dec (dot vzero vzero) 0) as [G|_]; [revert G; vunfold; lra|].
  split; intros F.
  - pose proof (dot_self_pos _ F). destruct (Rgt_dec _ 0); [reflexivity|lra].
  - rewrite F. destruct (Rgt_dec (dot vzero vzero) 0) as [G|_]; [revert G; vunfold; lra|reflexivity].
Qed.

(*@ friction.tangent *)
(* Turning n about changes nothing: which body is called A does not matter. *)
Theorem tangent_even eps v_r f n : friction_tangent eps v_r f (smul (-1) n) = friction_tangent eps v_r f n.
Proof.
  assert (E : forall a, tangential a (smul (-1) n) = tangential a n) by (intros; unfold tangential; vring).
  unfold friction_tangent, counts. rewrite !E. reflexivity.
Qed.

(* -- the sheet's rule -- *)
(*@ friction.sheet *)
(* What it does to a point mass, whose slip after a friction impulse j is s - j/m: it stops it, or slows it without
   turning it round; it never adds energy to a point mass. *)
Theorem sheet_rule_on_a_point_mass m mu_s mu_d j_r s : 0 < m -> 0 <= mu_d <= mu_s -> 0 <= j_r -> 0 <= s ->
  let j := sheet_friction_impulse m mu_s mu_d j_r s in
  0 <= j <= mu_s * j_r /\ 0 <= s - j / m <= s /\ (m * s <= mu_s * j_r -> s - j / m = 0).
Proof.
  intros Hm Hmu Hj Hs j.
  assert (S : m * s / m = s) by (field; lra).
  assert (Hi : 0 < / m) by (apply Rinv_0_lt_compat, Hm).
  unfold j, sheet_friction_impulse. destruct (Rle_dec (m * s) (mu_s * j_r)) as [L|L].
  - rewrite S. repeat split; nra.
  - assert (D : mu_d * j_r <= m * s) by nra.
    assert (Q : mu_d * j_r / m <= s).
    { rewrite <- S. unfold Rdiv. apply Rmult_le_compat_r; lra. }
    assert (P : 0 <= mu_d * j_r / m) by (unfold Rdiv; apply Rmult_le_pos; nra).
    repeat split; nra.
Qed.

(*@ friction.sheet_literal *)
(* Read literally the rule turns every slip round that is slower than mu_d j_r / m, and does nothing only at rest. *)
Theorem literal_rule_reverses m mu_d j_r s : 0 < m -> 0 < mu_d * j_r -> 0 < s < mu_d * j_r / m ->
  s - sheet_literal_friction_impulse mu_d j_r s / m < 0 /\ sheet_literal_friction_impulse mu_d j_r 0 = 0.
Proof.
  intros Hm Hj Hs. unfold sheet_literal_friction_impulse.
  destruct (Req_EM_T s 0); [lra|]. destruct (Req_EM_T 0 0); [lra|contradiction].
Qed.

(* -- Coulomb's law with Newton's restitution; by response, v' = v_r + K j -- *)
Lemma posdef_det K : posdef K -> det K <> 0.
Proof.
  intros P D.
  (* u = adj(K) e_k has Ku = det K e_k = 0, so every cofactor vanishes *)
  assert (Z : forall u, mv K u = vzero -> u = vzero).
  { intros u E. destruct (Req_dec (dot u u) 0) as [Q|Q]; [apply dot_self_zero, Q|].
    assert (N : u <> vzero) by (intros ->; apply Q; vring). specialize (P u N). rewrite E in P. revert P. vunfold. lra. }
  destruct K as [a b c d e' f g h i].
  assert (C : forall u, mv (M3 a b c d e' f g h i) u = V3 0 0 (det (M3 a b c d e' f g h i)) -> u = vzero).
  { intros u E. apply Z. rewrite E, D. reflexivity. }
  assert (C3 : V3 (b * f - c * e') (c * d - a * f) (a * e' - b * d) = vzero) by (apply C; vring).
  injection C3. intros m3 _ _.
  assert (E2 : V3 e' (- d) 0 = vzero).
  { destruct (Req_dec (dot (V3 e' (- d) 0) (V3 e' (- d) 0)) 0) as [Q|Q]; [apply dot_self_zero, Q|].
    assert (N : V3 e' (- d) 0 <> vzero) by (intros X; apply Q; rewrite X; vring). specialize (P _ N).
    exfalso. assert (e' * (a * e' - b * d) = 0) by (rewrite m3; ring). revert P. vunfold. lra. }
  injection E2. intros _ e0.
  assert (N : V3 0 1 0 <> vzero) by (intros X; injection X; lra). specialize (P _ N). revert P. vunfold. rewrite e0. lra.
Qed.

(*@ friction.coulomb *)
(* The stick trial is solved rightly. *)
Theorem cancelling_cancels K b : det K <> 0 -> mv K (impulse_cancelling K b) = smul (-1) b.
Proof.
  unfold impulse_cancelling. intros D. set (d := det K) in *.
  transitivity (smul (- / d) (smul d b)); [|unfold smul; apply Veq; cbn; field; exact D].
  transitivity (smul (- / d) (mv K (V3 (dot b (cross (col2 K) (col3 K))) (dot b (cross (col3 K) (col1 K))) (dot b (cross (col1 K) (col2 K)))))).
  - generalize (dot b (cross (col2 K) (col3 K))) (dot b (cross (col3 K) (col1 K))) (dot b (cross (col1 K) (col2 K))).
    clear. intros. unfold Rdiv. generalize (/ d). vring.
  - f_equal. unfold d. clear. vring.
Qed.

Section Coulomb.
Variables (K : M) (v_r n t : V) (e mu_s mu_d : R).
Hypothesis Ksym : sym K. Hypothesis Kpos : posdef K.
Hypothesis Hn : dot n n = 1.
Hypothesis Ht : t = vzero \/ (dot t t = 1 /\ dot t n = 0).
Hypothesis He : 0 <= e <= 1. Hypothesis Hmu : 0 <= mu_d <= mu_s.
Let v_n := dot v_r n.
Hypothesis approach : v_n < 0.
Let result := coulomb_impulse K v_r n t e mu_s mu_d.
Let j := impulse result.
Definition after K v_r j := vadd v_r (mv K j).
Let k_nn := dot n (mv K n).

Lemma k_nn_pos : 0 < k_nn.
Proof. apply Kpos. intros E. rewrite E in Hn. revert Hn. vunfold. lra. Qed.
Lemma t_n : dot t n = 0. Proof. destruct Ht as [->|[_ H]]; [vring|exact H]. Qed.
Lemma stick_outcome : after K v_r (coulomb_stick K v_r n e) = smul (- e * v_n) n.
Proof.
  unfold after, coulomb_stick. rewrite cancelling_cancels by (apply posdef_det, Kpos). fold v_n. generalize v_n. clear. vring.
Qed.
Lemma slide_outcome : k_nn - mu_d * dot t (mv K n) > 0 ->
  dot (after K v_r (coulomb_slide K v_r n t e mu_d)) n = - e * v_n.
Proof.
  intros D. unfold coulomb_slide, normal_impulse, after. fold v_n k_nn.
  set (d := k_nn - mu_d * dot t (mv K n)) in *.
  transitivity (v_n + - (1 + e) * v_n / d * (dot n (mv K n) - mu_d * dot n (mv K t))).
  - unfold v_n. generalize (- (1 + e) * dot v_r n / d). clear. vring.
  - rewrite (sym_dot K n t Ksym). fold k_nn d. field. lra.
Qed.
Lemma frictionless_outcome : dot (after K v_r (smul (normal_impulse e v_n k_nn) n)) n = - e * v_n.
Proof.
  pose proof k_nn_pos. unfold after, normal_impulse.
  transitivity (v_n + - (1 + e) * v_n / k_nn * k_nn); [|field; lra].
  unfold k_nn, v_n. generalize (- (1 + e) * dot v_r n / dot n (mv K n)). clear. vring.
Qed.

(* The four outcomes, one by one. *)
Lemma coulomb_cases :
  (outcome result = stuck /\ j = coulomb_stick K v_r n e /\ 0 <= dot j n
     /\ dot (tangential j n) (tangential j n) <= (mu_s * dot j n) ^ 2)
  \/ (k_nn - mu_d * dot t (mv K n) > 0 /\ j = coulomb_slide K v_r n t e mu_d
     /\ (outcome result = slid /\ 0 <= dot t (after K v_r j)
         \/ outcome result = slip_stopped_inside /\ dot t (after K v_r j) < 0))
  \/ (j = smul (normal_impulse e v_n k_nn) n
     /\ (outcome result = slid /\ mu_s = 0 \/ outcome result = jammed /\ k_nn - mu_d * dot t (mv K n) <= 0)).
Proof.
  assert (S : forall x, dot t (after K v_r x) = dot v_r t + dot t (mv K x)).
  { intros. unfold after. rewrite dot_add_r, (dot_comm t v_r). reflexivity. }
  assert (slides : forall r,
    r = (if Rgt_dec (dot n (mv K n) - mu_d * dot t (mv K n)) 0 then
      {| impulse := coulomb_slide K v_r n t e mu_d;
         outcome := if Rlt_dec (dot v_r t + dot t (mv K (coulomb_slide K v_r n t e mu_d))) 0
                    then slip_stopped_inside else slid |}
      else {| impulse := smul (normal_impulse e (dot v_r n) (dot n (mv K n))) n; outcome := jammed |}) ->
    (k_nn - mu_d * dot t (mv K n) > 0 /\ impulse r = coulomb_slide K v_r n t e mu_d
      /\ (outcome r = slid /\ 0 <= dot t (after K v_r (impulse r))
          \/ outcome r = slip_stopped_inside /\ dot t (after K v_r (impulse r)) < 0))
    \/ (impulse r = smul (normal_impulse e v_n k_nn) n
      /\ (outcome r = slid /\ mu_s = 0 \/ outcome r = jammed /\ k_nn - mu_d * dot t (mv K n) <= 0))).
  { intros r ->. destruct (Rgt_dec (dot n (mv K n) - mu_d * dot t (mv K n)) 0) as [D|D]; cbn [impulse outcome].
    - left. split; [exact D|split; [reflexivity|]]. rewrite S.
      destruct (Rlt_dec _ 0); [right|left]; (split; [reflexivity|lra]).
    - right. split; [reflexivity|]. right. split; [reflexivity|]. unfold k_nn. lra. }
  unfold j, result, coulomb_impulse. cbv zeta.
  destruct (Req_EM_T mu_s 0) as [Z|Z]; [right; right; cbn; split; [reflexivity|left; split; [reflexivity|exact Z]]|].
  set (s := coulomb_stick K v_r n e).
  destruct (Rge_dec (dot s n) 0) as [P|P]; [|right; apply slides; reflexivity].
  destruct (Rle_dec (dot (tangential s n) (tangential s n)) (mu_s * mu_s * dot s n * dot s n)) as [C|C].
  - left. cbn [impulse outcome]. repeat split; [lra|]. eapply Rle_trans; [exact C|]. right. ring.
  - right. apply slides. reflexivity.
Qed.

Lemma frictionless_push : 0 < normal_impulse e v_n k_nn.
Proof. apply normal_impulse_pushes; [apply k_nn_pos|lra|exact approach]. Qed.

(*@ friction.coulomb *)
(* In the docstring's domain, with j the impulse returned and after K v_r j = v_r + K j: Newton's restitution holds
   whatever friction does, because normal and tangent are solved together. *)
Theorem coulomb_restitution : dot (after K v_r j) n = - e * v_n.
Proof.
  destruct coulomb_cases as [(_ & -> & _)|[(D & -> & _)|(-> & _)]].
  - rewrite stick_outcome, dot_smul_l, Hn. ring.
  - apply slide_outcome, D.
  - apply frictionless_outcome.
Qed.

(*@ friction.coulomb *)
(* In the docstring's domain: the impulse pushes, and stays in the cone of mu_s. *)
Theorem coulomb_in_the_cone :
  0 <= dot j n /\ dot (tangential j n) (tangential j n) <= (mu_s * dot j n) ^ 2.
Proof.
  destruct coulomb_cases as [(_ & _ & P & C)|[(D & E & _)|(E & _)]]; [split; assumption| |]; rewrite E.
  - unfold coulomb_slide. fold v_n k_nn. set (d := k_nn - mu_d * dot t (mv K n)) in *.
    assert (J : 0 < normal_impulse e v_n d) by (apply normal_impulse_pushes; [exact D|lra|exact approach]).
    generalize dependent (normal_impulse e v_n d). intros J HJ.
    assert (N : dot (smul J (vsub n (smul mu_d t))) n = J).
    { rewrite dot_smul_l, dot_sub_l, dot_smul_l, Hn, t_n. ring. }
    rewrite N. split; [lra|].
    assert (T : tangential (smul J (vsub n (smul mu_d t))) n = smul (- (J * mu_d)) t).
    { unfold tangential. rewrite N. clear. vring. }
    rewrite T, dot_smul_l, dot_smul_r.
    assert (U : 0 <= dot t t <= 1) by (destruct Ht as [->|[-> _]]; [vunfold; lra|lra]).
    assert (0 <= (J * mu_d) ^ 2) by apply pow2_ge_0.
    assert ((J * mu_d) ^ 2 <= (mu_s * J) ^ 2) by (apply pow_incr; nra).
    nra.
  - pose proof frictionless_push as J. generalize dependent (normal_impulse e v_n k_nn). intros J _ HJ.
    assert (N : dot (smul J n) n = J) by (rewrite dot_smul_l, Hn; ring).
    rewrite N. split; [lra|].
    assert (T : tangential (smul J n) n = vzero) by (unfold tangential; rewrite N; vring).
    rewrite T. replace (dot vzero vzero) with 0 by vring. apply pow2_ge_0.
Qed.

(*@ friction.coulomb *)
(* In the docstring's domain. Stuck: no slip is left. *)
Theorem coulomb_stuck : outcome result = stuck -> after K v_r j = smul (- e * v_n) n.
Proof.
  intros O. destruct coulomb_cases as [(_ & -> & _)|[(_ & _ & [[E _]|[E _]])|(_ & [[E _]|[E _]])]];
    try (rewrite O in E; discriminate). apply stick_outcome.
Qed.

(*@ friction.coulomb *)
(* In the docstring's domain. Slid: friction lies on the cone of mu_d against t, the slip goes on along t, and no energy is added. *)
Theorem coulomb_slid : outcome result = slid -> 0 <= dot v_r t -> mu_s <> 0 ->
  tangential j n = smul (- mu_d * dot j n) t
  /\ 0 <= dot t (after K v_r j)
  /\ impulse_energy j v_r (after K v_r j) <= 0.
Proof.
  intros O slip Z.
  destruct coulomb_cases as [(E & _)|[(D & E & [[_ S]|[X _]])|(_ & [[_ X]|[X _]])]];
    try (rewrite O in *; discriminate); [|contradiction].
  pose proof coulomb_in_the_cone as [P _]. pose proof coulomb_restitution as N.
  assert (T : tangential j n = smul (- mu_d * dot j n) t).
  { rewrite E. unfold coulomb_slide. generalize (normal_impulse e (dot v_r n) (dot n (mv K n) - mu_d * dot t (mv K n))).
    intros J. assert (Q : dot (smul J (vsub n (smul mu_d t))) n = J) by (rewrite dot_smul_l, dot_sub_l, dot_smul_l, Hn, t_n; ring).
    unfold tangential. rewrite Q. clear. vring. }
  split; [exact T|split; [exact S|]].
  assert (F : j = vadd (smul (dot j n) n) (smul (- mu_d * dot j n) t)).
  { rewrite <- T. unfold tangential. clear. generalize (dot j n). vring. }
  unfold impulse_energy. rewrite F at 1. rewrite dot_add_l, !dot_smul_l, !dot_add_r.
  rewrite (dot_comm n v_r), (dot_comm n (after K v_r j)), N, (dot_comm t v_r). fold v_n.
  assert (0 <= dot j n * (mu_d * (dot v_r t + dot t (after K v_r j)))) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= dot j n * ((1 - e) * - v_n)) by (repeat apply Rmult_le_pos; lra).
  lra.
Qed.

(*@ friction.coulomb *)
(* In the docstring's domain: a plastic impact that sticks loses energy ... *)
Theorem coulomb_plastic_stick : outcome result = stuck -> e = 0 -> impulse_energy j v_r (after K v_r j) <= 0.
Proof.
  intros O Z. pose proof (coulomb_stuck O) as A. rewrite Z in A. unfold impulse_energy. rewrite A.
  assert (V : v_r = smul (-1) (mv K j)).
  { apply (vadd_cancel (mv K j)). transitivity (after K v_r j); [unfold after; vring|]. rewrite A. vring. }
  rewrite V at 1.
  assert (Q : 0 <= dot j (mv K j)) by apply (posdef_possemi K Kpos).
  replace (dot j (vadd (smul (-1) (mv K j)) (smul (- 0 * v_n) n))) with (- dot j (mv K j)) by (generalize (mv K j); vring).
  lra.
Qed.
End Coulomb.

(*@ friction.coulomb *)
(* ... but Newton's e with sticking can create energy: case FR-10, a cube's corner, gains 7/64. Nothing here promises
   otherwise; the energetic law does. *)
Theorem coulomb_stick_can_add_energy :
  let K := M3 (5 / 2) (- 3 / 2) 0 (- 3 / 2) (5 / 2) 0 0 0 1 in
  let v := V3 (1 / 2) (-1) 0 in let n := V3 0 1 0 in
  let j := impulse (coulomb_impulse K v n (V3 1 0 0) 1 1 1) in
  j = V3 (7 / 16) (17 / 16) 0 /\ impulse_energy j v (after K v j) = 7 / 64.
Proof.
  intros K v n j.
  assert (J : coulomb_stick K v n 1 = V3 (7 / 16) (17 / 16) 0).
  { unfold coulomb_stick, impulse_cancelling, K, v, n. vunfold. apply f_equal3; field. }
  assert (E : j = V3 (7 / 16) (17 / 16) 0).
  { unfold j, coulomb_impulse. cbv zeta. rewrite J.
    destruct (Req_EM_T 1 0); [lra|]. destruct (Rge_dec _ 0) as [_|N]; [|exfalso; apply N; unfold n; vunfold; lra].
    destruct (Rle_dec _ _) as [_|N]; [reflexivity|]. exfalso; apply N. unfold tangential, n. vunfold. lra. }
  split; [exact E|]. rewrite E. unfold impulse_energy, after, K, v. vunfold. field.
Qed.
