#include "felt/gather/copied_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr std::size_t kCopyPoints = 9;

/// What two copies have in common.
struct CopyKey {
  std::array<double, 2 * kCopyPoints + 1> cells{};  // of the points, then of the length
  std::array<double, 2 * kCopyPoints> exact{};      // so that the order does not choose
  friend bool operator<(const CopyKey& a, const CopyKey& b) {
    return a.cells != b.cells ? a.cells < b.cells : a.exact < b.exact;
  }
};

CopyKey key_of(std::span<const Point> line, double length_mm, double tolerance_mm) {
  std::array<Point, kCopyPoints> points;
  resample(line, points);
  CopyKey key;
  const auto fill = [&] {
    for (std::size_t k = 0; k < kCopyPoints; ++k) {
      key.exact[2 * k] = points[k].x;
      key.exact[2 * k + 1] = points[k].y;
    }
    for (std::size_t k = 0; k < key.exact.size(); ++k) {
      key.cells[k] = std::floor(key.exact[k] / tolerance_mm);
    }
  };
  key.cells.back() = std::floor(length_mm / tolerance_mm);
  fill();
  const CopyKey forwards = key;
  std::reverse(points.begin(), points.end());
  fill();
  return std::min(forwards, key);
}

}  // namespace

std::vector<std::uint32_t> copied_lines(std::span<const RoughLine> lines, double tolerance_mm) {
  std::vector<std::uint32_t> first(lines.size());
  std::iota(first.begin(), first.end(), 0U);
  std::vector<CopyKey> keys(lines.size());
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const double length_mm = polyline_length(lines[i]);
    if (!(length_mm > 0.0)) continue;
    keys[i] = key_of(lines[i], length_mm, tolerance_mm);
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const bool is_copy = keys[order[k]].cells == keys[order[k - 1]].cells;
    if (is_copy) first[order[k]] = first[order[k - 1]];
  }
  return first;
}

}  // namespace felt
