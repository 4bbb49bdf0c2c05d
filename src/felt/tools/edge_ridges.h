#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/rect.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/guide_track.h"

namespace felt {

/// The edges of the page and of the box around the selection as soft ridges, which push the pen
/// away from the edge (docs/design/forces.md#edges). The ridge of the nearer edge acts.
///
///   ridges.set(page, box);           // when they may have changed
///   ridges.update(sample);           // every sample
///   if (ridges.force()) ...          // the force near the last sample
///
/// A deterministic function of its calls. Use it on the edit thread.
class EdgeRidges {
 public:
  /// Distance from the edges beyond which force() returns null, because the force is zero there.
  static constexpr double kNearMm = 8.0;
  /// The other edge takes over when it is nearer by this.
  static constexpr double kSwitchMm = 1.0;

  /// Sets the rectangles; one that is empty, too small or too large has no ridge.
  void set(const Rect& page, const Rect& box);
  void update(const PenSample& sample);

  /// Returns the ridge near the last sample, or null if no edge is near.
  [[nodiscard]] const Guide* force() const noexcept { return active_ ? &guide_ : nullptr; }
  /// Returns a number that changes when another ridge acts, or the same one again; then its force
  /// begins at zero.
  [[nodiscard]] std::uint32_t number() const noexcept { return hold_; }

 private:
  struct Edge {
    Rect rect;
    std::optional<GuideTrack> track;
  };

  void set_edge(std::size_t which, const Rect& rect);

  std::array<Edge, 2> edges_;
  std::optional<std::size_t> active_;  // of edges_
  std::uint32_t active_hold_ = 0;      // GuideTrack::hold() of the active edge
  Guide guide_;
  // The last value of GuidePiece::hold (GuideTrack).
  std::uint32_t hold_ = 3U << 30;
};

}  // namespace felt
