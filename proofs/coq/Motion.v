(* Newton and Euler with real derivatives over all time: R' = [w] R, P' = F, L' = tau. *)
Require Import Vec3 Laws Calculus.

(*@ motion.linear *)
(* v' is the formula's exactly when momentum changes at the rate of the force. *)
Theorem newton m (v : R -> V) (f a : V) t : m <> 0 -> vderiv v t a ->
  (vderiv (fun s => linear_momentum m (v s)) t f <-> a = linear_acceleration (/ m) f).
Proof.
  intros Hm D.
  assert (P : vderiv (fun s => linear_momentum m (v s)) t (smul m a)).
  { eapply vderiv_is; [apply vderiv_smul; [apply deriv_const|exact D]|]. vring. }
  unfold linear_acceleration. split.
  - intros F. rewrite (vderiv_unique _ _ _ _ F P). vfield; exact Hm.
  - intros ->. eapply vderiv_is; [exact P|]. vfield; exact Hm.
Qed.

Section Body.
Variables (p v w : R -> V) (Rot : R -> M).
Hypothesis Rate : forall t, mderiv Rot t (rotation_rate (w t) (Rot t)).

(*@ motion.point_velocity *)
(* The formula is the derivative of where the point is: c is fixed in the body, R' = [w] R. *)
Theorem point_velocity_is_a_derivative c t : vderiv p t (v t) ->
  vderiv (fun s => vadd (p s) (mv (Rot s) c)) t (point_velocity (v t) (w t) (mv (Rot t) c)).
Proof.
  intros D. eapply vderiv_is; [apply vderiv_add; [exact D|apply vderiv_mv; [apply Rate|apply vderiv_const]]|].
  unfold point_velocity, rotation_rate. vring.
Qed.

(*@ rotation.rate *)
(* R' = [w] R keeps R^T R, for w that varies in time ... *)
Theorem rate_keeps_orthogonality : (forall t, mm (tr (Rot t)) (Rot t) = mm (tr (Rot 0)) (Rot 0)).
Proof.
  apply (mconstant (fun s => mm (tr (Rot s)) (Rot s))). intros t.
  eapply mderiv_is; [apply mderiv_mm; [apply mderiv_tr, Rate|apply Rate]|]. unfold rotation_rate. vring.
Qed.

(*@ rotation.rate *)
(* ... and the determinant: a rotation stays a rotation. *)
Theorem rate_keeps_rotations : rotation (Rot 0) -> forall t, rotation (Rot t).
Proof.
  intros [[H0 _] D0] t. split.
  - apply orthogonal_one_side. rewrite rate_keeps_orthogonality. exact H0.
  - rewrite <- D0. apply (constant (fun s => det (Rot s))). intros s. destruct (Rate s) as (C1 & C2 & C3).
    eapply deriv_is; [apply deriv_dot; [exact C1|apply vderiv_cross; [exact C2|exact C3]]|]. unfold rotation_rate. vring.
Qed.

(*@ rotation.rate *)
(* Along R' = [w] R from an orthogonal R(0), the spin is the only vector with that rate. *)
Theorem rate_unique a b : orthogonal (Rot 0) -> forall t,
  rotation_rate a (Rot t) = rotation_rate b (Rot t) -> a = b.
Proof.
  intros [H0 _] t E. pose proof (rate_keeps_orthogonality t) as H. rewrite H0 in H.
  apply orthogonal_one_side in H. destruct H as [_ H].
  apply (f_equal (fun A => mm A (tr (Rot t)))) in E. unfold rotation_rate in E.
  rewrite <- !mm_assoc, H, !mm_id in E. destruct a, b. injection E. vunfold. intros. apply Veq; cbn; lra.
Qed.

(* -- Euler's equation -- *)
Variable I : V.                             (* principal moments *)
Hypothesis HI : vx I <> 0 /\ vy I <> 0 /\ vz I <> 0.
Hypothesis R0 : rotation (Rot 0).
Definition inertia t := world_tensor (Rot t) I.
Definition inverse t := world_tensor (Rot t) (cuboid_inverse_inertia I).
Definition momentum t := mv (inertia t) (w t).

Lemma inverse_inertia_works t : mm (inverse t) (inertia t) = mid /\ mm (inertia t) (inverse t) = mid.
Proof.
  destruct (rate_keeps_rotations R0 t) as [[H H'] _]. unfold inverse, inertia, world_tensor.
  assert (D : mm (diag (cuboid_inverse_inertia I)) (diag I) = mid /\ mm (diag I) (diag (cuboid_inverse_inertia I)) = mid).
  { unfold cuboid_inverse_inertia. generalize HI. vunfold. intros (? & ? & ?). split; apply Meq; cbn; field; auto. }
  destruct D as [D D']. revert H H' D D'.
  generalize (Rot t) (diag I) (diag (cuboid_inverse_inertia I)). clear. intros Q A B H H' D D'. split.
  - transitivity (mm Q (mm B (mm (mm (tr Q) Q) (mm A (tr Q))))); [rewrite !mm_assoc; reflexivity|].
    rewrite H, id_mm, (mm_assoc B), D, id_mm. exact H'.
  - transitivity (mm Q (mm A (mm (mm (tr Q) Q) (mm B (tr Q))))); [rewrite !mm_assoc; reflexivity|].
    rewrite H, id_mm, (mm_assoc A), D', id_mm. exact H'.
Qed.

(* The tensor turns with the body: dI/dt = [w] I - I [w]. *)
Lemma inertia_rate t : mderiv inertia t (madd (mm (hat (w t)) (inertia t)) (mscale (-1) (mm (inertia t) (hat (w t))))).
Proof.
  unfold inertia, world_tensor.
  eapply mderiv_is;
    [apply mderiv_mm; [apply Rate|apply mderiv_mm; [apply mderiv_const|apply mderiv_tr, Rate]]|].
  unfold rotation_rate. generalize (Rot t) (w t) (diag I). clear. vring.
Qed.
Lemma momentum_rate t a : vderiv w t a -> vderiv momentum t (vadd (mv (inertia t) a) (cross (w t) (momentum t))).
Proof.
  intros D. unfold momentum. eapply vderiv_is; [apply vderiv_mv; [apply inertia_rate|exact D]|].
  generalize (inertia t) (w t). clear. vring.
Qed.

(*@ motion.euler *)
(* R' = [w] R, R(0) a rotation, the inertia R diag(I) R^T: dL/dt = tau exactly when w' = a is the formula's. *)
Theorem euler t a tau : vderiv w t a ->
  (vderiv momentum t tau <-> a = angular_acceleration (inertia t) (inverse t) (w t) tau).
Proof.
  intros D. pose proof (momentum_rate t a D) as P. destruct (inverse_inertia_works t) as [J J'].
  unfold angular_acceleration. fold (momentum t). split.
  - intros F. rewrite (vderiv_unique _ _ _ _ F P).
    replace (vsub _ _) with (mv (inertia t) a) by (generalize (mv (inertia t) a) (cross (w t) (momentum t)); vring).
    rewrite mv_mm, J, mv_id. reflexivity.
  - intros E. eapply vderiv_is; [exact P|]. rewrite E, mv_mm, J', mv_id. generalize (cross (w t) (momentum t)). vring.
Qed.

Variable tau : R -> V.
Hypothesis Euler : forall t, vderiv w t (angular_acceleration (inertia t) (inverse t) (w t) (tau t)).

(*@ motion.euler *)
(* Along Euler's equation, without torque the vector L = I w stands still in the world. *)
Theorem torque_free_momentum_constant : (forall t, tau t = vzero) -> forall t, momentum t = momentum 0.
Proof.
  intros Z. apply vconstant. intros t. rewrite <- (Z t). apply (proj2 (euler t _ (tau t) (Euler t))). reflexivity.
Qed.

(*@ motion.euler *)
(* Along Euler's equation the energy of turning changes at the rate tau.w ... *)
Theorem spin_energy_rate t : deriv (fun s => kinetic_energy 0 (inertia s) vzero (w s)) t (dot (tau t) (w t)).
Proof.
  pose proof (proj2 (euler t _ (tau t) (Euler t)) eq_refl) as L. fold momentum in L.
  pose proof (deriv_dot t w momentum _ _ (Euler t) L) as D.
  assert (S : dot (angular_acceleration (inertia t) (inverse t) (w t) (tau t)) (momentum t) = dot (tau t) (w t)).
  { unfold angular_acceleration. fold (momentum t). rewrite dot_comm, dot_tr.
    assert (E : mv (tr (inverse t)) (momentum t) = w t).
    { replace (tr (inverse t)) with (inverse t) by (unfold inverse, world_tensor; vring).
      unfold momentum. rewrite mv_mm, (proj1 (inverse_inertia_works t)), mv_id. reflexivity. }
    rewrite E. generalize (momentum t). intros. vring. }
  rewrite S in D.
  apply (deriv_ext (fun s => dot (w s) (momentum s) * / 2)).
  { intros s. unfold kinetic_energy, momentum. generalize (mv (inertia s) (w s)). intros. vunfold. field. }
  eapply deriv_is; [apply deriv_mult; [exact D|apply deriv_const]|]. rewrite (dot_comm (w t)). field.
Qed.

(*@ motion.euler *)
(* ... so it is constant without torque. *)
Theorem torque_free_energy_constant : (forall t, tau t = vzero) ->
  forall t, kinetic_energy 0 (inertia t) vzero (w t) = kinetic_energy 0 (inertia 0) vzero (w 0).
Proof.
  intros Z. apply (constant (fun s => kinetic_energy 0 (inertia s) vzero (w s))). intros t.
  eapply deriv_is; [apply spin_energy_rate|]. rewrite Z. vring.
Qed.
End Body.

(* -- the same in body axes, as the equations of the top are usually printed: I w' = (I w) x w -- *)
Section Top.
Variables (I : V) (w : R -> V).             (* principal moments; spin in body axes *)
Hypothesis HI : vx I <> 0 /\ vy I <> 0 /\ vz I <> 0.
Definition body_rate I w := angular_acceleration (diag I) (diag (cuboid_inverse_inertia I)) w vzero.
Hypothesis Euler : forall t, vderiv w t (body_rate I (w t)).

Lemma quadratic_rate c t : vderiv w t (body_rate I (w t)) ->
  deriv (fun s => dot (w s) (mv (diag c) (w s))) t (2 * dot (w t) (mv (diag c) (body_rate I (w t)))).
Proof.
  intros D. eapply deriv_is; [apply deriv_dot; [exact D|apply vderiv_mv; [apply mderiv_const|exact D]]|].
  generalize (body_rate I (w t)). intros. vring.
Qed.

(*@ motion.euler *)
(* In body axes, I w' = (I w) x w: the energy is constant ... *)
Theorem body_axes_energy_constant t : dot (w t) (mv (diag I) (w t)) = dot (w 0) (mv (diag I) (w 0)).
Proof.
  apply (constant (fun s => dot (w s) (mv (diag I) (w s)))). intros s.
  eapply deriv_is; [apply quadratic_rate, Euler|]. unfold body_rate, angular_acceleration, cuboid_inverse_inertia.
  generalize HI. vunfold. intros (? & ? & ?). field. auto.
Qed.

(*@ motion.euler *)
(* ... and so is |L|. *)
Theorem body_axes_momentum_constant t :
  let L s := mv (diag I) (w s) in dot (L t) (L t) = dot (L 0) (L 0).
Proof.
  intros L. set (c := V3 (vx I ^ 2) (vy I ^ 2) (vz I ^ 2)).
  assert (Q : forall s, dot (L s) (L s) = dot (w s) (mv (diag c) (w s))) by (intros; unfold L, c; vring).
  rewrite !Q. apply (constant (fun s => dot (w s) (mv (diag c) (w s)))). intros s.
  eapply deriv_is; [apply quadratic_rate, Euler|]. unfold c, body_rate, angular_acceleration, cuboid_inverse_inertia.
  generalize HI. vunfold. intros (? & ? & ?). field. auto.
Qed.

(*@ motion.euler *)
(* Case D-07: explicit Euler on these equations gains energy and momentum at every step, by exactly
   h^2/2 w'.I w' and h^2 |I w'|^2. *)
Theorem explicit_euler_gains h u :
  let u' := body_rate I u in let next := vadd u (smul h u') in
  let E x := dot x (mv (diag I) x) / 2 in let C x := dot (mv (diag I) x) (mv (diag I) x) in
  E next - E u = h ^ 2 / 2 * dot u' (mv (diag I) u') /\ C next - C u = h ^ 2 * C u'.
Proof.
  cbv zeta. unfold body_rate, angular_acceleration, cuboid_inverse_inertia. clear Euler. generalize HI. vunfold.
  intros (? & ? & ?). split; field; auto.
Qed.
End Top.
