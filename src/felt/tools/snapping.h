#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "felt/document/stroke_index.h"
#include "felt/haptics/bricks/well.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// What ends of strokes do to a pen that comes near (paper, eq. 11; R43). With the force alone you
/// can draw near an end without being connected to it.
enum class SnapMode { kOff, kForce, kSnap, kBoth };
/// Their names, in that order.
inline constexpr std::array<std::string_view, 4> kSnapModes = {"off", "force", "snap", "both"};

constexpr bool attracts(SnapMode mode) noexcept {
  return mode == SnapMode::kForce || mode == SnapMode::kBoth;
}
constexpr bool snaps(SnapMode mode) noexcept {
  return mode == SnapMode::kSnap || mode == SnapMode::kBoth;
}

struct SnapOptions {
  SnapMode mode = SnapMode::kBoth;
  double reach_mm = 8.0;   ///< M: the force is felt within
  double radius_mm = 2.0;  ///< r_snap: the end is moved within
  double force_n = 0.6;    ///< Fp
};

/// Greatest stiffness of an attraction, N/mm: with the 60 N/m of a dragged end the bound of
/// 300 N/m for edits is kept.
inline constexpr double kWellSlopeNPerMm = 0.24;

/// The shape of the attraction: core and rim of a quarter of the reach. The core grows with the
/// force so that it is not stiffer than kWellSlopeNPerMm; if the reach is too small for that, the
/// force is less. `strength` scales force and damping.
WellShape well_of(const SnapOptions& options, double strength = 1.0) noexcept;

/// A point that attracts: an end of a stroke of the document, a point on one, or the start of the
/// stroke being drawn.
struct SnapTarget {
  TipId tip;  ///< without a stroke: the own start
  Point point;
  bool on_curve = false;  ///< a point on the stroke; `tip.tip` has no meaning

  [[nodiscard]] bool is_own_start() const noexcept { return !tip.stroke; }
  friend bool operator==(const SnapTarget&, const SnapTarget&) noexcept = default;
};

/// Chooses the end that attracts an end being dragged: the nearest within reach, kept until another
/// is nearer by 1 mm, so that the force does not alternate between two. The other end of the same
/// stroke counts at once, because an end is dragged to be connected. One thread.
class SnapFinder {
 public:
  static constexpr double kHysteresisMm = 1.0;

  /// Nothing is dragged.
  void reset() noexcept;
  /// This end is dragged from now on.
  void drag(TipId tip) noexcept;
  /// The end has been moved here. Returns the target, or nothing.
  const std::optional<SnapTarget>& update(Point end, const SnapOptions& options,
                                          const Document& document, const StrokeIndex& index);
  [[nodiscard]] const std::optional<SnapTarget>& target() const noexcept { return target_; }

 private:
  std::optional<SnapTarget> target_;
  std::optional<TipId> dragged_;
};

/// True if the target is still where it was, on a visible layer. The own start always is.
bool is_still_there(const SnapTarget& target, const Document& document);

}  // namespace felt
