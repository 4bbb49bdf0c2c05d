#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/guide_choice.h"
#include "felt/tools/guide_shape.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/overlay.h"

namespace felt {

/// A line, circle or ellipse to which a stroke kept, and the positions on it (ShapeNearest::at) of
/// the first and last sample. Those of an ellipse count on beyond pi.
struct ExactPath {
  GuideShape shape;
  double from = 0.0, to = 0.0;
};

/// Holds the pen to one guide of the drawing during a stroke (docs/design/forces.md#guides). The
/// guide is chosen where the pen touches (choose_guide) and stays the same until the pen is lifted,
/// also after the pen has left it. Ink is not moved.
///
///   guide.update(sample, is_down, guides, document);   // every sample
///   if (guide.force()) ...                             // the force near the last sample
///   guide.exact_path()                                 // after the stroke: is it exact?
///
/// A deterministic function of the samples. Use it on the edit thread.
class StrokeGuide {
 public:
  /// A stroke that stays within this distance of a line, circle or ellipse can be made exact.
  static constexpr double kExactMm = 0.5;
  /// A perspective chooses its line after this distance from the touch.
  static constexpr double kChooseMm = 3.0;
  /// The wells of a grid end above the first speed, and are back below the second one.
  static constexpr double kGateMmPerS = 150.0, kOpenMmPerS = 100.0;
  /// First value of GuidePiece::hold. Guides of studies and Retrace have smaller ones.
  static constexpr std::uint32_t kFirstHold = 1U << 31;

  /// Handles a sample. `is_down` is true from the touch until the lift, also in a bounce. `guides`
  /// are the visible guides; `spring` is that of the device (guide_spring_for).
  void update(const PenSample& sample, bool is_down, std::span<const DrawingGuidePtr> guides,
              const Document& document, const GuideSpring& spring);
  /// Lets the pen go until the next touch, for example because the stroke was cancelled.
  void stop() noexcept;

  /// Returns the force near the last sample, or null if no guide holds the pen.
  [[nodiscard]] const Guide* force() const noexcept;
  /// Returns true if there is a force() and the pen is or was so near to the guide that it may be
  /// held: from the capture width on, until it leaves the guide. Rays and nodes are everywhere.
  [[nodiscard]] bool is_near() const noexcept { return force() && is_near_; }
  /// Returns a number that is different for each stroke that has a guide.
  [[nodiscard]] std::uint32_t number() const noexcept { return number_; }
  /// Returns the guide of the stroke, or null. It also stays while the pen is away from the guide.
  [[nodiscard]] const DrawingGuide* guide() const noexcept { return guide_.get(); }
  /// Returns a count of events to be felt as a tick: a perspective chose its line, or the pen came
  /// to another ray or node.
  [[nodiscard]] std::uint64_t ticks() const noexcept { return ticks_; }
  /// Returns the path of the current stroke, or of the last one while the pen is up, if it kept
  /// within kExactMm of one line, circle or ellipse, without turning back.
  [[nodiscard]] std::optional<ExactPath> exact_path() const;

  /// Adds the lines from which a perspective chooses, and the line that the stroke is held to.
  void draw(Overlay& overlay) const;
  /// Adds a spring from the pen to the guide, for users whose device has no force.
  void draw_spring(Overlay& overlay) const;

 private:
  enum class Phase : std::uint8_t { kNone, kChooses, kPath, kRays, kNodes };

  void let_go() noexcept;
  void end_track() noexcept;
  void begin(std::span<const DrawingGuidePtr> guides, const Document& document);
  void hold_to(const GuideShape& shape);
  void hold_to_path(const Document& document);
  void start_track(GuideLine line, const GuideLaw& law);
  void choose_line();
  void follow_rays();
  void follow_nodes(const PenSample& sample);
  void follow_shape();
  void follow_distance();
  [[nodiscard]] std::optional<Point> felt_point() const;

  GuideBounds bounds_;
  DrawingGuidePtr guide_;
  Phase phase_ = Phase::kNone;
  bool is_down_ = false;
  Point touch_, pen_;
  GuideSpring spring_;
  std::optional<GuideTrack> track_;     // kPath
  Guide piece_;                         // kRays, kNodes
  std::vector<GuideStraight> choices_;  // kChooses
  std::optional<int> ray_;
  std::optional<Point> node_;  // in whose well the pen is
  bool is_slow_ = true;
  bool is_near_ = false;
  double gate_ = 1.0;  // 0..1, share of the force that the speed allows
  std::int64_t last_ns_ = 0;
  std::uint32_t number_ = kFirstHold;
  std::uint32_t hold_ = kFirstHold;  // the last one that was used, except those of track_
  std::uint64_t ticks_ = 0;

  // How the stroke keeps to its shape.
  std::optional<GuideShape> shape_;
  bool keeps_ = false;
  double first_at_ = 0.0, last_at_ = 0.0, furthest_ = 0.0;
};

}  // namespace felt
