#include "tests/support/fit_checker.h"

#include <deque>
#include <limits>
#include <optional>
#include <unordered_map>

#include "tests/support/fit_curve_pieces.h"
#include "tests/support/fit_ink_polyline.h"

namespace fit_check {
namespace {

constexpr double kKinkDeg = 60.0;
constexpr double kKinkArcInTolerances = 0.25;
constexpr double kJoinedMm = 1e-9;
/// Two computations of the same distance may differ by kRoundingMm because of rounding.
constexpr double kRoundingMm = 1e-9;

bool is_corner(const FitCurve& curve, std::size_t joint) {
  return joint < curve.corners.size() && curve.corners[joint];
}

bool is_valid(const Ink& ink, const FitCurve& curve) {
  return !ink.samples.empty() && !curve.segments.empty() &&
         std::ranges::all_of(curve.segments,
                             [](const Segment& b) { return std::ranges::all_of(b, is_finite); });
}

/// Returns the direction at the start of the segment, or zero if all its points are equal.
Point start_direction(const Segment& b) {
  for (std::size_t i = 1; i < 4; ++i) {
    if (!(b[i] == b[0])) return b[i] - b[0];
  }
  return {};
}

/// Returns the direction at the end of the segment, or zero if all its points are equal.
Point end_direction(const Segment& b) {
  for (std::size_t i = 3; i-- > 0;) {
    if (!(b[i] == b[3])) return b[3] - b[i];
  }
  return {};
}

void measure_error(const Ink& ink, const CurvePieces& pieces, double tolerance, Report& report) {
  std::size_t hint = 0;
  for (const Point& sample : ink.samples) {
    const double error = pieces.distance(sample, hint);
    report.error_sum += error;
    report.max_error = std::max(report.max_error, error);
  }
  if (report.max_error > tolerance + kRoundingMm) report.over_tolerance = 1;
}

void judge_joint(double turn, bool corner, Report& report) {
  if (corner) {
    if (turn < 5.0) ++report.corners_bend_less;
    return;
  }
  report.max_smooth_turn_deg = std::max(report.max_smooth_turn_deg, turn);
  for (std::size_t k = 0; k < kBreakDeg.size(); ++k) {
    if (turn > kBreakDeg[k]) ++report.breaks[k];
  }
}

/// Measures the gaps and the tangent turns at the joints. A segment that is a single point has no
/// direction. It is skipped, and its two joints count as one joint, which is a corner if either of
/// them is declared a corner.
void measure_joints(const FitCurve& curve, Report& report) {
  const std::size_t n = curve.segments.size();
  Point incoming{};
  bool corner = false;
  for (std::size_t i = 0; i < (curve.closed ? n + 1 : n); ++i) {
    const Segment& b = curve.segments[i % n];
    if (i > 0) {
      corner = corner || is_corner(curve, i - 1);
      report.max_gap = std::max(report.max_gap, length(b[0] - curve.segments[i - 1][3]));
    }
    const Point outgoing = start_direction(b);
    if (outgoing == Point{}) {
      if (i < n) ++report.degenerate_segments;
      continue;
    }
    if (!(incoming == Point{})) judge_joint(turn_deg(incoming, outgoing), corner, report);
    incoming = end_direction(b);
    corner = false;
  }
}

/// Counts kinks: slides a window with an arc length of a quarter tolerance along the pieces and
/// counts the positions at which the curve turns by more than kKinkDeg within the window. Positions
/// closer together than the window count as one. The window is emptied at declared corners.
void measure_kinks(const FitCurve& curve, const CurvePieces& pieces, double tolerance,
                   Report& report) {
  struct Bend {
    double arc;
    double degrees;
  };
  const double reach = kKinkArcInTolerances * tolerance;
  std::deque<Bend> window;
  double arc = 0.0, inside = 0.0, last_kink = -2.0 * reach;
  const Piece* last = nullptr;
  for (const Piece& piece : pieces.pieces()) {
    if (piece.a == piece.b) continue;
    if (last && last->segment != piece.segment && is_corner(curve, piece.segment - 1)) {
      window.clear();
      inside = 0.0;
    } else if (last) {
      window.push_back({arc, turn_deg(last->b - last->a, piece.b - piece.a)});
      inside += window.back().degrees;
    }
    for (; !window.empty() && window.front().arc < arc - reach; window.pop_front()) {
      inside -= window.front().degrees;
    }
    if (inside > kKinkDeg) {
      if (arc - last_kink > reach) ++report.kinks;
      last_kink = arc;
    }
    arc += length(piece.b - piece.a);
    last = &piece;
  }
}

/// Computes by how much the distance from a point of the curve to the ink exceeds the sample gap.
/// The gap is the length of the nearest line of the ink. The nearest line may belong to another
/// part of the ink that merely passes by. Therefore each line is also tried if both its ends are
/// close to the same segment of the curve or a neighbour; the smallest excess counts.
class OvershootExcess {
 public:
  OvershootExcess(const FitCurve& curve, const InkPolyline& ink, double tolerance)
      : curve_(curve), ink_(ink), tolerance_(tolerance) {}

