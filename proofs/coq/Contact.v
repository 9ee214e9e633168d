(* Positional correction: the smallest shift that takes every point of a body out of a half-space. *)
Require Import Vec3 Laws.
From Coq Require Import List.
Import ListNotations.

Section HalfSpace.
Variables (q n : V).                        (* a point of the plane, its unit normal towards the free side *)
Hypothesis Hn : dot n n = 1.
Definition gap p := dot (vsub p q) n.
(* how deep the deepest of the points lies; 0 if none is inside *)
Fixpoint depth (points : list V) := match points with [] => 0 | p :: rest => Rmax (- gap p) (depth rest) end.
Definition shift points := positional_correction (depth points) n.

Lemma depth_nonneg points : 0 <= depth points.
Proof. induction points; cbn [depth]; [lra|]. eapply Rle_trans; [exact IHpoints|apply Rmax_r]. Qed.
Lemma depth_bound points p : In p points -> - gap p <= depth points.
Proof.
  induction points as [|a rest IH]; intros H; destruct H; cbn [depth].
  - subst. apply Rmax_l.
  - eapply Rle_trans; [apply IH; assumption|apply Rmax_r].
Qed.
Lemma depth_attained points : depth points = 0 \/ exists p, In p points /\ - gap p = depth points.
Proof.
  induction points as [|a rest [IH|(p & Hp & IH)]]; cbn [depth]; [left; reflexivity| |];
    destruct (Rle_dec (depth rest) (- gap a)).
  - right. exists a. rewrite Rmax_left by assumption. split; [left|]; reflexivity.
  - left. rewrite Rmax_right by lra. exact IH.
  - right. exists a. rewrite Rmax_left by assumption. split; [left|]; reflexivity.
  - right. exists p. rewrite Rmax_right by lra. split; [right|]; assumption.
Qed.
Lemma shift_is points : shift points = smul (depth points) n.
Proof. unfold shift, positional_correction. rewrite Rmax_right by apply depth_nonneg. reflexivity. Qed.
Lemma gap_shifted p d : gap (vadd p d) = gap p + dot d n. Proof. unfold gap. vring. Qed.

(*@ contact.correction *)
(* n a unit vector, points the corners: after the correction no point is inside, and the deepest one lies in the plane; without penetration nothing moves. *)
Theorem correction_removes_the_deepest points :
  (forall p, In p points -> 0 <= gap (vadd p (shift points)))
  /\ ((exists p, In p points /\ gap p < 0) -> exists p, In p points /\ gap (vadd p (shift points)) = 0)
  /\ ((forall p, In p points -> 0 <= gap p) -> shift points = vzero).
Proof.
  split; [|split].
  - intros p Hp. rewrite gap_shifted, shift_is, dot_smul_l, Hn. pose proof (depth_bound points p Hp). lra.
  - intros (p & Hp & inside). destruct (depth_attained points) as [E|(d & Hd & E)].
    + pose proof (depth_bound points p Hp). lra.
    + exists d. split; [exact Hd|]. rewrite gap_shifted, shift_is, dot_smul_l, Hn. lra.
  - intros H. rewrite shift_is. destruct (depth_attained points) as [->|(d & Hd & E)]; [vring|].
    pose proof (H d Hd). pose proof (depth_nonneg points). replace (depth points) with 0 by lra. vring.
Qed.

(*@ contact.correction *)
(* ... and nothing else: along the plane nothing moves, and no shorter shift frees every point. *)
Theorem correction_does_nothing_else points :
  (forall t, dot t n = 0 -> dot t (shift points) = 0)
  /\ forall d, (forall p, In p points -> 0 <= gap (vadd p d)) -> dot (shift points) (shift points) <= dot d d.
Proof.
  split.
  - intros t Ht. rewrite shift_is, dot_smul_r, Ht. ring.
  - intros d H. rewrite shift_is, dot_smul_l, dot_smul_r, Hn.
    destruct (depth_attained points) as [->|(p & Hp & E)].
    + pose proof (dot_self_nonneg d). lra.
    + specialize (H p Hp). rewrite gap_shifted in H. pose proof (depth_nonneg points).
      (* depth <= d.n <= |d| *)
      assert (0 <= dot (vsub d (smul (dot d n) n)) (vsub d (smul (dot d n) n))) by apply dot_self_nonneg.
      assert (dot (vsub d (smul (dot d n) n)) (vsub d (smul (dot d n) n)) = dot d d - dot d n ^ 2 * (2 - dot n n)) by vring.
      rewrite Hn in *. nra.
Qed.
End HalfSpace.

(*@ contact.correction *)
(* It lifts the centre of mass by depth n, which costs m g.n depth of potential energy: the ledger's entry. *)
Theorem correction_lifts m g depth n : 0 <= depth ->
  - m * dot g (positional_correction depth n) = - m * dot g n * depth.
Proof. intros H. unfold positional_correction. rewrite Rmax_right by exact H. vring. Qed.
