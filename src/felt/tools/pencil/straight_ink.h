#pragma once

#include <optional>
#include <vector>

#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The straight line that the pencil draws while a modifier is held: from the touch to the pen. The
/// width at each place is the width that the pen had there, so pressure works as in a free line.
///
/// Use, for each line: begin(); push() for each sample; stroke(). If the pen moves back towards the
/// start, the widths beyond it are forgotten. The work per sample is O(1), amortised.
class StraightInk {
 public:
  /// Distance along the line between two places whose width is stored.
  static constexpr double kPlaceMm = 0.25;

  void begin(Point start, const WidthMapOptions& widths);
  void push(const InkSample& sample);

  [[nodiscard]] Point start() const noexcept { return start_; }
  /// Returns the position of the pen, or the point nearest to it in a direction from the start that
  /// in_direction_steps() allows.
  [[nodiscard]] Point pen() const noexcept { return pen_; }
  [[nodiscard]] Point pen_in_steps() const noexcept;

  /// Returns the line between two points with the widths that were drawn, or nullopt if it is
  /// shorter than kMinSegmentMm.
  [[nodiscard]] std::optional<Stroke> stroke(Point from, Point to,
                                             const InkFitOptions& options) const;
  /// Adds the line between two points as wet ink.
  void draw(Point from, Point to, Overlay& overlay) const;

 private:
  struct Place {
    double distance_mm = 0.0;  // from the start
    InkWidth ink;
  };

  /// Returns the position of a place on the line, 0 (start) to 1 (pen).
  [[nodiscard]] double share(const Place& place) const noexcept;

  Point start_, pen_;
  WidthMap widths_;
  std::vector<Place> places_;  // by increasing distance; the first one is the start
};

}  // namespace felt