  [[nodiscard]] double at(Point p, std::size_t segment, const InkPolyline::Nearest& nearest) {
    double smallest = nearest.distance - nearest.gap;
    if (smallest <= kOvershootInTolerances * tolerance_) return smallest;
    const std::vector<Point>& v = ink_.vertices();
    for (const std::size_t i : ink_.edges_by_length()) {
      const double gap = length(v[i + 1] - v[i]);
      // The other lines are shorter and not nearer, so none of them has a smaller excess.
      if (nearest.distance - gap >= smallest) break;
      const double excess = distance_to_line(v[i], v[i + 1], p) - gap;
      if (excess < smallest && is_local(v[i], segment) && is_local(v[i + 1], segment))
        smallest = excess;
    }
    return smallest;
  }

 private:
  /// Returns true if p lies within one tolerance of the segment or a neighbour.
  bool is_local(Point p, std::size_t segment) {
    if (!pieces_ || segment != segment_) {
      const std::size_t first = segment > 0 ? segment - 1 : 0;
      const std::size_t last = std::min(segment + 2, curve_.segments.size());
      const auto begin = curve_.segments.begin();
      segments_.assign(begin + static_cast<std::ptrdiff_t>(first),
                       begin + static_cast<std::ptrdiff_t>(last));
      pieces_.emplace(segments_, tolerance_);
      segment_ = segment;
    }
    std::size_t hint = 0;
    return pieces_->distance(p, hint) <= tolerance_ + kRoundingMm;
  }

