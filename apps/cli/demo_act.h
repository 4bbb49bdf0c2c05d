#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"
#include "felt/geometry/point.h"
#include "felt/session/event.h"

namespace felt {

/// Writes one act of the demonstration as a script: what the hand does, line by line, with the
/// pauses that it takes to feel something. Ways are smooth and at an unhurried pace; times count by
/// themselves.
class DemoAct {
 public:
  /// Presses this deep unless it says so: 0.3 N in a typical hand on paper.
  static constexpr double kLightMm = 2.0;

  void tool(const char* id);
  void set(const char* id, const OptionValue& value);
  /// Lines for the pencil, as a hand records them; `count` numbers them on.
  void draw(WritingHand& hand, const std::vector<Gesture>& gestures, int& count);

  /// Goes there through the air and waits a moment above it.
  void hover(Point at);
  void press(double depth_mm = kLightMm);
  /// Through these points, starting where the hand is.
  void along(const std::vector<Point>& via, double mm_per_s = 30.0);
  void wait(double seconds);
  void lift();
  /// Touches for a moment.
  void tap(Point at);
  /// One whole gesture: down at the first point, along the others, a moment of rest, up.
  void gesture(const std::vector<Point>& via, double mm_per_s = 30.0, double depth_mm = kLightMm);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  void say(const decltype(Event::what)& what);
  void go(const Vec3& target, double seconds);
  void aim(const Vec3& target);

  std::string text_;
  double now_s_ = 0.0;
  double drawing_s_ = 0.0;  // that lines for the pencil take
  Vec3 hand_{};
  bool is_there_ = false;
};

}  // namespace felt
