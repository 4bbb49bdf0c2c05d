#pragma once

#include "felt/geometry/point.h"

namespace felt {

struct PseudoCursorOptions {
  bool on = true;
  double gain = 1.0;        ///< shown displacement per mm that the force moves the pen
  double most_mm = 3.0;     ///< a tablet is absolute: more, and pen and cursor part
  double release_s = 0.05;  ///< from the largest displacement back to none, on lift
};

/// What the eye is told of a force that the hand cannot feel (devices.md 10.5; Lecuyer et al. 2004:
/// a cursor that lags behind or runs ahead of the hand is taken for a slope). The cursor is shown
/// at the hand plus a bounded part of what the simulated force moves the simulated pen against it.
///
/// While ink flows on a tablet it is off, since ink must appear under the pen's tip; when the pen
/// lifts, the displacement is released evenly. Total: values that are not finite show the hand.
class PseudoCursor {
 public:
  explicit PseudoCursor(const PseudoCursorOptions& options = {}) noexcept : options_(options) {}

  /// What the pen does.
  enum class Use {
    kInAir,      ///< no force is meant to be felt
    kFeeling,    ///< pressing, pulling, near something that attracts
    kTabletInk,  ///< drawing with a pen on a tablet
  };

  /// Where to show the cursor. `hand`: where mouse or tablet say the hand is; `stylus`: where the
  /// forces have moved the simulated pen; dt_s since the last call.
  Point update(Point hand, Point stylus, Use use, double dt_s) noexcept;

  void set_options(const PseudoCursorOptions& options) noexcept { options_ = options; }
  [[nodiscard]] const PseudoCursorOptions& options() const noexcept { return options_; }

 private:
  PseudoCursorOptions options_;
  Vec shown_;  // displacement, mm
};

}  // namespace felt
