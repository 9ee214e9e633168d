(* The rounding bounds of the docstrings. Traced.v prints each straight formula three times from one recording:
   cpp_ as real numbers, fl_ with every operation rounded, size_ with every difference a sum. The theorems say how far
   fl_ is from cpp_, for every input, in units of size_ at the absolute values of the input: the "absolute sum".
   The order of operations is the recorded one: the compiler keeps it (no -ffast-math, -ffp-contract=off). *)
Require Import Vec3 Laws Traced.

Section Model.
(* Rounding to nearest with an unbounded exponent (no underflow, no overflow), seen through what is used of it. *)
Variables (u : R) (rnd : R -> R).
Hypothesis Hu : 0 <= u. Hypothesis Hu100 : 100 * u < 1.
Hypothesis nearest : forall x, Rabs (rnd x - x) <= u * Rabs x.
Hypothesis idempotent : forall x, rnd (rnd x) = rnd x.
Hypothesis odd : forall x, rnd (- x) = - rnd x.
Definition fits x := rnd x = x.
Hypothesis small_integers : fits 0 /\ fits 1 /\ fits 2 /\ fits 12.
Definition vfits a := fits (vx a) /\ fits (vy a) /\ fits (vz a).
Definition mfits A := vfits (col1 A) /\ vfits (col2 A) /\ vfits (col3 A).
Definition body_fits B := fits (inverse_mass B) /\ mfits (inverse_inertia B) /\ vfits (arm B).
Definition velocity_fits c := vfits (linear c) /\ vfits (angular c).
Definition pair_fits p := velocity_fits (of_A p) /\ velocity_fits (of_B p).
Definition wrench_fits s := vfits (force s) /\ vfits (torque s).

Definition vabs a := V3 (Rabs (vx a)) (Rabs (vy a)) (Rabs (vz a)).
Definition mabs A := M3 (Rabs (xx A)) (Rabs (xy A)) (Rabs (xz A)) (Rabs (yx A)) (Rabs (yy A)) (Rabs (yz A))
  (Rabs (zx A)) (Rabs (zy A)) (Rabs (zz A)).
Definition body_abs B := {| inverse_mass := Rabs (inverse_mass B); inverse_inertia := mabs (inverse_inertia B); arm := vabs (arm B) |}.
Definition velocity_abs c := {| linear := vabs (linear c); angular := vabs (angular c) |}.
Definition pair_abs p := {| of_A := velocity_abs (of_A p); of_B := velocity_abs (of_B p) |}.
Definition wrench_abs s := {| force := vabs (force s); torque := vabs (torque s) |}.

(* gamma_k = k u / (1 - k u), Higham's notation *)
Definition gamma k := INR k * u / (1 - INR k * u).
(* y is x up to k roundings, relative to m: the bound of the docstrings *)
Definition within k m x y := Rabs (y - x) <= gamma k * m.
Definition vwithin k m x y := within k (vx m) (vx x) (vx y) /\ within k (vy m) (vy x) (vy y) /\ within k (vz m) (vz x) (vz y).
Definition mwithin k m x y := vwithin k (col1 m) (col1 x) (col1 y) /\ vwithin k (col2 m) (col2 x) (col2 y)
  /\ vwithin k (col3 m) (col3 x) (col3 y).

(* the invariant of the walk through a recording *)
Definition approx k m x y := Rabs (y - x) <= ((1 + u) ^ k - 1) * m /\ Rabs x <= m /\ fits y.

Lemma power k : 1 <= (1 + u) ^ k. Proof. apply pow_R1_Rle. lra. Qed.
Lemma power_mono j k : (j <= k)%nat -> (1 + u) ^ j <= (1 + u) ^ k. Proof. apply Rle_pow. lra. Qed.
Lemma approx_more j k m x y : (j <= k)%nat -> approx j m x y -> approx k m x y.
Proof.
  intros L (E & S & F). repeat split; try assumption. eapply Rle_trans; [exact E|].
  pose proof (power_mono j k L). pose proof (Rabs_pos x). apply Rmult_le_compat_r; lra.
Qed.
Lemma approx_size k m x y : approx k m x y -> Rabs y <= (1 + u) ^ k * m.
Proof. intros (E & S & _). replace y with ((y - x) + x) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra. Qed.
Lemma approx_round k m x y : Rabs (y - x) <= ((1 + u) ^ k - 1) * m -> Rabs x <= m -> approx (S k) m x (rnd y).
Proof.
  intros E S. split; [|split; [exact S|apply idempotent]].
  assert (Y : Rabs y <= (1 + u) ^ k * m).
  { replace y with ((y - x) + x) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra. }
  replace (rnd y - x) with ((rnd y - y) + (y - x)) by ring. eapply Rle_trans; [apply Rabs_triang|].
  pose proof (nearest y) as N. cbn [pow]. nra.
Qed.

Lemma approx_again k m x y : approx k m x y -> approx k m x (rnd y).
Proof. intros (E & S & F). unfold fits in F. rewrite F. repeat split; assumption. Qed.
Lemma approx_input x : fits x -> approx 0 (Rabs x) x x.
Proof. intros F. repeat split; [|lra|exact F]. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. cbn. lra. Qed.
Lemma approx_constant x : 0 <= x -> fits x -> approx 0 x x x.
Proof. intros P F. pose proof (approx_input x F) as A. rewrite Rabs_pos_eq in A by exact P. exact A. Qed.
Lemma approx_opp k m x y : approx k m x y -> approx k m (- x) (- y).
Proof.
  intros (E & S & F). repeat split.
  - replace (- y - - x) with (- (y - x)) by ring. rewrite Rabs_Ropp. exact E.
  - rewrite Rabs_Ropp. exact S.
  - unfold fits. rewrite odd, F. reflexivity.
Qed.
Lemma approx_add j k m n x x' y y' : approx j m x y -> approx k n x' y' ->
  approx (S (max j k)) (m + n) (x + x') (rnd (y + y')).
