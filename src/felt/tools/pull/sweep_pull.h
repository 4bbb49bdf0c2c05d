#pragma once

#include <cstdint>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// A stroke that is drawn over again (specification 5c, "Sweep"): in each step what is nearest to
/// the pen goes a part of the way there, by the weights of least motion. Incremental, hence not
/// undone by moving back; but since the part is 1 - exp(-dt/tau) of the way, the result hardly
/// depends on the length of the steps.
///
/// What is nearest is looked for only next to where it was, so that it wanders along the stroke
/// and does not leap to where the stroke comes near itself. Pieces near the pen are kept short
/// (kPieceMm), within kMostSegments; handles are kept below kLongestHandle of their segments
/// (R24). Ends and corners stay unless they are nearest themselves.
class SweepPull {
 public:
  static constexpr double kPieceMm = 8.0;
  static constexpr int kMostSegments = 300;
  static constexpr double kLongestHandle = 1.5;
  static constexpr double kLeapMm = 1.0;

  /// Takes hold at u0, clamped to the stroke.
  SweepPull(StrokePtr snapshot, double u0);

  /// The pen is at `pen` now; `part` of the way to it is gone, 0..1. False when nothing moved.
  bool step(Point pen, double part);
  /// The point that follows the pen.
  [[nodiscard]] Point point() const noexcept;
  [[nodiscard]] StrandPlace place() const noexcept { return place_; }
  /// Where that point is on the curve: its normal, whether it is an end or a corner.
  [[nodiscard]] CurveNear near() const noexcept;
  /// How often what is nearest has leapt by more than kLeapMm, where the stroke is folded.
  [[nodiscard]] std::uint32_t leaps() const noexcept { return leaps_; }
  [[nodiscard]] Result<Stroke> stroke() const { return strand_.stroke(); }
  /// With what changed in good shape (refit.h), for the end.
  [[nodiscard]] Result<Stroke> finished() const;

 private:
  void track(Point pen);
  void keep_short();

  Strand strand_;
  StrandPlace place_;
  std::uint32_t leaps_ = 0;
};

}  // namespace felt
