#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "felt/rt/servo.h"

namespace felt::rt_test {

/// A haptic loop with everything it needs, and the edit side that supplies its force models.
class Session {
 public:
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  virtual ~Session() = default;

  virtual Servo& servo() = 0;
  /// Does the work of the edit side before tick `tick`, which will happen at `now_ns`: aims the
  /// hand, publishes force models and drains rings. May block and allocate, because it is not
  /// watched.
  virtual void edit(int tick, std::int64_t now_ns) = 0;
  /// Returns the number of first ticks that are not watched, because a program's first access to
  /// its memory and code causes page faults. (A real loop locks its memory.)
  [[nodiscard]] virtual int warm_up_ticks() const { return 200; }
  /// Returns the number of ticks, warm-up included, that the session needs to show everything.
  [[nodiscard]] virtual int min_ticks() const { return 0; }
};

/// One line of the list in scenarios.cc: the name of a session and a function that creates it.
struct Scenario {
  std::string name;
  bool pushes = true;  ///< true if a run without forces would prove nothing
  std::function<std::unique_ptr<Session>()> make;
};

/// Returns all scenarios. To add a scenario, derive a class from Session and add a line to the list
/// in scenarios.cc.
std::span<const Scenario> scenarios();

}  // namespace felt::rt_test
