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
  assert (U : forall a, dot (tangential a n) (tangential a n) > (4 * eps / 2) ^ 2 * dot a a ->
    dot (unit (tangential a n)) (unit (tangential a n)) = 1 /\ dot (unit (tangential a n)) n = 0).
  { intros a G. split.
    - apply unit_unit. pose proof (dot_self_nonneg a). pose proof (pow2_ge_0 (4 * eps / 2)). nra.
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
  replace ((4 * 0 / 2) ^ 2 * dot v_r v_r) with 0 by field.
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
  replace ((4 * 0 / 2) ^ 2 * dot v_r v_r) with 0 by field. replace ((4 * 0 / 2) ^ 2 * dot f f) with 0 by field.
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
