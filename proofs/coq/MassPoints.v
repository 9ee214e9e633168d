(* A rigid body as a finite heap of mass points: where m, the centre, the inertia tensor, P, L and T come from. *)
Require Import Vec3 Laws.
From Coq Require Import List.
Import ListNotations.

(* (mass, arm from the centre of mass) *)
Fixpoint sum (g : R -> V -> R) body := match body with [] => 0 | (m, r) :: rest => g m r + sum g rest end.
Fixpoint vsum (g : R -> V -> V) body := match body with [] => vzero | (m, r) :: rest => vadd (g m r) (vsum g rest) end.
(* of one point: m (|r|^2 1 - r r^T) *)
Definition point_tensor m r := mscale m (madd (mscale (dot r r) mid) (mscale (-1) (outer r r))).
Fixpoint tensor body := match body with [] => mzero | (m, r) :: rest => madd (point_tensor m r) (tensor rest) end.
Definition mass body := sum (fun m _ => m) body.
Definition centre body := vsum (fun m r => smul m r) body.

(*@ momentum.linear *)
(* All points together have the momentum of the mass at the centre. *)
Theorem momentum_of_points body v w : centre body = vzero ->
  vsum (fun m r => smul m (point_velocity v w r)) body = linear_momentum (mass body) v.
Proof.
  intros C.
  assert (E : vsum (fun m r => smul m (point_velocity v w r)) body = vadd (smul (mass body) v) (cross w (centre body))).
  { clear C. unfold mass, centre. induction body as [|[m r] rest IH]; cbn [sum vsum]; [vring|].
    rewrite IH. unfold point_velocity. vring. }
  rewrite E, C. unfold linear_momentum. vring.
Qed.

(*@ momentum.angular *)
(* Koenig: about any point o, the orbit of the mass at the centre p and the spin I w. *)
Theorem angular_momentum_of_points body p v w o : centre body = vzero ->
  vsum (fun m r => cross (vsub (vadd p r) o) (smul m (point_velocity v w r))) body
  = angular_momentum (mass body) (tensor body) p v w o.
Proof.
  intros C.
  assert (E : vsum (fun m r => cross (vsub (vadd p r) o) (smul m (point_velocity v w r))) body
    = vadd (angular_momentum (mass body) (tensor body) p v w o)
           (vadd (cross (centre body) v) (cross (vsub p o) (cross w (centre body))))).
  { clear C. unfold mass, centre, angular_momentum, linear_momentum.
    induction body as [|[m r] rest IH]; cbn [sum vsum tensor]; [vring|].
    rewrite IH. unfold point_velocity, point_tensor. vring. }
  rewrite E, C. generalize (angular_momentum (mass body) (tensor body) p v w o). vring.
Qed.

(*@ energy.kinetic *)
(* Koenig: the energy of all points is that of the mass at the centre and of the spin. *)
Theorem kinetic_energy_of_points body v w : centre body = vzero ->
  sum (fun m r => m * dot (point_velocity v w r) (point_velocity v w r) / 2) body
  = kinetic_energy (mass body) (tensor body) v w.
Proof.
  intros C.
  assert (E : sum (fun m r => m * dot (point_velocity v w r) (point_velocity v w r) / 2) body
    = kinetic_energy (mass body) (tensor body) v w + dot v (cross w (centre body))).
  { clear C. unfold mass, centre, kinetic_energy.
    induction body as [|[m r] rest IH]; cbn [sum vsum tensor]; [vunfold; field|].
    rewrite IH. unfold point_velocity, point_tensor. vunfold. field. }
  rewrite E, C. vring.
Qed.

(*@ energy.kinetic *)
(* Never negative, and zero only at rest. *)
Theorem kinetic_energy_positive m I v w : 0 < m -> posdef I ->
  0 <= kinetic_energy m I v w /\ (kinetic_energy m I v w = 0 -> v = vzero /\ w = vzero).
Proof.
  intros Hm HI. unfold kinetic_energy. pose proof (posdef_possemi I HI w). pose proof (dot_self_nonneg v).
  split; [nra|]. intros E.
  assert (V0 : dot v v = 0) by nra. assert (W0 : dot w (mv I w) = 0) by nra.
  split; [apply dot_self_zero, V0|].
  destruct (Req_dec (dot w w) 0) as [Z|Z]; [apply dot_self_zero, Z|].
  exfalso. assert (N : w <> vzero) by (intros ->; apply Z; vring). specialize (HI w N). lra.
Qed.

(*@ inertia.world *)
(* Turning every point by Rot turns the tensor into Rot I Rot^T. *)
Theorem tensor_turns body Rot : orthogonal Rot ->
  tensor (map (fun mr => (fst mr, mv Rot (snd mr))) body) = mm Rot (mm (tensor body) (tr Rot)).
Proof.
  intros O. destruct O as [H H'].
  assert (P : forall m r, point_tensor m (mv Rot r) = mm Rot (mm (point_tensor m r) (tr Rot))).
  { intros m r. unfold point_tensor. rewrite rotation_dot by (split; assumption).
    transitivity (mscale m (madd (mscale (dot r r) (mm Rot (tr Rot))) (mscale (-1) (mm Rot (mm (outer r r) (tr Rot)))))).
    - rewrite H'. generalize (dot r r). clear. vring.
    - generalize (dot r r). clear. vring. }
  induction body as [|[m r] rest IH]; cbn [map tensor fst snd]; [vring|].
  rewrite IH, P. generalize (point_tensor m r) (tensor rest). clear. vring.
Qed.

(*@ inertia.cuboid *)
(* Parallel axes: moving every point by d adds the tensor of the whole mass at d. *)
Theorem tensor_shifts body d : centre body = vzero ->
  tensor (map (fun mr => (fst mr, vadd d (snd mr))) body) = madd (tensor body) (point_tensor (mass body) d).
Proof.
  intros C.
  assert (E : tensor (map (fun mr => (fst mr, vadd d (snd mr))) body)
    = madd (madd (tensor body) (point_tensor (mass body) d))
           (madd (mscale (2 * dot d (centre body)) mid)
                 (mscale (-1) (madd (outer d (centre body)) (outer (centre body) d))))).
  { clear C. unfold mass, centre, point_tensor. induction body as [|[m r] rest IH]; cbn [map tensor sum vsum fst snd]; [vring|].
    rewrite IH. unfold point_tensor. vring. }
  rewrite E, C. generalize (madd (tensor body) (point_tensor (mass body) d)). clear. vring.
Qed.
