(* The explicit step of a rotation matrix, and the exponential that would be exact. *)
Require Import Vec3 Laws Calculus Motion.

Lemma naive_is_a_product h w Rot : naive_rotation_step h w Rot = mm (madd mid (mscale h (hat w))) Rot.
Proof. unfold naive_rotation_step, rotation_rate. vring. Qed.

(*@ rotation.naive_step *)
(* The defect is known: R'^T R' = R^T (1 - h^2 [w]^2) R, and -[w]^2 = |w|^2 1 - w w^T. *)
Theorem naive_step_defect h w Rot :
  let R' := naive_rotation_step h w Rot in
  mm (tr R') R' = mm (tr Rot) (mm (madd mid (mscale (h ^ 2) (madd (mscale (dot w w) mid) (mscale (-1) (outer w w))))) Rot).
Proof.
  cbv zeta. rewrite naive_is_a_product.
  transitivity (mm (tr Rot) (mm (mm (tr (madd mid (mscale h (hat w)))) (madd mid (mscale h (hat w)))) Rot)).
  - rewrite tr_mm, !mm_assoc. reflexivity.
  - f_equal. f_equal. vring.
Qed.

(*@ rotation.naive_step *)
(* Case K-07: lengths grow by sqrt(1 + h^2 w^2) across w, stay along w ... *)
Theorem naive_step_stretch h w Rot x : orthogonal Rot ->
  let y := mv Rot x in let y' := mv (naive_rotation_step h w Rot) x in
  dot y' y' = dot y y + h ^ 2 * dot (cross w y) (cross w y).
Proof. intros _ y y'. unfold y', y. rewrite naive_is_a_product, <- mv_mm. generalize (mv Rot x). vring. Qed.

(*@ rotation.naive_step *)
(* ... the tangent of the angle turned is h|w| (y across w: the part along y is unchanged, the part across is h w x y) ... *)
Theorem naive_step_angle h w Rot x :
  let y := mv Rot x in mv (naive_rotation_step h w Rot) x = vadd y (smul h (cross w y)) /\ dot y (cross w y) = 0.
Proof. split; [rewrite naive_is_a_product, <- mv_mm; generalize (mv Rot x); vring | vring]. Qed.

(*@ rotation.naive_step *)
(* ... and the determinant grows by 1 + h^2 w^2: never singular, never a reflection. *)
Theorem naive_step_det h w Rot : det (naive_rotation_step h w Rot) = (1 + h ^ 2 * dot w w) * det Rot.
Proof. rewrite naive_is_a_product, det_mm. f_equal. vring. Qed.

(*@ rotation.naive_step *)
(* The result is orthogonal only if nothing turned. *)
Theorem naive_step_leaves_the_rotations h w Rot : orthogonal Rot -> orthogonal (naive_rotation_step h w Rot) ->
  h = 0 \/ w = vzero.
Proof.
  intros [H H'] [HB _]. pose proof (naive_step_defect h w Rot) as D. cbv zeta in D. rewrite HB in D.
  destruct (Req_dec h 0) as [|Hh]; [now left|right].
  set (E := madd mid (mscale (h ^ 2) (madd (mscale (dot w w) mid) (mscale (-1) (outer w w))))) in D.
  assert (HE : E = mid).
  { transitivity (mm (mm Rot (tr Rot)) (mm E (mm Rot (tr Rot)))); [rewrite H', mm_id, id_mm; reflexivity|].
    transitivity (mm Rot (mm (mm (tr Rot) (mm E Rot)) (tr Rot))); [rewrite !mm_assoc; reflexivity|].
    rewrite <- D, id_mm. exact H'. }
  assert (Hh2 : 0 < h ^ 2) by nra.
  assert (Z : dot w w = 0); [|apply dot_self_zero, Z].
  pose proof (f_equal xx HE) as D1. pose proof (f_equal yy HE) as D2. pose proof (f_equal zz HE) as D3.
  unfold E in D1, D2, D3. revert D1 D2 D3. destruct w as [x y z]. vunfold. intros D1 D2 D3.
  assert (h ^ 2 * (x * x + y * y + z * z) = 0) by lra. nra.
Qed.

(* -- Rodrigues' formula: exp_so3 of src/linalg -- *)
(* the rotation by phi about the unit vector a *)
Definition rodrigues a phi := madd mid (madd (mscale (sin phi) (hat a)) (mscale (1 - cos phi) (mm (hat a) (hat a)))).

(*@ law.rodrigues *)
Theorem rodrigues_is_a_rotation a phi : dot a a = 1 -> rotation (rodrigues a phi).
Proof.
  intros Ha. pose proof (sin2_cos2 phi) as S. unfold Rsqr in S.
  split.
  - apply orthogonal_one_side.
    assert (E : mm (tr (rodrigues a phi)) (rodrigues a phi)
      = madd mid (mscale (2 * (1 - cos phi) - sin phi * sin phi - (1 - cos phi) ^ 2 * dot a a) (mm (hat a) (hat a)))).
    { unfold rodrigues. generalize (sin phi) (cos phi). clear. vring. }
    rewrite E, Ha. replace (2 * (1 - cos phi) - sin phi * sin phi - (1 - cos phi) ^ 2 * 1) with 0 by nra. vring.
  - assert (E : det (rodrigues a phi)
      = 1 + (sin phi * sin phi - 2 * (1 - cos phi)) * dot a a + (1 - cos phi) ^ 2 * (dot a a) ^ 2).
    { unfold rodrigues. generalize (sin phi) (cos phi). clear. vring. }
    rewrite E, Ha. nra.
Qed.

(*@ law.rodrigues *)
(* It keeps the axis, and rotations about one axis add their angles. *)
Theorem rodrigues_adds_angles a phi psi : dot a a = 1 ->
  mv (rodrigues a phi) a = a /\ mm (rodrigues a phi) (rodrigues a psi) = rodrigues a (phi + psi).
Proof.
  intros Ha. split; [unfold rodrigues; vring|]. unfold rodrigues. rewrite sin_plus, cos_plus.
  assert (E3 : mm (hat a) (mm (hat a) (hat a)) = mscale (-1) (hat a)).
  { transitivity (mscale (- dot a a) (hat a)); [vring|rewrite Ha; reflexivity]. }
  assert (E4 : mm (mm (hat a) (hat a)) (mm (hat a) (hat a)) = mscale (-1) (mm (hat a) (hat a))).
  { rewrite <- mm_assoc, E3. vring. }
  generalize (sin phi) (cos phi) (sin psi) (cos psi). intros s c s' c'.
  transitivity (madd mid (madd (mscale (s + s') (hat a)) (madd (mscale (s * s' + (1 - c) + (1 - c')) (mm (hat a) (hat a)))
    (madd (mscale (s * (1 - c') + (1 - c) * s') (mm (hat a) (mm (hat a) (hat a))))
          (mscale ((1 - c) * (1 - c')) (mm (mm (hat a) (hat a)) (mm (hat a) (hat a)))))))).
  - clear. vring.
  - rewrite E3, E4. clear. vring.
Qed.

Lemma rodrigues_deriv a rate t : dot a a = 1 ->
  mderiv (fun s => rodrigues a (rate * s)) t (mm (hat (smul rate a)) (rodrigues a (rate * t))).
Proof.
  intros Ha.
  assert (L : deriv (fun s => rate * s) t rate).
  { eapply deriv_is; [exact (derivable_pt_lim_scal id rate t 1 (derivable_pt_lim_id t))|ring]. }
  assert (Ds : deriv (fun s => sin (rate * s)) t (cos (rate * t) * rate))
    by exact (derivable_pt_lim_comp (fun s => rate * s) sin t rate _ L (derivable_pt_lim_sin _)).
  assert (Dc : deriv (fun s => cos (rate * s)) t (- sin (rate * t) * rate))
    by exact (derivable_pt_lim_comp (fun s => rate * s) cos t rate _ L (derivable_pt_lim_cos _)).
  eapply mderiv_is.
  - unfold rodrigues. apply mderiv_add; [apply mderiv_const|]. apply mderiv_add.
    + apply mderiv_scale; [exact Ds|apply mderiv_const].
    + apply mderiv_scale; [apply deriv_minus; [apply deriv_const|exact Dc]|apply mderiv_const].
  - assert (E3 : mm (hat a) (mm (hat a) (hat a)) = mscale (-1) (hat a)).
    { transitivity (mscale (- dot a a) (hat a)); [vring|rewrite Ha; reflexivity]. }
    transitivity (madd (mscale (rate * cos (rate * t)) (hat a)) (mscale (rate * sin (rate * t)) (mm (hat a) (hat a)))).
    + clear. vring.
    + transitivity (madd (mscale rate (hat a)) (madd (mscale (rate * sin (rate * t)) (mm (hat a) (hat a)))
        (mscale (rate * (1 - cos (rate * t))) (mm (hat a) (mm (hat a) (hat a)))))); [rewrite E3; clear; vring|].
      unfold rodrigues. clear. vring.
Qed.

(*@ law.rodrigues *)
(* For a spin w = rate a that stays as it is, t -> exp(t [w]) R0 solves R' = [w] R, starts at R0 ... *)
Theorem rodrigues_solves a rate R0 : dot a a = 1 ->
  let Rot t := mm (rodrigues a (rate * t)) R0 in
  Rot 0 = R0 /\ forall t, mderiv Rot t (rotation_rate (smul rate a) (Rot t)).
Proof.
  intros Ha Rot. split.
  - unfold Rot, rodrigues. rewrite Rmult_0_r, sin_0, cos_0. vring.
  - intros t. eapply mderiv_is; [apply mderiv_mm; [apply rodrigues_deriv, Ha|apply mderiv_const]|].
    unfold Rot, rotation_rate. generalize (rodrigues a (rate * t)). clear. vring.
Qed.

(*@ law.rodrigues *)
(* ... and is the only solution. *)
Theorem rodrigues_unique a rate Rot : dot a a = 1 ->
  (forall t, mderiv Rot t (rotation_rate (smul rate a) (Rot t))) -> forall t, Rot t = mm (rodrigues a (rate * t)) (Rot 0).
Proof.
  intros Ha H t.
  assert (C : forall s, mm (tr (rodrigues a (rate * s))) (Rot s) = mm (tr (rodrigues a (rate * 0))) (Rot 0)).
  { apply (mconstant (fun s => mm (tr (rodrigues a (rate * s))) (Rot s))). intros s.
    eapply mderiv_is; [apply mderiv_mm; [apply mderiv_tr, rodrigues_deriv, Ha|apply H]|].
    unfold rotation_rate. generalize (rodrigues a (rate * s)) (Rot s). clear. vring. }
  specialize (C t). apply (f_equal (mm (rodrigues a (rate * t)))) in C.
  destruct (rodrigues_is_a_rotation a (rate * t) Ha) as [[_ O] _].
  rewrite mm_assoc, O, id_mm in C. rewrite C. f_equal.
  replace (rodrigues a (rate * 0)) with mid; [vring|]. unfold rodrigues. rewrite Rmult_0_r, sin_0, cos_0. vring.
Qed.
