#pragma once

#include <cstdint>

#include "felt/base/random.h"
#include "tests/devices/safety/fuzz_body.h"
#include "tests/devices/safety/tick_record.h"

namespace felt::safety {

/// A random device, hand, edit side and force model that try to make the chain fail. Each seed
/// gives one episode. The world sees the forces and reports of the chain. So it can stay calm until
/// forces are engaged, and cause faults then.
class FuzzWorld {
 public:
  explicit FuzzWorld(std::uint64_t seed);

  [[nodiscard]] const SafetyLimits& limits() const { return limits_; }
  /// Returns the number of ticks of this episode.
  [[nodiscard]] int ticks() const { return ticks_; }
  /// Returns true if all ticks of this episode have the same length.
  [[nodiscard]] bool is_regular() const { return mood_ == Mood::kClean; }

  /// Advances by one tick and returns its inputs. `report` and `sent` are the chain's report and
  /// force of the tick before.
  TickInput next(const SafetyReport& report, const Force& sent);
  /// Returns the force that the model requests, which is often too large. `dt_s`: the time that
  /// the chain gives to models.
  Force asked(const PenSample& sample, const StiffnessScale& scale, double dt_s);
  /// Returns the rule that the body under the pen broke, or null.
  [[nodiscard]] const char* broken_by_body() const { return body_.broken(); }

 private:
  enum class Mood : std::uint8_t { kClean, kRough, kWild };
  enum class Hand : std::uint8_t { kStill, kPress, kWalk, kSweep, kFree, kNoise, kCount };
  enum class Model : std::uint8_t {
    kNone,
    kConstant,
    kPlane,
    kStiff,
    kActiveDamper,
    kRandom,
    kFlip,
    kHuge,
    kBody,
    kCount
  };
  /// How the device is wrong about the velocity, in all ticks of an episode.
  enum class Lie : std::uint8_t { kNone, kReversed, kFrozen, kTenfold, kCount };

  bool chance(double p) { return random_.between(0.0, 1.0) < p; }
  std::uint64_t below(std::uint64_t n) { return random_.bits() % n; }
  Vec3 any_way(double length);
  void choose_limits();
  std::int64_t next_time();
  void orders(const SafetyReport& report, TickInput& in);
  void move_hand(const Force& sent, double dt_s);
  PenSample sense(double dt_s);
  void spoil(PenSample& sample);

  Random random_;
  SafetyLimits limits_;
  Mood mood_ = Mood::kClean;
  Hand hand_ = Hand::kStill;
  Model model_ = Model::kNone;
  int ticks_ = 0;
  int tick_ = 0;
  std::int64_t now_ns_ = 0;
  double time_s_ = 0.0;
  double next_beat_s_ = 0.0;
  double silent_until_s_ = -1.0;
  bool reports_velocity_ = true;
  Lie lie_ = Lie::kNone;
  Vec3 frozen_velocity_;
  Vec3 position_, velocity_, aim_, last_position_;
  double amplitude_mm_ = 10.0;
  double rate_hz_ = 2.0;
  int frozen_ticks_ = 0;
  int jumped_ticks_ = 0;
  Vec3 jump_;
  int calm_until_ = 12;
  Force constant_;
  double stiffness_ = 500.0;
  FuzzBody body_;
};

}  // namespace felt::safety