Proof.
  intros A B. apply (approx_more _ (max j k)) in A; [|apply Nat.le_max_l]. apply (approx_more _ (max j k)) in B; [|apply Nat.le_max_r].
  destruct A as (E & S & _), B as (E' & S' & _). apply approx_round.
  - replace (y + y' - (x + x')) with ((y - x) + (y' - x')) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra.
  - eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.
Lemma approx_sub j k m n x x' y y' : approx j m x y -> approx k n x' y' ->
  approx (S (max j k)) (m + n) (x - x') (rnd (y - y')).
Proof. intros A B. apply (approx_add j k m n x (- x') y (- y') A), approx_opp, B. Qed.
Lemma approx_mul j k m n x x' y y' : approx j m x y -> approx k n x' y' ->
  approx (S (j + k)) (m * n) (x * x') (rnd (y * y')).
Proof.
  intros A B. pose proof (approx_size _ _ _ _ B) as Y'. destruct A as (E & S & _), B as (E' & S' & _).
  pose proof (Rabs_pos x). pose proof (Rabs_pos x'). pose proof (Rabs_pos (y - x)). pose proof (Rabs_pos y').
  pose proof (Rabs_pos (y' - x')). pose proof (power j). pose proof (power k). apply approx_round.
  - replace (y * y' - x * x') with ((y - x) * y' + x * (y' - x')) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, pow_add.
    apply Rle_trans with (((1 + u) ^ j - 1) * m * ((1 + u) ^ k * n) + m * (((1 + u) ^ k - 1) * n)).
    + apply Rplus_le_compat; apply Rmult_le_compat; assumption.
    + right. ring.
  - rewrite Rabs_mult. apply Rmult_le_compat; assumption.
Qed.
Lemma approx_div k m x y d e : d <> 0 -> Rabs d = e -> approx k m x y -> approx (S k) (m / e) (x / d) (rnd (y / d)).
Proof.
  intros D <- (E & S & _). assert (I : 0 <= Rabs (/ d)) by apply Rabs_pos.
  assert (Q : Rabs (/ d) = / Rabs d) by (apply Rabs_inv). apply approx_round; unfold Rdiv; rewrite <- Q.
  - replace (y * / d - x * / d) with ((y - x) * / d) by ring. rewrite Rabs_mult, <- Rmult_assoc.
    apply Rmult_le_compat_r; assumption.
  - rewrite Rabs_mult. apply Rmult_le_compat_r; assumption.
Qed.

Lemma power_gamma k : INR k * u < 1 -> (1 + u) ^ k - 1 <= gamma k.
Proof.
  intros L. assert (P : (1 + u) ^ k * (1 - INR k * u) <= 1).
  { clear L. induction k; [cbn; lra|]. rewrite S_INR. cbn [pow]. pose proof (power k). pose proof (pos_INR k).
    assert (0 <= (1 + u) ^ k * (u * u * (INR k + 1))) by (repeat apply Rmult_le_pos; lra). nra. }
  unfold gamma. apply (Rmult_le_reg_r (1 - INR k * u)); [lra|].
  replace (INR k * u / (1 - INR k * u) * (1 - INR k * u)) with (INR k * u) by (field; lra). lra.
Qed.
Lemma approx_within j k m x y : approx j m x y -> (j <= k)%nat -> (k <= 100)%nat -> within k m x y.
Proof.
  intros A J K. apply (approx_more _ k) in A; [|exact J]. destruct A as (E & S & _). unfold within.
  eapply Rle_trans; [exact E|]. apply Rmult_le_compat_r; [pose proof (Rabs_pos x); lra|]. apply power_gamma.
  assert (INR k <= 100) by (replace 100 with (INR 100) by (rewrite INR_IZR_INZ; reflexivity); apply le_INR, K).
  pose proof (pos_INR k). nra.
Qed.

(* Products with 0 and 1 and sums with 0 are exact: take them out before counting. *)
Lemma rnd_0 : rnd 0 = 0. Proof. apply small_integers. Qed.
Ltac trivial_products := rewrite ?Rmult_0_r, ?Rmult_0_l, ?Rmult_1_r, ?rnd_0, ?Rplus_0_l, ?Rplus_0_r, ?Rminus_0_r, ?Rminus_0_l.
Ltac given := match goal with
  | |- fits 0 => apply small_integers | |- fits 1 => apply small_integers
  | |- fits 2 => apply small_integers | |- fits 12 => apply small_integers
  | |- fits _ => assumption end.
Ltac divisor := first [assumption | lra].
Ltac walk := first
  [ apply approx_input; given | apply approx_constant; [lra|given]
  | eapply approx_div; [divisor | first [reflexivity | apply Rabs_pos_eq; lra] | walk]
  | eapply approx_mul; [walk|walk] | eapply approx_add; [walk|walk] | eapply approx_sub; [walk|walk]
  | apply approx_opp; walk | apply approx_again; walk ].
Ltac inputs := repeat match goal with
  | H : body_fits _ |- _ => destruct H as (? & ? & ?) | H : velocity_fits _ |- _ => destruct H as (? & ?)
  | H : pair_fits _ |- _ => destruct H as (? & ?) | H : wrench_fits _ |- _ => destruct H as (? & ?)
  | H : _ <> 0 /\ _ |- _ => destruct H
  | H : mfits _ |- _ => destruct H as (? & ? & ?) | H : vfits _ |- _ => destruct H as (? & ? & ?) end.
Ltac show := lazy beta iota zeta delta
  [inverse_mass inverse_inertia arm linear angular of_A of_B force torque vabs mabs body_abs velocity_abs pair_abs wrench_abs
   vfits mfits body_fits velocity_fits pair_fits wrench_fits col1 col2 col3 vx vy vz xx xy xz yx yy yz zx zy zz] in *.
Ltac count := eapply approx_within; [walk | cbv; lia | lia].
Ltac rounding cpp fl size := intros; unfold cpp, fl, size; inputs; show; repeat split; show; trivial_products; count.

(*@ rounding inertia.cuboid *)
Theorem cuboid_inertia_rounding m s : fits m -> vfits s ->
  vwithin 4 (size_cuboid_inertia (Rabs m) (vabs s)) (cpp_cuboid_inertia m s)
    (fl_cuboid_inertia rnd m s).
Proof. rounding cpp_cuboid_inertia fl_cuboid_inertia size_cuboid_inertia. Qed.

(*@ rounding inertia.cuboid_inverse *)
Theorem cuboid_inverse_inertia_rounding I : vfits I -> vx I <> 0 /\ vy I <> 0 /\ vz I <> 0 ->
  vwithin 1 (size_cuboid_inverse_inertia (vabs I)) (cpp_cuboid_inverse_inertia I)
    (fl_cuboid_inverse_inertia rnd I).
Proof. rounding cpp_cuboid_inverse_inertia fl_cuboid_inverse_inertia size_cuboid_inverse_inertia. Qed.

(*@ rounding inertia.world *)
Theorem world_inertia_rounding Rot I : mfits Rot -> vfits I ->
  mwithin 5 (size_world_inertia (mabs Rot) (vabs I)) (cpp_world_inertia Rot I)
    (fl_world_inertia rnd Rot I).
Proof. rounding cpp_world_inertia fl_world_inertia size_world_inertia. Qed.

(*@ rounding inertia.world_inverse *)
Theorem world_inverse_inertia_rounding Rot inverse_I : mfits Rot -> vfits inverse_I ->
  mwithin 5 (size_world_inverse_inertia (mabs Rot) (vabs inverse_I)) (cpp_world_inverse_inertia Rot inverse_I)
    (fl_world_inverse_inertia rnd Rot inverse_I).
Proof. rounding cpp_world_inverse_inertia fl_world_inverse_inertia size_world_inverse_inertia. Qed.

(*@ rounding force.torque *)
Theorem torque_of_force_rounding r f : vfits r -> vfits f ->
  vwithin 2 (size_torque_of_force (vabs r) (vabs f)) (cpp_torque_of_force r f)
    (fl_torque_of_force rnd r f).
Proof. rounding cpp_torque_of_force fl_torque_of_force size_torque_of_force. Qed.

(* one force more; the first term of a sum is added to 0, so N of them make N - 1 and N + 1 *)
(*@ rounding force.sum *)
Theorem add_force_rounding sum r f : wrench_fits sum -> vfits r -> vfits f ->
  let size := size_add_force (wrench_abs sum) (vabs r) (vabs f) in
  let exact := cpp_add_force sum r f in let computed := fl_add_force rnd sum r f in
  vwithin 1 (force size) (force exact) (force computed) /\ vwithin 3 (torque size) (torque exact) (torque computed).
Proof. rounding cpp_add_force fl_add_force size_add_force. Qed.

(*@ rounding motion.linear *)
Theorem linear_acceleration_rounding w f : fits w -> vfits f ->
  vwithin 1 (size_linear_acceleration (Rabs w) (vabs f)) (cpp_linear_acceleration w f)
    (fl_linear_acceleration rnd w f).
Proof. rounding cpp_linear_acceleration fl_linear_acceleration size_linear_acceleration. Qed.

(*@ rounding motion.euler *)
Theorem angular_acceleration_rounding I inverse_I w tau : mfits I -> mfits inverse_I -> vfits w -> vfits tau ->
  vwithin 9 (size_angular_acceleration (mabs I) (mabs inverse_I) (vabs w) (vabs tau)) (cpp_angular_acceleration I inverse_I w tau)
    (fl_angular_acceleration rnd I inverse_I w tau).
Proof. rounding cpp_angular_acceleration fl_angular_acceleration size_angular_acceleration. Qed.

(*@ rounding motion.point_velocity *)
Theorem point_velocity_rounding v w r : vfits v -> vfits w -> vfits r ->
  vwithin 3 (size_point_velocity (vabs v) (vabs w) (vabs r)) (cpp_point_velocity v w r)
    (fl_point_velocity rnd v w r).
Proof. rounding cpp_point_velocity fl_point_velocity size_point_velocity. Qed.

(*@ rounding rotation.rate *)
Theorem rotation_rate_rounding w Rot : vfits w -> mfits Rot ->
  mwithin 2 (size_rotation_rate (vabs w) (mabs Rot)) (cpp_rotation_rate w Rot)
    (fl_rotation_rate rnd w Rot).
Proof. rounding cpp_rotation_rate fl_rotation_rate size_rotation_rate. Qed.

(*@ rounding rotation.naive_step *)
Theorem naive_rotation_step_rounding h w Rot : fits h -> vfits w -> mfits Rot ->
  mwithin 4 (size_naive_rotation_step (Rabs h) (vabs w) (mabs Rot)) (cpp_naive_rotation_step h w Rot)
    (fl_naive_rotation_step rnd h w Rot).
Proof. rounding cpp_naive_rotation_step fl_naive_rotation_step size_naive_rotation_step. Qed.

(*@ rounding impulse.effective_mass *)
Theorem effective_inverse_mass_rounding A B : body_fits A -> body_fits B ->
  mwithin 8 (size_effective_inverse_mass (body_abs A) (body_abs B)) (cpp_effective_inverse_mass A B)
    (fl_effective_inverse_mass rnd A B).
Proof. rounding cpp_effective_inverse_mass fl_effective_inverse_mass size_effective_inverse_mass. Qed.

(*@ rounding impulse.normal_effective_mass *)
Theorem normal_inverse_mass_rounding A B n : body_fits A -> body_fits B -> vfits n ->
  within 12 (size_normal_inverse_mass (body_abs A) (body_abs B) (vabs n)) (cpp_normal_inverse_mass A B n)
    (fl_normal_inverse_mass rnd A B n).
Proof. rounding cpp_normal_inverse_mass fl_normal_inverse_mass size_normal_inverse_mass. Qed.

(*@ rounding impulse.relative_velocity *)
Theorem relative_velocity_rounding A B u' : body_fits A -> body_fits B -> pair_fits u' ->
  vwithin 4 (size_relative_velocity (body_abs A) (body_abs B) (pair_abs u')) (cpp_relative_velocity A B u')
    (fl_relative_velocity rnd A B u').
Proof. rounding cpp_relative_velocity fl_relative_velocity size_relative_velocity. Qed.

(*@ rounding impulse.normal *)
Theorem normal_impulse_rounding e v_n k_nn : fits e -> fits v_n -> fits k_nn -> k_nn <> 0 ->
  within 3 (size_normal_impulse (Rabs e) (Rabs v_n) (Rabs k_nn)) (cpp_normal_impulse e v_n k_nn)
    (fl_normal_impulse rnd e v_n k_nn).
Proof. rounding cpp_normal_impulse fl_normal_impulse size_normal_impulse. Qed.

(*@ rounding impulse.normal_printed *)
Theorem normal_impulse_printed_rounding e v_n k_nn : fits e -> fits v_n -> fits k_nn -> k_nn <> 0 ->
  within 3 (size_normal_impulse_printed (Rabs e) (Rabs v_n) (Rabs k_nn)) (cpp_normal_impulse_printed e v_n k_nn)
    (fl_normal_impulse_printed rnd e v_n k_nn).
Proof. rounding cpp_normal_impulse_printed fl_normal_impulse_printed size_normal_impulse_printed. Qed.

(*@ rounding impulse.apply *)
Theorem apply_impulse_rounding B u' j : body_fits B -> velocity_fits u' -> vfits j ->
  let size := size_apply_impulse (body_abs B) (velocity_abs u') (vabs j) in
  let exact := cpp_apply_impulse B u' j in let computed := fl_apply_impulse rnd B u' j in
  (vwithin 2 (linear size) (linear exact) (linear computed)
   /\ vwithin 6 (angular size) (angular exact) (angular computed)).
Proof. rounding cpp_apply_impulse fl_apply_impulse size_apply_impulse. Qed.

(*@ rounding impulse.apply_pair *)
Theorem apply_pair_impulse_rounding A B u' j : body_fits A -> body_fits B -> pair_fits u' -> vfits j ->
  let size := size_apply_pair_impulse (body_abs A) (body_abs B) (pair_abs u') (vabs j) in
  let exact := cpp_apply_pair_impulse A B u' j in let computed := fl_apply_pair_impulse rnd A B u' j in
  (vwithin 2 (linear (of_A size)) (linear (of_A exact)) (linear (of_A computed))
   /\ vwithin 6 (angular (of_A size)) (angular (of_A exact)) (angular (of_A computed)))
  /\ (vwithin 2 (linear (of_B size)) (linear (of_B exact)) (linear (of_B computed))
   /\ vwithin 6 (angular (of_B size)) (angular (of_B exact)) (angular (of_B computed))).
Proof. rounding cpp_apply_pair_impulse fl_apply_pair_impulse size_apply_pair_impulse. Qed.

(*@ rounding energy.kinetic *)
Theorem kinetic_energy_rounding m I v w : fits m -> mfits I -> vfits v -> vfits w ->
  within 8 (size_kinetic_energy (Rabs m) (mabs I) (vabs v) (vabs w)) (cpp_kinetic_energy m I v w)
    (fl_kinetic_energy rnd m I v w).
Proof. rounding cpp_kinetic_energy fl_kinetic_energy size_kinetic_energy. Qed.

(*@ rounding energy.impulse *)
Theorem impulse_energy_rounding j v v' : vfits j -> vfits v -> vfits v' ->
  within 5 (size_impulse_energy (vabs j) (vabs v) (vabs v')) (cpp_impulse_energy j v v')
    (fl_impulse_energy rnd j v v').
Proof. rounding cpp_impulse_energy fl_impulse_energy size_impulse_energy. Qed.

(*@ rounding momentum.linear *)
Theorem linear_momentum_rounding m v : fits m -> vfits v ->
  vwithin 1 (size_linear_momentum (Rabs m) (vabs v)) (cpp_linear_momentum m v)
    (fl_linear_momentum rnd m v).
Proof. rounding cpp_linear_momentum fl_linear_momentum size_linear_momentum. Qed.

(*@ rounding momentum.angular *)
Theorem angular_momentum_rounding m I p v w o : fits m -> mfits I -> vfits p -> vfits v -> vfits w -> vfits o ->
  vwithin 5 (size_angular_momentum (Rabs m) (mabs I) (vabs p) (vabs v) (vabs w) (vabs o)) (cpp_angular_momentum m I p v w o)
    (fl_angular_momentum rnd m I p v w o).
Proof. rounding cpp_angular_momentum fl_angular_momentum size_angular_momentum. Qed.
End Model.
