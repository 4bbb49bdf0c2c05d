#include "felt/tools/guide_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr std::ptrdiff_t kHalf = GuidePiece::kPoints / 2;
/// Number of points before and after the last position that are searched while the pen touches.
constexpr std::ptrdiff_t kStepPoints = 16;
/// Half the number of intervals over which the speed of the teacher is measured: 4 mm in total.
constexpr std::ptrdiff_t kSpeedPoints = 4;
constexpr double kMaxTeacherMmPerS = 500.0;
constexpr double kEndFadeMm = 5.0;
constexpr double kMaxGuideStepS = 0.02;  // longest time between two samples that counts

GuideLaw law_of(const GuideLine& line) {
  switch (line.kind) {
    case GuideKind::kErrorAmplifying:
      return GuideLaw::error_amplifying(line.strength);
    case GuideKind::kTeacher:
      return GuideLaw::teacher(line.strength);
    case GuideKind::kNone:
    case GuideKind::kGroove:
    case GuideKind::kAsNeeded:
      break;
  }
  return GuideLaw::groove(line.strength);
}

}  // namespace

GuideTrack::GuideTrack(GuideLine line, std::uint32_t number)
    : GuideTrack(line, number, law_of(line)) {}

GuideTrack::GuideTrack(GuideLine line, std::uint32_t number, const GuideLaw& law, Ends ends)
    : line_(std::move(line)), number_(number), hold_(number), law_(law), ends_(ends) {
  FELT_CHECK(line_.kind != GuideKind::kNone && check_guide(line_).has_value());
  resample();
  measure_teacher();
  if (!line_.is_closed && ends_ == Ends::kContinue) add_ends();
}

/// Divides the path into equal steps of about kSpacingMm.
void GuideTrack::resample() {
  std::vector<Point> path = line_.points;
  if (line_.is_closed) path.push_back(path.front());
  const double length = polyline_length(path);
  const double steps = std::max(2.0, std::round(length / GuidePiece::kSpacingMm));
  spacing_mm_ = length / steps;
  const auto count = static_cast<std::size_t>(steps) + 1;
  double end_mm = 0.0;  // of the line from path[i] to path[i + 1]
  std::size_t i = 0;
  double begin_mm = 0.0;
  end_mm = distance(path[0], path[1]);
  for (std::size_t k = 0; k < count; ++k) {
    const double along = spacing_mm_ * static_cast<double>(k);
    while (along > end_mm && i + 2 < path.size()) {
      ++i;
      begin_mm = end_mm;
      end_mm += distance(path[i], path[i + 1]);
    }
    const double size = end_mm - begin_mm;
    const double t = size > 0.0 ? std::clamp((along - begin_mm) / size, 0.0, 1.0) : 0.0;
    points_.push_back(lerp(path[i], path[i + 1], t));
    if (!line_.times_ms.empty()) {
      times_.push_back(1e-3 * std::lerp(line_.times_ms[i], line_.times_ms[i + 1], t));
    }
  }
  if (line_.is_closed) points_.pop_back();
}

void GuideTrack::measure_teacher() {
  speeds_.assign(points_.size(), 0.0F);
  const auto last = static_cast<std::ptrdiff_t>(times_.size()) - 1;
  for (std::ptrdiff_t i = 0; i < last; ++i) {  // 0 at the end of the path
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(i - kSpeedPoints, 0);
    const std::ptrdiff_t to = std::min(i + kSpeedPoints, last);
    const double time_s =
        times_[static_cast<std::size_t>(to)] - times_[static_cast<std::size_t>(from)];
    const double mm = spacing_mm_ * static_cast<double>(to - from);
    const double speed = time_s > 0.0 ? mm / time_s : kMaxTeacherMmPerS;
    speeds_[static_cast<std::size_t>(i)] = static_cast<float>(std::min(speed, kMaxTeacherMmPerS));
  }
}

/// Adds kHalf points before and after an open path, straight on.
void GuideTrack::add_ends() {
  const Vec first = normalized(points_[0] - points_[1]);
  const Vec last = normalized(points_.back() - points_[points_.size() - 2]);
  const Point begin = points_.front(), end = points_.back();
  std::vector<Point> before;
  for (std::ptrdiff_t i = kHalf; i > 0; --i) {
    before.push_back(begin + static_cast<double>(i) * spacing_mm_ * first);
  }
  points_.insert(points_.begin(), before.begin(), before.end());
  for (std::ptrdiff_t i = 1; i <= kHalf; ++i) {
    points_.push_back(end + static_cast<double>(i) * spacing_mm_ * last);
  }
  speeds_.insert(speeds_.begin(), kHalf, 0.0F);
  speeds_.resize(points_.size(), 0.0F);
}

