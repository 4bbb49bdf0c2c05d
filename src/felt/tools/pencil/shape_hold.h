#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/haptics/bricks/snap_well.h"
#include "felt/recognise/shape_guess.h"
#include "felt/tools/offer.h"
#include "felt/tools/pencil/rest_watch.h"

namespace felt {

/// Offers the shapes that a line resembles while the pen rests at the end of the line, and holds
/// the pen there. The best shape is accepted if the user presses harder while the pen rests. If the
/// pressure has hardly changed during the line, as with a mouse, it is accepted if the pen stays
/// for kStayS. A user who goes on drawing refuses the offer; it is made again if the pen rests
/// again.
///
/// Use: begin() at the touch; update() for each sample in contact.
class ShapeHold {
 public:
  static constexpr double kStayS = 1.0;
  /// Largest mean speed of a resting pen, of that of the line before.
  static constexpr double kMaxRestPace = 0.6;
  /// The offer ends at this distance from the resting point. The hold is a well of this radius, so
  /// its force is already on its plateau there.
  static constexpr double kLeaveMm = 4.0;
  /// Rise of the pressure that takes the shape: kPress, or half of what is left of the range.
  static constexpr double kPress = 0.2;
  /// A tip that is pressed harder may slip. A pen that leaves its rest for longer than this has
  /// moved on, so a press must exceed the pressure of its next rest (chosen).
  static constexpr double kSlipS = 0.25;
  /// A pressure that varies less than this in a line is not that of a hand on a pen (chosen: the
  /// pen strokes of `./dev bench gestures` with pressure vary more in all but a few lines).
  static constexpr double kConstantPressure = 0.05;
  /// Largest force of the hold. Its stiffness is 150 N/m, because a stiffer hold is not calm on the
  /// device with the most delay and no friction (docs/stability.md).
  static constexpr double kHoldN = 0.45;

  void begin(Point pen, std::int64_t time_ns) noexcept;
  /// Handles one sample. `path` is the line so far; it is examined once for each rest,
  /// and every 0.25 s while the pen is within the radius of a rest but not slow.
  void update(Point pen, std::optional<double> pressure, std::int64_t time_ns,
              std::span<const Point> path);
  /// Takes an offered shape. Has no effect if it is not offered.
  void accept(OfferKind kind) noexcept;

  /// Returns the offered shapes, the best one first; empty if nothing is offered.
  [[nodiscard]] const std::vector<ShapeGuess>& shapes() const noexcept { return shapes_; }
  /// Returns the index of the shape that was accepted.
  [[nodiscard]] std::optional<std::size_t> accepted() const noexcept { return accepted_; }
  /// Returns the point at which the pen is held: while shapes are offered and none is accepted.
  [[nodiscard]] std::optional<Point> holds_at() const noexcept;

 private:
  void watch_pressure(std::optional<double> pressure, std::int64_t time_ns) noexcept;
  void watch_resting_pressure(std::int64_t time_ns) noexcept;
  void watch_pace(Point pen, std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_accepted_by(std::optional<double> pressure) const noexcept;

  RestWatch rest_;
  double ask_at_s_ = 0.0;  // the path is examined when the rest has lasted so long
  std::vector<ShapeGuess> shapes_;
  std::optional<std::size_t> accepted_;
  Point held_, last_;  // last_: the pen at last_ns_, while shapes are offered
  std::int64_t last_ns_ = 0;
  double speed_ = 0.0, max_speed_ = 0.0;  // mm/s, low-passed, and the largest at rest
  double offered_s_ = 0.0;                // still_s() when the shapes were offered
  std::int64_t start_ns_ = 0;
  double low_ = 1.0, high_ = 0.0;  // pressures of the line
  double smooth_ = 0.0;            // low-passed pressure
  double resting_ = 0.0;           // pressure of the rest, which a press must exceed
  std::int64_t rested_ns_ = 0;     // when the pen last rested with shapes offered
  bool has_pressure_ = false;
};

/// Returns the attraction that holds the pen while shapes are offered: a spring that ends
/// (WellShape), so it is bounded and passive, and it yields to a pen that goes on.
WellShape hold_shape(double strength) noexcept;

/// Returns the kind of offer of a shape.
OfferKind offer_of(ShapeForm form) noexcept;

}  // namespace felt
