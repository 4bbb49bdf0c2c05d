#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "felt/rt/servo.h"

namespace felt::rt_test {

/// A haptic loop with everything that it needs, and the edit side that feeds it.
class Session {
 public:
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  virtual ~Session() = default;

  virtual Servo& servo() = 0;
  /// What the edit side does before tick `tick`, which will happen at `now_ns`: aims the hand,
  /// publishes force models, drains rings. May do what it likes: it is not watched.
  virtual void edit(int tick, std::int64_t now_ns) = 0;
  /// So many first ticks are not watched: what a program touches first, its code included, comes
  /// with a page fault. (A real loop locks its memory.)
  [[nodiscard]] virtual int warm_up_ticks() const { return 200; }
  /// It has not shown all before so many.
  [[nodiscard]] virtual int least_ticks() const { return 0; }
};

/// One line of the list in scenarios.cc: a name, and how to make it.
struct Scenario {
  std::string name;
  bool pushes = true;  ///< forces must have been sent, or the run proves nothing
  std::function<std::unique_ptr<Session>()> make;
};

/// To add one: a class that is a Session, in a file of its own or in scenarios.cc, and a line here.
std::span<const Scenario> scenarios();

}  // namespace felt::rt_test
