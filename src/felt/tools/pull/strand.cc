#include "felt/tools/pull/strand.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// A handle shorter than this moves less, the shorter it is, because it would turn too fast.
constexpr double kFreeHandleMm = 0.1;

/// Minimum length of divided segments. It is slightly above the minimum of I5, to allow for
/// rounding.
constexpr double kMinStrandSegmentMm = 1.001 * kMinSegmentMm;

double handle_compliance(double length_mm, JointKind joint) noexcept {
  return joint == JointKind::kSmooth ? std::min(1.0, length_mm / kFreeHandleMm) : 1.0;
}

}  // namespace

Strand::Strand(StrokePtr snapshot)
    : snapshot_(std::move(snapshot)),
      points_(snapshot_->data().points),
      joints_(snapshot_->data().joints),
      widths_(snapshot_->data().widths),
      changed_(static_cast<std::size_t>(snapshot_->segment_count()), 0) {
  for (int i = 0; i <= count(); ++i) origins_.push_back(i);
  if (closed() && count() == 1) divide(0, 0.5);
}

Cubic Strand::segment(int i) const noexcept {
  const Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>(i);
  return Cubic{{p[0], p[1], p[2], p[3]}};
}

JointKind Strand::joint(int i) const noexcept {
  if (i <= 0 || i >= count()) return closed() ? joints_.back() : JointKind::kEnd;
  return joints_[static_cast<std::size_t>(i - 1)];
}

int Strand::previous(int i) const noexcept {
  return i > 0 ? i - 1 : (closed() ? count() - 1 : -1);
}

int Strand::next(int i) const noexcept {
  return i + 1 < count() ? i + 1 : (closed() ? 0 : -1);
}

StrandPlace Strand::locate(double snapshot_u) const noexcept {
  const auto after = std::upper_bound(origins_.begin() + 1, origins_.end() - 1, snapshot_u);
  const auto i = static_cast<int>(after - origins_.begin()) - 1;
  const double from = origins_[static_cast<std::size_t>(i)];
  const double to = *after;
  return {i, std::clamp((snapshot_u - from) / (to - from), 0.0, 1.0)};
}

bool Strand::divide(int i, double t) {
  const Cubic whole = segment(i);
  auto [a, b] = split(whole, t);
  // Restores zero-length handles, because rounding would give them an arbitrary direction (I2).
  if (whole.p[1] == whole.p[0]) a.p[1] = a.p[0];
  if (whole.p[2] == whole.p[3]) b.p[2] = b.p[3];
  const double shortest = std::min(control_length(a), control_length(b));
  const double handle = std::min(distance(a.p[2], a.p[3]), distance(b.p[0], b.p[1]));
  if (!(shortest >= kMinStrandSegmentMm && handle >= kStandingMm))
    return false;  // a piece is too short, or there is a cusp at t

  const auto at = points_.begin() + 3 * static_cast<std::ptrdiff_t>(i);
  std::copy(a.p.begin() + 1, a.p.begin() + 3, at + 1);
  points_.insert(at + 3, {a.p[3], b.p[1], b.p[2]});
  joints_.insert(joints_.begin() + i, JointKind::kSmooth);
  const auto origin = origins_.begin() + i;
  origins_.insert(origin + 1, *origin + t * (*(origin + 1) - *origin));
  changed_.insert(changed_.begin() + i, 1);
  changed_[static_cast<std::size_t>(i) + 1] = 1;
  carry_widths();
  return true;
}

int Strand::divide_evenly(int i, double longest_mm, int max_pieces) {
  constexpr double kAccuracy = 1e-3;
  const double length = arc_length(segment(i), kAccuracy);
  const double wanted = std::ceil(length / longest_mm);
  const int pieces =
      std::max(1, static_cast<int>(std::min(wanted, static_cast<double>(max_pieces))));
  int made = 1;
  for (int left = pieces; left > 1; --left, ++made) {
    const int k = i + made - 1;
    if (!divide(k, parameter_at_length(segment(k), length / pieces, kAccuracy))) break;
  }
  return made;
}

