#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/capabilities.h"
#include "felt/tools/eraser/eraser_options.h"
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
///   guard.update(pen, mode, settings, scene);  // every sample of a gesture
///   guard.is_guarded(id)                       // whether that line keeps its ink
///   guard.force()                              // the force near the last sample, or null
///   guard.end();                               // at the end of the gesture
///
/// A deterministic function of its calls. Use it on the edit thread. An update takes time in
/// proportion to the segments near the eraser; another line near it takes time linear in its
/// length, once.
class GuardRidge {
 public:
  /// The force begins at this distance between the eraser and a line, and is largest when they
  /// touch ...
  static constexpr double kBeforeMm = 1.2;
  /// ... until the eraser covers this much of it; further on the line has been passed.
  static constexpr double kPassedMm = 1.5;
  static constexpr int kMaxPassed = 2;
  /// An eraser with a larger radius is for areas, so nothing pushes it.
  static constexpr double kMaxRadiusMm = 10.0;
  /// Another line must be nearer by this much before it pushes instead.
  static constexpr double kSwitchMm = 0.3;
  /// The first value of GuidePiece::hold. Guides of studies have smaller ones, Retrace greater
  /// ones.
  static constexpr std::uint32_t kFirstHold = 1U << 29;

  /// Handles a sample of a gesture.
  void update(Point pen, EraserMode mode, const EraserSettings& settings, const Scene& scene);
  /// Ends the gesture.
  void end() noexcept;

  /// Returns true if the eraser must not erase the line yet. In the mode kCrossing, which erases
  /// only lines that the path of the pen crosses, lines have a force but keep no ink.
  [[nodiscard]] bool is_guarded(StrokeId id) const noexcept {
    return is_active_ && mode_ != EraserMode::kCrossing && !is_meant(id);
  }
  /// Returns the force near the last sample, or null if no line pushes the pen.
  [[nodiscard]] const Guide* force() const noexcept { return line_ ? &guide_ : nullptr; }
  /// Returns a number that is different each time that a line begins to push the pen.
  [[nodiscard]] std::uint32_t number() const noexcept { return hold_; }
  /// Returns the line that pushes the pen, or nullopt.
  [[nodiscard]] std::optional<StrokeId> line() const noexcept {
    return line_ ? std::optional(line_->id) : std::nullopt;
  }

  /// Adds the line that pushes the pen.
  void draw(Overlay& overlay) const;

  /// Returns the law of the force for an eraser that touches a line when the pen is `touch_mm` from
  /// its centre line.
  static GuideLaw law(double touch_mm, double force_n, const Capabilities& device) noexcept;

 private:
  struct Near {
    StrokeId id;
    double gap_mm = 0.0;  ///< between the eraser and the line; negative if it covers a part
    double touch_mm = 0.0;
  };
  /// The line that pushes the pen, as points at equal distances.
  struct Line {
    StrokeId id;
    StrokePtr stroke;
    std::vector<Point> points;
    double spacing_mm = 0.0;
    bool is_closed = false;
  };

  [[nodiscard]] std::vector<Near> lines_near(Point pen, const EraserSettings& settings,
                                             const Scene& scene) const;
  void pass(const std::vector<Near>& near);
  [[nodiscard]] bool is_meant(StrokeId id) const noexcept;
  void follow(const std::vector<Near>& near, const Scene& scene);
  [[nodiscard]] GuidePiece piece_at(Point pen) const noexcept;

  // Longest distance between two positions of the pen at which lines may be passed.
  static constexpr double kStepMm = 0.5;
  static constexpr int kMaxSteps = 100;

  EraserMode mode_ = EraserMode::kTouched;
  std::vector<StrokeId> meant_;  // ascending
  int passed_ = 0;
  bool is_active_ = false;    // lines other than meant_ are guarded
  std::optional<Point> pen_;  // at the last sample of this gesture
  std::optional<Line> line_;
  Guide guide_;
  std::uint32_t hold_ = kFirstHold;
};

}  // namespace felt
