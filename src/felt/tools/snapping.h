#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "felt/document/stroke_index.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// What ends of strokes do when the pen comes near (paper, eq. 11; R43): attract the pen, snap, or
/// both. With kForce the user can draw near an end without connecting to it.
enum class SnapMode { kOff, kForce, kSnap, kBoth };
/// The option names of SnapMode, in order.
inline constexpr std::array<std::string_view, 4> kSnapModes = {"off", "force", "snap", "both"};

constexpr bool attracts(SnapMode mode) noexcept {
  return mode == SnapMode::kForce || mode == SnapMode::kBoth;
}
constexpr bool snaps(SnapMode mode) noexcept {
  return mode == SnapMode::kSnap || mode == SnapMode::kBoth;
}

struct SnapOptions {
  SnapMode mode = SnapMode::kBoth;
  double reach_mm = 8.0;   ///< M: the force acts within this distance
  double radius_mm = 2.0;  ///< r_snap: an end within this distance snaps
  double force_n = 0.6;    ///< Fp: maximum attraction
};

/// Maximum stiffness of an attraction, N/mm. Together with the 60 N/m of a dragged end, it stays
/// within the limit of 300 N/m for edits.
inline constexpr double kWellSlopeNPerMm = 0.24;

/// Returns the shape of the attraction. The core, where the force grows with the distance, and the
/// rim, where it fades to zero, are each a quarter of the reach wide. If the force is large, the
/// core is wider, so that the stiffness stays below `slope_n_per_mm`. If the reach is too small for
/// that, the force is reduced. `strength` scales force and damping.
WellShape well_of(const SnapOptions& options, double strength = 1.0,
                  double slope_n_per_mm = kWellSlopeNPerMm) noexcept;

/// A point that attracts the pen: an end of a stroke of the document, a point on a stroke, or the
/// start of the stroke being drawn.
struct SnapTarget {
  TipId tip;  ///< no stroke id means the start of the stroke being drawn
  Point point;
  bool on_curve = false;  ///< true for a point on the stroke; `tip.tip` is then unused

  [[nodiscard]] bool is_own_start() const noexcept { return !tip.stroke; }
  friend bool operator==(const SnapTarget&, const SnapTarget&) noexcept = default;
};

/// Chooses the end that attracts an end being dragged. This is the nearest end within reach. It
/// stays chosen until another end is nearer by kHysteresisMm, so that the force does not alternate
/// between two ends. The other end of the same stroke is a target immediately, because the user
/// drags an end in order to connect it. The class is not thread-safe.
class SnapFinder {
 public:
  static constexpr double kHysteresisMm = 1.0;

  /// Forgets the dragged end and the target.
  void reset() noexcept;
  /// Starts dragging this end, without a target yet.
  void drag(TipId tip) noexcept;
  /// Updates the target for the dragged end, which is now at `end`. Returns the target, or nullopt
  /// if no end is within reach.
  const std::optional<SnapTarget>& update(Point end, const SnapOptions& options,
                                          const Document& document, const StrokeIndex& index);
  [[nodiscard]] const std::optional<SnapTarget>& target() const noexcept { return target_; }

 private:
  std::optional<SnapTarget> target_;
  std::optional<TipId> dragged_;
};

/// Returns true if the target has not moved and is on a visible layer. Always returns true for the
/// start of the stroke being drawn.
bool is_still_there(const SnapTarget& target, const Document& document);

}  // namespace felt
