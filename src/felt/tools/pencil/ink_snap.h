#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/tools/pencil/pen_track.h"
#include "felt/tools/pencil/snap_rules.h"
#include "felt/tools/scene.h"
#include "felt/tools/snapping.h"

namespace felt {

/// Decides to which target a line being drawn snaps, and which target attracts the pen
/// (docs/decisions/0011-when-a-line-snaps.md; R43, R44):
///
///   - an end of another line, if the pen approaches it slowly and is heading for it, and the new
///     line would continue the other one. These ends are excluded: the end on which the new line
///     was begun, ends at which the new line would turn back along the other line, ends of lines
///     that the new line has crossed elsewhere, and ends that belong to a hatching;
///   - the start of the line itself, if the line goes once around an area;
///   - a point on another line, if the pen stops just before that line and no other line is close
///     behind it.
///
/// Call order: hover() for each hover sample; begin() at the touch; update() for each sample in
/// contact; start_target() and target() to get the targets of the line's two ends; end() after the
/// lift. Not thread-safe.
class InkSnap {
 public:
  /// The line's own start, and the other end of the line on which it was begun, are targets only if
  /// the line so far goes once around an area: 4 pi A / L^2, with A the area and L the length (1
  /// for a circle, 0.24 for an ellipse of 10:1), is at least this ...
  static constexpr double kMinRoundness = 0.22;
  /// ... or at least this, if the extent is at least kLargeMm and the gap at most kLargeShare of
  /// it. This is for shapes like a star or the outline of a hand.
  static constexpr double kMinRoundnessOfLarge = 0.06;
  static constexpr double kLargeMm = 15.0, kLargeShare = 0.05;
  /// Maximum number of turns. A line with more turns is a coil, which is shading.
  static constexpr double kMaxTurns = 1.6;
  /// Minimum size. Smaller shapes never close.
  static constexpr double kMinExtentMm = 2.0;
  /// Maximum gap in a shape that closes, relative to the extent of the shape.
  static constexpr double kMaxGapShare = 0.62;
  /// The radius for closing, relative to the snap radius. It is larger because users often lift the
  /// pen a little before the shape is closed. The faster the pen, the earlier they lift it.
  /// Therefore the distance that the pen moves in kEarlyS is added, but at most the snap radius.
  static constexpr double kCloseShare = 1.2;
  static constexpr double kEarlyS = 0.02;
  /// Maximum distance between an end and the start of a new line that continues it, relative to the
  /// snap radius. The direction is not checked, because a pen that lands has none yet.
  static constexpr double kStartShare = 0.6;
  /// If the pen stops within this distance of another line, relative to the snap radius, the two
  /// lines meet.
  static constexpr double kMeetShare = 0.3;
  /// A pen that has come this near has reached the target that attracts it.
  static constexpr double kReachedMm = 0.3;

  /// Handles a hover sample. `is_near` says whether the pen is near the surface.
  void hover(Point pen, std::int64_t time_ns, bool is_near, const SnapOptions& options,
             const Scene& scene);
  void begin(Point pen, std::int64_t time_ns, const SnapOptions& options, const Scene& scene);
  void update(Point pen, std::int64_t time_ns, const SnapOptions& options, const Scene& scene);
  /// Ends the line. `drawn` is its stroke, or nullopt if it was discarded.
  void end(std::optional<StrokeId> drawn) noexcept;

  /// Returns the target that the end of the line gets if the pen is lifted now. While the pen
  /// hovers, returns the possible target of a line that begins now. Returns nullopt if snapping is
  /// off.
  [[nodiscard]] const std::optional<SnapTarget>& target() const noexcept { return target_; }
  /// Returns the target of the line's start. Returns nullopt until the line has a direction.
  [[nodiscard]] const std::optional<SnapTarget>& start_target() const noexcept {
    return start_target_;
  }
  /// Returns the target that attracts the pen. Returns nullopt if attraction is off.
  [[nodiscard]] const std::optional<SnapTarget>& attraction() const noexcept { return attraction_; }
  /// Returns true if the pen is on the page and has been slow for long enough to rest, or leaves
  /// slowly, and has not been at attraction() yet. A target that has been reached lets the pen go.
  [[nodiscard]] bool rests() const noexcept {
    return rests_ && (!attraction_ || closest_mm_ > kReachedMm);
  }

 private:
  /// Conditions on the distance and direction of the pen for a target.
  struct Aim {
    double within_mm;
    double cone_deg;
    double miss_mm;
    double closing_mm;  ///< the maximum gap to the start of the line
    double sure_share;  ///< below this gap/extent, the direction does not matter
    bool felt;          ///< true for the attraction, which excludes the line just finished
  };
  /// The part of an outline that is already drawn: the line on which the new line was begun.
  struct Part {
    double area_mm2 = 0.0, length_mm = 0.0, extent_mm = 0.0;
  };

  void find_begun_on(const Scene& scene);
  void note_crossings(const Scene& scene);
  void follow_rest(std::int64_t time_ns) noexcept;
  void find_attraction(const Scene& scene);
  [[nodiscard]] bool is_heading_for(Point target, const Aim& aim) const noexcept;
  [[nodiscard]] bool is_slow(double gap_mm) const noexcept;
  [[nodiscard]] bool closes(Point target, const Part& before) const noexcept;
  [[nodiscard]] bool is_closing(Point target, const Part& before, const Aim& aim) const noexcept;
  [[nodiscard]] bool may_join(const TipHit& end, const Scene& scene) const;
  [[nodiscard]] std::optional<TipHit> nearest_end(const Aim& aim, const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> find(const Aim& aim, double meet_mm,
                                               const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> find_curve(double within_mm, const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> find_start(const Scene& scene) const;
  [[nodiscard]] bool may_begin_on(const TipId& end, const Scene& scene) const;

  SnapOptions options_;
  PenTrack track_;
  bool is_drawing_ = false, is_in_air_ = false, rests_ = false;
  std::int64_t slow_since_ns_ = 0;
  std::optional<StrokeId> last_;   // the line just finished
  std::optional<TipId> begun_on_;  // the end nearest to the start, joined or not
  Part begun_part_;                // stroke of begun_on_, from its other end
  std::optional<SnapTarget> target_, start_target_, attraction_;
  double closest_mm_ = 0.0;  // smallest distance of the pen from attraction_ so far
  Point crossings_from_;
  std::vector<snap_rules::Crossed> crossed_;
  std::optional<double> first_crossing_mm_, last_crossing_mm_;  // path lengths at these crossings
};

}  // namespace felt
