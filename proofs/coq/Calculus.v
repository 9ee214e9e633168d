(* Derivatives of vectors and matrices that depend on time, component by component. *)
Require Import Vec3.

Definition deriv (f : R -> R) t d := derivable_pt_lim f t d.
Definition vderiv (f : R -> V) t d :=
  deriv (fun s => vx (f s)) t (vx d) /\ deriv (fun s => vy (f s)) t (vy d) /\ deriv (fun s => vz (f s)) t (vz d).
Definition mderiv (f : R -> M) t d :=
  vderiv (fun s => col1 (f s)) t (col1 d) /\ vderiv (fun s => col2 (f s)) t (col2 d)
  /\ vderiv (fun s => col3 (f s)) t (col3 d).

Lemma deriv_is f t d d' : deriv f t d -> d = d' -> deriv f t d'. Proof. intros H <-. exact H. Qed.
Lemma deriv_const c t : deriv (fun _ => c) t 0. Proof. apply (derivable_pt_lim_const c). Qed.
Lemma deriv_plus f g t a b : deriv f t a -> deriv g t b -> deriv (fun s => f s + g s) t (a + b).
Proof. exact (derivable_pt_lim_plus f g t a b). Qed.
Lemma deriv_minus f g t a b : deriv f t a -> deriv g t b -> deriv (fun s => f s - g s) t (a - b).
Proof. exact (derivable_pt_lim_minus f g t a b). Qed.
Lemma deriv_mult f g t a b : deriv f t a -> deriv g t b -> deriv (fun s => f s * g s) t (a * g t + f t * b).
Proof. exact (derivable_pt_lim_mult f g t a b). Qed.
Lemma deriv_opp f t a : deriv f t a -> deriv (fun s => - f s) t (- a).
Proof. exact (derivable_pt_lim_opp f t a). Qed.
Lemma deriv_unique f t a b : deriv f t a -> deriv f t b -> a = b. Proof. apply uniqueness_limite. Qed.
Lemma deriv_ext f g t d : (forall s, f s = g s) -> deriv f t d -> deriv g t d.
Proof. intros E H eps He. destruct (H eps He) as (delta & Hd). exists delta. intros h. rewrite <- !E. apply Hd. Qed.
Lemma constant f : (forall t, deriv f t 0) -> forall t, f t = f 0.
Proof.
  intros D t. assert (pr : derivable f) by (intros x; exists 0; apply D).
  apply (null_derivative_1 f pr). intros x. apply derive_pt_eq_0, D.
Qed.

(* Follows the shape of the function; leaves the equality of the derivative found and the one claimed. *)
Ltac rule := first
  [ eassumption | apply deriv_plus; rule | apply deriv_minus; rule | apply deriv_mult; rule | apply deriv_opp; rule
  | apply deriv_const ].
Ltac differentiate := eapply deriv_is; [rule|].
Ltac vsplit := repeat split.

Section Vectors.
Variable t : R.
Lemma vderiv_is f d d' : vderiv f t d -> d = d' -> vderiv f t d'. Proof. intros H <-. exact H. Qed.
Lemma vderiv_const c : vderiv (fun _ => c) t vzero. Proof. vsplit; apply deriv_const. Qed.
Lemma vderiv_add f g a b : vderiv f t a -> vderiv g t b -> vderiv (fun s => vadd (f s) (g s)) t (vadd a b).
Proof. intros (?&?&?) (?&?&?); vsplit; cbn; differentiate; reflexivity. Qed.
Lemma vderiv_sub f g a b : vderiv f t a -> vderiv g t b -> vderiv (fun s => vsub (f s) (g s)) t (vsub a b).
Proof. intros (?&?&?) (?&?&?); vsplit; cbn; differentiate; reflexivity. Qed.
Lemma vderiv_smul f g a b : deriv f t a -> vderiv g t b ->
  vderiv (fun s => smul (f s) (g s)) t (vadd (smul a (g t)) (smul (f t) b)).
Proof. intros ? (?&?&?); vsplit; cbn; differentiate; reflexivity. Qed.
Lemma deriv_dot f g a b : vderiv f t a -> vderiv g t b ->
  deriv (fun s => dot (f s) (g s)) t (dot a (g t) + dot (f t) b).
