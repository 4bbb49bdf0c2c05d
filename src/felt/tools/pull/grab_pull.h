#pragma once

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/tools/pull/edit_weights.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// Options of the grab mode.
struct GrabOptions {
  WeightKind weights = WeightKind::kSoft;
  /// Whether ends and corners stay in place unless they are grabbed themselves. If they stay, the
  /// handles move more instead (docs/design/editing.md#pull-weights).
  bool pins_joints = true;
  /// Maximum length of the part of the stroke that changes, mm. If positive, the stroke is divided
  /// around the grabbed point first; 30 is a useful value (docs/design/editing.md#grab).
  double affected_mm = 0.0;
};

/// Bends one segment of a stroke so that its point at u0 moves exactly as far as the pen (R21). The
/// neighbouring segments stay G1-continuous with it; nothing else changes
/// (docs/design/editing.md#smooth-joints). The result depends only on the total displacement and on
/// the stroke at the start of the gesture, not on the samples in between
/// (docs/design/editing.md#snapshot, R23).
///
/// Closed strokes wrap around. A closed stroke of one segment is divided at .5 first. In a closed
/// stroke of two segments, the other segment is the neighbour on both sides, so both its ends are
/// adapted (R26).
class GrabPull {
 public:
  /// Prepares everything that does not depend on the displacement. u0 is clamped to the stroke.
  GrabPull(StrokePtr snapshot, double u0, const GrabOptions& options);

  /// Returns the stroke with the grabbed point displaced by this vector, in mm, or exactly the
  /// snapshot for 0. Fails if the displacement is not finite, if the shape would break an
  /// invariant, or if no control point that may move has an effect on the grabbed point.
  [[nodiscard]] Result<Stroke> at(Vec displacement) const;
  /// Returns the stroke to commit: the same stroke with badly shaped segments refitted (refit.h).
  [[nodiscard]] Result<Stroke> finished(Vec displacement) const;

  /// Returns the grabbed point, in the snapshot.
  [[nodiscard]] Point origin() const noexcept { return origin_; }
  /// Returns the parameter of the grabbed point on strokes made by at(), which may differ from its
  /// parameter in the snapshot.
  [[nodiscard]] double u() const noexcept { return place_.segment + place_.t; }
  /// Return the part of strokes made by at() that may differ from the snapshot, as joint numbers.
  /// On a closed stroke, last <= first means that the part crosses the seam.
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
