(* Vectors and 3x3 matrices over R as plain records, from Coq's standard library alone. Everything is transparent,
   so vring and vfield reduce a vector identity to one polynomial identity per component. *)
From Coq Require Export Reals Lra Lia Psatz Field.
Global Open Scope R_scope.

Record V := V3 { vx : R; vy : R; vz : R }.
Record M := M3 { xx : R; xy : R; xz : R;
                 yx : R; yy : R; yz : R;
                 zx : R; zy : R; zz : R }.

Definition vzero := V3 0 0 0.
Definition vadd a b := V3 (vx a + vx b) (vy a + vy b) (vz a + vz b).
Definition vsub a b := V3 (vx a - vx b) (vy a - vy b) (vz a - vz b).
Definition smul s a := V3 (s * vx a) (s * vy a) (s * vz a).
Definition dot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition cross a b := V3 (vy a * vz b - vz a * vy b)
                           (vz a * vx b - vx a * vz b)
                           (vx a * vy b - vy a * vx b).
Definition mv (A : M) (u : V) :=
  V3 (xx A * vx u + xy A * vy u + xz A * vz u)
     (yx A * vx u + yy A * vy u + yz A * vz u)
     (zx A * vx u + zy A * vy u + zz A * vz u).
Definition mm (A B : M) := M3
  (xx A * xx B + xy A * yx B + xz A * zx B) (xx A * xy B + xy A * yy B + xz A * zy B)
  (xx A * xz B + xy A * yz B + xz A * zz B)
  (yx A * xx B + yy A * yx B + yz A * zx B) (yx A * xy B + yy A * yy B + yz A * zy B)
  (yx A * xz B + yy A * yz B + yz A * zz B)
  (zx A * xx B + zy A * yx B + zz A * zx B) (zx A * xy B + zy A * yy B + zz A * zy B)
  (zx A * xz B + zy A * yz B + zz A * zz B).
Definition madd (A B : M) := M3
  (xx A + xx B) (xy A + xy B) (xz A + xz B) (yx A + yx B) (yy A + yy B) (yz A + yz B) (zx A + zx B) (zy A + zy B)
  (zz A + zz B).
Definition mscale s (A : M) := M3
  (s * xx A) (s * xy A) (s * xz A) (s * yx A) (s * yy A) (s * yz A) (s * zx A) (s * zy A) (s * zz A).
Definition tr (A : M) := M3 (xx A) (yx A) (zx A) (xy A) (yy A) (zy A) (xz A) (yz A) (zz A).
Definition mid := M3 1 0 0 0 1 0 0 0 1.
Definition mzero := M3 0 0 0 0 0 0 0 0 0.
Definition hat w := M3 0 (- vz w) (vy w) (vz w) 0 (- vx w) (- vy w) (vx w) 0.
Definition outer a b := M3 (vx a * vx b) (vx a * vy b) (vx a * vz b)
                           (vy a * vx b) (vy a * vy b) (vy a * vz b)
                           (vz a * vx b) (vz a * vy b) (vz a * vz b).
Definition cols a b c := M3 (vx a) (vx b) (vx c) (vy a) (vy b) (vy c) (vz a) (vz b) (vz c).
Definition diag (a : V) := M3 (vx a) 0 0 0 (vy a) 0 0 0 (vz a).
Definition col1 A := V3 (xx A) (yx A) (zx A).
Definition col2 A := V3 (xy A) (yy A) (zy A).
Definition col3 A := V3 (xz A) (yz A) (zz A).
Definition det3 a b c := dot a (cross b c).
Definition det A := det3 (col1 A) (col2 A) (col3 A).
Definition norm u := sqrt (dot u u).
Definition unit u := smul (/ norm u) u.

Definition sym A := xy A = yx A /\ xz A = zx A /\ yz A = zy A.
Definition posdef A := forall u, u <> vzero -> 0 < dot u (mv A u).
Definition possemi A := forall u, 0 <= dot u (mv A u).
Definition orthogonal A := mm (tr A) A = mid /\ mm A (tr A) = mid.
Definition rotation A := orthogonal A /\ det A = 1.

(* Unfold to components in ONE lazy step, projections included: cbv followed by cbn costs the kernel up to 100 times
   more at Qed. Variables are not destructed: under repeat, destructing a section variable never ends. *)
Ltac vunfold := lazy beta iota zeta delta
  [vzero vadd vsub smul dot cross mv mm madd mscale tr mid mzero hat outer cols diag
   col1 col2 col3 det3 det vx vy vz xx xy xz yx yy yz zx zy zz].
Lemma Veq a b : vx a = vx b -> vy a = vy b -> vz a = vz b -> a = b.
Proof. destruct a, b; cbn; intros -> -> ->; reflexivity. Qed.
Lemma Meq A B : xx A = xx B -> xy A = xy B -> xz A = xz B -> yx A = yx B -> yy A = yy B ->
  yz A = yz B -> zx A = zx B -> zy A = zy B -> zz A = zz B -> A = B.
