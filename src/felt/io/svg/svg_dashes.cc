#include "felt/io/svg/svg_dashes.h"

#include <cmath>
#include <numeric>

namespace felt {
namespace {

/// Walks along a contour and through the pattern at the same time.
class Dasher {
 public:
  Dasher(std::span<const double> pattern, double offset, bool keep_dots)
      : pattern_(pattern), keep_dots_(keep_dots) {
    const double sum = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    double into = std::fmod(offset, sum);
    if (into < 0.0) into += sum;
    tiny_ = 1e-11 * sum;
    left_ = pattern_[0];
    while (into > 0.0 && into >= left_ && index_ + 1 < pattern_.size()) {
      into -= left_;
      left_ = pattern_[++index_];
    }
    left_ = std::max(0.0, left_ - into);
  }

  void along(const Cubic& c, double length) {
    double at = 0.0;
    while (at < length) {
      if (is_fresh_) begin_dash(c, at);
      if (left_ <= 0.0) {
        next();
        continue;
      }
      double to = std::min(length, at + left_);
      if (length - to <= tiny_) to = length;
      if (is_drawn()) append(c, at, to, length);
      left_ = to < length || left_ - (to - at) <= tiny_ ? 0.0 : left_ - (to - at);
      at = to;
    }
  }

  std::vector<SvgContour> take() {
    open_ = false;
    return std::move(dashes_);
  }

 private:
  [[nodiscard]] bool is_drawn() const noexcept { return index_ % 2 == 0; }

  void next() {
    open_ = false;
    is_fresh_ = true;
    index_ = (index_ + 1) % pattern_.size();
    left_ = pattern_[index_];
  }

  /// Starts a dash. A dash without length becomes a dot.
  void begin_dash(const Cubic& c, double at) {
    is_fresh_ = false;
    if (left_ > 0.0 || !is_drawn() || !keep_dots_) return;
    const Point p = evaluate(c, parameter_at_length(c, at));
    dashes_.push_back({{p, p, p, p}, false});
  }

  void append(const Cubic& c, double from, double to, double length) {
    const double t0 = from > 0.0 ? parameter_at_length(c, from) : 0.0;
    const double t1 = to < length ? parameter_at_length(c, to) : 1.0;
    const Cubic part = sub_segment(c, t0, t1);
    if (!open_) dashes_.push_back({{part.p[0]}, false});
    open_ = true;
    std::vector<Point>& points = dashes_.back().points;
    points.insert(points.end(), {part.p[1], part.p[2], part.p[3]});
  }

  std::span<const double> pattern_;
  bool keep_dots_;
  std::vector<SvgContour> dashes_;
  std::size_t index_ = 0;
  double left_ = 0.0;
  double tiny_ = 0.0;     ///< shorter lengths are errors of rounding
  bool is_fresh_ = true;  ///< no part of the current pattern length was used yet
  bool open_ = false;     ///< the last dash has not ended yet
};

}  // namespace

std::optional<std::vector<SvgContour>> svg_dashes(const SvgContour& contour,
                                                  std::span<const double> pattern, double offset,
                                                  bool keep_dots, std::size_t max_dashes) {
  std::vector<double> lengths;
  double whole = 0.0;
  for (std::size_t i = 0; i < contour.segment_count(); ++i) {
    lengths.push_back(arc_length(contour.segment(i)));
    whole += lengths.back();
  }
  const double sum = std::accumulate(pattern.begin(), pattern.end(), 0.0);
  const double count = (whole / sum + 1.0) * (0.5 * static_cast<double>(pattern.size()));
  if (!(count <= static_cast<double>(max_dashes))) return std::nullopt;
  Dasher dasher(pattern, offset, keep_dots);
  for (std::size_t i = 0; i < lengths.size(); ++i) dasher.along(contour.segment(i), lengths[i]);
  return dasher.take();
}

std::vector<SvgContour> joined_dashes(std::vector<SvgContour> dashes) {
  constexpr double kSmooth = 1e-6;
  std::vector<SvgContour> joined;
  for (SvgContour& dash : dashes) {
    const auto goes_on = [&](const SvgContour& before) {
      const Cubic a = before.segment(before.segment_count() - 1), b = dash.segment(0);
      const Vec out = tangent(a, 1.0), in = tangent(b, 0.0);
      return distance(a.p[3], b.p[0]) <= kSmooth * (control_length(a) + control_length(b)) &&
             std::fabs(cross(out, in)) <= kSmooth && dot(out, in) > 0.0;
    };
    if (joined.empty() || !goes_on(joined.back())) {
      joined.push_back(std::move(dash));
      continue;
    }
    std::vector<Point>& points = joined.back().points;
    points.insert(points.end(), dash.points.begin() + 1, dash.points.end());
  }
  return joined;
}

}  // namespace felt