void Strand::prepare(int i) {
  for (const int k : {previous(i), i, next(i)}) {
    if (k >= 0) stand_up(k);
  }
}

void Strand::stand_up(int i) {
  Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>(i);
  const Cubic c = segment(i);  // both directions come from the unchanged segment
  if (joint(i) == JointKind::kSmooth && distance(p[0], p[1]) < kNoHandleMm) {
    p[1] = p[0] + kStandingMm * tangent(c, 0.0);
  }
  if (joint(i + 1) == JointKind::kSmooth && distance(p[2], p[3]) < kNoHandleMm) {
    p[2] = p[3] - kStandingMm * tangent(c, 1.0);
  }
}

Compliance Strand::compliance(int i, double t, bool pins_joints) const noexcept {
  const Cubic c = segment(i);
  const JointKind left = joint(i), right = joint(i + 1);
  const auto of_joint = [&](JointKind kind, double away) {
    return pins_joints && kind != JointKind::kSmooth ? pinned_compliance(away) : 1.0;
  };
  return {.left_joint = of_joint(left, t),
          .left_handle = handle_compliance(distance(c.p[0], c.p[1]), left),
          .right_handle = handle_compliance(distance(c.p[2], c.p[3]), right),
          .right_joint = of_joint(right, 1.0 - t)};
}

bool Strand::bend(int i, double t, const EditWeights& weights, Vec pull) {
  if (closed() && count() == 1) {  // too short to divide, so it moves as a whole
    for (Point& p : points_) p += pull;
    changed_[0] = 1;
    return is_finite(segment(0));
  }
  const std::array<int, 3> touched{previous(i), i, next(i)};
  std::array<Cubic, 3> before{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (touched[k] >= 0) before[k] = segment(touched[k]);
  }
  const Point target = evaluate(segment(i), t) + weights.gain(t) * pull;
  shift_with_neighbours(i, weights, pull);
  if (drop_tiny_handles(i)) {
    const Cubic c = segment(i);
    const Compliance rest{.left_handle = c.p[0] == c.p[1] ? 0.0 : 1.0,
                          .right_handle = c.p[2] == c.p[3] ? 0.0 : 1.0};
    shift_with_neighbours(i, soft_weights(t, rest), target - evaluate(c, t));
  }
  keep_collinear(i);
  const bool good =
      std::all_of(touched.begin(), touched.end(), [&](int k) { return k < 0 || is_sound(k); });
  for (std::size_t k = 0; k < 3; ++k) {
    if (touched[k] < 0) continue;
    if (!good) set_segment(touched[k], before[k]);
    if (good) changed_[static_cast<std::size_t>(touched[k])] = 1;
  }
  return good;
}

bool Strand::is_sound(int i) const noexcept {
  const Cubic c = segment(i);
  return is_finite(c) && control_length(c) >= kMinSegmentMm;
}

bool Strand::shift(int first, std::span<const double> weights, Vec pull) {
  const int segments = static_cast<int>(weights.size() / 3);
  const bool all_round = closed() && segments == count();
  const std::vector<Point> before = points_;
  for (int k = 0; k < segments; ++k) {
    Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>((first + k) % count());
    const double* w = weights.data() + 3 * static_cast<std::ptrdiff_t>(k);
    // Each joint moves with the segment after it; the last joint moves with the segment before it.
    const bool is_last = k + 1 == segments && !all_round;
    for (int j = 0; j < (is_last ? 4 : 3); ++j) p[j] += w[j] * pull;
  }
  if (closed()) {
    // The point at the seam is stored twice. Copies the moved one to the other.
    if (points_.front() != before.front()) points_.back() = points_.front();
    points_.front() = points_.back();
  }
  bool good = true;
  for (int k = 0; k < segments; ++k) good = good && is_sound((first + k) % count());
  if (!good) points_ = before;
  for (int k = 0; good && k < segments; ++k) {
    changed_[static_cast<std::size_t>((first + k) % count())] = 1;
  }
  return good;
}

void Strand::set_segment(int i, const Cubic& c) noexcept {
  std::copy(c.p.begin(), c.p.end(), points_.begin() + 3 * static_cast<std::ptrdiff_t>(i));
}

