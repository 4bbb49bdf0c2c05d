#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/pull/edit_weights.h"

namespace felt {

/// A position on a strand: t in [0, 1] on a segment.
struct StrandPlace {
  int segment = 0;
  double t = 0.0;
};

/// A mutable stroke: control points can be moved and segments divided without checking and copying
/// the whole stroke at each step. The modes grab, push and sweep use it. A value type.
///
/// Smooth joints stay smooth: `bend` turns the neighbours' handles
/// (docs/design/editing.md#smooth-joints). A zero-length handle at a smooth joint gets the length
/// kStandingMm before anything next to it moves. Otherwise the direction of this handle would
/// depend on a control point elsewhere (R28).
class Strand {
 public:
  static constexpr double kStandingMm = 1e-3;
  /// Handles shorter than kNoHandleMm count as zero (docs/design/editing.md#smooth-joints).
  static constexpr double kNoHandleMm = 1e-6;

  /// Copies the snapshot. A closed stroke of one segment is divided at .5 if it is long enough
  /// (docs/design/editing.md#smooth-joints).
  explicit Strand(StrokePtr snapshot);

  /// Number of segments; at least 1.
  [[nodiscard]] int count() const noexcept { return static_cast<int>(points_.size() / 3); }
  [[nodiscard]] bool closed() const noexcept { return snapshot_->closed(); }
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// Returns the joint before segment i; i = count() is the end of the stroke.
  [[nodiscard]] JointKind joint(int i) const noexcept;
  /// Return the number of the segment before or after segment i, wrapping around on a closed
  /// stroke; -1 past an end.
  [[nodiscard]] int previous(int i) const noexcept;
  [[nodiscard]] int next(int i) const noexcept;
  /// Returns 3 count() + 1 control points, as in StrokeData::points.
  [[nodiscard]] std::span<const Point> points() const noexcept { return points_; }

  /// Returns the stroke that the strand was made from.
  [[nodiscard]] const StrokePtr& snapshot() const noexcept { return snapshot_; }
  /// Returns the parameter of a joint in the snapshot.
  [[nodiscard]] double snapshot_u(int joint) const noexcept {
    return origins_[static_cast<std::size_t>(joint)];
  }
  /// Returns the position that corresponds to a parameter of the snapshot. For an inner joint it is
  /// t = 0 of the segment after the joint.
  [[nodiscard]] StrandPlace locate(double snapshot_u) const noexcept;

  /// Divides segment i at t with a smooth joint into segments i and i + 1, which trace the same
  /// curve. Returns false without a change if one of them would be shorter than I5 allows or the
  /// curve has a cusp at t.
  bool divide(int i, double t);
  /// Divides segment i into as few pieces of equal arc length as possible, each at most
  /// `longest_mm` long. If that would take more than `max_pieces` pieces, divides it into
  /// `max_pieces` longer pieces. Returns the number of pieces.
  int divide_evenly(int i, double longest_mm, int max_pieces);
  /// Gives a length (kStandingMm) to zero-length handles at the smooth joints of segment i and its
  /// neighbours.
  void prepare(int i);
  /// Returns how freely the parts of segment i may move if it is pulled at t. Pinned ends and
  /// corners may move only if t is near them; zero-length handles at smooth joints do not turn.
  [[nodiscard]] Compliance compliance(int i, double t, bool pins_joints) const noexcept;
  /// Bends segment i: B_i' = B_i + w_i V. The neighbours' handles move with the joints; at smooth
  /// joints they keep their lengths and turn to stay collinear. Requires an earlier prepare(i). The
  /// point at t moves by gain(t) V, up to rounding. Returns false without a change if a segment
  /// would be shorter than I5 allows or not finite.
  bool bend(int i, double t, const EditWeights& weights, Vec pull);
  /// Moves the control points of segments [first, first + (n - 1) / 3), n = weights.size(),
  /// wrapping around on a closed stroke, each by its weight times the pull. The weights must keep
  /// joints smooth. Returns false without a change if a segment would be shorter than I5 allows or
  /// not finite. If the whole of a closed stroke is moved, the last weight is unused, because the
  /// last control point is the first one again.
  bool shift(int first, std::span<const double> weights, Vec pull);
  /// Shortens handles of segment i that are longer than `longest` times its arc length. Keeps their
  /// directions.
  void limit_handles(int i, double longest) noexcept;

  /// Returns true if segment i may have a different shape than in the snapshot, or is a piece of a
  /// segment that was divided.
  [[nodiscard]] bool is_changed(int i) const noexcept {
    return changed_[static_cast<std::size_t>(i)] != 0;
  }
  /// Returns the current stroke. Fails if it breaks an invariant.
  [[nodiscard]] Result<Stroke> stroke() const;

 private:
  void stand_up(int i);
  void set_segment(int i, const Cubic& c) noexcept;
  void shift_with_neighbours(int i, const EditWeights& weights, Vec pull);
  [[nodiscard]] bool is_sound(int i) const noexcept;
  bool drop_tiny_handles(int i) noexcept;
  void keep_collinear(int i) noexcept;
  void carry_widths();

  StrokePtr snapshot_;
  std::vector<Point> points_;
  std::vector<JointKind> joints_;  // joint k + 1 at index k
  std::vector<WidthKnot> widths_;
  std::vector<double> origins_;        // snapshot_u() of the count() + 1 joints
  std::vector<std::uint8_t> changed_;  // by segment
};

}  // namespace felt
