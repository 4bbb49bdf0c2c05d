#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "felt/validate/probe_device.h"
#include "felt/validate/test_loop.h"
#include "felt/validate/test_subject.h"

namespace felt {

/// The most force that a device test sends, N; the safety chain holds it.
inline constexpr double kTestForceN = 0.3;
/// Where the pen may be while it is held, mm around the middle: beyond, forces go.
inline constexpr double kHeldWithinMm = 15.0;

/// A device in the haptic loop, for one check: servo, safety chain (limit kTestForceN), probe. Its
/// force is off until arm(). Ends with no force, whatever happened.
///
///   Result<std::unique_ptr<Trial>> trial = Trial::begin(subject, loop, is_cancelled);
///   (*trial)->pass(2.0);                       // 2 s; the ticks are in ticks()
///   (*trial)->arm(); (*trial)->push({0.3, 0, 0}); ...
///   if ((*trial)->trouble() != nullptr) ...    // cancelled, moved too far, the device failed
class Trial {
 public:
  /// `subject` is open; all must outlive it.
  static Result<std::unique_ptr<Trial>> begin(TestSubject& subject, TestLoop& loop,
                                              const std::function<bool()>& is_cancelled);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial();

  /// Lets time pass; nothing where there is trouble.
  void pass(double seconds);
  /// Forces on; returns when the engage ramp is over. The pen's place now is the middle of where it
  /// may be from now on.
  void arm();
  /// The force goes there evenly within 0.15 s.
  void push(const Force& force);
  /// Or at once, as fast as the chain lets it.
  void step(const Force& force);
  /// Nobody speaks to the device for so long.
  void stall(double seconds);
  void publish(const ForceModel& model);

  /// Ticks since begin() or forget(); not while keep(false), for what takes long.
  [[nodiscard]] const std::vector<ProbeTick>& ticks() const noexcept { return ticks_; }
  void forget() noexcept { ticks_.clear(); }
  void keep(bool on) noexcept { keeps_ = on; }
  /// Sees every tick, kept or not.
  std::function<void(const ProbeTick&)> on_tick;
  /// Sees the loop's newest report every few ms.
  std::function<void(const TickReport&)> on_turn;

  /// Mean place over the last so many seconds, mm.
  [[nodiscard]] Vec3 mean_place(double last_seconds) const;
  /// Why it cannot go on, in words; empty: it can.
  [[nodiscard]] const std::string& trouble() const noexcept { return trouble_; }
  [[nodiscard]] bool was_cancelled() const noexcept { return was_cancelled_; }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  [[nodiscard]] ProbeDevice& probe() noexcept { return probe_; }
  [[nodiscard]] TestLoop& loop() noexcept { return loop_; }
  /// Device faults are what is looked for: no trouble.
  void expect_faults() noexcept { expects_faults_ = true; }

 private:
  Trial(TestSubject& subject, TestLoop& loop, const std::function<bool()>& is_cancelled);
  void turn();
  void see(const ProbeTick& tick);

  TestSubject& subject_;
  TestLoop& loop_;
  const std::function<bool()>& is_cancelled_;
  ProbeDevice probe_;
  std::unique_ptr<Servo> servo_;  // large
  std::vector<ProbeTick> ticks_;
  Force force_;
  std::string trouble_;
  bool keeps_ = true;
  bool was_cancelled_ = false;
  bool expects_faults_ = false;
};

}  // namespace felt
