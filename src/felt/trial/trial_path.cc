#include <utility>

#include "felt/geometry/polyline.h"
#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

// Where the path turns back, the sum of two opposite directions is only rounding.
constexpr double kMinDirection = 1e-9;

std::vector<Point> clean_path(std::span<const Point> path, TrialPathEnds ends) {
  std::vector<Point> line;
  for (const Point p : path) {
    if (is_in_range(p) && (line.empty() || line.back() != p)) line.push_back(p);
  }
  const bool joins = ends == TrialPathEnds::kClosed && line.size() > 1;
  if (joins && line.front() != line.back()) line.push_back(line.front());
  return line;
}

std::vector<LineTree::Line> lines_of_path(std::span<const Point> line) {
  std::vector<LineTree::Line> lines;
  for (std::size_t i = 1; i < line.size(); ++i) lines.push_back({line[i - 1], line[i]});
  if (line.size() == 1) lines.push_back({line[0], line[0]});
  return lines;
}

}  // namespace

TrialPath::TrialPath(std::span<const Point> path, TrialPathEnds ends)
    : line_(clean_path(path, ends)),
      tree_(lines_of_path(line_)),
      length_mm_(polyline_length(line_)),
      closed_(ends == TrialPathEnds::kClosed && line_.size() > 1) {}

bool TrialPath::straight() const noexcept {
  if (closed_ || line_.size() < 2) return false;
  const double chord_mm = distance(line_.front(), line_.back());
  return chord_mm > 0.0 && length_mm_ <= chord_mm * (1.0 + 1e-9);
}

Vec TrialPath::direction(std::size_t index) const noexcept {
  return normalized(line_[index + 1] - line_[index]);
}

Vec TrialPath::tangent(const PolylineNearest& at) const noexcept {
  if (line_.size() < 2) return {};
  const Vec here = direction(at.index);
  if ((at.t > 0.0 && at.t < 1.0) || is_end(at)) return here;
  const std::size_t count = line_.size() - 1;
  const std::size_t other = at.t > 0.0 ? (at.index + 1) % count : (at.index + count - 1) % count;
  const Vec sum = here + direction(other);
  return norm(sum) > kMinDirection ? normalized(sum) : here;
}

bool TrialPath::is_end(const PolylineNearest& at) const noexcept {
  if (closed_ || line_.size() < 2) return !closed_;
  return (at.index == 0 && at.t == 0.0) || (at.index + 2 == line_.size() && at.t == 1.0);
}

}  // namespace felt
