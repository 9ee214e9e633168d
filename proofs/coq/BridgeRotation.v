(* Gram-Schmidt and the step that calls it: as Bridge.v, for formulas with square roots. *)
Require Import Vec3 Laws Traced Bridge.

(* Roots: innermost first, each replaced by the norm it is, then treated as a number of its own. *)
Ltac inner_sqrt N := match goal with |- context [sqrt ?x] =>
  lazymatch x with context [sqrt _] => fail | _ => replace (sqrt x) with N end end.
Lemma norm_eq u x : x = dot u u -> sqrt x = norm u. Proof. intros ->. reflexivity. Qed.

(*@ bridge rotation.gram_schmidt *)
Theorem cpp_gram_schmidt_ok A : cpp_gram_schmidt A = gram_schmidt A.
Proof.
  unfold gram_schmidt, cpp_gram_schmidt. lazy zeta.
  set (b := without (col2 A) (u1 A)).
  set (c := without (without (col3 A) (u1 A)) (u2 A)).
  inner_sqrt (norm (col1 A)). 2:{ symmetry. apply norm_eq. vunfold. ring. }
  inner_sqrt (norm b).
  2:{ symmetry. apply norm_eq. unfold b, without, u1, unit. generalize (norm (col1 A)); intros.
      vunfold. unfold Rdiv. ring. }
  inner_sqrt (norm c).
  2:{ symmetry. apply norm_eq. unfold c, without, u2. fold b. unfold unit. generalize (norm b).
      unfold b, without, u1, unit. generalize (norm (col1 A)). intros. vunfold. unfold Rdiv. ring. }
  unfold u3. fold c. unfold unit at 1. generalize (norm c). unfold c, without, u2. fold b. unfold unit.
  generalize (norm b). unfold b, without, u1, unit. generalize (norm (col1 A)). intros. vunfold. unfold Rdiv.
  components; ring.
Qed.

(*@ bridge step.semi_implicit *)
(* The step calls Gram-Schmidt: the recording of the whole equals the recording of Gram-Schmidt on the naive step. *)
Theorem cpp_semi_implicit_step_ok h s a alpha :
  cpp_semi_implicit_step h s a alpha = semi_implicit_step h s a alpha.
Proof.
  unfold semi_implicit_step. cbv zeta. rewrite <- cpp_gram_schmidt_ok, <- cpp_naive_rotation_step_ok.
  vm_cast_no_check (eq_refl (cpp_semi_implicit_step h s a alpha)).
Qed.
