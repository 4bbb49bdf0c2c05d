#pragma once

#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/pull/edit_weights.h"

namespace felt {

/// A stroke while it is being bent: control points that may be moved and segments that may be
/// divided, without checking and copying the whole stroke for each step. What grab, push and sweep
/// share. Values; cheap to copy for strokes of some hundred segments.
///
/// Smooth joints stay smooth: `bend` turns the neighbours' handles (specification 5c, "G1 after
/// moving"). A handle of zero length at a smooth joint gets a length of its own, kStandingMm, the
/// first time that something beside it moves, since its direction would otherwise be that of a
/// control point elsewhere (R28).
class Strand {
 public:
  static constexpr double kStandingMm = 1e-3;
  /// Handles shorter than this are none (specification 5c).
  static constexpr double kNoHandleMm = 1e-6;

  explicit Strand(StrokePtr snapshot);

  [[nodiscard]] int count() const noexcept { return static_cast<int>(points_.size() / 3); }
  [[nodiscard]] bool closed() const noexcept { return snapshot_->closed(); }
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// The joint before segment i; i = count() is the end of the stroke.
  [[nodiscard]] JointKind joint(int i) const noexcept;
  /// The segment before or after, round a closed stroke; -1 past an end.
  [[nodiscard]] int previous(int i) const noexcept;
  [[nodiscard]] int next(int i) const noexcept;
  /// The stroke at the touch.
  [[nodiscard]] const StrokePtr& snapshot() const noexcept { return snapshot_; }
  /// Place in the snapshot that joint i came from.
  [[nodiscard]] double snapshot_u(int joint) const noexcept {
    return origins_[static_cast<std::size_t>(joint)];
  }

  /// Divides segment i at t by a smooth joint: two segments i and i + 1, the same curve. False,
  /// and nothing happens, where one of them would be shorter than I5 allows.
  bool divide(int i, double t);
  /// Gives standing handles beside segment i their own length.
  void prepare(int i);
  /// What may move when segment i is pulled at t: pinned ends and corners give way only near
  /// themselves, standing handles at smooth joints do not turn. Requires prepare(i).
  [[nodiscard]] Compliance compliance(int i, double t, bool pins_joints) const noexcept;
  /// B_i' = B_i + w_i V for segment i, the neighbours' handles with the joints, turned where these
  /// are smooth. Requires prepare(i).
  void bend(int i, double t, const EditWeights& weights, Vec pull);
  /// Shortens the handles of segment i to that part of its arc length; directions stay.
  void limit_handles(int i, double longest);

  /// The stroke as it is now. Error: an invariant is broken.
  [[nodiscard]] Result<Stroke> stroke() const;

 private:
  [[nodiscard]] std::vector<WidthKnot> widths() const;
  void stand_up(int i);
  void follow_left(int i, Vec shift);
  void follow_right(int i, Vec shift);
  void keep_collinear(int i);

  StrokePtr snapshot_;
  std::vector<Point> points_;
  std::vector<JointKind> joints_;  // joint k + 1 at k
  std::vector<double> origins_;    // u in the snapshot of each joint, count() + 1
};

}  // namespace felt