  const FitCurve& curve_;
  const InkPolyline& ink_;
  double tolerance_;
  std::size_t segment_ = 0;
  std::vector<Segment> segments_;
  std::optional<CurvePieces> pieces_;  // pieces of segments_
};

void measure_overshoot(const FitCurve& curve, const InkPolyline& ink, const CurvePieces& pieces,
                       double tolerance, Report& report) {
  double overshoot = 0.0;
  std::size_t hint = 0;
  OvershootExcess excess(curve, ink, tolerance);
  const auto measure = [&](Point p, std::size_t segment) {
    const InkPolyline::Nearest nearest = ink.nearest(p, hint);
    overshoot = std::max(overshoot, nearest.distance);
    report.overshoot_excess =
        std::max(report.overshoot_excess,
                 excess.at(p, segment, nearest) - kOvershootInTolerances * tolerance);
  };
  for (const Piece& piece : pieces.pieces()) measure(piece.a, piece.segment);
  measure(pieces.pieces().back().b, pieces.pieces().back().segment);
  report.overshoots.push_back(overshoot);
  if (report.overshoot_excess > kRoundingMm) report.overshoot_violations = 1;
}

void audit_corner(const InkPolyline& ink, Point place, double tolerance, Report& report) {
  ++report.corners;
  for (std::size_t arm = 0; arm < kArmInTolerances.size(); ++arm) {
    const InkPolyline::Turn turn = ink.turn_near(place, kCornerReachInTolerances * tolerance,
                                                 kArmInTolerances[arm] * tolerance);
    for (std::size_t limit = 0; limit < kCornerDeg.size(); ++limit) {
      if (turn.degrees < kCornerDeg[limit]) ++report.weak_corners[arm][limit];
    }
    if (arm == 1 && turn.short_arm) ++report.corners_near_end;
  }
}

void audit_corners(const InkPolyline& ink, const FitCurve& curve, double tolerance,
                   Report& report) {
  for (std::size_t joint = 0; joint < curve.segments.size(); ++joint) {
    if (is_corner(curve, joint)) audit_corner(ink, curve.segments[joint][3], tolerance, report);
  }
}

}  // namespace

Report check_stroke(const Ink& ink, const FitCurve& curve, double tolerance) {
  Report report;
  report.strokes = 1;
  report.samples = static_cast<std::int64_t>(ink.samples.size());
  report.segments = static_cast<std::int64_t>(curve.segments.size());
  report.worst_id = report.most_broken_id = report.overshoot_id = report.excess_id = ink.id;
  if (!is_valid(ink, curve)) {
    report.invalid = 1;
    report.over_tolerance = 1;
    report.max_error = std::numeric_limits<double>::infinity();
    report.overshoots.push_back(0.0);
    return report;
  }
  const CurvePieces pieces(curve.segments, tolerance);
  const InkPolyline polyline(ink.samples);
  measure_error(ink, pieces, tolerance, report);
  measure_joints(curve, report);
  measure_kinks(curve, pieces, tolerance, report);
  measure_overshoot(curve, polyline, pieces, tolerance, report);
  audit_corners(polyline, curve, tolerance, report);
  return report;
}

void Report::add(const Report& other) {
  const auto raise = [](double& mine, std::string& id, double theirs, const std::string& their_id) {
    if (theirs > mine || id.empty()) id = their_id;
    mine = std::max(mine, theirs);
  };
  double overshoot = max_overshoot();
  raise(overshoot, overshoot_id, other.max_overshoot(), other.overshoot_id);
  raise(max_error, worst_id, other.max_error, other.worst_id);
  raise(max_smooth_turn_deg, most_broken_id, other.max_smooth_turn_deg, other.most_broken_id);
  raise(overshoot_excess, excess_id, other.overshoot_excess, other.excess_id);
  strokes += other.strokes;
  samples += other.samples;
  segments += other.segments;
  error_sum += other.error_sum;
  over_tolerance += other.over_tolerance;
  invalid += other.invalid;
  missing += other.missing;
  degenerate_segments += other.degenerate_segments;
  max_gap = std::max(max_gap, other.max_gap);
  kinks += other.kinks;
  overshoot_violations += other.overshoot_violations;
  corners += other.corners;
  corners_near_end += other.corners_near_end;
  corners_bend_less += other.corners_bend_less;
  for (std::size_t k = 0; k < breaks.size(); ++k) breaks[k] += other.breaks[k];
  for (std::size_t arm = 0; arm < weak_corners.size(); ++arm) {
    for (std::size_t limit = 0; limit < kCornerDeg.size(); ++limit) {
      weak_corners[arm][limit] += other.weak_corners[arm][limit];
    }
  }
  overshoots.insert(overshoots.end(), other.overshoots.begin(), other.overshoots.end());
}

double Report::mean_error() const {
  return samples > 0 ? error_sum / static_cast<double>(samples) : 0.0;
}

double Report::max_overshoot() const {
  return overshoots.empty() ? 0.0 : *std::max_element(overshoots.begin(), overshoots.end());
}

double Report::overshoot_quantile(double fraction) const {
  if (overshoots.empty()) return 0.0;
  std::vector<double> sorted = overshoots;
  std::sort(sorted.begin(), sorted.end());
  const double rank = std::ceil(fraction * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(0.0, rank))];
}

bool Report::clean() const {
  return invalid == 0 && missing == 0 && over_tolerance == 0 && breaks[0] == 0 &&
         overshoot_violations == 0 && max_gap <= kJoinedMm;
}

Report check_all(const std::vector<Ink>& inks, const std::vector<FitCurve>& curves,
                 double tolerance, std::map<std::string, Report>* by_source) {
  const bool by_order =
      std::all_of(curves.begin(), curves.end(), [](const FitCurve& c) { return c.id.empty(); });
  std::unordered_map<std::string, const FitCurve*> by_id;
  for (const FitCurve& curve : curves) by_id.emplace(curve.id, &curve);
  Report total;
  for (std::size_t i = 0; i < inks.size(); ++i) {
    const FitCurve* curve = nullptr;
    if (by_order) {
      if (i < curves.size()) curve = &curves[i];
    } else if (const auto found = by_id.find(inks[i].id); found != by_id.end()) {
      curve = found->second;
    }
    Report report;
    if (curve) {
      report = check_stroke(inks[i], *curve, tolerance);
    } else {
      report.missing = 1;
    }
    total.add(report);
    if (by_source) (*by_source)[inks[i].source].add(report);
  }
  return total;
}

}  // namespace fit_check
