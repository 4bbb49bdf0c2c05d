#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/overlay.h"
#include "felt/tools/scene.h"

namespace felt {

/// Keeps the eraser away from lines that it was not meant to erase (docs/design/forces.md#guard).
/// The lines under the eraser at its first ink are meant. All others are guarded: they keep their
/// ink, and the nearest one pushes the pen away, from before the eraser touches it. A pen that
/// pushes on passes that line, which then counts as meant. After kMaxPassed lines, the user is
/// clearing an area, and nothing is guarded until the next gesture. Only a device with forces has
/// guarded lines.
///
///   guard.update(sample, mode, settings, scene);  // every sample of a gesture
///   guard.is_guarded(id)                          // whether that line keeps its ink
///   guard.force()                                 // the force near the last sample, or null
///   guard.end();                                  // at the end of the gesture
///
/// A deterministic function of its calls. Use it on the edit thread. An update takes time in
/// proportion to the segments near the eraser, of which there are at most kMaxSegments. When
/// another line becomes the nearest one, it takes time linear in the length of that line. A very
/// long line pushes only along the part that stroke_path() returns.
class GuardRidge {
 public:
  /// The force begins at this distance between the eraser and a line, and is largest when they
  /// touch ...
  static constexpr double kBeforeMm = 1.2;
  /// ... until the eraser covers this much of it, or kPassedShare of the way to its centre line if
  /// that is less; further on the line has been passed.
  static constexpr double kPassedMm = 1.5, kPassedShare = 0.6;
  static constexpr int kMaxPassed = 2;
  /// An eraser with a larger radius, or in denser ink, is for areas, so nothing is guarded.
  static constexpr double kMaxRadiusMm = 10.0;
  static constexpr std::size_t kMaxSegments = 1'000;
  /// Another line must be nearer by this much before it pushes instead.
  static constexpr double kSwitchMm = 0.3;
  /// The first value of GuidePiece::hold (GuideTrack).
  static constexpr std::uint32_t kFirstHold = 1U << 29;

  /// Handles a sample of a gesture. `mode` is the mode in which the gesture erases now.
  void update(const PenSample& sample, EraserMode mode, const EraserSettings& settings,
              const Scene& scene);
  /// Ends the gesture.
  void end() noexcept;

  /// Returns true if the eraser must not erase the line yet. In the mode kCrossing, which erases
  /// only lines that the path of the pen crosses, lines have a force but keep no ink.
  [[nodiscard]] bool is_guarded(StrokeId id) const noexcept {
    return is_active_ && mode_ != EraserMode::kCrossing && !is_meant(id);
  }
  /// Returns the force near the last sample, or null if no line pushes the pen.
  [[nodiscard]] const Guide* force() const noexcept { return track_ ? &track_->guide() : nullptr; }
  /// Returns a number that is different each time that a line begins to push the pen.
  [[nodiscard]] std::uint32_t number() const noexcept { return track_ ? track_->number() : hold_; }
  /// Returns the line that pushes the pen, or nullopt.
  [[nodiscard]] std::optional<StrokeId> line() const noexcept {
    return track_ ? std::optional(id_) : std::nullopt;
  }
  /// Adds the line that pushes the pen.
  void draw(Overlay& overlay) const;

  /// Returns the law of the force for an eraser that touches a line when the pen is `touch_mm` from
  /// its centre line.
  static GuideLaw law(double touch_mm, double force_n, const Capabilities& device) noexcept;

 private:
  /// A part of a line near the path of the pen.
  struct Part {
    StrokeId id;
    StrokePtr stroke;
    int segment = 0;
  };
  struct Near {
    StrokeId id;
    StrokePtr stroke;
    double gap_mm = 0.0;    ///< between the eraser and the line; negative if it covers a part
    double touch_mm = 0.0;  ///< distance from the centre line at which they touch
  };

  [[nodiscard]] bool collect(Point from, Point to, const EraserSettings& settings,
                             const Scene& scene);
  void look(Point pen, const EraserSettings& settings);
  void pass();
  [[nodiscard]] bool is_meant(StrokeId id) const noexcept;
  [[nodiscard]] bool erases_by_path() const noexcept {
    // After the touch, this mode acts on the lines that the path of the pen crosses.
    return mode_ == EraserMode::kCrossing && !meant_.empty();
  }
  [[nodiscard]] const Near* choose() const noexcept;
  void push(const Near& line, const PenSample& sample, double force_n, const Capabilities& device);
  void let_go() noexcept;

  EraserMode mode_ = EraserMode::kTouched;
  std::vector<StrokeId> meant_;  // ascending
  int passed_ = 0;
  bool is_active_ = false;    // lines other than meant_ are guarded
  std::optional<Point> pen_;  // at the last sample of this gesture
  std::vector<Part> parts_;   // near the path of the pen since the last sample
  std::vector<Near> near_;    // lines near the pen, by ascending id
  StrokeId id_;               // the line that pushes the pen,
  StrokePtr stroke_;
  std::optional<GuideTrack> track_;  // and its force
  std::uint32_t hold_ = kFirstHold;  // last number
};

}  // namespace felt
