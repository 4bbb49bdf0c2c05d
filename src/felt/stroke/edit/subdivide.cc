#include "felt/stroke/edit/subdivide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/stroke/profile_builder.h"

namespace felt {
namespace {

/// The accuracy of the lengths that decide if a part is too short (a sliver), mm.
constexpr double kExactLength = 1e-9;

/// Returns both parts of c. Zero handles are kept exactly zero, because rounding would give them a
/// direction, which would become the tangent (I2).
std::pair<Cubic, Cubic> divided(const Cubic& c, double t) noexcept {
  auto parts = split(c, t);
  auto& [a, b] = parts;
  if (c.p[1] == c.p[0]) {
    a.p[1] = a.p[0];
    if (c.p[2] == c.p[0]) a.p[2] = a.p[0];
  }
  if (c.p[2] == c.p[3]) {
    b.p[2] = b.p[3];
    if (c.p[1] == c.p[3]) b.p[1] = b.p[3];
  }
  return parts;
}

/// Returns the kind of the joint at a cut: a corner only at a cusp, where the curve turns back
/// within a segment.
JointKind kind_between(const Cubic& a, const Cubic& b) {
  const double deg = angle_between(tangent(a, 1.0), tangent(b, 0.0)) * (180.0 / std::numbers::pi);
  return deg <= kSmoothJointMaxDeg ? JointKind::kSmooth : JointKind::kCorner;
}

/// Copies a stroke segment by segment, and adds joints.
class Subdivision {
 public:
  explicit Subdivision(const Stroke& stroke) : stroke_(stroke), profile_(stroke.widths()) {
    data_.points.push_back(stroke.data().points.front());
    data_.closed = stroke.closed();
    data_.medium = stroke.medium();
    data_.color = stroke.color();
  }

  /// Copies segment i with joints at `us`, all on that segment; appends their numbers to `joints`.
  void add(int i, std::span<const double> us, std::vector<int>& joints) {
    const Cubic whole = stroke_.segment(i);
    rest_ = whole;
    from_ = 0.0;
    for (const double u : us) joints.push_back(cut(whole, i, u - i));
    close(i);
  }

  [[nodiscard]] Result<Stroke> finish() && {
    if (!data_.closed) data_.joints.pop_back();
    data_.widths = std::move(profile_).finish(count_);
    return Stroke::create(std::move(data_));
  }

 private:
  /// Returns the number of the joint at t of the segment: a new one, or the nearer neighbour if a
  /// part would be too short.
  int cut(const Cubic& whole, int i, double t) {
    const double before = arc_length(whole, from_, t, kExactLength);
    const double after = arc_length(whole, t, 1.0, kExactLength);
    if (before < kMinSegmentMm || after < kMinSegmentMm) {
      return before <= after ? count_ : count_ + 1;
    }
    const auto [part, rest] = divided(rest_, (t - from_) / (1.0 - from_));
    push(part, kind_between(part, rest));
    profile_.stretch(i + from_, i + t, count_ - 1, count_);
    rest_ = rest;
    from_ = t;
    return count_;
  }
  void close(int i) {
    push(rest_, stroke_.joint(i + 1));
    if (from_ == 0.0) {
      profile_.shift(i, i + 1, count_ - 1 - i);
    } else {
      profile_.stretch(i + from_, i + 1, count_ - 1, count_);
    }
  }
  void push(const Cubic& c, JointKind kind) {
    data_.points.insert(data_.points.end(), c.p.begin() + 1, c.p.end());
    data_.joints.push_back(kind);
    ++count_;
  }

  const Stroke& stroke_;
  ProfileBuilder profile_;
  StrokeData data_;
  int count_ = 0;      // segments so far
  Cubic rest_;         // the rest of the current segment
  double from_ = 0.0;  // the t at which it starts
};

}  // namespace

Result<Stroke> subdivided(const Stroke& stroke, std::span<const double> us,
                          std::vector<int>* joints) {
  const int n = stroke.segment_count();
  for (std::size_t k = 0; k < us.size(); ++k) {
    // NaN compares false.
    if (!(us[k] >= (k > 0 ? us[k - 1] : 0.0) && us[k] <= n)) {
      return fail(ErrorCode::kInvalidArgument,
                  "the parameters at which a stroke is divided must ascend and lie on it");
    }
  }
  std::vector<int> numbers;
  Subdivision result(stroke);
  auto next = us.begin();
  for (int i = 0; i < n; ++i) {
    const auto end = i + 1 < n ? std::lower_bound(next, us.end(), i + 1.0) : us.end();
    result.add(i, {next, end}, numbers);
    next = end;
  }
  if (joints != nullptr) *joints = std::move(numbers);
  return std::move(result).finish();
}

}  // namespace felt
