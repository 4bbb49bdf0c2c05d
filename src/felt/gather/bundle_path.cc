#include "felt/gather/bundle_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/gather/percentile.h"
#include "felt/gather/strip_positions.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

// The standard deviation of the smoothing in each round, relative to the width of the strip. It is
// large at first, because the first positions may be wrong by more than that width.
constexpr std::array kSmoothShares{2.0, 1.5, 1.0, 0.7, 0.25};
constexpr double kRampShare = 0.5;
// A ramp is at least so many times as long as the jump is wide. On a shorter one, the average would
// turn back to the lines that go on, and the positions of the points would follow it.
constexpr double kRampJumps = 2.0;
constexpr double kTailShare = 1.5;  // the last widths of a strip, in which lines end one by one
constexpr double kEndSlack = 0.3;   // bins: lines that end so near to each other end together
constexpr double kMaxBins = 4000.0;
constexpr double kMaxJump = 8.0;  // bins from one point of a line to the next

/// The average of a strip's points at equal distances along it.
class StripAverage {
 public:
  explicit StripAverage(StripPositions strip)
      : strip_(std::move(strip)), closed_(strip_.period_mm.has_value()) {
    step_mm_ = std::max(strip_.step_mm, range_mm() / kMaxBins);
    for (const double share : kSmoothShares) {
      average(share);
      project();
    }
    average(kSmoothShares.back());
  }

  [[nodiscard]] BundlePath path() const;
  [[nodiscard]] double step_mm() const { return step_mm_; }
  /// Returns the distance from the middle line that 95 % of the points do not exceed.
  [[nodiscard]] double blur_mm() const { return blur_mm_; }

 private:
  struct Bin {
    Vec sum;
    double weight = 0.0;
    Rect box;
    /// The lines that end here, forwards and backwards.
    std::array<Vec, 2> end_sums;
    std::array<double, 2> end_weights{};
  };
  [[nodiscard]] double range_mm() const {
    return closed_ ? *strip_.period_mm : strip_.last_mm - strip_.first_mm;
  }
  [[nodiscard]] std::size_t bin_of(double along_mm) const;
  [[nodiscard]] std::ptrdiff_t bins() const { return static_cast<std::ptrdiff_t>(middle_.size()); }
  [[nodiscard]] Point middle(std::ptrdiff_t i) const;
  void average(double smooth_share);
  struct PieceEnds {
    double from = 0.0, to = 0.0;  // in bins
  };
  [[nodiscard]] PieceEnds piece(std::size_t i, std::size_t bins) const;
  void add_line(std::size_t first, std::size_t last, Point origin, std::vector<Bin>& bins) const;
  void add_piece(std::size_t i, bool is_first, bool is_last, Point origin,
                 std::vector<Bin>& bins) const;
  void blend_ends(const std::vector<Bin>& bins, std::vector<Vec>& means) const;
  void smooth(double share);
  void project();

  StripPositions strip_;
  bool closed_;
  double step_mm_ = 0.0;
  double width_mm_ = 0.0;  // of the strip
  double wide_mm_ = 0.0;   // of its widest tenth
  double ramp_mm_ = 0.0;   // beyond its end, a line fades out over this length
  double blur_mm_ = 0.0;
  std::vector<Point> middle_;
};

std::size_t StripAverage::bin_of(double along_mm) const {
  const double n = static_cast<double>(middle_.size());
  double at = (along_mm - strip_.first_mm) / range_mm();
  if (closed_) at -= std::floor(at);
  return static_cast<std::size_t>(std::clamp(at * n, 0.0, n - 1.0));
}

Point StripAverage::middle(std::ptrdiff_t i) const {
  const std::ptrdiff_t n = bins();
  const std::ptrdiff_t k = closed_ ? ((i % n) + n) % n : std::clamp<std::ptrdiff_t>(i, 0, n - 1);
  return middle_[static_cast<std::size_t>(k)];
}

// Returns the positions of point i and the next one, equal if the next one has moved to another
// part of the strip.
StripAverage::PieceEnds StripAverage::piece(std::size_t i, std::size_t bins) const {
  const double per_bin = range_mm() / static_cast<double>(bins - (closed_ ? 0 : 1));
  double from = (strip_.points[i].along_mm - strip_.first_mm) / per_bin;
  double to = (strip_.points[i + 1].along_mm - strip_.first_mm) / per_bin;
  const auto n = static_cast<double>(bins);
  if (closed_) {
    from -= n * std::floor(from / n);
    to -= n * std::round((to - from) / n);
  }
  return {from, std::fabs(to - from) > kMaxJump ? from : to};
}

// Adds a line, from one point to another, without the hooks at its ends: pieces that lead back do
// not show where the line ends, and the line would count several times there.
void StripAverage::add_line(std::size_t first, std::size_t last, Point origin,
                            std::vector<Bin>& bins) const {
  const auto step = [&](std::size_t i) {
    const PieceEnds ends = piece(i, bins.size());
    return ends.to - ends.from;
  };
  double way = 0.0;
  for (std::size_t i = first; i < last; ++i) way += step(i);
  if (way != 0.0) {
    while (first < last && step(first) * way <= 0.0) ++first;
    while (first < last && step(last - 1) * way <= 0.0) --last;
  }
  for (std::size_t i = first; i < last; ++i) add_piece(i, i == first, i + 1 == last, origin, bins);
}

