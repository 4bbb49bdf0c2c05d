#include "felt/validate/trial.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kPushS = 0.15;
constexpr double kTurnS = 0.004;
constexpr double kEngagedS = 0.7;  // time for 4 calm ticks and the ramp of 0.5 s
constexpr double kStillS = 0.2;    // the held position is the mean over this time

/// A constant force.
struct TestForce {
  Force force;
  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    memory.terms.add("test", force);
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }
};

}  // namespace

Trial::Trial(TestSubject& subject, TestLoop& loop, const std::function<bool()>& is_cancelled)
    : subject_(subject), loop_(loop), is_cancelled_(is_cancelled), probe_(*subject.device()) {
  const Capabilities& device = subject.device()->capabilities();
  ServoOptions options;
  options.period_ns = device.period_ns;
  options.limits = limits_for(device, kTestForceN);
  servo_ = std::make_unique<Servo>(probe_, options);
}

Result<std::unique_ptr<Trial>> Trial::begin(TestSubject& subject, TestLoop& loop,
                                            const std::function<bool()>& is_cancelled) {
  std::unique_ptr<Trial> trial(new Trial(subject, loop, is_cancelled));
  if (Result<void> started = loop.start(*trial->servo_, subject.device()->loop_host()); !started) {
    return tl::unexpected(started.error());
  }
  return trial;
}

Trial::~Trial() {
  servo_->disarm();
  loop_.stop();
}

void Trial::pass(double seconds) {
  // Runs in short slices, so that it ends early if something goes wrong.
  for (double left = seconds; left > 1e-9 && trouble_.empty(); left -= kTurnS) {
    loop_.pass(std::llround(1e9 * std::min(left, kTurnS)), [this] { turn(); });
  }
}

void Trial::turn() {
  ProbeTick tick;
  while (probe_.ticks().pop(tick)) see(tick);
  if (on_turn) on_turn(servo_->latest());
  if (is_cancelled_ && is_cancelled_()) {
    was_cancelled_ = true;
    trouble_ = "the test was interrupted";
  }
  if (probe_.has_tripped() && trouble_.empty()) {
    trouble_ =
        "the pen moved more than 15 mm from where it was held, so forces were switched off: "
        "hold it still and try again";
  }
  if (!trouble_.empty()) servo_->disarm();
}

void Trial::see(const ProbeTick& tick) {
  if (on_tick) on_tick(tick);
  if (keeps_) ticks_.push_back(tick);
  const std::optional<DeviceFault> fault = tick.read_fault ? tick.read_fault : tick.write_fault;
  if (!fault || expects_faults_ || !trouble_.empty()) return;
  fault_ = fault;
  trouble_ = std::string("the device failed: ") + std::string(describe(*fault));
  OpenDevice* const device = subject_.device();
  const DeviceStatus status = device ? device->status() : DeviceStatus();
  const ShortText& words = status.vendor_words;
  if (!words.empty()) trouble_ += " Its message: " + std::string(words.view());
}

void Trial::arm() {
  publish(ForceModel(TestForce{}));
  force_ = {};
  pass(kStillS);
  probe_.guard(mean_place(kStillS), kHeldWithinMm);
  servo_->arm();
  pass(kEngagedS);
}

void Trial::publish(const ForceModel& model) {
  servo_->publish(model);
}

void Trial::step(const Force& force) {
  force_ = force;
  publish(ForceModel(TestForce{force}));
}

void Trial::push(const Force& force) {
  const Force from = force_;
  const int steps = static_cast<int>(kPushS / kTurnS);
  for (int i = 1; i <= steps && trouble_.empty(); ++i) {
    const double part = static_cast<double>(i) / steps;
    step(from + part * (force - from));
    pass(kTurnS);
  }
}

void Trial::stall(double seconds) {
  if (!trouble_.empty()) return;
  loop_.stall(probe_, std::llround(1e9 * seconds));
  pass(seconds + kTurnS);
}

Vec3 Trial::mean_place(double last_seconds) const {
  Vec3 sum{};
  double count = 0.0;
  if (ticks_.empty()) return sum;
  const std::int64_t from_ns = ticks_.back().now_ns - static_cast<std::int64_t>(1e9 * last_seconds);
  for (auto tick = ticks_.rbegin(); tick != ticks_.rend() && tick->now_ns > from_ns; ++tick) {
    if (tick->read_fault) continue;
    sum += tick->sample.position;
    count += 1.0;
  }
  return count > 0.0 ? (1.0 / count) * sum : sum;
}

}  // namespace felt
