(* Gram-Schmidt on three columns: orthonormal, the sign of the determinant kept, nothing else changed. *)
Require Import Vec3 Laws.

Lemma norm_sqr u : norm u * norm u = dot u u. Proof. apply sqrt_sqrt, dot_self_nonneg. Qed.
Lemma norm_pos u : 0 < dot u u -> 0 < norm u. Proof. apply sqrt_lt_R0. Qed.
Lemma unit_unit u : 0 < dot u u -> dot (unit u) (unit u) = 1.
Proof.
  intros H. unfold unit. rewrite dot_smul_l, dot_smul_r, <- norm_sqr. field. apply norm_pos in H. lra.
Qed.
Lemma det_nonzero a b c : det3 a b c <> 0 -> 0 < dot a a /\ 0 < dot b b /\ 0 < dot c c.
Proof. intros H; repeat split; apply dot_self_pos; intros ->; apply H; vunfold; ring. Qed.

Section GS.
Variable A : M.
Hypothesis independent : det A <> 0.
Let a := col1 A. Let b := col2 A. Let c := col3 A.
Definition b' A := without (col2 A) (u1 A).
Definition c' A := without (without (col3 A) (u1 A)) (u2 A).

Lemma det_b : det3 a (b' A) c = det A.
Proof. unfold b', without, u1, unit, a, c. generalize (/ norm (col1 A)). clear. vring. Qed.
Lemma det_bc : det3 a (b' A) (c' A) = det A.
Proof.
  rewrite <- det_b. unfold c', u2. fold (b' A). unfold without, u1, unit, a, c.
  generalize (/ norm (col1 A)) (/ norm (b' A)) (b' A). clear. vring.
Qed.
Lemma nonzero : 0 < dot a a /\ 0 < dot (b' A) (b' A) /\ 0 < dot (c' A) (c' A).
Proof. apply det_nonzero. rewrite det_bc. exact independent. Qed.

Lemma u11 : dot (u1 A) (u1 A) = 1. Proof. apply unit_unit, nonzero. Qed.
Lemma u22 : dot (u2 A) (u2 A) = 1. Proof. apply unit_unit, nonzero. Qed.
Lemma u33 : dot (u3 A) (u3 A) = 1. Proof. apply unit_unit, nonzero. Qed.
Lemma dot_without_self x u : dot u u = 1 -> dot u (without x u) = 0.
Proof. intros H. unfold without. rewrite dot_sub_r, dot_smul_r, H. ring. Qed.
Lemma dot_without p x q : dot p (without x q) = dot p x - dot q x * dot p q.
Proof. unfold without. rewrite dot_sub_r, dot_smul_r. reflexivity. Qed.
Lemma rebuild x u v : x = vadd (without (without x u) v) (vadd (smul (dot v (without x u)) v) (smul (dot u x) u)).
Proof. unfold without. vring. Qed.
Lemma u12 : dot (u1 A) (u2 A) = 0.
Proof. unfold u2. unfold unit at 1. rewrite dot_smul_r, dot_without_self by apply u11. ring. Qed.
Lemma u23 : dot (u2 A) (u3 A) = 0.
Proof. unfold u3. unfold unit at 1. rewrite dot_smul_r, dot_without_self by apply u22. ring. Qed.
Lemma u13 : dot (u1 A) (u3 A) = 0.
Proof.
  unfold u3. unfold unit at 1. rewrite dot_smul_r, dot_without, u12, (dot_without_self _ _ u11). ring.
Qed.
Lemma gram_matrix : mm (tr (gram_schmidt A)) (gram_schmidt A) = mid.
Proof.
  pose proof u11 as e11. pose proof u22 as e22. pose proof u33 as e33.
  pose proof u12 as e12. pose proof u13 as e13. pose proof u23 as e23.
  revert e11 e22 e33 e12 e13 e23. unfold gram_schmidt. generalize (u1 A) (u2 A) (u3 A). intros p q s.
  unfold dot. intros. apply Meq; cbn; lra.
Qed.
Lemma gram_det : det (gram_schmidt A) = det A / (norm a * norm (b' A) * norm (c' A)).
Proof.
  rewrite <- det_bc. destruct nonzero as (Ha & Hb & Hc). apply norm_pos in Ha, Hb, Hc.
  unfold gram_schmidt. replace (det (cols (u1 A) (u2 A) (u3 A))) with (det3 (u1 A) (u2 A) (u3 A)) by vring.
  unfold u3. fold (c' A). unfold u2 at 1. fold (b' A). unfold u1 at 1. fold a. unfold unit at 1 2 3.
  revert Ha Hb Hc. generalize a (b' A) (c' A). clear. intros x y z. generalize (norm x) (norm y) (norm z). intros.
  vunfold. field. repeat split; lra.
Qed.
End GS.

(*@ rotation.gram_schmidt *)
Theorem gram_schmidt_orthogonal A : det A <> 0 -> orthogonal (gram_schmidt A).
Proof. intros H. apply orthogonal_one_side, gram_matrix, H. Qed.

(*@ rotation.gram_schmidt *)
(* The sign of the determinant is kept: a right-handed input gives a rotation ... *)
Theorem gram_schmidt_right_handed A : 0 < det A -> rotation (gram_schmidt A).
Proof.
  intros H. assert (N : det A <> 0) by lra. split; [apply gram_schmidt_orthogonal, N|].
  assert (P : 0 < det (gram_schmidt A)).
  { rewrite gram_det by exact N. destruct (nonzero A N) as (Ha & Hb & Hc). apply norm_pos in Ha, Hb, Hc.
    apply Rdiv_lt_0_compat; [exact H|]. repeat apply Rmult_lt_0_compat; assumption. }
  assert (S : det (gram_schmidt A) * det (gram_schmidt A) = 1).
  { rewrite <- (det_tr (gram_schmidt A)) at 1. rewrite <- det_mm, (gram_matrix A N). vunfold. ring. }
  nra.
Qed.

(*@ rotation.gram_schmidt *)
(* ... a left-handed one a reflection: callers must refuse it, the determinant tells. *)
Theorem gram_schmidt_left_handed A : det A < 0 -> orthogonal (gram_schmidt A) /\ det (gram_schmidt A) = -1.
Proof.
  intros H. assert (N : det A <> 0) by lra. split; [apply gram_schmidt_orthogonal, N|].
  assert (P : det (gram_schmidt A) < 0).
  { rewrite gram_det by exact N. destruct (nonzero A N) as (Ha & Hb & Hc). apply norm_pos in Ha, Hb, Hc.
    assert (0 < - det A / (norm (col1 A) * norm (b' A) * norm (c' A))).
    { apply Rdiv_lt_0_compat; [lra|]. repeat apply Rmult_lt_0_compat; assumption. }
    unfold Rdiv in *. lra. }
  assert (S : det (gram_schmidt A) * det (gram_schmidt A) = 1).
  { rewrite <- (det_tr (gram_schmidt A)) at 1. rewrite <- det_mm, (gram_matrix A N). vunfold. ring. }
  nra.
Qed.

(*@ rotation.gram_schmidt *)
(* The first column keeps its direction, the second stays in the plane of the first two: A = Q U, U upper
   triangular with a positive diagonal. *)
Theorem gram_schmidt_is_QR A : det A <> 0 ->
  let Q := gram_schmidt A in let U := mm (tr Q) A in
  A = mm Q U /\ yx U = 0 /\ zx U = 0 /\ zy U = 0 /\ 0 < xx U /\ 0 < yy U /\ 0 < zz U.
Proof.
  intros H Q U. destruct (gram_schmidt_orthogonal A H) as [_ O]. fold Q in O.
  assert (E : A = mm Q U) by (unfold U; rewrite mm_assoc, O, id_mm; reflexivity).
  split; [exact E|].
  destruct (nonzero A H) as (Ha & Hb & Hc). apply norm_pos in Ha, Hb, Hc.
  pose proof (u11 A H) as e11. pose proof (u22 A H) as e22. pose proof (u33 A H) as e33.
  pose proof (u12 A H) as e12. pose proof (u13 A H) as e13. pose proof (u23 A H) as e23.
  (* the columns of A in terms of the u's *)
  assert (back : forall x, 0 < norm x -> smul (norm x) (unit x) = x).
  { intros x Hx. unfold unit. clear -Hx. revert Hx. generalize (norm x). intros n Hn. vfield; lra. }
  assert (A1 : col1 A = smul (norm (col1 A)) (u1 A)) by (symmetry; apply back, Ha).
  assert (A2 : col2 A = vadd (smul (norm (b' A)) (u2 A)) (smul (dot (u1 A) (col2 A)) (u1 A))).
  { unfold u2. fold (b' A). rewrite (back _ Hb). unfold b', without. vring. }
  assert (A3 : col3 A = vadd (smul (norm (c' A)) (u3 A))
    (vadd (smul (dot (u2 A) (without (col3 A) (u1 A))) (u2 A)) (smul (dot (u1 A) (col3 A)) (u1 A)))).
  { unfold u3. fold (c' A). rewrite (back _ Hc). unfold c'. apply rebuild. }
  assert (X : xx U = dot (u1 A) (col1 A) /\ yx U = dot (u2 A) (col1 A) /\ zx U = dot (u3 A) (col1 A)
    /\ yy U = dot (u2 A) (col2 A) /\ zy U = dot (u3 A) (col2 A) /\ zz U = dot (u3 A) (col3 A)).
  { unfold U, Q, gram_schmidt. generalize (u1 A) (u2 A) (u3 A). clear. intros. repeat split; vunfold; ring. }
  destruct X as (-> & -> & -> & -> & -> & ->).
  split; [|split; [|split; [|split; [|split]]]].
  - rewrite A1, dot_smul_r, (dot_comm (u2 A)), e12. ring.
  - rewrite A1, dot_smul_r, (dot_comm (u3 A)), e13. ring.
  - rewrite A2, dot_add_r, !dot_smul_r, !(dot_comm (u3 A)), e23, e13. ring.
  - rewrite A1, dot_smul_r, e11. lra.
  - rewrite A2, dot_add_r, !dot_smul_r, e22, (dot_comm (u2 A)), e12. lra.
  - rewrite A3, !dot_add_r, !dot_smul_r, e33, !(dot_comm (u3 A)), e23, e13. lra.
Qed.

(*@ rotation.gram_schmidt *)
(* An orthogonal matrix, rotation or reflection, is returned as it is. *)
Theorem gram_schmidt_fixes_orthogonal A : orthogonal A -> gram_schmidt A = A.
Proof.
  intros [H _].
  assert (G : dot (col1 A) (col1 A) = 1 /\ dot (col2 A) (col2 A) = 1 /\ dot (col3 A) (col3 A) = 1
    /\ dot (col1 A) (col2 A) = 0 /\ dot (col1 A) (col3 A) = 0 /\ dot (col2 A) (col3 A) = 0).
  { pose proof (f_equal xx H). pose proof (f_equal yy H). pose proof (f_equal zz H).
    pose proof (f_equal xy H). pose proof (f_equal xz H). pose proof (f_equal yz H). cbn in *. unfold dot; cbn. lra. }
  destruct G as (g11 & g22 & g33 & g12 & g13 & g23).
  assert (one : forall u, dot u u = 1 -> unit u = u).
  { intros u E. unfold unit, norm. rewrite E, sqrt_1, Rinv_1. vring. }
  assert (skip : forall x u, dot u x = 0 -> without x u = x).
  { intros x u E. unfold without. rewrite E. vring. }
  unfold gram_schmidt, u3, u2, u1. rewrite (one (col1 A) g11).
  rewrite (skip (col2 A) (col1 A) g12), (one (col2 A) g22), (skip (col3 A) (col1 A) g13), (skip (col3 A) (col2 A) g23), (one _ g33).
  destruct A. reflexivity.
Qed.

(*@ rotation.gram_schmidt *)
(* Subtracting both projections of the original third column (classical order) is the same map over the reals. *)
Theorem gram_schmidt_classical A : det A <> 0 ->
  without (without (col3 A) (u1 A)) (u2 A)
  = vsub (col3 A) (vadd (smul (dot (u1 A) (col3 A)) (u1 A)) (smul (dot (u2 A) (col3 A)) (u2 A))).
Proof.
  intros H. set (x := without (col3 A) (u1 A)).
  assert (E : dot (u2 A) x = dot (u2 A) (col3 A)).
  { unfold x. rewrite dot_without, (dot_comm (u2 A) (u1 A)), (u12 A H). ring. }
  unfold without at 1. rewrite E. unfold x, without. generalize (u1 A) (u2 A). vring.
Qed.
