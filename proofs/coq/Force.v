(* Forces on a rigid body: what their sum and their torque stand for. *)
Require Import Vec3 Laws.
From Coq Require Import List Permutation.
Import ListNotations.

(*@ force.torque *)
(* The torque is what a force adds to the power of a body that turns: f.(v + w x r) = f.v + tau.w ... *)
Theorem torque_is_power v w r f :
  dot f (point_velocity v w r) = dot f v + dot (torque_of_force r f) w.
Proof. unfold point_velocity, torque_of_force. vring. Qed.

(*@ force.torque *)
(* ... and no other vector does. *)
Theorem torque_unique r f tau : (forall w, dot f (cross w r) = dot tau w) -> tau = torque_of_force r f.
Proof.
  intros H. apply vsub_zero, dot_self_zero. set (d := vsub tau (torque_of_force r f)).
  transitivity (dot tau d - dot (torque_of_force r f) d); [unfold d; vring|].
  rewrite <- (H d). unfold torque_of_force. vring.
Qed.

(*@ force.torque *)
(* A force may slide along its line; taken about another point its torque changes by the cross product of the shift. *)
Theorem torque_of_shifted_force r d f l :
  torque_of_force (vadd r (smul l f)) f = torque_of_force r f
  /\ torque_of_force (vadd r d) f = vadd (torque_of_force r f) (torque_of_force d f).
Proof. unfold torque_of_force. split; vring. Qed.

(* a list of (arm, force) *)
Definition no_force := {| force := vzero; torque := vzero |}.
Definition wrench_of forces := fold_left (fun sum rf => add_force sum (fst rf) (snd rf)) forces no_force.
Fixpoint total (g : V * V -> V) forces := match forces with [] => vzero | rf :: rest => vadd (g rf) (total g rest) end.

Lemma wrench_from forces start :
  fold_left (fun sum rf => add_force sum (fst rf) (snd rf)) forces start
  = {| force := vadd (force start) (total snd forces);
       torque := vadd (torque start) (total (fun rf => cross (fst rf) (snd rf)) forces) |}.
Proof.
  revert start. induction forces as [|[r f] rest IH]; intros [F tau]; cbn [fold_left total force torque fst snd].
  - f_equal; vring.
  - rewrite IH. unfold add_force; cbn [force torque]. f_equal; unfold torque_of_force; vring.
Qed.

(*@ force.sum *)
(* The accumulators hold F = sum f_i and tau = sum r_i x f_i. *)
Theorem wrench_is_the_sums forces :
  wrench_of forces = {| force := total snd forces; torque := total (fun rf => cross (fst rf) (snd rf)) forces |}.
Proof. unfold wrench_of. rewrite wrench_from. cbn [force torque no_force]. f_equal; vring. Qed.

(*@ force.sum *)
(* In any order. *)
Theorem wrench_order_is_free forces forces' : Permutation forces forces' -> wrench_of forces = wrench_of forces'.
Proof.
  intros P. rewrite !wrench_is_the_sums.
  assert (E : forall g, total g forces = total g forces').
  { intros g. induction P; cbn [total]; [reflexivity|rewrite IHP; reflexivity|vring|congruence]. }
  rewrite !E. reflexivity.
Qed.

Fixpoint power v w forces := match forces with
  | [] => 0 | (r, f) :: rest => dot f (point_velocity v w r) + power v w rest end.

(*@ force.sum *)
(* They are all that a rigid body feels: together the forces work at the rate F.v + tau.w. *)
Theorem wrench_works v w forces :
  power v w forces = dot (force (wrench_of forces)) v + dot (torque (wrench_of forces)) w.
Proof.
  rewrite wrench_is_the_sums. cbn [force torque].
  induction forces as [|[r f] rest IH]; cbn [power total fst snd]; [vring|].
  rewrite IH, torque_is_power, !dot_add_l. unfold torque_of_force. ring.
Qed.