void Strand::shift_with_neighbours(int i, const EditWeights& weights, Vec pull) {
  Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>(i);
  for (std::size_t k = 0; k < 4; ++k) p[k] += weights.w[k] * pull;
  if (const int left = previous(i); left >= 0) {
    Point* q = points_.data() + 3 * static_cast<std::ptrdiff_t>(left);
    q[2] += weights.w[0] * pull;
    q[3] = p[0];
  }
  if (const int right = next(i); right >= 0) {
    Point* q = points_.data() + 3 * static_cast<std::ptrdiff_t>(right);
    q[1] += weights.w[3] * pull;
    q[0] = p[3];
  }
}

bool Strand::drop_tiny_handles(int i) noexcept {
  Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>(i);
  bool dropped = false;
  const auto drop = [&](JointKind kind, Point at, Point& handle) {
    if (kind != JointKind::kSmooth || handle == at || distance(at, handle) >= kNoHandleMm) return;
    handle = at;
    dropped = true;
  };
  drop(joint(i), p[0], p[1]);
  drop(joint(i + 1), p[3], p[2]);
  return dropped;
}

void Strand::keep_collinear(int i) noexcept {
  const Cubic c = segment(i);
  const auto turn = [](Point at, Vec direction, Point& handle) {
    const double length = std::max(distance(at, handle), kStandingMm);
    handle = at + length * direction;
  };
  if (const int left = previous(i); left >= 0 && joint(i) == JointKind::kSmooth) {
    turn(c.p[0], -tangent(c, 0.0), points_[3 * static_cast<std::size_t>(left) + 2]);
  }
  if (const int right = next(i); right >= 0 && joint(i + 1) == JointKind::kSmooth) {
    turn(c.p[3], tangent(c, 1.0), points_[3 * static_cast<std::size_t>(right) + 1]);
  }
}

void Strand::limit_handles(int i, double longest) noexcept {
  Point* p = points_.data() + 3 * static_cast<std::ptrdiff_t>(i);
  const double chord = distance(p[0], p[3]);
  if (std::max(distance(p[0], p[1]), distance(p[2], p[3])) <= longest * chord) return;
  // Shorter handles also shorten the segment, so a margin and several rounds are needed.
  for (int round = 0; round < 8; ++round) {
    const double largest = longest * arc_length(segment(i), 1e-3);
    const double left = distance(p[0], p[1]), right = distance(p[3], p[2]);
    if (left <= largest && right <= largest) return;
    changed_[static_cast<std::size_t>(i)] = 1;
    if (left > largest) p[1] = lerp(p[0], p[1], 0.95 * largest / left);
    if (right > largest) p[2] = lerp(p[3], p[2], 0.95 * largest / right);
  }
}

/// Computes the widths again from the snapshot. Each knot keeps its position on the ink, and joints
/// of divided segments get a knot.
void Strand::carry_widths() {
  const auto knots = snapshot_->widths();
  widths_.clear();
  const auto add = [&](double u, const WidthKnot& ink) {
    if (widths_.empty() || u > widths_.back().u) widths_.push_back({u, ink.width_mm, ink.tone});
  };
  auto k = knots.begin();
  bool was_divided = false;
  for (int i = 0; i < count(); ++i) {
    const double from = snapshot_u(i), to = snapshot_u(i + 1);
    const bool is_divided = to - from < 1.0;
    if (is_divided || was_divided) add(i, knot_at(knots, from));
    for (; k != knots.end() && k->u < to; ++k) add(i + (k->u - from) / (to - from), *k);
    was_divided = is_divided;
  }
  while (widths_.back().u >= count()) widths_.pop_back();
  widths_.push_back({static_cast<double>(count()), knots.back().width_mm, knots.back().tone});
}

Result<Stroke> Strand::stroke() const {
  return Stroke::create({.points = points_,
                         .joints = joints_,
                         .closed = closed(),
                         .widths = widths_,
                         .medium = snapshot_->medium(),
                         .color = snapshot_->color()});
}

}  // namespace felt
