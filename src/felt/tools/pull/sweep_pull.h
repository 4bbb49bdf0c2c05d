#pragma once

#include <cstdint>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// A stroke being redrawn (docs/design/editing.md#sweep): in each step the point nearest to the pen
/// moves towards the pen by a fraction of its distance to the pen. edit_weights() determines how
/// far each control point moves so that the nearest point does. Each step starts from the result of
/// the previous step, so moving back does not undo the change. Because the fraction is 1 -
/// exp(-dt/tau), the result hardly depends on the step length.
///
/// The search for the nearest point covers only the segment of the previous nearest point and the
/// neighbours of that segment, so that the point moves along the stroke and does not leap to
/// another part of the stroke that is near the pen. With WeightKind::kPaper and kPrinted this is
/// the loop of the paper (eq. 6 and 7), with its three cases or as printed, repeated in each step.
/// Pieces near the pen are kept short (kPieceMm) as long as the stroke has fewer than kMaxSegments.
/// Handles are kept below kLongestHandle times the length of their segments (R24). Ends and corners
/// stay unless they are themselves nearest to the pen.
class SweepPull {
 public:
  static constexpr double kPieceMm = 8.0;
  static constexpr int kMaxSegments = 300;
  static constexpr double kLongestHandle = 1.5;
  static constexpr double kLeapMm = 1.0;

  /// Grabs the stroke at u0, clamped to the stroke.
  SweepPull(StrokePtr snapshot, double u0, WeightKind weights = WeightKind::kSoft);

  /// Moves the nearest point by the fraction `part`, 0..1, of its distance to the pen. Returns
  /// false if nothing moved.
  bool step(Point pen, double part);
  /// Returns the point that follows the pen.
  [[nodiscard]] Point point() const noexcept;
  [[nodiscard]] StrandPlace place() const noexcept { return place_; }
  /// Returns the point that follows the pen, the normal of the curve there, and whether the point
  /// is an end or a corner.
  [[nodiscard]] CurveNear near() const noexcept;
  /// Returns how often the nearest point has leapt by more than kLeapMm, which happens on a folded
  /// stroke.
  [[nodiscard]] std::uint32_t leaps() const noexcept { return leaps_; }
  [[nodiscard]] Result<Stroke> stroke() const { return strand_.stroke(); }
  /// Returns the final stroke, with its changed segments refitted (refit.h).
  [[nodiscard]] Result<Stroke> finished() const;

 private:
  void track(Point pen);
  void keep_short();

  Strand strand_;
  StrandPlace place_;
  WeightKind weights_;
  std::uint32_t leaps_ = 0;
};

}  // namespace felt
