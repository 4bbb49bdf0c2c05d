#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/tools/pencil/pen_track.h"
#include "felt/tools/pencil/snap_rules.h"
#include "felt/tools/scene.h"
#include "felt/tools/snapping.h"

namespace felt {

/// Decides what a line being drawn snaps to, and what attracts the pen
/// (docs/decisions/0011-when-a-line-snaps.md; R43, R44):
///
///   - an end of another line, if the pen comes to it slowly, is heading for it, and the two would
///     go on as one line: never one that the line was begun on, that it runs back along, that
///     it has crossed, or that lies in a hatching;
///   - the start of the line itself, if the line goes once around an area;
///   - a point on another line, if the line stops just before the first line in its way.
///
/// In order: hover() for each sample in the air; begin() at the touch; update() for each sample in
/// contact; then start_target() and target() say what the ends of the line are put on; end(). One
/// thread.
class InkSnap {
 public:
  /// An own start, and the other end of the line begun on, attract only if the line so far went
  /// once around an area: 4 pi A / L^2, which is 1 for a circle and 0.24 for an ellipse of 10:1 ...
  static constexpr double kMinRoundness = 0.22;
  /// ... or less if the shape is large and the gap small: a star, the outline of a hand.
  static constexpr double kMinRoundnessOfLarge = 0.06;
  static constexpr double kLargeMm = 15.0, kLargeShare = 0.05;
  /// A coil goes around more often. It is shading.
  static constexpr double kMaxTurns = 1.6;
  /// Smaller shapes never close.
  static constexpr double kMinExtentMm = 2.0;
  /// Largest gap in a shape that closes, relative to its extent.
  static constexpr double kMaxGapShare = 0.62;
  /// The radius for closing, relative to the snap radius: a hand that means to close a shape often
  /// lifts the pen a little early, at full speed by more (kEarlyS).
  static constexpr double kCloseShare = 1.2;
  static constexpr double kEarlyS = 0.02;
  /// How near to an end a line begins that continues it, relative to the snap radius. The pen lands
  /// freely, so that there is no direction that would tell more.
  static constexpr double kStartShare = 0.6;
  /// How far before a line the pen stops that is meant to meet it, relative to the snap radius.
  static constexpr double kMeetShare = 0.3;

  /// A sample in the air, `is_near` the surface.
  void hover(Point pen, std::int64_t time_ns, bool is_near, const SnapOptions& options,
             const Scene& scene);
  void begin(Point pen, std::int64_t time_ns, const SnapOptions& options, const Scene& scene);
  void update(Point pen, std::int64_t time_ns, const SnapOptions& options, const Scene& scene);
  /// The line is finished or discarded. Its stroke, if there is one, is the line just left.
  void end(std::optional<StrokeId> drawn) noexcept;

  /// What the end is put on if the pen is lifted here; in the air, what a line begun here may be
  /// put on. Nothing if snapping is off.
  [[nodiscard]] const std::optional<SnapTarget>& target() const noexcept { return target_; }
  /// What the start is put on. Nothing before the line has got a direction.
  [[nodiscard]] const std::optional<SnapTarget>& start_target() const noexcept {
    return start_target_;
  }
  /// What attracts the pen. Nothing if attraction is off.
  [[nodiscard]] const std::optional<SnapTarget>& attraction() const noexcept { return attraction_; }

 private:
  /// How exactly the pen must be heading for a target.
  struct Aim {
    double within_mm;
    double cone_deg;
    double miss_mm;
    double closing_mm;  ///< instead of within_mm, for the start of the line
    double sure_share;  ///< a gap this small beside the extent closes from every direction
    bool felt;          ///< for the attraction: not the line just left
  };
  /// What belongs to an outline besides the line being drawn: the line begun on.
  struct Part {
    double area_mm2 = 0.0, length_mm = 0.0, extent_mm = 0.0;
  };

  void find_begun_on(const Scene& scene);
  void note_crossings(const Scene& scene);
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
  bool is_drawing_ = false, is_in_air_ = false;
  std::optional<StrokeId> last_;   // the line just left
  std::optional<TipId> begun_on_;  // the end nearest to the start, joined or not
  Part begun_part_;                // its stroke, from the other end to this one
  std::optional<SnapTarget> target_, start_target_, attraction_;
  double closest_mm_ = 0.0;  // that the pen came to the attraction
  Point crossings_from_;
  std::vector<snap_rules::Crossed> crossed_;
  std::optional<double> first_crossing_mm_, last_crossing_mm_;  // along the path
};

}  // namespace felt
