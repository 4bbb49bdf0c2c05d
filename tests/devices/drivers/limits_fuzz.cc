#include "tests/devices/drivers/limits_fuzz.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/hash.h"
#include "felt/base/random.h"
#include "felt/driver/force_gate.h"

namespace felt {
namespace {

constexpr int kCalls = 1200;

class Sequence {
 public:
  Sequence(const BenchMaker& make, std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15ULL + 3) {
    std::vector<FaultWindow> faults;
    for (std::uint64_t k = random_.bits() % 4; k > 0; --k) {
      FaultWindow window;
      window.fault = injected_faults()[random_.bits() % injected_faults().size()];
      window.from_ns = static_cast<std::int64_t>(random_.between(0.0, 900.0) * 1e6);
      window.until_ns =
          window.from_ns + static_cast<std::int64_t>(random_.between(1.0, 200.0) * 1e6);
      window.amount = std::pow(10.0, random_.between(-2.0, 3.0));
      faults.push_back(window);
    }
    const auto shown = make({});
    std::erase_if(faults, [&shown](const FaultWindow& w) { return !shown->shows(w.fault); });
    bench_ = make(std::move(faults));
    max_n_ = ForceGate(bench_->device()->capabilities()).max_n();
    kind_ = random_.bits() % 6;
    step_ = any_way(random_.between(0.0, 50.0));
  }

  LimitsVerdict run() {
    for (int k = 0; k < kCalls && verdict_.broken.empty(); ++k) call();
    if (bench_->device() != nullptr) bench_->device()->stop();
    if (verdict_.broken.empty()) look("at the end");
    verdict_.largest_n = bench_->largest_asked_n();
    verdict_.digest = hash_.value();
    return verdict_;
  }

 private:
  bool chance(double p) { return random_.between(0.0, 1.0) < p; }
  Force any_way(double length) {
    const Force f{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    return (length / std::max(norm(f), 1e-3)) * f;
  }

  Force any_force() {
    constexpr std::array<double, 9> kOdd{kNan, kInf,   -kInf,   1.7e308, -1e300,
                                         4e38, 5e-324, -1e-310, -0.0};
    switch (kind_) {
      case 0:
        return any_way(random_.between(0.0, 2.0 * max_n_));
      case 1:
        return step_;
      case 2:
        return chance(0.5) ? step_ : -step_;
      case 3:
        return any_way(std::pow(10.0, random_.between(-320.0, 308.0)));
      default: {
        Force force = any_way(random_.between(0.0, 5.0));
        if (chance(0.1)) force.x = kOdd[random_.bits() % kOdd.size()];
        if (chance(0.1)) force.y = kOdd[random_.bits() % kOdd.size()];
        if (chance(0.1)) force.z = kOdd[random_.bits() % kOdd.size()];
        return force;
      }
    }
  }

  void next_time() {
    const std::int64_t period_ns =
        bench_->device() != nullptr ? bench_->device()->capabilities().period_ns : kMs;
    std::int64_t step_ns = period_ns;
    if (chance(0.01)) {
      constexpr std::array<std::int64_t, 8> kSteps{0,         1,          20 * kMs,      -kMs,
                                                   500 * kMs, -500 * kMs, 600'000 * kMs, 31 * kMs};
      step_ns = kSteps[random_.bits() % kSteps.size()];
    }
    now_ns_ += step_ns;
    bench_->before_tick(now_ns_);
    if (chance(0.05)) {
      bench_->hand().aim(
          {random_.between(-30, 120), random_.between(-30, 120), random_.between(-8, 8)}, {},
          static_cast<std::uint32_t>(random_.bits() % 4));
    }
  }

  void call() {
    ++verdict_.calls;
    DriverDevice* device = bench_->device();
    if (device == nullptr || chance(0.002)) return reopen();
    if (chance(0.003)) return home(*device);
    next_time();
    if (chance(0.98)) read(*device);
    if (chance(0.97)) write(*device);
    if (chance(0.02)) write(*device);
    if (chance(0.01)) stop(*device);
    look("");
  }

  void reopen() {
    next_time();
    (void)bench_->reconnect();
    is_gone_ = false;
    if (bench_->world().held_force() != Force{}) verdict_.broken = "opening pushes";
    look("after opening");
  }

  void home(DriverDevice& device) {
    device.stop();
    (void)device.homing();
    (void)device.homing_words();
    (void)device.find_home();
    look("after looking for home");
  }

  void read(DriverDevice& device) {
    const auto sample = device.read(now_ns_);
    if (!sample) {
      is_gone_ = is_gone_ || sample.error() == DeviceFault::kDisconnected;
      hash_.add_value(static_cast<int>(sample.error()));
      return;
    }
    if (is_gone_) verdict_.broken = "it said that it was gone, and lives";
    if (!is_finite(sample->position) || !is_finite(sample->velocity)) {
      verdict_.broken = "a sample that is no number";
    }
    hash_.add_value(sample->position.x);
    hash_.add_value(sample->position.z);
  }

  void write(DriverDevice& device) {
    const Force force = any_force();
    const auto done = device.write(force);
    if (done && !is_finite(force)) verdict_.broken = "a force that is no number is taken";
    hash_.add_value(done ? -1 : static_cast<int>(done.error()));
  }

  void stop(DriverDevice& device) {
    device.stop();
    if (bench_->stands_still()) return;
    if (bench_->world().held_force() != Force{}) verdict_.broken = "a force is held after stop()";
  }

  void look(const char* when) {
    const Force held = bench_->world().held_force();
    if (!is_finite(held)) verdict_.broken = "a force that is no number is held";
    if (!(bench_->largest_asked_n() <= max_n_ + 1e-6)) {
      verdict_.broken = "asked for " + std::to_string(bench_->largest_asked_n()) + " N, allowed " +
                        std::to_string(max_n_);
    }
    if (!bench_->broken_rule().empty()) verdict_.broken = std::string(bench_->broken_rule());
    if (!verdict_.broken.empty() && *when != '\0') verdict_.broken += std::string(" ") + when;
    hash_.add_value(held.x);
  }

  Random random_;
  std::unique_ptr<DriverBench> bench_;
  double max_n_ = 0.0;
  std::uint64_t kind_ = 0;
  Force step_;
  std::int64_t now_ns_ = 0;
  bool is_gone_ = false;
  LimitsVerdict verdict_;
  Fnv1a hash_;
};

}  // namespace

LimitsVerdict fuzz_limits(const BenchMaker& make, std::uint64_t seed) {
  return Sequence(make, seed).run();
}

}  // namespace felt