Proof. intros (?&?&?) (?&?&?); unfold dot; differentiate; cbn beta; ring. Qed.
Lemma vderiv_cross f g a b : vderiv f t a -> vderiv g t b ->
  vderiv (fun s => cross (f s) (g s)) t (vadd (cross a (g t)) (cross (f t) b)).
Proof. intros (?&?&?) (?&?&?); vsplit; cbn; differentiate; cbn beta; ring. Qed.
Lemma mderiv_is f d d' : mderiv f t d -> d = d' -> mderiv f t d'. Proof. intros H <-. exact H. Qed.
Lemma mderiv_const c : mderiv (fun _ => c) t mzero. Proof. vsplit; apply deriv_const. Qed.
Lemma mderiv_add f g a b : mderiv f t a -> mderiv g t b -> mderiv (fun s => madd (f s) (g s)) t (madd a b).
Proof. intros ((?&?&?)&(?&?&?)&(?&?&?)) ((?&?&?)&(?&?&?)&(?&?&?)); vsplit; cbn in *; differentiate; reflexivity. Qed.
Lemma mderiv_scale f g a b : deriv f t a -> mderiv g t b ->
  mderiv (fun s => mscale (f s) (g s)) t (madd (mscale a (g t)) (mscale (f t) b)).
Proof. intros ? ((?&?&?)&(?&?&?)&(?&?&?)); vsplit; cbn in *; differentiate; reflexivity. Qed.
Lemma mderiv_tr f a : mderiv f t a -> mderiv (fun s => tr (f s)) t (tr a).
Proof. intros ((?&?&?)&(?&?&?)&(?&?&?)); vsplit; cbn in *; assumption. Qed.
Lemma vderiv_mv F f A a : mderiv F t A -> vderiv f t a ->
  vderiv (fun s => mv (F s) (f s)) t (vadd (mv A (f t)) (mv (F t) a)).
Proof. intros ((?&?&?)&(?&?&?)&(?&?&?)) (?&?&?); vsplit; cbn in *; differentiate; cbn beta; ring. Qed.
Lemma mderiv_mm F G A B : mderiv F t A -> mderiv G t B ->
  mderiv (fun s => mm (F s) (G s)) t (madd (mm A (G t)) (mm (F t) B)).
Proof.
  intros ((?&?&?)&(?&?&?)&(?&?&?)) ((?&?&?)&(?&?&?)&(?&?&?)); vsplit; cbn in *; differentiate; cbn beta; ring.
Qed.
Lemma vderiv_unique f a b : vderiv f t a -> vderiv f t b -> a = b.
Proof. intros (?&?&?) (?&?&?). apply Veq; eapply deriv_unique; eassumption. Qed.
Lemma vderiv_ext f g d : (forall s, f s = g s) -> vderiv f t d -> vderiv g t d.
Proof. intros E (?&?&?); vsplit; (eapply deriv_ext; [|eassumption]); intros; cbn beta; rewrite E; reflexivity. Qed.
End Vectors.

Lemma vconstant f : (forall t, vderiv f t vzero) -> forall t, f t = f 0.
Proof.
  intros D t. apply Veq.
  - apply (constant (fun s => vx (f s))). intros. apply D.
  - apply (constant (fun s => vy (f s))). intros. apply D.
  - apply (constant (fun s => vz (f s))). intros. apply D.
Qed.
Lemma mconstant f : (forall t, mderiv f t mzero) -> forall t, f t = f 0.
Proof.
  intros D t.
  assert (C1 : col1 (f t) = col1 (f 0)) by (apply (vconstant (fun s => col1 (f s))); intros; apply D).
  assert (C2 : col2 (f t) = col2 (f 0)) by (apply (vconstant (fun s => col2 (f s))); intros; apply D).
  assert (C3 : col3 (f t) = col3 (f 0)) by (apply (vconstant (fun s => col3 (f s))); intros; apply D).
  injection C1; injection C2; injection C3; intros. apply Meq; assumption.
Qed.
