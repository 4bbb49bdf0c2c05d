#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/pull/edit_weights.h"

namespace felt {

/// A place on a strand: t in [0, 1] on a segment.
struct StrandPlace {
  int segment = 0;
  double t = 0.0;
};

/// A stroke while it is being bent: control points that may be moved and segments that may be
/// divided, without checking and copying the whole stroke for each step. What grab, push and sweep
/// share. A value.
///
/// Smooth joints stay smooth: `bend` turns the neighbours' handles (specification 5c, "G1 after
/// moving"). A handle of zero length at a smooth joint gets a length of its own, kStandingMm,
/// before anything beside it moves: its direction would otherwise be that of a control point
/// elsewhere (R28).
class Strand {
 public:
  static constexpr double kStandingMm = 1e-3;
  /// Handles shorter than this are none (specification 5c).
  static constexpr double kNoHandleMm = 1e-6;

  /// A closed stroke of one segment is divided at .5, if it is long enough (specification 5c).
  explicit Strand(StrokePtr snapshot);

  /// Number of segments; at least 1.
  [[nodiscard]] int count() const noexcept { return static_cast<int>(points_.size() / 3); }
  [[nodiscard]] bool closed() const noexcept { return snapshot_->closed(); }
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// The joint before segment i; i = count() is the end of the stroke.
  [[nodiscard]] JointKind joint(int i) const noexcept;
  /// The segment before or after, round a closed stroke; -1 past an end.
  [[nodiscard]] int previous(int i) const noexcept;
  [[nodiscard]] int next(int i) const noexcept;
  /// 3 count() + 1 control points, as StrokeData::points.
  [[nodiscard]] std::span<const Point> points() const noexcept { return points_; }

  /// The stroke that it was made of.
  [[nodiscard]] const StrokePtr& snapshot() const noexcept { return snapshot_; }
  /// The place in the snapshot that joint i comes from.
  [[nodiscard]] double snapshot_u(int joint) const noexcept {
    return origins_[static_cast<std::size_t>(joint)];
  }
  /// The place that comes from a place in the snapshot; of a joint, the segment after it.
  [[nodiscard]] StrandPlace locate(double snapshot_u) const noexcept;

  /// Divides segment i at t by a smooth joint into segments i and i + 1, which trace the same
  /// curve. False, and nothing happens, where one would be shorter than I5 allows or t is a cusp.
  bool divide(int i, double t);
  /// Divides segment i into pieces of the same arc length, as few as are at most so long, but no
  /// more than `most`. Returns their number.
  int divide_evenly(int i, double longest_mm, int most);
  /// Gives standing handles at the smooth joints of segment i and its neighbours a length.
  void prepare(int i);
  /// What may move when segment i is pulled at t: pinned ends and corners give way only near
  /// themselves, standing handles at smooth joints do not turn.
  [[nodiscard]] Compliance compliance(int i, double t, bool pins_joints) const noexcept;
  /// B_i' = B_i + w_i V for segment i; its neighbours' handles go with the joints and, where these
  /// are smooth, keep their lengths and turn into line. Requires prepare(i). The point at t moves
  /// by gain(t) V, exactly up to rounding. False, and nothing happens, where a segment would be
  /// shorter than I5 allows or not be finite.
  bool bend(int i, double t, const EditWeights& weights, Vec pull);
  /// Moves the control points of segments [first, first + (n - 1) / 3), n = weights.size(), round a
  /// closed stroke, each by its weight times the pull. What keeps joints smooth is the weights'
  /// affair. False, and nothing happens, where a segment would be shorter than I5 allows or not be
  /// finite. Of a closed stroke that is moved all round the last weight is not needed: it is the
  /// first again.
  bool shift(int first, std::span<const double> weights, Vec pull);
  /// Shortens handles of segment i that are longer than `longest` times its arc length; directions
  /// stay.
  void limit_handles(int i, double longest) noexcept;

  /// True when segment i may differ from the snapshot, be it only in where it begins and ends.
  [[nodiscard]] bool is_changed(int i) const noexcept {
    return changed_[static_cast<std::size_t>(i)] != 0;
  }
  /// The stroke as it is now. Error: an invariant is broken.
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
  std::vector<JointKind> joints_;  // joint k + 1 at k
  std::vector<WidthKnot> widths_;
  std::vector<double> origins_;        // count() + 1
  std::vector<std::uint8_t> changed_;  // by segment
};

}  // namespace felt
