#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/base/random.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt {

/// A simulated person who follows a raised or engraved line without eyes
/// (docs/design/simulation.md#without-eyes). The person knows neither the line nor the position of
/// the pen on it. All that reaches the plan is the force on the pen, late, blurred and with noise,
/// and the person's own plan.
///
/// Besides the hand, the person may have ears: the tone of the tool is steady while the pen is on a
/// line, and the tool says when it is at an end (hear()). Who hears that the tone is not steady any
/// more goes back to where it was; who has heard no end does not believe in one.
///
/// The plan moves along a heading. A force from the side turns the heading and shifts the plan, and
/// any force slows it. A small weave from side to side shows whether there is a line at all. If the
/// pen is held back, if a strong force ends suddenly, or if nothing is felt for a while, the person
/// goes back and probes to both sides, then obliquely, and goes on where a line is felt from the
/// side and the pen is not held back. If there is none in any direction, the line ends. A
/// person who has not heard an end probes again, in the directions between.
///
///   BlindHand hand(preset, person, start, heading_rad);
///   Servo servo(hand.device(), options);
///   each tick: hand.step(); servo.step(now_ns);
///
/// Deterministic, like FeedbackHand.
class BlindHand {
 public:
  /// The person presses the pen down at `start` and moves in the direction of the heading.
  BlindHand(const StylusPreset& preset, const Person& person, Point start, double heading_rad);

  [[nodiscard]] FeedbackHand& device() noexcept { return hand_; }
  /// Tells the person what the tool sounds like now. Without a call, the person hears nothing.
  void hear(bool is_on_line, bool is_at_end) noexcept {
    hears_line_ = is_on_line;
    hears_end_ = is_at_end;
  }
  /// Plans the next tick. Call it before each read() of the device.
  void step() noexcept;
  /// Returns true once the person believes that the line ends at the pen.
  [[nodiscard]] bool found_end() const noexcept { return state_ == State::kDone; }

 private:
  enum class State { kRest, kFollow, kProbe, kReturn, kDone };

  void feel() noexcept;
  void rest() noexcept;
  void follow() noexcept;
  void start_probing(Point from) noexcept;
  void probe() noexcept;
  void go_back() noexcept;
  void press() noexcept;
  [[nodiscard]] Vec heading() const noexcept;
  [[nodiscard]] double weave_speed() const noexcept;

  FeedbackHand hand_;
  Random random_;
  double tick_s_;
  std::vector<Vec> delayed_;  // ring buffer of felt forces, N
  std::vector<Point> plans_;  // the plan in the same ticks
  std::size_t tick_ = 0;
  Vec noise_{}, felt_{};
  State state_ = State::kRest;
  Point plan_;
  double turn_rad_;       // heading
  double weave_s_ = 0.0;  // time since the weave began
  double held_back_s_ = 0.0, nothing_s_ = 0.0;
  double strongest_n_ = 0.0;                   // of the last moments
  double side_ = 0.0;                          // on which side the force was last felt
  Point felt_at_{};                            // the plan when a line was last felt
  Point anchor_{};                             // from where the person probes
  double first_rad_ = 0.0;                     // heading before probing
  std::size_t probe_ = 0, round_ = 0;          // of probes
  bool hears_line_ = true, hears_end_ = true;  // without ears, only the hand counts
  double off_line_s_ = 0.0;                    // since the tone was steady
  Point heard_at_{};                           // the plan when it was
  double probed_mm_ = 0.0, aside_n_ = 0.0;
  double waited_s_ = 0.0;
};

}  // namespace felt
