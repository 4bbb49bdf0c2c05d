#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "felt/document/stroke_index.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/well.h"

namespace felt {

/// What ends of strokes do to a pen that comes near (paper, eq. 11; specification 5g; R43). With
/// the force alone a person can draw near an end and resist being connected to it.
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

/// The shape of the attraction: core and rim of a quarter of the reach, as 2 mm of 8.
WellShape well_of(const SnapOptions& options) noexcept;

/// A place that attracts: an end of a stroke of the document, or (no stroke) the start of the one
/// being drawn.
struct SnapTarget {
  TipId tip;
  Point point;

  [[nodiscard]] bool is_own_start() const noexcept { return !tip.stroke; }
  friend bool operator==(const SnapTarget&, const SnapTarget&) noexcept = default;
};

/// Chooses what a pen is attracted to, sample by sample: the nearest end within reach, kept until
/// another is nearer by 1 mm, so that the force does not flicker between two. The start of the
/// stroke being drawn counts only after the pen has been farther away than the reach and has come
/// three times as far (R44): a short scribble never closes. One thread.
class SnapFinder {
 public:
  static constexpr double kHysteresisMm = 1.0;
  /// Path is measured in steps of at least this: a resting pen trembles, it does not travel.
  static constexpr double kPathStepMm = 0.25;
  /// Path that arms the own start, in reaches.
  static constexpr double kArmingReaches = 3.0;

  /// In the air, before a stroke.
  void reset() noexcept;
  /// A stroke begins here. `connected` is the end that its start was put on, if any: it is no
  /// target of this stroke, whose own start lies there.
  void begin(Point start, std::optional<TipId> connected) noexcept;
  /// An end of a stroke of the document is dragged from here on: it is no target of itself. The
  /// other end of its stroke counts at once, since closing is what a person drags it for.
  void drag(TipId tip) noexcept;
  /// The pen (or the end that it drags) is here now. Returns the target, or nothing.
  const std::optional<SnapTarget>& update(Point pen, const SnapOptions& options,
                                          const Document& document, const StrokeIndex& index);
  [[nodiscard]] const std::optional<SnapTarget>& target() const noexcept { return target_; }
  /// True once the start of the stroke attracts.
  [[nodiscard]] bool is_armed() const noexcept { return armed_; }

 private:
  void travel(Point pen, double reach_mm) noexcept;
  [[nodiscard]] bool is_still_there(const SnapTarget& target, const Document& document) const;

  std::optional<SnapTarget> target_;
  std::optional<Point> start_;
  std::optional<TipId> connected_;
  Point path_end_;
  double path_mm_ = 0.0;
  bool has_left_ = false;
  bool armed_ = false;
};

}  // namespace felt