Proof. destruct A, B; cbn; intros -> -> -> -> -> -> -> -> ->; reflexivity. Qed.
Ltac veq := match goal with
  | |- @eq V _ _ => apply Veq | |- @eq M _ _ => apply Meq | |- _ => idtac end.
Ltac vring := intros; veq; vunfold; ring.
Ltac vfield := intros; veq; vunfold; field.

Lemma dot_comm a b : dot a b = dot b a. Proof. vring. Qed.
Lemma dot_add_r a b c : dot a (vadd b c) = dot a b + dot a c. Proof. vring. Qed.
Lemma dot_add_l a b c : dot (vadd a b) c = dot a c + dot b c. Proof. vring. Qed.
Lemma dot_sub_r a b c : dot a (vsub b c) = dot a b - dot a c. Proof. vring. Qed.
Lemma dot_sub_l a b c : dot (vsub a b) c = dot a c - dot b c. Proof. vring. Qed.
Lemma dot_smul_r s a b : dot a (smul s b) = s * dot a b. Proof. vring. Qed.
Lemma dot_smul_l s a b : dot (smul s a) b = s * dot a b. Proof. vring. Qed.
Lemma mv_add A a b : mv A (vadd a b) = vadd (mv A a) (mv A b). Proof. vring. Qed.
Lemma mv_smul A s a : mv A (smul s a) = smul s (mv A a). Proof. vring. Qed.
Lemma mv_mm A B u : mv A (mv B u) = mv (mm A B) u. Proof. vring. Qed.
Lemma mv_id u : mv mid u = u. Proof. vring. Qed.
Lemma cross_smul_r s a b : cross a (smul s b) = smul s (cross a b). Proof. vring. Qed.
Lemma triple a b c : dot (cross a b) c = dot a (cross b c). Proof. vring. Qed.
Lemma hat_cross w u : mv (hat w) u = cross w u. Proof. vring. Qed.
Lemma sym_dot A a b : sym A -> dot a (mv A b) = dot b (mv A a).
Proof. destruct A, a, b; unfold sym; cbn; intros (-> & -> & ->); vunfold; ring. Qed.
Lemma dot_self_nonneg a : 0 <= dot a a.
Proof. destruct a; vunfold; nra. Qed.
Lemma dot_self_pos a : a <> vzero -> 0 < dot a a.
Proof.
  intros H. destruct (Rle_lt_or_eq_dec _ _ (dot_self_nonneg a)) as [|E]; [assumption|].
  exfalso; apply H. destruct a as [x y z]; revert E; vunfold; intros E.
  assert (x = 0) by nra; assert (y = 0) by nra; assert (z = 0) by nra; subst; reflexivity.
Qed.
Lemma dot_self_zero a : dot a a = 0 -> a = vzero.
Proof.
  destruct a as [x y z]. vunfold. intros E.
  assert (x = 0) by nra; assert (y = 0) by nra; assert (z = 0) by nra; subst; reflexivity.
Qed.
Lemma vsub_zero a b : vsub a b = vzero -> a = b.
Proof. destruct a, b. vunfold. intros E; injection E; intros. apply Veq; cbn; lra. Qed.
Lemma mm_assoc A B C : mm A (mm B C) = mm (mm A B) C. Proof. vring. Qed.
Lemma mm_id A : mm A mid = A. Proof. vring. Qed.
Lemma id_mm A : mm mid A = A. Proof. vring. Qed.
Lemma tr_mm A B : tr (mm A B) = mm (tr B) (tr A). Proof. vring. Qed.
Lemma tr_tr A : tr (tr A) = A. Proof. vring. Qed.
Lemma dot_tr A a b : dot a (mv A b) = dot (mv (tr A) a) b. Proof. vring. Qed.
Lemma det_mm A B : det (mm A B) = det A * det B. Proof. vring. Qed.
Lemma det_tr A : det (tr A) = det A. Proof. vring. Qed.

Lemma posdef_possemi A : posdef A -> possemi A.
Proof.
  intros H u. destruct (Req_dec (dot u u) 0) as [E|E].
  - apply dot_self_zero in E. subst. vunfold. lra.
  - apply Rlt_le, H. intros ->. apply E. vring.
Qed.

(* A rotation carries cross products along; an orthogonal matrix alone would bring in the sign of its determinant. *)
Lemma rotation_dot A a b : orthogonal A -> dot (mv A a) (mv A b) = dot a b.
Proof. intros [H _]. rewrite dot_tr, mv_mm, H, mv_id. reflexivity. Qed.
Lemma rotation_cross A a b : rotation A -> cross (mv A a) (mv A b) = mv A (cross a b).
Proof.
  intros [[_ H] D].
  assert (E : mv (tr A) (cross (mv A a) (mv A b)) = smul (det A) (cross a b)) by vring.
  rewrite D in E. apply (f_equal (mv A)) in E. rewrite mv_mm, H, mv_id in E. rewrite E. vring.
