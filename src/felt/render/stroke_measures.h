#pragma once

#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Measures of strokes that do not depend on the part of the page that is drawn. Those of the long
/// strokes that were used last are kept, because a drawing is painted in many tiles, and a long
/// stroke is in many of them.
///
/// A stroke is recognised by its points and widths, which takes much less time than to measure it.
/// Not thread-safe.
class StrokeMeasures {
 public:
  /// Strokes with fewer segments are measured again each time.
  static constexpr int kMinKeptSegments = 128;
  /// Largest number of strokes that are kept, and of their segments and widths together: about
  /// 20 MB.
  static constexpr std::size_t kMaxKept = 64;
  static constexpr std::size_t kMaxKeptSegments = 200'000;

  /// Selects the stroke that the other functions are about.
  void use(const Stroke& stroke);
  /// Returns segment_area() of each segment of the stroke. Requires a call of use().
  [[nodiscard]] std::span<const Rect> areas() const noexcept { return current_->areas; }
  /// Returns the sums of segment_travel() at the start of each segment, and at the end of the
  /// stroke, if it is drawn at this scale. Valid until the next call of use(). `stroke` is the one
  /// of use().
  std::span<const double> travels(const Stroke& stroke, double px_per_mm);
  /// Returns how many strokes have been measured so far.
  [[nodiscard]] std::size_t measured_count() const noexcept { return measured_; }

 private:
  struct Entry {
    std::vector<Point> points;
    std::vector<WidthKnot> widths;
    bool closed = false;
    std::vector<Rect> areas;
    std::vector<double> travels;
    double px_per_mm = 0.0;  // of the travels; 0 if there are none

    [[nodiscard]] bool is_of(const Stroke& stroke) const noexcept;
  };
  void measure(const Stroke& stroke, Entry& entry);

  std::list<Entry> kept_;  // the one that was used last is the last
  std::size_t kept_segments_ = 0;
  Entry short_;  // of the last short stroke
  Entry* current_ = &short_;
  std::size_t measured_ = 0;
};

}  // namespace felt
