#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/scene.h"

namespace felt {

/// Holds a slow pen to a line that it draws over, with a small force like a groove
/// (docs/design/forces.md#retracing). A pen retraces a line if it has stayed near that line, and
/// along it, for kFollowedMm. It is let go when it leaves the line, turns away or becomes fast.
///
///   retrace.update(sample, is_down, scene, force_n);  // every sample
///   retrace.force()                                   // the force near the last sample, or null
///
/// The path of the pen is divided into steps of at least 0.5 mm; the distances along it are counted
/// in such steps.
///
/// A deterministic function of the samples. Use it on the edit thread. With n segments near the
/// pen, a step takes O(n log n); the one at which the hold begins takes time linear in the length
/// of the line.
class Retrace {
 public:
  /// A pen follows a line if it stays within the first distance of it ...
  static constexpr double kNearMm = 0.7;
  /// ... and within this angle of its direction, for this distance, and on average within kMeanMm.
  static constexpr double kAlongDeg = 15.0, kFollowedMm = 5.0, kMeanMm = 0.35;
  /// A pen that is held has left the line beyond this distance or angle.
  static constexpr double kLeftMm = 1.0, kLeftDeg = 25.0;
  /// A pen is held if it was slower than the first speed, and let go if it becomes faster than the
  /// second one.
  static constexpr double kSlowMmPerS = 80.0, kFastMmPerS = 100.0;
  /// A pen that was let go is not held again in the same touch for this distance.
  static constexpr double kAgainMm = 10.0;
  /// No hold begins if another line runs beside the pen, between kNearMm and this distance, as in a
  /// hatching, or if the line comes back beside itself, further away than kApartMm, as in a zigzag.
  static constexpr double kBesideMm = 2.0, kApartMm = 0.3;
  /// The first value of GuidePiece::hold (GuideTrack): that of lines, and that of contours.
  static constexpr std::uint32_t kFirstHold = 1U << 30, kFirstContourHold = 3U << 29;

  explicit Retrace(std::uint32_t first_hold = kFirstHold) noexcept : hold_(first_hold) {}

  /// Handles a sample. `is_down` is true from the touch until the lift, also in a bounce. `force_n`
  /// is the largest force; 0 lets the pen go.
  void update(const PenSample& sample, bool is_down, const Scene& scene, double force_n);
  /// Lets the pen go until the next touch.
  void stop() noexcept;

  /// Returns the force near the last sample, or null if no line holds the pen.
  [[nodiscard]] const Guide* force() const noexcept { return track_ ? &track_->guide() : nullptr; }
  /// Returns a number that is different each time that a line begins to hold the pen.
  [[nodiscard]] std::uint32_t number() const noexcept { return track_ ? track_->number() : hold_; }
  /// Returns the line that holds the pen, or nullopt.
  [[nodiscard]] std::optional<StrokeId> line() const noexcept {
    return track_ ? std::optional(held_) : std::nullopt;
  }

  /// Returns the law of the force: a groove with the spring of guides (guide_spring_for).
  static GuideLaw law(double force_n, const Capabilities& device) noexcept;

 private:
  // Directions are measured over kChordSteps steps.
  static constexpr double kStepMm = 0.5;
  static constexpr std::size_t kChordSteps = 4;
  static constexpr int kFollowedSteps = static_cast<int>(kFollowedMm / kStepMm);
  static constexpr int kAgainSteps = static_cast<int>(kAgainMm / kStepMm);

  /// Positions of the pen, or the positions on a line nearest to them, after the last steps; [0] is
  /// the newest.
  using Positions = std::array<Point, kChordSteps + 1>;
  /// A line near the pen.
  struct Line {
    StrokeId id;
    Positions positions{};
    double u = 0.0;        ///< of positions[0]
    int steps = 0;         ///< for which the pen has followed it
    double away_mm = 0.0;  ///< sum of the distances over those steps
  };
  struct Near {
    StrokeId id;
    StrokePtr stroke;
    double u = 0.0;  ///< segment index + t
    Point point;
    double distance_mm = 0.0;
  };

  static void add(Positions& positions, Point position) noexcept;
  void begin(const PenSample& sample) noexcept;
  static bool is_onward(double from_u, const Near& to) noexcept;
  void step(Point pen, std::int64_t time_ns, const Scene& scene, double force_n);
  [[nodiscard]] std::vector<Near> lines_near(Point pen, const Scene& scene) const;
  [[nodiscard]] bool goes_along(const Line& line, double max_deg) const noexcept;
  void follow(const std::vector<Near>& near);
  [[nodiscard]] bool is_beside_ink(const Scene& scene) const;
  void hold(const Scene& scene, double force_n);
  void let_go() noexcept;
  [[nodiscard]] double chord_mm_per_s() const noexcept;

  Positions pen_{};
  std::array<std::int64_t, kChordSteps + 1> times_{};  // of pen_
  bool is_down_ = false;
  bool is_stopped_ = true;        // until the next touch
  int free_steps_ = kAgainSteps;  // since the pen was let go
  std::vector<Line> lines_;
  std::optional<GuideTrack> track_;
  StrokeId held_;
  std::uint32_t hold_;
};

}  // namespace felt