// Adds the points at which the piece from point i to the next one crosses the positions of bins.
void StripAverage::add_piece(std::size_t i, bool is_first, bool is_last, Point origin,
                             std::vector<Bin>& bins) const {
  const StripPoint& p = strip_.points[i];
  const StripPoint& q = strip_.points[i + 1];
  const auto [from, to] = piece(i, bins.size());
  if (from == to && !is_first && !is_last) return;
  const auto n = static_cast<double>(bins.size());
  const bool forwards = from <= to;
  const double low = std::min(from, to), high = std::max(from, to);
  const double at_from = is_first ? kEndSlack : 0.0;
  const double at_to = is_last ? kEndSlack : 0.0;
  const double last = high + (forwards ? at_to : at_from);
  for (double at = std::ceil(low - (forwards ? at_from : at_to)); at <= last; ++at) {
    if (at == to && at_to == 0.0) continue;  // the next piece begins here
    const double share = high > low ? std::clamp((at - low) / (high - low), 0.0, 1.0) : 0.0;
    const double t = forwards ? share : 1.0 - share;
    const auto k = static_cast<std::size_t>(
        std::clamp(closed_ ? at - n * std::floor(at / n) : at, 0.0, n - 1.0));
    const Point at_bin = lerp(p.point, q.point, t);
    bins[k].sum += at_bin - origin;
    bins[k].box.extend(at_bin);
    bins[k].weight += 1.0;
  }
  const auto add_end = [&](const StripPoint& end, double at, std::size_t backwards) {
    at = backwards != 0 ? std::ceil(at - kEndSlack) : std::floor(at + kEndSlack);
    Bin& bin = bins[static_cast<std::size_t>(
        std::clamp(closed_ ? at - n * std::floor(at / n) : at, 0.0, n - 1.0))];
    bin.end_sums[backwards] += end.point - origin;
    bin.end_weights[backwards] += 1.0;
  };
  if (is_first) add_end(p, from, forwards ? 1 : 0);
  if (is_last) add_end(q, to, forwards ? 0 : 1);
}

// Where lines end, the average jumps to that of the lines that go on. Adds this jump to the average
// beyond the end, so that it fades out over the ramp: up to the end, the average stays the middle
// of all lines.
void StripAverage::blend_ends(const std::vector<Bin>& bins, std::vector<Vec>& means) const {
  const auto n = static_cast<std::ptrdiff_t>(bins.size());
  const auto in_range = [&](std::ptrdiff_t i) { return closed_ || (i >= 0 && i < n); };
  const auto index = [&](std::ptrdiff_t i) { return static_cast<std::size_t>((i % n + n) % n); };
  const std::vector<Vec> before = means;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    for (const std::size_t side : {0U, 1U}) {
      const Bin& bin = bins[index(i)];
      const std::ptrdiff_t step = side == 0 ? 1 : -1;
      const double others = bin.weight - bin.end_weights[side];
      if (bin.end_weights[side] == 0.0 || others < 0.5 || !in_range(i + step)) continue;
      if (bins[index(i + step)].weight == 0.0) continue;
      Vec jump = before[index(i)] - (bin.sum - bin.end_sums[side]) / others;
      const Vec along = normalized(before[index(i + step)] - before[index(i)] + jump);
      jump = jump - dot(jump, along) * along;  // the end of a line may lie between two bins
      const double steps = std::max(ramp_mm_, kRampJumps * norm(jump)) / step_mm_;
      // Lines that soon end, too, are no reason to swerve to them.
      const std::ptrdiff_t tail = side == 0 ? n - 1 - i : i;
      const bool keeps = !closed_ && static_cast<double>(tail) * step_mm_ <= kTailShare * wide_mm_;
      for (std::ptrdiff_t k = 1; keeps || static_cast<double>(k) < steps; ++k) {
        const std::ptrdiff_t at = i + step * k;
        if (!in_range(at) || bins[index(at)].weight == 0.0 || k >= n) break;
        const double x = static_cast<double>(k) / steps;
        means[index(at)] += (keeps ? 1.0 : 1.0 - x * x * (3.0 - 2.0 * x)) * jump;
      }
    }
  }
}

