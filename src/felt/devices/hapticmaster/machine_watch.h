#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace felt::hapticmaster {

/// The conditions that may last only for a limited time. Then the machine is switched off.
enum class Condition : std::uint8_t {
  kReleasePending,        ///< the force is to be zero, and the controller has not confirmed it
  kNoAnswer,              ///< the controller does not answer when asked for the position
  kImpossiblePosition,    ///< no position, or one that cannot be (MotionVerdict::kImpossible)
  kInconsistentPosition,  ///< positions and velocities contradict each other
  kCount
};
inline constexpr std::size_t kConditions = static_cast<std::size_t>(Condition::kCount);

struct Limit {
  Condition condition;
  std::int64_t limit_ns;  ///< the machine is switched off if the condition lasts longer
  /// How quickly the time of the condition is forgotten while the condition is absent: at once (0),
  /// or this much for each ns. The second kind also finds a fault that comes and goes.
  double forgets;
  std::string_view words;  ///< for the user
};

/// The table of the limits, in the order of Condition.
inline constexpr std::array<Limit, kConditions> kLimits{{
    {Condition::kReleasePending, 50'000'000, 0.0,
     "The controller did not confirm for 0.05 s that it has ended the force."},
    {Condition::kNoAnswer, 100'000'000, 0.0, "The controller did not answer for 0.1 s."},
    {Condition::kImpossiblePosition, 20'000'000, 0.25,
     "The position or velocity was impossible for longer than 0.02 s."},
    {Condition::kInconsistentPosition, 20'000'000, 0.25,
     "The position does not follow the velocity that the controller reports."},
}};

/// What a tick says about a condition.
enum class Sign : std::uint8_t {
  kAbsent,
  kPresent,
  kUnknown,  ///< the tick brought no news: the condition is as it was
};
using Signs = std::array<Sign, kConditions>;

/// Measures how long each condition has lasted. Real-time safe.
///
///   const Limit* const broken = watch.tick(ns since the last tick, signs);
///   if (broken != nullptr) ...  switch the machine off, and say broken->words
class MachineWatch {
 public:
  /// Forgets all conditions.
  void restart() noexcept { *this = {}; }
  /// Handles a tick, `ns` after the last one (LoopTime). Returns the first limit that is exceeded,
  /// or null. The whole time since the last tick counts for a condition that is present now.
  const Limit* tick(std::int64_t ns, const Signs& signs) noexcept;

 private:
  std::array<bool, kConditions> is_present_{};
  std::array<std::int64_t, kConditions> lasted_ns_{};
};

}  // namespace felt::hapticmaster
