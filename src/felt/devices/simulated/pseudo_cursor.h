#pragma once

#include "felt/geometry/point.h"

namespace felt {

struct PseudoCursorOptions {
  bool on = true;
  double gain = 1.0;        ///< shown displacement per mm that the force moves the pen
  double most_mm = 3.0;     ///< a tablet is absolute: with more, pen and cursor would separate
  double release_s = 0.05;  ///< from the largest displacement to none, after the force ends
};

/// Shows forces to the eye if the hand cannot feel them (docs/design/devices.md#pseudo-haptics;
/// Lecuyer et al. 2004: a cursor that lags behind or runs ahead of the hand is perceived as a
/// slope). The cursor is shown at the hand's position plus a bounded part of the displacement of
/// the simulated pen by the simulated force.
///
/// It is off while a pen draws on a tablet, because ink must appear under the pen's tip; when the
/// pen lifts, the displacement is released evenly. If values are not finite the cursor is at the
/// hand.
class PseudoCursor {
 public:
  explicit PseudoCursor(const PseudoCursorOptions& options = {}) noexcept : options_(options) {}

  /// What the pen does.
  enum class Use {
    kInAir,      ///< there is no force to show
    kFeeling,    ///< pressing, pulling, near something that attracts
    kTabletInk,  ///< drawing with a pen on a tablet
  };

  /// Returns the position of the cursor. `hand`: the position that mouse or tablet report;
  /// `stylus`: the simulated pen, moved by the forces; dt_s: time since the last call.
  Point update(Point hand, Point stylus, Use use, double dt_s) noexcept;

  void set_options(const PseudoCursorOptions& options) noexcept { options_ = options; }
  [[nodiscard]] const PseudoCursorOptions& options() const noexcept { return options_; }

 private:
  PseudoCursorOptions options_;
  Vec shown_;  // displacement, mm
};

}  // namespace felt