void StripAverage::average(double smooth_share) {
  const Point origin = strip_.points.front().point;
  middle_.resize(static_cast<std::size_t>(std::max(4.0, std::round(range_mm() / step_mm_))));
  std::vector<Bin> bins(middle_.size());
  for (std::size_t first = 0, i = 0; i < strip_.points.size(); ++i) {
    const bool is_last =
        i + 1 == strip_.points.size() || strip_.points[i].line != strip_.points[i + 1].line;
    if (!is_last) continue;
    add_line(first, i, origin, bins);
    first = i + 1;
  }
  std::vector<double> widths;
  for (const Bin& bin : bins) {
    const double width = std::hypot(bin.box.width(), bin.box.height());
    if (width > 0.0) widths.push_back(width);  // not if one line passes
  }
  width_mm_ = percentile(widths, 0.5);
  wide_mm_ = percentile(widths, 0.9);
  std::vector<Vec> means(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].weight > 0.0) means[i] = bins[i].sum / bins[i].weight;
  }
  blend_ends(bins, means);
  std::vector<Point> filled;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].weight > 0.0) filled.push_back(origin + means[i]);
  }
  if (filled.empty()) filled.push_back(origin);  // all lines turn back where they began
  if (filled.size() == 1) filled.push_back(filled.front());
  if (closed_) filled.push_back(filled.front());
  const std::size_t n = middle_.size();
  middle_.resize(n + (closed_ ? 1 : 0));
  resample(filled, middle_);
  middle_.resize(n);
  smooth(smooth_share);
}

void StripAverage::smooth(double share) {
  // One pass of the kernel 1/4, 1/2, 1/4 has a variance of half a step squared.
  const double steps = share * wide_mm_ / step_mm_;
  const int passes = static_cast<int>(std::clamp(2.0 * steps * steps, 2.0, 200.0));
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Point> smoothed = middle_;
    const std::ptrdiff_t margin = closed_ ? 0 : 1;
    for (std::ptrdiff_t i = margin; i < bins() - margin; ++i) {
      const Vec bend = (middle(i - 1) - middle(i)) + (middle(i + 1) - middle(i));
      smoothed[static_cast<std::size_t>(i)] = middle(i) + 0.25 * bend;
    }
    middle_ = std::move(smoothed);
  }
}

// Moves each point to the position of the nearest point of the middle line, searched near its old
// position. Points beyond an open end keep their distance from it.
void StripAverage::project() {
  const double length =
      polyline_length(middle_) + (closed_ ? distance(middle_.front(), middle_.back()) : 0.0);
  const double per_bin = length / static_cast<double>(bins() - (closed_ ? 0 : 1));
  const auto window = std::max<std::ptrdiff_t>(8, bins() / 10);
  double first = 0.0, last = length;
  std::vector<double> distances;
  for (StripPoint& p : strip_.points) {
    const auto at = static_cast<std::ptrdiff_t>(bin_of(p.along_mm));
    double best = 1e300, along = 0.0;
    for (std::ptrdiff_t k = at - window; k < at + window; ++k) {
      if (!closed_ && (k < 0 || k + 1 >= bins())) continue;
      const LineNearest nearest = nearest_on_line(middle(k), middle(k + 1), p.point);
      if (nearest.distance_squared >= best) continue;
      best = nearest.distance_squared;
      along = per_bin * (static_cast<double>(k) + nearest.t);
    }
    if (!closed_ && along <= 0.0) {
      along = -std::max(0.0, dot(p.point - middle(0), normalized(middle(0) - middle(2))));
    } else if (!closed_ && along >= length * (1.0 - 1e-12)) {
      const std::ptrdiff_t n = bins() - 1;
      along =
          length + std::max(0.0, dot(p.point - middle(n), normalized(middle(n) - middle(n - 2))));
    }
    distances.push_back(std::sqrt(best));
    p.along_mm = along;
    first = std::min(first, along);
    last = std::max(last, along);
  }
  blur_mm_ = percentile(distances, 0.95);
  strip_.first_mm = closed_ ? 0.0 : first;
  strip_.last_mm = closed_ ? length : last;
  if (closed_) strip_.period_mm = length;
  ramp_mm_ = std::max(kRampShare * wide_mm_, 2.0 * step_mm_);
}

BundlePath StripAverage::path() const {
  BundlePath path{.points = middle_, .closed = closed_, .strip_mm = width_mm_};
  if (closed_) path.points.push_back(path.points.front());
  return path;
}

}  // namespace

Result<BundlePath> bundle_path(std::span<const RoughLine> lines) {
  std::size_t with_length = 0;
  const RoughLine* only = nullptr;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const Point p : lines[i]) {
      if (is_in_range(p)) continue;
      return fail(ErrorCode::kInvalidArgument,
                  "stroke " + std::to_string(i) + " has a coordinate beyond 1e9 mm");
    }
    if (!(polyline_length(lines[i]) > 0.0)) continue;
    ++with_length;
    only = &lines[i];
  }
  if (with_length == 0) {
    return fail(ErrorCode::kInvalidArgument, "there is no stroke with a length to gather");
  }
  if (with_length == 1) return BundlePath{.points = *only};
  StripPositions positions = strip_positions(lines);
  if (!positions.period_mm) return StripAverage(std::move(positions)).path();
  // A line that meets itself, such as a letter, is not always closed: then points of different
  // parts would be averaged, and would be far from their average.
  const StripAverage closed(positions);
  positions.period_mm.reset();
  const StripAverage open(std::move(positions));
  return closed.blur_mm() <= 1.5 * open.blur_mm() + closed.step_mm() ? closed.path() : open.path();
}

}  // namespace felt
