#include "felt/render/ink_damage.h"

#include <algorithm>
#include <cmath>

#include "felt/render/segments_in_area.h"

namespace felt {
namespace {

/// Returns the number of equal segments at the beginning of two strokes.
int common_head(const Stroke& a, const Stroke& b) noexcept {
  const auto& p = a.data().points;
  const auto& q = b.data().points;
  const auto points = std::mismatch(p.begin(), p.end(), q.begin(), q.end()).first - p.begin();
  const auto v = a.widths(), w = b.widths();
  const auto knots = std::mismatch(v.begin(), v.end(), w.begin(), w.end()).first - v.begin();
  if (points == 0 || knots == 0) return 0;
  const double u = v[static_cast<std::size_t>(knots) - 1].u;
  return std::min(static_cast<int>((points - 1) / 3), static_cast<int>(std::floor(u)));
}

/// Returns the number of equal segments at the end of two strokes.
int common_tail(const Stroke& a, const Stroke& b) noexcept {
  const auto& p = a.data().points;
  const auto& q = b.data().points;
  const auto points = std::mismatch(p.rbegin(), p.rend(), q.rbegin(), q.rend()).first - p.rbegin();
  const auto v = a.widths(), w = b.widths();
  const double ends = b.segment_count() - a.segment_count();
  std::size_t knots = 0;
  while (knots < v.size() && knots < w.size()) {
    const WidthKnot& k = v[v.size() - 1 - knots];
    const WidthKnot& l = w[w.size() - 1 - knots];
    if (k.width_mm != l.width_mm || k.u + ends != l.u) break;
    ++knots;
  }
  if (points == 0 || knots == 0) return 0;
  const double u = v[v.size() - knots].u;
  return std::min(static_cast<int>((points - 1) / 3),
                  static_cast<int>(std::floor(a.segment_count() - u)));
}

void add_segments(const Stroke& stroke, int first, int last, InkDamage& damage) {
  for (int i = first; i < last; ++i) damage.push_back(segment_area(stroke, i));
}

}  // namespace

void add_ink(const Stroke& stroke, InkDamage& damage) {
  add_segments(stroke, 0, stroke.segment_count(), damage);
}

void add_difference(const Stroke& before, const Stroke& after, InkDamage& damage) {
  if (before.color() != after.color() || before.medium() != after.medium() ||
      before.closed() != after.closed()) {
    add_ink(before, damage);
    add_ink(after, damage);
    return;
  }
  if (before == after) return;
  const int fewer = std::min(before.segment_count(), after.segment_count());
  const int head = std::min(common_head(before, after), fewer);
  const int tail = std::min(common_tail(before, after), fewer - head);
  // Includes the neighbours of the difference, because a round end may reach into them.
  const auto add = [&](const Stroke& stroke) {
    add_segments(stroke, std::max(0, head - 1),
                 std::min(stroke.segment_count(), stroke.segment_count() - tail + 1), damage);
  };
  add(before);
  add(after);
}

}  // namespace felt
