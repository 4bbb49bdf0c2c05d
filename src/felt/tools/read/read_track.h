#pragma once

#include <optional>
#include <vector>

#include "felt/tools/guide_track.h"
#include "felt/tools/read/line_marks.h"
#include "felt/tools/read/read_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// Follows the pen from line to line: which line attracts it, and at which mark it is.
///
/// The line nearest to the pen attracts it. It does so until another line is nearer by kSwitchMm,
/// so that the pen passes crossings straight on unless the hand pushes it to the other line.
/// A deterministic function of the samples and the document. Use it on the edit thread.
class ReadTrack {
 public:
  static constexpr double kSwitchMm = 1.0;
  /// A pen that is nearer to a mark than kArriveMm has arrived; it has left beyond kLeaveMm.
  static constexpr double kArriveMm = 1.0;
  static constexpr double kLeaveMm = 2.0;

  /// Handles a sample of a pen that touches.
  void update(const PenSample& sample, const Scene& scene, const ReadSettings& settings);
  /// Forgets the line.
  void release();

  /// Returns the line that the pen follows; zero if there is none.
  [[nodiscard]] StrokeId stroke() const noexcept { return held_ ? held_->id : StrokeId{}; }
  [[nodiscard]] double length_mm() const noexcept { return held_ ? held_->length_mm : 0.0; }
  /// Returns the nearest point of the nearest line, with its distance from the pen, or nullopt if
  /// no line is within Reading::kFarMm.
  [[nodiscard]] const std::optional<StrokeHit>& nearest() const noexcept { return nearest_; }
  /// Returns the mark at which the pen is, or null.
  [[nodiscard]] const LineMark* mark() const noexcept { return arrived_ ? &*arrived_ : nullptr; }
  /// Returns the groove of the line, or null if it is too short for one.
  [[nodiscard]] const GuideTrack* groove() const noexcept {
    return held_ && held_->groove ? &*held_->groove : nullptr;
  }
  /// Returns the mark that is felt as a notch, or null.
  [[nodiscard]] const LineMark* notch() const noexcept { return notch_ ? &*notch_ : nullptr; }

 private:
  struct Held {
    StrokeId id;
    StrokePtr stroke;
    double length_mm = 0.0;
    std::optional<GuideTrack> groove;
  };

  void look(Point pen, const Scene& scene, const ReadSettings& settings);
  void hold(StrokeId id, const Scene& scene, double strength);
  void look_for_marks(Point pen, const Scene& scene, ReadLayers layers);
  void arrive(Point pen);

  std::optional<StrokeHit> nearest_;
  std::optional<Held> held_;
  std::optional<Point> looked_at_, marked_at_;
  std::vector<LineMark> marks_;
  std::optional<LineMark> arrived_, notch_;
  std::uint32_t number_ = 0;  // of the last groove
};

}  // namespace felt
