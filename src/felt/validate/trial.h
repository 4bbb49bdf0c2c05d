#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/validate/probe_device.h"
#include "felt/validate/test_loop.h"
#include "felt/validate/test_subject.h"

namespace felt {

/// The maximum force that a device test sends, N. The safety chain enforces it.
inline constexpr double kTestForceN = 0.3;
/// Maximum distance of the pen from its position at Trial::arm(), mm. If the pen is farther away,
/// forces are switched off.
inline constexpr double kHeldWithinMm = 15.0;

/// A device in the haptic loop for one check: servo, safety chain (limit kTestForceN) and probe.
/// Forces are off until arm(), and are always switched off when the trial ends.
///
///   Result<std::unique_ptr<Trial>> trial = Trial::begin(subject, loop, is_cancelled);
///   (*trial)->pass(2.0);                       // 2 s; the ticks are in ticks()
///   (*trial)->arm(); (*trial)->push({0.3, 0, 0}); ...
///   if (!(*trial)->trouble().empty()) ...      // cancelled, moved too far, the device failed
class Trial {
 public:
  /// Starts the loop. `subject` must be open; all arguments must outlive the trial. Fails if the
  /// loop cannot be started.
  static Result<std::unique_ptr<Trial>> begin(TestSubject& subject, TestLoop& loop,
                                              const std::function<bool()>& is_cancelled);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial();

  /// Lets time pass. Returns early if trouble() is no longer empty.
  void pass(double seconds);
  /// Enables forces and returns when the engage ramp is over. The current position of the pen
  /// becomes the centre of the range in which it may move.
  void arm();
  /// Changes the force linearly within 0.15 s.
  void push(const Force& force);
  /// Changes the force as fast as the safety chain permits.
  void step(const Force& force);
  /// Stops communication with the device for this time.
  void stall(double seconds);
  void publish(const ForceModel& model);

  /// Returns the ticks since begin() or forget(), except those during keep(false). Long trials use
  /// keep(false) to save memory.
  [[nodiscard]] const std::vector<ProbeTick>& ticks() const noexcept { return ticks_; }
  void forget() noexcept { ticks_.clear(); }
  void keep(bool on) noexcept { keeps_ = on; }
  /// Called with every tick, even if the tick is not kept.
  std::function<void(const ProbeTick&)> on_tick;
  /// Called with the loop's newest report every few ms.
  std::function<void(const TickReport&)> on_turn;

  /// Returns the mean position over the last `last_seconds` seconds, mm.
  [[nodiscard]] Vec3 mean_place(double last_seconds) const;
  /// Returns the reason why the trial cannot continue; empty if it can continue.
  [[nodiscard]] const std::string& trouble() const noexcept { return trouble_; }
  /// Returns the fault of the device that is the trouble, if it is one.
  [[nodiscard]] std::optional<DeviceFault> fault() const noexcept { return fault_; }
  [[nodiscard]] bool was_cancelled() const noexcept { return was_cancelled_; }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  [[nodiscard]] ProbeDevice& probe() noexcept { return probe_; }
  [[nodiscard]] TestLoop& loop() noexcept { return loop_; }
  /// Does not treat device faults as trouble, for checks that cause them.
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
  std::optional<DeviceFault> fault_;
  bool keeps_ = true;
  bool was_cancelled_ = false;
  bool expects_faults_ = false;
};

}  // namespace felt
