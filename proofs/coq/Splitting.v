(* Torque-free rotation as a product of rotations: splitting methods keep the angular momentum vector exactly. *)
Require Import Vec3 Laws Calculus Motion Rotation.

(* orientation and angular momentum in body axes; L in the world is Rot L *)
Record Spinning := { turned : M; body_L : V }.
Definition world_L s := mv (turned s) (body_L s).
(* a sub-step: the body turns by some rotation of its own axes, and L, fixed in space, turns back in the body *)
Definition substep Q s := {| turned := mm (turned s) Q; body_L := mv (tr Q) (body_L s) |}.

(*@ law.splitting *)
(* Every sub-step keeps L in the world, whatever axis and angle: so does every composition of them. *)
Theorem substep_keeps_L Q s : orthogonal Q -> world_L (substep Q s) = world_L s.
Proof.
  intros [_ H]. unfold world_L, substep. cbn [turned body_L]. rewrite <- mv_mm, (mv_mm Q), H, mv_id. reflexivity.
Qed.

(*@ law.splitting *)
(* The factor taken out, a rotation about L itself in the world, keeps it as well. *)
Theorem casimir_factor_keeps_L a phi s : dot a a = 1 -> (exists l, world_L s = smul l a) ->
  world_L {| turned := mm (rodrigues a phi) (turned s); body_L := body_L s |} = world_L s.
Proof.
  intros Ha (l & E). unfold world_L in *. cbn [turned body_L]. rewrite <- mv_mm, E, mv_smul.
  rewrite (proj1 (rodrigues_adds_angles a phi 0 Ha)). reflexivity.
Qed.

(* With the spin u in body axes R' = R [u]: the transpose obeys the law of Motion.v with the spin -u. *)
Lemma body_rate_keeps_rotations (S : R -> M) (u : R -> V) :
  (forall t, mderiv S t (mm (S t) (hat (u t)))) -> rotation (S 0) -> forall t, rotation (S t).
Proof.
  intros HS R0 t. rewrite <- (tr_tr (S t)). apply rotation_tr.
  apply (rate_keeps_rotations (fun s => smul (-1) (u s)) (fun s => tr (S s))); [|apply rotation_tr, R0].
  intros s. eapply mderiv_is; [apply mderiv_tr, HS|]. unfold rotation_rate. generalize (S s) (u s). vring.
Qed.

(*@ law.splitting *)
(* Taking |L|^2/(2 I2) out of the energy is exact. L is l a in the world and J the diagonal of the inverse moments.
   If S moves with the spin (J - k) S^T L, then exp(t k [L]) S moves with the spin J R^T L of the free body, and sees
   the same L in body axes. *)
Theorem casimir_removed_is_exact a l J k (S : R -> M) : dot a a = 1 -> rotation (S 0) ->
  let L_in t := mv (tr (S t)) (smul l a) in
  (forall t, mderiv S t (mm (S t) (hat (vsub (mv (diag J) (L_in t)) (smul k (L_in t)))))) ->
  let Rot t := mm (rodrigues a (k * l * t)) (S t) in
  forall t, mv (tr (Rot t)) (smul l a) = L_in t
            /\ mderiv Rot t (mm (Rot t) (hat (mv (diag J) (mv (tr (Rot t)) (smul l a))))).
Proof.
  intros Ha R0 L_in HS Rot t. pose proof (body_rate_keeps_rotations S _ HS R0) as HR.
  destruct (rodrigues_is_a_rotation a (k * l * t) Ha) as [[O O'] DE].
  assert (AX : mv (tr (rodrigues a (k * l * t))) a = a).
  { rewrite <- (proj1 (rodrigues_adds_angles a (k * l * t) 0 Ha)) at 2. rewrite mv_mm, O, mv_id. reflexivity. }
  assert (EL : mv (tr (Rot t)) (smul l a) = L_in t).
  { unfold Rot, L_in. rewrite tr_mm, <- mv_mm, !mv_smul, AX. reflexivity. }
  split; [exact EL|]. rewrite EL.
  eapply mderiv_is; [apply mderiv_mm; [apply rodrigues_deriv, Ha|apply HS]|].
  (* [l a] R = R [R^T l a] = R [L_in], for the rotation R = Rot t *)
  assert (RR : rotation (Rot t)) by (apply rotation_mm; [split; [split|]; assumption|apply HR]).
  assert (T : mm (hat (smul (k * l) a)) (Rot t) = mm (Rot t) (hat (smul k (L_in t)))).
  { apply mv_ext. intros u. rewrite <- !mv_mm, !hat_cross, <- (rotation_cross _ _ _ RR). f_equal.
    rewrite mv_smul, <- EL, mv_mm, (proj2 (proj1 RR)), mv_id. vring. }
  transitivity (madd (mm (hat (smul (k * l) a)) (Rot t))
                     (mm (Rot t) (hat (vsub (mv (diag J) (L_in t)) (smul k (L_in t)))))).
  - unfold Rot. rewrite !mm_assoc. reflexivity.
  - rewrite T. generalize (Rot t) (L_in t). clear. vring.
Qed.
