(* The C++ computes the formulas the theorems are about: every cpp_NAME is a recording of the template NAME of
   src/formulas (Traced.v, made anew at each check), and equals the definition of the same name in Laws.v. *)
Require Import Vec3 Laws Traced.

Ltac law_unfold := lazy beta iota zeta delta
  [cuboid_inertia cuboid_inverse_inertia world_tensor torque_of_force add_force linear_acceleration
   angular_acceleration point_velocity rotation_rate naive_rotation_step without semi_implicit_step turn_response
   effective_inverse_mass normal_inverse_mass contact_velocity relative_velocity normal_impulse
   normal_impulse_printed apply_impulse apply_pair_impulse tangential kinetic_energy impulse_energy
   linear_momentum angular_momentum
   inverse_mass inverse_inertia arm linear angular of_A of_B force torque position orientation velocity spin
   vzero vadd vsub smul dot cross mv mm madd mscale tr mid mzero hat outer cols diag col1 col2 col3 det3 det
   vx vy vz xx xy xz yx yy yz zx zy zz].
(* One equation per component; a record's constructor is an injective function like any other. *)
Ltac components := repeat match goal with
  | |- V3 _ _ _ = V3 _ _ _ => apply f_equal3
  | |- M3 _ _ _ _ _ _ _ _ _ = M3 _ _ _ _ _ _ _ _ _ => apply Meq; cbn [xx xy xz yx yy yz zx zy zz]
  | |- Build_Velocity _ _ = _ => apply f_equal2
  | |- Build_PairVelocity _ _ = _ => apply f_equal2
  | |- Build_Wrench _ _ = _ => apply f_equal2
  end.
(* Straight-line formulas without quotients of their arguments: one polynomial identity per component. *)
Ltac bridge name := intros; unfold name; law_unfold; components; first [reflexivity | ring | field].

(*@ bridge inertia.cuboid *)
Theorem cpp_cuboid_inertia_ok m s : cpp_cuboid_inertia m s = cuboid_inertia m s.
Proof. bridge cpp_cuboid_inertia. Qed.

(*@ bridge inertia.cuboid_inverse *)
Theorem cpp_cuboid_inverse_inertia_ok I : cpp_cuboid_inverse_inertia I = cuboid_inverse_inertia I.
Proof. bridge cpp_cuboid_inverse_inertia. Qed.

(*@ bridge inertia.world *)
Theorem cpp_world_inertia_ok Rot I : cpp_world_inertia Rot I = world_tensor Rot I.
Proof. bridge cpp_world_inertia. Qed.

(*@ bridge inertia.world_inverse *)
Theorem cpp_world_inverse_inertia_ok Rot inverse_I :
  cpp_world_inverse_inertia Rot inverse_I = world_tensor Rot inverse_I.
Proof. bridge cpp_world_inverse_inertia. Qed.

(*@ bridge force.torque *)
Theorem cpp_torque_of_force_ok r f : cpp_torque_of_force r f = torque_of_force r f.
Proof. bridge cpp_torque_of_force. Qed.

(*@ bridge force.sum *)
Theorem cpp_add_force_ok sum r f : cpp_add_force sum r f = add_force sum r f.
Proof. bridge cpp_add_force. Qed.

(*@ bridge motion.linear *)
Theorem cpp_linear_acceleration_ok w f : cpp_linear_acceleration w f = linear_acceleration w f.
Proof. bridge cpp_linear_acceleration. Qed.

(*@ bridge motion.euler *)
Theorem cpp_angular_acceleration_ok I inverse_I w tau :
  cpp_angular_acceleration I inverse_I w tau = angular_acceleration I inverse_I w tau.
Proof. bridge cpp_angular_acceleration. Qed.

(*@ bridge motion.point_velocity *)
Theorem cpp_point_velocity_ok v w r : cpp_point_velocity v w r = point_velocity v w r.
Proof. bridge cpp_point_velocity. Qed.

(*@ bridge rotation.rate *)
Theorem cpp_rotation_rate_ok w Rot : cpp_rotation_rate w Rot = rotation_rate w Rot.
Proof. bridge cpp_rotation_rate. Qed.

(*@ bridge rotation.naive_step *)
Theorem cpp_naive_rotation_step_ok h w Rot : cpp_naive_rotation_step h w Rot = naive_rotation_step h w Rot.
Proof. bridge cpp_naive_rotation_step. Qed.

(*@ bridge impulse.effective_mass *)
Theorem cpp_effective_inverse_mass_ok A B : cpp_effective_inverse_mass A B = effective_inverse_mass A B.
Proof. bridge cpp_effective_inverse_mass. Qed.

(*@ bridge impulse.normal_effective_mass *)
Theorem cpp_normal_inverse_mass_ok A B n : cpp_normal_inverse_mass A B n = normal_inverse_mass A B n.
Proof. bridge cpp_normal_inverse_mass. Qed.

(*@ bridge impulse.relative_velocity *)
Theorem cpp_relative_velocity_ok A B u : cpp_relative_velocity A B u = relative_velocity A B u.
Proof. bridge cpp_relative_velocity. Qed.

(*@ bridge impulse.normal *)
Theorem cpp_normal_impulse_ok e v_n k_nn : cpp_normal_impulse e v_n k_nn = normal_impulse e v_n k_nn.
Proof. bridge cpp_normal_impulse. Qed.

(*@ bridge impulse.normal_printed *)
Theorem cpp_normal_impulse_printed_ok e v_n k_nn :
  cpp_normal_impulse_printed e v_n k_nn = normal_impulse_printed e v_n k_nn.
Proof. bridge cpp_normal_impulse_printed. Qed.

(*@ bridge impulse.apply *)
Theorem cpp_apply_impulse_ok B before j : cpp_apply_impulse B before j = apply_impulse B before j.
Proof. bridge cpp_apply_impulse. Qed.

(*@ bridge impulse.apply_pair *)
Theorem cpp_apply_pair_impulse_ok A B before j :
  cpp_apply_pair_impulse A B before j = apply_pair_impulse A B before j.
Proof. bridge cpp_apply_pair_impulse. Qed.

(*@ bridge contact.correction *)
Theorem cpp_positional_correction_ok depth n : cpp_positional_correction depth n = positional_correction depth n.
Proof.
  unfold cpp_positional_correction, positional_correction. destruct (Rgt_dec depth 0).
  - rewrite Rmax_right by lra. bridge vzero.
  - rewrite Rmax_left by lra. bridge vzero.
Qed.

(*@ bridge energy.kinetic *)
Theorem cpp_kinetic_energy_ok m I v w : cpp_kinetic_energy m I v w = kinetic_energy m I v w.
Proof. bridge cpp_kinetic_energy. Qed.

(*@ bridge energy.impulse *)
Theorem cpp_impulse_energy_ok j v_r_before v_r_after :
  cpp_impulse_energy j v_r_before v_r_after = impulse_energy j v_r_before v_r_after.
Proof. bridge cpp_impulse_energy. Qed.

(*@ bridge momentum.linear *)
Theorem cpp_linear_momentum_ok m v : cpp_linear_momentum m v = linear_momentum m v.
Proof. bridge cpp_linear_momentum. Qed.

(*@ bridge momentum.angular *)
Theorem cpp_angular_momentum_ok m I p v w o : cpp_angular_momentum m I p v w o = angular_momentum m I p v w o.
Proof. bridge cpp_angular_momentum. Qed.