Qed.
Lemma rotation_tr A : rotation A -> rotation (tr A).
Proof. intros [[H H'] D]. repeat split; rewrite ?tr_tr, ?det_tr; assumption. Qed.
Lemma rotation_mm A B : rotation A -> rotation B -> rotation (mm A B).
Proof.
  intros [[HA HA'] DA] [[HB HB'] DB]. repeat split.
  - rewrite tr_mm, <- mm_assoc, (mm_assoc (tr A)), HA, id_mm. exact HB.
  - rewrite tr_mm, <- mm_assoc, (mm_assoc B), HB', id_mm. exact HA'.
  - rewrite det_mm, DA, DB. ring.
Qed.
(* One side suffices: a square matrix with orthonormal columns has orthonormal rows. *)
Lemma orthogonal_one_side A : mm (tr A) A = mid -> orthogonal A.
Proof.
  intros H. split; [exact H|].
  assert (D : det A * det A = 1).
  { rewrite <- (det_tr A) at 1. rewrite <- det_mm, H. vunfold. ring. }
  (* the adjugate is a left and a right inverse up to det A *)
  set (J := M3 (yy A * zz A - yz A * zy A) (xz A * zy A - xy A * zz A) (xy A * yz A - xz A * yy A)
               (yz A * zx A - yx A * zz A) (xx A * zz A - xz A * zx A) (xz A * yx A - xx A * yz A)
               (yx A * zy A - yy A * zx A) (xy A * zx A - xx A * zy A) (xx A * yy A - xy A * yx A)).
  assert (L : mm A J = mscale (det A) mid) by (unfold J; vring).
  assert (E : mscale (det A) (tr A) = J).
  { transitivity (mm (mm (tr A) A) J); [|rewrite H; apply id_mm].
    rewrite <- mm_assoc, L. vring. }
  assert (F : mscale (det A) (mm A (tr A)) = mscale (det A) mid).
  { transitivity (mm A (mscale (det A) (tr A))); [vring|]. rewrite E. exact L. }
  apply (f_equal (mscale (det A))) in F.
  assert (G : forall B, mscale (det A) (mscale (det A) B) = B).
  { intros B. transitivity (mscale (det A * det A) B); [unfold mscale; apply Meq; cbn; ring|].
    rewrite D. vring. }
  rewrite !G in F. exact F.
Qed.
Lemma vadd_cancel a b c : vadd a b = vadd a c -> b = c.
Proof. destruct a, b, c. vunfold. intros E; injection E; intros. apply Veq; cbn; lra. Qed.
(* A matrix is what it does to vectors. *)
Lemma mv_ext A B : (forall u, mv A u = mv B u) -> A = B.
Proof.
  intros H. pose proof (H (V3 1 0 0)) as E1. pose proof (H (V3 0 1 0)) as E2. pose proof (H (V3 0 0 1)) as E3.
  destruct A, B. revert E1 E2 E3. vunfold. intros E1 E2 E3. injection E1; injection E2; injection E3. intros.
  apply Meq; cbn; lra.
Qed.
Lemma sym_tr A : sym A <-> tr A = A.
Proof.
  destruct A as [a b c d e f g h i]. unfold sym. vunfold. split.
  - intros (-> & -> & ->). reflexivity.
  - intros E; injection E; intros; subst; auto.
Qed.
Lemma posdef_diag a : 0 < vx a -> 0 < vy a -> 0 < vz a -> posdef (diag a).
Proof.
  destruct a as [p q r]; cbn [vx vy vz]. intros Hp Hq Hr [x y z] Hu. pose proof (dot_self_pos _ Hu) as P. revert P.
  vunfold. intros P.
  assert (X : 0 <= x * x) by nra. assert (Y : 0 <= y * y) by nra. assert (Z : 0 <= z * z) by nra.
  set (m := Rmin p (Rmin q r)).
  assert (Hm : 0 < m) by (unfold m; repeat apply Rmin_glb_lt; assumption).
  assert (m <= p) by apply Rmin_l.
  assert (m <= q) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_l]).
  assert (m <= r) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_r]).
  assert (m * (x * x) <= p * (x * x)) by (apply Rmult_le_compat_r; assumption).
  assert (m * (y * y) <= q * (y * y)) by (apply Rmult_le_compat_r; assumption).
  assert (m * (z * z) <= r * (z * z)) by (apply Rmult_le_compat_r; assumption).
  assert (0 < m * (x * x + y * y + z * z)) by (apply Rmult_lt_0_compat; assumption). lra.
Qed.
