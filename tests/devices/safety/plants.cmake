# Each plant is one bug: a stage of the chain is removed, or a check is disabled.
felt_plant(no_finite_force safety_chain.cc "!is_finite(asked) || " "")
felt_plant(no_finite_sample safety_chain.cc
  "if (!is_finite(sample)) {" "if (false) {" " || !is_finite(sample)" "")
felt_plant(no_peak safety_chain.cc
  "clamp(asked, limits_.peak_force_n, kLimitedByPeak)" "asked"
  "force = clamp_length(force, limits_.peak_force_n)" ""
  "clamp_length(force, carries_force() ? limits_.peak_force_n : 0.0)" "force")
felt_plant(no_rise safety_chain.cc
  "limit_rise(sent_, wanted, credit_n(limits_.rise_n_per_ms))" "wanted")
felt_plant(free_reversal safety_stages.cc
  "return step_towards(from, wanted, step_n)"
  "return norm(wanted) <= norm(previous) ? wanted : step_towards(from, wanted, step_n)")
felt_plant(late_ticks_buy_steps safety_chain.cc
  "kMsPerS * time_.credited_s" "kMsPerS * time_.charged_s")
felt_plant(backwards_is_on_time safety_guards.cc "std::abs(measured_s)" "measured_s")
felt_plant(no_wait safety_chain.cc "calm_ticks_ = is_calm ? calm_ticks_ + 1 : 0;" "++calm_ticks_;")
felt_plant(no_ramp safety_chain.cc "const Force target = ramp_ * wanted;"
  "const Force target = wanted; ramp_ = 1.0;")
felt_plant(no_slow_rise safety_chain.cc "credit_n(limits_.engage_rise_n_per_ms)"
  "credit_n(limits_.rise_n_per_ms)")
felt_plant(no_fall safety_chain.cc "norm(sent_) - limits_.soft_fall_n_per_ms * ms" "norm(sent_)")
felt_plant(no_late_tick safety_chain.cc "soft_fault(SafetyFault::kLateTick, SafetyState::kFalling)" "")
felt_plant(no_very_late_tick safety_chain.cc
  "soft_fault(SafetyFault::kVeryLateTick, SafetyState::kWaiting)" "")
felt_plant(no_fault_count safety_chain.cc
  "if (kept >= static_cast<std::uint32_t>(limits_.soft_faults))" "if (false)")
felt_plant(no_brake safety_chain.cc "if (brake > 0.0)" "if (false)")
felt_plant(no_cut safety_chain.cc "if (speed_.must_cut())" "if (false)")
felt_plant(cut_believes_the_device safety_guards.cc "std::max(reported, measured)" "reported")
felt_plant(no_jump safety_chain.cc "switch (jumps_.judge(sample.position, time_))"
  "switch (PositionVerdict::kBelieved)")
felt_plant(jumps_last safety_guards.cc "return too_long ? PositionVerdict::kFault : PositionVerdict::kHeld"
  "return PositionVerdict::kHeld")
felt_plant(no_silent_damping safety_chain.cc
  "wants_damping_only() ? damping(speed_.measured_mm_per_s()) : asked" "asked")
felt_plant(damping_believes_the_device safety_chain.cc
  "damping(speed_.measured_mm_per_s())" "damping(sample.velocity)")
felt_plant(brake_believes_the_device safety_guards.cc "agree && reported" "reported")
felt_plant(no_silent_stop safety_chain.cc "silence_s_ >= limits_.silent_stop_s" "false")
felt_plant(old_heartbeats_count safety_guards.cc "if (is_new_)" "if (has_beat_)"
  "silence_s_ = std::min(silence_s_, std::max(seconds_between(last_beat_ns_, now_ns), 0.0))"
  "silence_s_ = 0.0")
felt_plant(no_device_fault safety_chain.cc "hard_fault(SafetyFault::kDeviceError)" "")
felt_plant(no_force_off safety_chain.cc "go_to(SafetyState::kOff)" "")
felt_plant(no_latch safety_chain.cc "go_to(SafetyState::kLatched)" "go_to(SafetyState::kWaiting)")
felt_plant(no_motor_guard safety_chain.cc
  "return clamp(force, motors_.allowed_n(), kLimitedByContinuous)" "return force")
felt_plant(no_budget safety_stages.cc
  "scale.lateral = share_of(slopes.lateral_n_per_m, budget)" "scale.lateral = 1.0")
felt_plant(friction_last safety_stages.cc
  "share_of(slopes.friction_n_per_m, budget - lateral)" "share_of(slopes.friction_n_per_m, 1.0)")

# Bugs of the force of a body: the rules of FuzzBody find them, not those of the chain.
set(rule "a body does not rely on the device's velocity")
felt_plant(body_believes_the_velocity ../bricks/solid_surface.cc
  "const Vec3 velocity = touch.motion.velocity();" "const Vec3 velocity = sample.velocity;")
set(rule "a body does not pull the pen in")
felt_plant(body_pulls_in ../bricks/solid_surface.cc
  "std::max(0.0, memory.spring_force_n - brake)" "memory.spring_force_n - brake")
set(rule "the force of a body is under the force of the device")
felt_plant(body_has_no_bound ../bricks/solid_surface.cc
  "options_.max_force_n > 0.0 ?" "options_.max_force_n < 0.0 ?")
set(rule "a body that appears around the pen does not push")
felt_plant(body_throws_out ../bricks/solid_surface.cc
  "touch.is_outside = rise_mm <= kFollowMm;" "touch.is_outside = true;")
felt_plant(body_starts_inside ../bricks/solid_surface.cc
  "if (!is_free_in_front(pen)) return false;" "")
unset(rule)