std::size_t GuideTrack::wrapped(std::ptrdiff_t i) const noexcept {
  const auto size = static_cast<std::ptrdiff_t>(points_.size());
  if (line_.is_closed) return static_cast<std::size_t>(((i % size) + size) % size);
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, size - 1));
}

/// Returns the nearest of `count` points from `from` on; the first of equally near ones.
std::size_t GuideTrack::nearest(Point pen, std::ptrdiff_t from, std::ptrdiff_t count) const {
  std::size_t best = wrapped(from);
  for (std::ptrdiff_t i = from + 1; i < from + count; ++i) {
    const std::size_t at = wrapped(i);
    if (distance_squared(points_[at], pen) < distance_squared(points_[best], pen)) best = at;
  }
  return best;
}

/// Returns the nearest position on the lines before and after the nearest point.
GuideTrack::Place GuideTrack::place(Point pen) const {
  const auto at = static_cast<std::ptrdiff_t>(at_);
  const LineNearest before = nearest_on_line(points_[at_], points_[wrapped(at - 1)], pen);
  const LineNearest after = nearest_on_line(points_[at_], points_[wrapped(at + 1)], pen);
  const bool is_after = after.distance_squared < before.distance_squared;
  return {spacing_mm_ * (static_cast<double>(at) + (is_after ? after.t : -before.t)),
          std::sqrt(is_after ? after.distance_squared : before.distance_squared)};
}

/// Returns the share of the force at a position from points_[0]: less than 1 beyond an open end.
double GuideTrack::end_share(double place_mm) const noexcept {
  if (line_.is_closed || ends_ == Ends::kEnd) return 1.0;
  const double added = static_cast<double>(kHalf) * spacing_mm_;
  const double last = static_cast<double>(points_.size() - 1) * spacing_mm_;
  const double beyond = std::max(added - place_mm, place_mm - (last - added));
  const double x = std::clamp(beyond / kEndFadeMm, 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

void GuideTrack::make_piece(double place_mm) {
  const auto size = static_cast<std::ptrdiff_t>(points_.size());
  const auto at = static_cast<std::ptrdiff_t>(at_);
  // A short closed path is not repeated.
  const std::ptrdiff_t half = line_.is_closed ? std::min(kHalf, size / 2) : kHalf;
  std::ptrdiff_t from = at - half, to = at + half;  // to: not included
  if (!line_.is_closed) {
    from = std::max<std::ptrdiff_t>(from, 0);
    to = std::min(to, size);
  }
  GuidePiece piece;
  piece.count = static_cast<std::size_t>(to - from);
  for (std::size_t i = 0; i < piece.count; ++i) {
    const std::size_t source = wrapped(from + static_cast<std::ptrdiff_t>(i));
    piece.points[i] = points_[source];
    piece.speeds_mm_per_s[i] = speeds_[source];
  }
  piece.spacing_mm = spacing_mm_;
  piece.at_mm = place_mm - spacing_mm_ * static_cast<double>(from);
  piece.gain = end_share(place_mm);
  if (line_.kind == GuideKind::kAsNeeded) piece.gain *= as_needed_.gain();
  piece.hold = hold_;
  piece.free_side = free_side_;
  GuideLaw law = law_;
  law.window_mm = std::min(law.window_mm, spacing_mm_ * static_cast<double>(half - 1));
  guide_ = Guide(law, piece);
}

void GuideTrack::update(const PenSample& sample) {
  const Point pen = on_page(sample.position);
  const std::size_t last = at_;
  const auto size = static_cast<std::ptrdiff_t>(points_.size());
  const bool searches_all = !in_contact(sample) || is_lost_ || size <= 2 * kStepPoints;
  const auto from = static_cast<std::ptrdiff_t>(last) - kStepPoints;
  at_ = searches_all ? nearest(pen, 0, size) : nearest(pen, from, 2 * kStepPoints + 1);
  auto moved = std::abs(static_cast<std::ptrdiff_t>(at_) - static_cast<std::ptrdiff_t>(last));
  if (line_.is_closed) moved = std::min(moved, size - moved);
  if (moved > kStepPoints) ++hold_;
  const Place place = this->place(pen);
  is_lost_ = place.distance_mm > guide_.law().well.radius_mm + 1.0;  // there is no force
  // A pen that has just come back does not count as off the path for all the time in between.
  const double dt_s =
      std::min(1e-9 * static_cast<double>(sample.time_ns - last_ns_), kMaxGuideStepS);
  if (in_contact(sample) && !is_lost_) as_needed_.update(place.distance_mm, dt_s);
  last_ns_ = sample.time_ns;
  make_piece(place.mm);
}

}  // namespace felt
