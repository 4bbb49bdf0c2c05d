#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"
#include "felt/geometry/point.h"
#include "felt/session/event.h"

namespace felt {

/// Writes one act of the demonstration as a script: the movements of the hand, with the pauses that
/// a hand needs to feel something. The hand moves slowly along smooth curves; the times of its
/// events are computed from the lengths of the curves.
class DemoAct {
 public:
  /// Default depth of a press. A typical hand then presses on paper with 0.3 N.
  static constexpr double kLightMm = 2.0;

  void tool(const char* id);
  void set(const char* id, const OptionValue& value);
  /// Adds the pencil strokes that `hand` draws, as recorded samples. For each stroke, increases
  /// `count` by one and names the stroke after the new number ("demo-7").
  void draw(WritingHand& hand, const std::vector<Gesture>& gestures, int& count);

  /// Adds a movement through the air and a moment of rest above the point.
  void hover(Point at);
  void press(double depth_mm = kLightMm);
  /// Adds a movement through these points, starting at the hand's position.
  void along(const std::vector<Point>& via, double mm_per_s = 30.0);
  void wait(double seconds);
  void lift();
  /// From now on, the hand shakes to both sides of its aim by `amplitude_mm`; 0 stops it.
  void shake(Vec amplitude_mm, double hz) noexcept {
    shake_mm_ = amplitude_mm;
    shake_hz_ = hz;
  }
  /// Adds the choice of what a stroke means.
  void choose(OfferKind what);
  /// Opens a ring around the pen.
  void open_ring(double radius_mm);
  void close_ring() { say(UseRing{}); }
  void add_guide(const DrawingGuide& guide) { say(GuidesEvent{.guide = guide}); }
  void clear_guides() { say(GuidesEvent{.what = GuidesEvent::Do::kClear}); }
  void make_exact() { say(ExactEvent{}); }
  /// Adds a short touch at this point.
  void tap(Point at);
  /// Adds a whole gesture: the pen touches at the first point, moves along the others, rests for a
  /// moment, and lifts.
  void gesture(const std::vector<Point>& via, double mm_per_s = 30.0, double depth_mm = kLightMm);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// Returns the time of the last event.
  [[nodiscard]] double seconds() const noexcept { return now_s_; }

 private:
  void say(const decltype(Event::what)& what);
  void go(const Vec3& target, double seconds);
  void aim(const Vec3& target);

  std::string text_;
  double now_s_ = 0.0;
  double drawing_s_ = 0.0;  // time needed to draw the strokes that draw() added
  Vec3 hand_{};
  bool is_there_ = false;
  Vec shake_mm_{};
  double shake_hz_ = 0.0;
};

/// Returns a loop around the head of the cat of share/samples.
std::vector<Point> loop_around_cats_head();

}  // namespace felt
