(* The friction laws of src/formulas are those of Laws.v: as Bridge.v, for formulas that branch. *)
Require Import Vec3 Laws Traced Bridge.

Ltac friction_unfold := lazy beta iota zeta delta
  [normal_impulse tangential impulse_cancelling coulomb_stick coulomb_slide
   vadd vsub smul dot cross mv col1 col2 col3 det3 det vx vy vz xx xy xz yx yy yz zx zy zz].

(*@ bridge friction.sheet *)
Theorem cpp_sheet_friction_impulse_ok m mu_s mu_d j_r slip :
  cpp_sheet_friction_impulse m mu_s mu_d j_r slip = sheet_friction_impulse m mu_s mu_d j_r slip.
Proof. reflexivity. Qed.

(*@ bridge friction.sheet_literal *)
Theorem cpp_sheet_literal_friction_impulse_ok mu_d j_r slip :
  cpp_sheet_literal_friction_impulse mu_d j_r slip = sheet_literal_friction_impulse mu_d j_r slip.
Proof. reflexivity. Qed.

(* The recording asks the same questions, of equal numbers. *)
Lemma same_question (T : Type) (P Q : R -> R -> Prop) (dec : forall a b, {P a b} + {Q a b})
  a a' b b' (x x' y y' : T) : a = a' -> b = b' -> x = x' -> y = y' ->
  (if dec a b then x else y) = (if dec a' b' then x' else y').
Proof. intros -> -> -> ->. reflexivity. Qed.
Lemma same_impact j j' o o' : j = j' -> o = o' ->
  {| impulse := j; outcome := o |} = {| impulse := j'; outcome := o' |}.
Proof. intros -> ->. reflexivity. Qed.
(* an answer inside a result is the result inside an answer *)
Lemma answer_outside (P Q : Prop) (d : {P} + {Q}) j a b :
  {| impulse := j; outcome := if d then a else b |}
  = if d then {| impulse := j; outcome := a |} else {| impulse := j; outcome := b |}.
Proof. destruct d; reflexivity. Qed.

Lemma unit_of u x y z s : x = vx u -> y = vy u -> z = vz u -> s = dot u u ->
  V3 (x / sqrt s) (y / sqrt s) (z / sqrt s) = unit u.
Proof. intros -> -> -> ->. unfold unit, norm, Rdiv. generalize (/ sqrt (dot u u)). vring. Qed.

(*@ bridge friction.tangent *)
Theorem cpp_friction_tangent_ok eps v_r f n : cpp_friction_tangent eps v_r f n = friction_tangent eps v_r f n.
Proof.
  unfold cpp_friction_tangent, friction_tangent, counts. cbv zeta.
  apply (same_question _ _ _ Rgt_dec); [law_unfold; ring | law_unfold; field | apply unit_of; law_unfold; ring |].
  apply (same_question _ _ _ Rgt_dec); [law_unfold; ring | law_unfold; field | apply unit_of; law_unfold; ring | reflexivity].
Qed.

(*@ bridge friction.coulomb *)
Theorem cpp_coulomb_impulse_ok K v_r n t e mu_s mu_d :
  cpp_coulomb_impulse K v_r n t e mu_s mu_d = coulomb_impulse K v_r n t e mu_s mu_d.
Proof.
  unfold cpp_coulomb_impulse, coulomb_impulse. cbv zeta. rewrite answer_outside. friction_unfold.
  repeat first [reflexivity | apply same_question | apply same_impact | apply f_equal3 | ring].
Qed.

(* Planar impacts: the two signs of k_tn and the two answers for sticking first, so that what the recording asks again
   is settled; then question by question. *)
Lemma same_end j j' i i' m : j = j' -> i = i' ->
  {| j_n := j; j_t := i; mode := m |} = {| j_n := j'; j_t := i'; mode := m |}.
Proof. intros -> ->. reflexivity. Qed.
Lemma answer_chosen (T : Type) (P Q : Prop) (d : {P} + {Q}) (x y : T) :
  (if (if d then true else false) then x else y) = if d then x else y.
Proof. destruct d; reflexivity. Qed.

Ltac planar name :=
  unfold name, planar_impulse, leg_without_slip; cbv zeta;
  lazy beta iota zeta delta [slip_leg dv_n end_of_restitution end_on_first_leg end_on_second_leg friction leg_mode];
  match goal with i : PlanarImpact |- _ =>
    unfold Rabs; destruct (Rcase_abs (k_tn i)); destruct (Rlt_dec (k_tn i) 0); try (exfalso; lra);
    match goal with |- context [Rle_dec ?p (mu_s i * k_tt i)] => destruct (Rle_dec p (mu_s i * k_tt i)) end;
    cbv iota beta;
    replace (k_nn i + - mu_d i * k_tn i) with (k_nn i - mu_d i * k_tn i) by ring;
    rewrite ?answer_chosen;
    repeat first [reflexivity | apply same_question | apply same_end | ring]
  end.

(*@ bridge friction.stronge_planar *)
Theorem cpp_planar_impulse_stronge_ok i : cpp_planar_impulse_stronge i = planar_impulse stronge i.
Proof. planar cpp_planar_impulse_stronge. Qed.

(*@ bridge friction.stronge_planar *)
Theorem cpp_planar_impulse_poisson_ok i : cpp_planar_impulse_poisson i = planar_impulse poisson i.
Proof. planar cpp_planar_impulse_poisson. Qed.

(*@ bridge friction.stronge_planar *)
Theorem cpp_planar_impulse_newton_ok i : cpp_planar_impulse_newton i = planar_impulse newton i.
Proof. planar cpp_planar_impulse_newton. Qed.
