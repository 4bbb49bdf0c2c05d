#pragma once

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/tools/pull/edit_weights.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// How one segment is bent.
struct GrabOptions {
  WeightKind weights = WeightKind::kSoft;
  /// Whether ends and corners stay where they are unless themselves taken hold of, and give their
  /// part to the handles (architecture section 10).
  bool pins_joints = true;
  /// The stroke is divided round the grab so that no more than this changes, mm; 0 takes the
  /// segments as they are (specification 5c, "optional split at grab": 30).
  double affected_mm = 0.0;
};

/// One segment of a stroke bent so that its point at u0 goes exactly as far as the pen (R21), with
/// G1 kept to its neighbours, which are all that changes besides (specification 5c). Computed from
/// the stroke at the touch and the whole displacement, never from tick to tick (decision 1, R23).
///
/// A closed stroke wraps. One of a single segment is divided at .5 first; in one of two segments
/// the same segment is both neighbours and gets both its ends treated (R26).
class GrabPull {
 public:
  /// Prepares all that does not depend on the displacement. u0 is clamped to the stroke.
  GrabPull(StrokePtr snapshot, double u0, const GrabOptions& options);

  /// The stroke with the point taken hold of displaced by that much, mm; the very snapshot at 0.
  /// Error: the displacement is not finite, or the shape would break an invariant, or nothing that
  /// may move moves the point.
  [[nodiscard]] Result<Stroke> at(Vec displacement) const;
  /// The same with ill-shaped segments fitted anew (refit.h): what is committed.
  [[nodiscard]] Result<Stroke> finished(Vec displacement) const;

  /// The point that was taken hold of, in the snapshot.
  [[nodiscard]] Point origin() const noexcept { return origin_; }
  /// Its place on strokes made by at(), but for the snapshot.
  [[nodiscard]] double u() const noexcept { return place_.segment + place_.t; }
  /// The part of strokes made by at() that may differ from the snapshot; on a closed stroke
  /// last <= first goes through the seam. Joint numbers.
  [[nodiscard]] int first_joint() const noexcept;
  [[nodiscard]] int last_joint() const noexcept;

 private:
  [[nodiscard]] Result<Strand> bent(Vec displacement) const;
  [[nodiscard]] bool moves_left() const noexcept;
  [[nodiscard]] bool moves_right() const noexcept;

  StrokePtr snapshot_;
  Strand strand_;
  StrandPlace place_;
  Point origin_;
  EditWeights weights_;
};

}  // namespace felt
