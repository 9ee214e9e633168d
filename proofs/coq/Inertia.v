(* Inertia of a homogeneous cuboid from the volume integral (Coquelicot's Riemann integral), wherever it lies. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Require Import Vec3 Laws.
Open Scope R_scope.

(* Coquelicot speaks of a module over R: say that an equation is one of plain numbers, or ring does not see it. *)
Ltac numbers := match goal with |- ?a = ?b => change (@eq R a b) end.

(* over [c - h/2, c + h/2]: k + l x + m x^2 *)
Lemma RInt_quadratic k l m c h :
  RInt (fun x => k + l * x + m * (x * x)) (c - h / 2) (c + h / 2) = h * (k + l * c + m * (c ^ 2 + h ^ 2 / 12)).
Proof.
  apply is_RInt_unique.
  set (F := fun x => k * x + l / 2 * x ^ 2 + m / 3 * x ^ 3).
  replace (h * (k + l * c + m * (c ^ 2 + h ^ 2 / 12))) with (minus (F (c + h / 2)) (F (c - h / 2))).
  2:{ unfold F, minus, plus, opp; cbn. field. }
  apply (is_RInt_derive F).
  - intros x _. unfold F. auto_derive; [exact I|field].
  - intros x _. apply (ex_derive_continuous (fun x => k + l * x + m * (x * x))). auto_derive. exact I.
Qed.
Lemma integrand (f g : R -> R) a b : (forall x, f x = g x) -> RInt f a b = RInt g a b.
Proof. intros H. apply RInt_ext. intros x _. apply H. Qed.

(* the integral of rho f over the box with centre c and full edges s *)
Definition over_box rho c s (f : V -> R) : R :=
  RInt (fun x => RInt (fun y => RInt (fun z => rho * f (V3 x y z))
    (vz c - vz s / 2) (vz c + vz s / 2)) (vy c - vy s / 2) (vy c + vy s / 2)) (vx c - vx s / 2) (vx c + vx s / 2).
Definition box_mass rho s := rho * vx s * vy s * vz s.
Definition origin := vzero.

(* Every quadratic moment at once: f(r) = k + l.r + r.Qr. *)
Definition quadratic k l Q r := k + dot l r + dot r (mv Q r).
Lemma over_box_quadratic rho c s k l Q : over_box rho c s (quadratic k l Q)
  = box_mass rho s * (quadratic k l Q c + (xx Q * vx s ^ 2 + yy Q * vy s ^ 2 + zz Q * vz s ^ 2) / 12).
Proof.
  destruct c as [cx cy cz], s as [A B C], l as [lx ly lz], Q as [qxx qxy qxz qyx qyy qyz qzx qzy qzz].
  unfold over_box, quadratic, box_mass. cbn [vx vy vz xx yy zz]. vunfold.
  rewrite (integrand _ (fun x => (rho * B * C * (k + ly * cy + lz * cz + qyy * (cy ^ 2 + B ^ 2 / 12)
      + qzz * (cz ^ 2 + C ^ 2 / 12) + (qyz + qzy) * cy * cz))
    + rho * B * C * (lx + (qxy + qyx) * cy + (qxz + qzx) * cz) * x + rho * B * C * qxx * (x * x))).
  2:{ intros x.
    rewrite (integrand _ (fun y => (rho * C * (k + lx * x + lz * cz + qxx * x ^ 2 + (qxz + qzx) * x * cz
        + qzz * (cz ^ 2 + C ^ 2 / 12)))
      + rho * C * (ly + (qxy + qyx) * x + (qyz + qzy) * cz) * y + rho * C * qyy * (y * y))).
    2:{ intros y.
      rewrite (integrand _ (fun z => rho * (k + lx * x + ly * y + qxx * x ^ 2 + qyy * y ^ 2 + (qxy + qyx) * x * y)
        + rho * (lz + (qxz + qzx) * x + (qyz + qzy) * y) * z + rho * qzz * (z * z))).
      2:{ intros z. numbers. ring. }
      rewrite RInt_quadratic. numbers. field. }
    rewrite RInt_quadratic. numbers. field. }
  rewrite RInt_quadratic. numbers. field.
Qed.
(* Integrands are given as they are; this says which quadratic they are. *)
Lemma over_box_is rho c s f k l Q : (forall x y z, f (V3 x y z) = quadratic k l Q (V3 x y z)) ->
  over_box rho c s f
  = box_mass rho s * (quadratic k l Q c + (xx Q * vx s ^ 2 + yy Q * vy s ^ 2 + zz Q * vz s ^ 2) / 12).
Proof.
  intros H. rewrite <- over_box_quadratic. unfold over_box. do 3 (apply integrand; intros ?). rewrite H. reflexivity.
Qed.

(* |r|^2 1 - r r^T, and its integral entry by entry *)
Definition point_tensor r := madd (mscale (dot r r) mid) (mscale (-1) (outer r r)).
Definition tensor_over rho c s (g : V -> V) :=
  let entry e := over_box rho c s (fun r => e (point_tensor (g r))) in
  M3 (entry xx) (entry xy) (entry xz) (entry yx) (entry yy) (entry yz) (entry zx) (entry zy) (entry zz).

(*@ inertia.cuboid *)
(* The integral over a box of density rho centred at the origin is its mass, ... *)
Theorem mass_of_box rho s : over_box rho origin s (fun _ => 1) = box_mass rho s.
Proof. rewrite (over_box_is _ _ _ _ 1 vzero mzero); [|intros; unfold quadratic; vring]. unfold quadratic, origin. vunfold. field. Qed.

Ltac entry Q := rewrite (over_box_is _ _ _ _ 0 vzero Q); [|intros; unfold quadratic, point_tensor; vring].

(*@ inertia.cuboid *)
(* ... the integral of |r|^2 1 - r r^T the formula's diagonal, without products of inertia; and anywhere else the
   parallel-axis term of the whole mass is added. *)
Theorem cuboid_inertia_is_the_integral rho c s :
  tensor_over rho c s (fun r => r)
  = madd (diag (cuboid_inertia (box_mass rho s) s)) (mscale (box_mass rho s) (point_tensor c)).
Proof.
  unfold tensor_over.
  entry (M3 0 0 0 0 1 0 0 0 1). entry (M3 0 (-1) 0 0 0 0 0 0 0). entry (M3 0 0 (-1) 0 0 0 0 0 0).
  entry (M3 0 (-1) 0 0 0 0 0 0 0). entry (M3 1 0 0 0 0 0 0 0 1). entry (M3 0 0 0 0 0 (-1) 0 0 0).
  entry (M3 0 0 (-1) 0 0 0 0 0 0). entry (M3 0 0 0 0 0 (-1) 0 0 0). entry (M3 1 0 0 0 1 0 0 0 0).
  unfold quadratic, cuboid_inertia, point_tensor. generalize (box_mass rho s). intros m. apply Meq; vunfold; field.
Qed.

(*@ inertia.cuboid *)
(* Cut into eight equal boxes, each moved to its place, the cuboid has the inertia it had (case I-03). *)
Theorem eight_boxes m s :
  let small i j k := madd (diag (cuboid_inertia (m / 8) (smul (1 / 2) s)))
    (mscale (m / 8) (point_tensor (V3 (i * vx s / 4) (j * vy s / 4) (k * vz s / 4)))) in
  madd (madd (madd (small 1 1 1) (small 1 1 (-1))) (madd (small 1 (-1) 1) (small 1 (-1) (-1))))
       (madd (madd (small (-1) 1 1) (small (-1) 1 (-1))) (madd (small (-1) (-1) 1) (small (-1) (-1) (-1))))
  = diag (cuboid_inertia m s).
Proof. cbv zeta. unfold cuboid_inertia, point_tensor. apply Meq; vunfold; field. Qed.

(*@ inertia.cuboid *)
(* Each moment is at most the sum of the other two; equality only for a vanishing edge (case I-02). *)
Theorem cuboid_triangle m s : 0 < m ->
  let I := cuboid_inertia m s in vx I + vy I - vz I = m / 6 * vz s ^ 2 /\ vx I <= vy I + vz I.
Proof.
  intros Hm I. unfold I, cuboid_inertia. cbn [vx vy vz]. split; [field|].
  assert (0 <= m / 6 * vx s ^ 2); [|lra]. apply Rmult_le_pos; [lra|apply pow2_ge_0].
Qed.

(*@ inertia.cuboid *)
Theorem cuboid_inertia_positive m s : 0 < m -> 0 < vx s -> 0 < vy s -> 0 < vz s -> posdef (diag (cuboid_inertia m s)).
Proof.
  intros Hm Hx Hy Hz. unfold cuboid_inertia.
  apply posdef_diag; cbn [vx vy vz]; (apply Rmult_lt_0_compat; [lra|]);
    apply Rplus_lt_0_compat; apply pow_lt; assumption.
Qed.

(*@ inertia.cuboid_inverse *)
(* Both ways round the product is 1. *)
Theorem cuboid_inverse_is_the_inverse I : 0 < vx I -> 0 < vy I -> 0 < vz I ->
  let J := cuboid_inverse_inertia I in mm (diag J) (diag I) = mid /\ mm (diag I) (diag J) = mid.
Proof.
  intros x y z J. unfold J, cuboid_inverse_inertia. revert x y z. vunfold. intros. split; apply Meq; cbn; field; repeat split; lra.
Qed.

(* -- in world axes -- *)
(*@ inertia.world *)
(* R I R^T is the integral of |r|^2 1 - r r^T with every point of the box turned by R. *)
Theorem world_inertia_is_the_integral rho s Rot : orthogonal Rot ->
  tensor_over rho origin s (mv Rot) = world_tensor Rot (cuboid_inertia (box_mass rho s) s).
Proof.
  intros O.
  assert (P : forall (e : M -> R) r, e (point_tensor (mv Rot r)) = e (mm Rot (mm (point_tensor r) (tr Rot)))).
  { intros e r. f_equal. destruct O as [H H']. unfold point_tensor. rewrite rotation_dot by (split; assumption).
    transitivity (madd (mscale (dot r r) (mm Rot (tr Rot))) (mscale (-1) (mm Rot (mm (outer r r) (tr Rot))))).
    - rewrite H'. generalize (dot r r). clear. vring.
    - generalize (dot r r). clear. vring. }
  transitivity (mm Rot (mm (tensor_over rho origin s (fun r => r)) (tr Rot))).
  2:{ rewrite cuboid_inertia_is_the_integral. unfold world_tensor. do 2 f_equal. unfold origin, point_tensor.
      generalize (diag (cuboid_inertia (box_mass rho s) s)). clear. vring. }
  rewrite cuboid_inertia_is_the_integral. unfold tensor_over, cuboid_inertia, origin.
  (* entry (i, j): the quadratic form sum over k, l of R_ik (delta_kl |r|^2 - r_k r_l) R_jl *)
  assert (F : forall i j, over_box rho vzero s (fun r => dot i (mv (mm Rot (mm (point_tensor r) (tr Rot))) j))
    = dot i (mv (mm Rot (mm (diag (cuboid_inertia (box_mass rho s) s)) (tr Rot))) j)).
  { intros i j. set (a := mv (tr Rot) i). set (b := mv (tr Rot) j).
    rewrite (over_box_is _ _ _ _ 0 vzero (madd (mscale (dot a b) mid) (mscale (-1) (outer a b)))).
    - transitivity (dot a (mv (diag (cuboid_inertia (box_mass rho s) s)) b)).
      + unfold quadratic, cuboid_inertia. generalize (box_mass rho s) a b. clear. intros. vunfold. field.
      + unfold a, b. generalize (diag (cuboid_inertia (box_mass rho s) s)). clear. vring.
    - intros. unfold quadratic, point_tensor, a, b. clear. vring. }
  assert (E : forall (e : M -> R) i j, (forall X, e X = dot i (mv X j)) ->
    over_box rho vzero s (fun r => e (point_tensor (mv Rot r)))
    = e (mm Rot (mm (diag (cuboid_inertia (box_mass rho s) s)) (tr Rot)))).
  { intros e i j He. rewrite He, <- F. unfold over_box. do 3 (apply integrand; intros ?). rewrite P, He. reflexivity. }
  set (e1 := V3 1 0 0). set (e2 := V3 0 1 0). set (e3 := V3 0 0 1).
  assert (Z : madd (diag (cuboid_inertia (box_mass rho s) s)) (mscale (box_mass rho s) (point_tensor vzero))
    = diag (cuboid_inertia (box_mass rho s) s)) by (unfold point_tensor; vring).
  unfold cuboid_inertia in Z, E. rewrite Z. clear Z F P.
  rewrite (E xx e1 e1), (E xy e1 e2), (E xz e1 e3), (E yx e2 e1), (E yy e2 e2), (E yz e2 e3), (E zx e3 e1),
    (E zy e3 e2), (E zz e3 e3); unfold e1, e2, e3; clear; vring.
Qed.

(*@ inertia.world *)
(* Symmetric, and its energy and momentum are those of the principal axes, turned. *)
Theorem world_tensor_turns Rot I w :
  sym (world_tensor Rot I)
  /\ mv (world_tensor Rot I) w = mv Rot (mv (diag I) (mv (tr Rot) w))
  /\ dot w (mv (world_tensor Rot I) w) = dot (mv (tr Rot) w) (mv (diag I) (mv (tr Rot) w)).
Proof. split; [apply sym_tr|split]; unfold world_tensor; vring. Qed.

(*@ inertia.world *)
(* Trace and determinant do not notice the turn (case I-04). *)
Theorem world_tensor_invariants Rot I : rotation Rot ->
  let W := world_tensor Rot I in
  xx W + yy W + zz W = vx I + vy I + vz I /\ det W = vx I * vy I * vz I.
Proof.
  intros [[H H'] D] W. split.
  - transitivity (vx I * xx (mm (tr Rot) Rot) + vy I * yy (mm (tr Rot) Rot) + vz I * zz (mm (tr Rot) Rot)).
    + unfold W, world_tensor. clear. vring.
    + rewrite H. clear. vring.
  - unfold W, world_tensor. rewrite !det_mm, det_tr, D. clear. vring.
Qed.

(*@ inertia.world_inverse *)
(* The principal inverses turned are the inverse of the principal moments turned. *)
Theorem world_inverse_is_the_inverse Rot I : orthogonal Rot -> 0 < vx I -> 0 < vy I -> 0 < vz I ->
  let W := world_tensor Rot I in let J := world_tensor Rot (cuboid_inverse_inertia I) in
  mm J W = mid /\ mm W J = mid.
Proof.
  intros [H H'] x y z W J. destruct (cuboid_inverse_is_the_inverse I x y z) as [D D'].
  unfold W, J, world_tensor. revert H H' D D'. generalize (diag I) (diag (cuboid_inverse_inertia I)). clear.
  intros A B H H' D D'. split.
  - transitivity (mm Rot (mm B (mm (mm (tr Rot) Rot) (mm A (tr Rot))))); [rewrite !mm_assoc; reflexivity|].
    rewrite H, id_mm, (mm_assoc B), D, id_mm. exact H'.
  - transitivity (mm Rot (mm A (mm (mm (tr Rot) Rot) (mm B (tr Rot))))); [rewrite !mm_assoc; reflexivity|].
    rewrite H, id_mm, (mm_assoc A), D', id_mm. exact H'.
Qed.

(*@ inertia.world_inverse *)
(* Positive semidefinite, also with zeros for a body that cannot turn: what K needs. *)
Theorem world_inverse_semidefinite Rot J : 0 <= vx J -> 0 <= vy J -> 0 <= vz J -> possemi (world_tensor Rot J).
Proof.
  intros x y z u. destruct (world_tensor_turns Rot J u) as (_ & _ & ->). generalize (mv (tr Rot) u). intros [a b c].
  revert x y z. vunfold. generalize dependent J. intros [p q r]. intros.
  assert (0 <= p * (a * a)) by (apply Rmult_le_pos; nra). assert (0 <= q * (b * b)) by (apply Rmult_le_pos; nra).
  assert (0 <= r * (c * c)) by (apply Rmult_le_pos; nra). lra.
Qed.
