(* A cuboid that lands flat on four corners (case P-10): the symmetric answer, and that it is the smallest one. *)
Require Import Vec3 Laws Impulse.

Section Landing.
Variables (m s e : R) (I half v : V).       (* mass, approach speed, restitution; moments, half edges, velocity *)
Hypothesis Hm : 0 < m.
Hypothesis HI : 0 < vx I /\ 0 < vy I /\ 0 < vz I.
Hypothesis Hh : 0 < vx half /\ 0 < vz half.
Hypothesis Hv : vy v = - s.                 (* the plane's normal is y *)

Definition up := V3 0 1 0.
(* the corner at (a, -1, b) half edges, a and b = +-1 *)
Definition corner a b :=
  {| inverse_mass := / m; inverse_inertia := diag (cuboid_inverse_inertia I);
     arm := V3 (a * vx half) (- vy half) (b * vz half) |}.
Definition land q1 q2 q3 q4 :=
  apply_impulse (corner 1 1) (apply_impulse (corner 1 (-1)) (apply_impulse (corner (-1) 1)
    (apply_impulse (corner (-1) (-1)) {| linear := v; angular := vzero |}
      (smul q4 up)) (smul q3 up)) (smul q2 up)) (smul q1 up).
Definition leaves a b u := dot (contact_velocity (corner a b) u) up.

Lemma leaves_by_impulses a b q1 q2 q3 q4 : leaves a b (land q1 q2 q3 q4) =
  - s + (q1 + q2 + q3 + q4) / m + a * vx half ^ 2 * (q1 + q2 - q3 - q4) / vz I + b * vz half ^ 2 * (q1 - q2 + q3 - q4) / vx I.
Proof.
  rewrite <- Hv. unfold leaves, land, corner, up, contact_velocity, point_velocity, apply_impulse, cuboid_inverse_inertia.
  cbn [linear angular inverse_mass inverse_inertia arm]. generalize HI. clear Hh Hv. vunfold. intros (a1 & a2 & a3).
  field. repeat split; lra.
Qed.

Let q := (1 + e) * m * s / 4.

(*@ impulse.apply *)
(* Case P-10: half edges and moments positive, approach at s along y, no spin before. A quarter of (1 + e) m s at each
   corner: no spin after, and every corner leaves with e times the approach speed. *)
Theorem flat_landing_quarters :
  land q q q q = {| linear := vadd v (smul ((1 + e) * s) up); angular := vzero |}
  /\ forall a b, leaves a b (land q q q q) = e * s.
Proof.
  split.
  - unfold land, corner, up, apply_impulse, cuboid_inverse_inertia, q.
    cbn [linear angular inverse_mass inverse_inertia arm]. clear Hh Hv. f_equal; apply Veq; generalize HI; vunfold;
      intros (a1 & a2 & a3); field; repeat split; lra.
  - intros. rewrite leaves_by_impulses. unfold q. field. repeat split; lra.
Qed.

(*@ impulse.apply *)
(* Case P-10: four impulses that make every corner leave at e s differ from the quarters by a twist d that moves nothing, so the quarters are the
   answer of least sum of squares. *)
Theorem flat_landing_smallest q1 q2 q3 q4 :
  (forall a b, (a = 1 \/ a = -1) -> (b = 1 \/ b = -1) -> leaves a b (land q1 q2 q3 q4) = e * s) ->
  q1 + q2 + q3 + q4 = (1 + e) * m * s
  /\ exists d, q1 = q + d /\ q2 = q - d /\ q3 = q - d /\ q4 = q + d
     /\ q1 ^ 2 + q2 ^ 2 + q3 ^ 2 + q4 ^ 2 = 4 * q ^ 2 + 4 * d ^ 2.
Proof.
  intros H.
  pose proof (H 1 1 ltac:(auto) ltac:(auto)) as E1. pose proof (H 1 (-1) ltac:(auto) ltac:(auto)) as E2.
  pose proof (H (-1) 1 ltac:(auto) ltac:(auto)) as E3. clear H.
  rewrite !leaves_by_impulses in *.
  set (X := vx half ^ 2 * (q1 + q2 - q3 - q4) / vz I). set (Z := vz half ^ 2 * (q1 - q2 + q3 - q4) / vx I).
  assert (x : X = 0) by (unfold X, Rdiv in *; lra). assert (z : Z = 0) by (unfold Z, Rdiv in *; lra).
  assert (S : (q1 + q2 + q3 + q4) / m = (1 + e) * s) by (unfold X, Z, Rdiv in *; lra).
  assert (S' : q1 + q2 + q3 + q4 = (1 + e) * m * s).
  { replace (q1 + q2 + q3 + q4) with ((q1 + q2 + q3 + q4) / m * m) by (field; lra). rewrite S. ring. }
  assert (Ex : q1 + q2 - q3 - q4 = 0).
  { unfold X in x. apply (Rmult_eq_reg_l (vx half ^ 2 / vz I)).
    - rewrite Rmult_0_r, <- x. field. lra.
    - apply Rgt_not_eq. apply Rdiv_lt_0_compat; [nra|lra]. }
  assert (Ez : q1 - q2 + q3 - q4 = 0).
  { unfold Z in z. apply (Rmult_eq_reg_l (vz half ^ 2 / vx I)).
    - rewrite Rmult_0_r, <- z. field. lra.
    - apply Rgt_not_eq. apply Rdiv_lt_0_compat; [nra|lra]. }
  split; [exact S'|]. exists (q1 - q).
  assert (Q : 4 * q = (1 + e) * m * s) by (unfold q; field).
  assert (q2 = q - (q1 - q)) by lra. assert (q3 = q - (q1 - q)) by lra. assert (q4 = q + (q1 - q)) by lra.
  repeat split; try lra. rewrite H, H0, H1. ring.
Qed.
End Landing.
