#pragma once

#include "felt/geometry/point.h"

namespace felt {

struct PseudoCursorOptions {
  bool on = true;
  double gain = 1.0;        ///< mm of cursor displacement for each mm that the force moves the pen
  double max_mm = 3.0;      ///< maximum displacement, so that cursor and pen stay together
  double release_s = 0.05;  ///< time from the maximum to 0 after the force ends
};

/// Shows forces by displacing the cursor, for users whose device has no force
/// (docs/design/devices.md#pseudo-haptics). A cursor that lags behind or runs ahead of the hand is
/// perceived as a slope (Lecuyer et al. 2004). The cursor's displacement is the displacement of the
/// simulated pen by the simulated force, multiplied by a gain and limited to `max_mm`.
///
/// The displacement is 0 while a pen draws on a tablet, because ink must appear under the pen's
/// tip. When the force ends, the displacement falls to 0 at a constant rate. If values are not
/// finite, the displacement is 0.
class PseudoCursor {
 public:
  explicit PseudoCursor(const PseudoCursorOptions& options = {}) noexcept : options_(options) {}

  /// What the user does with the pen now.
  enum class Use {
    kInAir,      ///< in the air, without force
    kFeeling,    ///< pressing, pulling, or near something that attracts the pen
    kTabletInk,  ///< drawing with a pen on a tablet
  };

  /// Returns the position of the cursor. `hand` is the position that the mouse or tablet reports,
  /// `stylus` the position of the simulated pen, which the forces move, and `dt_s` the time since
  /// the last call.
  Point update(Point hand, Point stylus, Use use, double dt_s) noexcept;

  void set_options(const PseudoCursorOptions& options) noexcept { options_ = options; }
  [[nodiscard]] const PseudoCursorOptions& options() const noexcept { return options_; }

 private:
  PseudoCursorOptions options_;
  Vec shown_;  // displacement, mm
};

}  // namespace felt
