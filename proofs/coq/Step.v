(* Semi-implicit Euler: what the method itself computes, step by step, in closed form. *)
Require Import Vec3 Laws Rotation GramSchmidt.

(* n steps under a constant acceleration and angular acceleration *)
Fixpoint steps n h s a alpha := match n with O => s | S k => semi_implicit_step h (steps k h s a alpha) a alpha end.

(*@ step.semi_implicit *)
(* Case D-02: v_n = v + n h a and p_n = p + t v + a t^2/2 + a t h/2, t = n h: beyond the parabola by a t h/2,
   whatever the step. *)
Theorem discrete_closed_form n h s a alpha :
  let last := steps n h s a alpha in let t := INR n * h in
  velocity last = vadd (velocity s) (smul t a)
  /\ spin last = vadd (spin s) (smul t alpha)
  /\ position last = vadd (vadd (position s) (vadd (smul t (velocity s)) (smul (t ^ 2 / 2) a))) (smul (t * h / 2) a).
Proof.
  cbv zeta. induction n as [|k (IHv & IHw & IHp)]; cbn [steps].
  - change (INR 0) with 0. repeat split; apply Veq; vunfold; field.
  - rewrite S_INR. unfold semi_implicit_step. cbn [velocity spin position orientation].
    rewrite IHv, IHw, IHp. generalize (INR k). intros x. repeat split; apply Veq; vunfold; field.
Qed.

(*@ step.semi_implicit *)
(* A rotation stays a rotation, for every step and every spin: Gram-Schmidt meets determinant 1 + h^2 w^2 only. *)
Theorem step_keeps_rotations h s a alpha :
  rotation (orientation s) -> rotation (orientation (semi_implicit_step h s a alpha)).
Proof.
  intros [_ D]. unfold semi_implicit_step. cbn [orientation]. apply gram_schmidt_right_handed.
  rewrite naive_step_det, D. set (w := vadd (spin s) (smul h alpha)).
  pose proof (dot_self_nonneg w). pose proof (pow2_ge_0 h). nra.
Qed.

(*@ step.semi_implicit *)
(* Case D-04: on a linear spring, a = -k p, the method keeps |v|^2/2 + k|p|^2/2 - h k p.v/2 exactly: it does not
   drift, it solves a spring next to the one asked for. *)
Theorem spring_invariant h k s alpha :
  let E s := dot (velocity s) (velocity s) / 2 + k * dot (position s) (position s) / 2
             - h * k * dot (position s) (velocity s) / 2 in
  E (semi_implicit_step h s (smul (- k) (position s)) alpha) = E s.
Proof. cbv zeta. unfold semi_implicit_step. cbn [position velocity]. generalize (position s) (velocity s). vfield. Qed.

(*@ step.semi_implicit *)
(* Without force and torque: a straight line, and a spin that stays as it is. *)
Theorem free_step h s : let next := semi_implicit_step h s vzero vzero in
  velocity next = velocity s /\ spin next = spin s /\ position next = vadd (position s) (smul h (velocity s)).
Proof. unfold semi_implicit_step. cbn [position velocity spin]. repeat split; vring. Qed.

(*@ step.semi_implicit *)
(* The first column turns exactly by the angle with tangent h w across it; Gram-Schmidt leaves its direction alone. *)
Theorem first_column h s a alpha :
  let w := vadd (spin s) (smul h alpha) in let c := col1 (orientation s) in
  col1 (orientation (semi_implicit_step h s a alpha)) = unit (vadd c (smul h (cross w c))).
Proof.
  intros w c. unfold semi_implicit_step. cbn [orientation]. fold w.
  transitivity (u1 (naive_rotation_step h w (orientation s))).
  - unfold gram_schmidt. generalize (naive_rotation_step h w (orientation s)). intros X.
    generalize (u1 X) (u2 X) (u3 X). intros [] ? ?. reflexivity.
  - unfold u1. f_equal. unfold c, naive_rotation_step, rotation_rate. generalize w (orientation s). clear. vring.
Qed.
