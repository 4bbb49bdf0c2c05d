#include "felt/document/fill.h"

#include <cmath>
#include <string>

namespace felt {
namespace {

bool is_parameter(double u) noexcept {
  return std::isfinite(u) && u >= 0.0;
}

/// Returns what is wrong with a loop, or null.
const char* fault_of(const FillLoop& loop) noexcept {
  const std::size_t count = loop.points.size();
  if (count < 4 || count % 3 != 1) return "does not have 3n + 1 points";
  for (const Point& p : loop.points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return "has a point that is not finite";
  }
  if (loop.points.front() != loop.points.back()) return "is not closed";
  if (loop.pieces.size() > count / 3) return "has more pieces than segments";
  for (const FillPiece& piece : loop.pieces) {
    if (!is_parameter(piece.from) || !is_parameter(piece.to)) return "has an invalid parameter";
    if (!piece.stroke && (piece.from != 0.0 || piece.to != 0.0)) {
      return "has a bridge with parameters";
    }
  }
  return nullptr;
}

}  // namespace

Result<void> check_fill(const Fill& fill) {
  if (fill.loops.empty()) return invalid_data("the fill has no boundary");
  if (fill.loops.size() > kMaxFillLoops) {
    return fail(ErrorCode::kLimitExceeded, "the fill has more than 100000 loops");
  }
  if (!is_parameter(fill.max_gap_mm)) return invalid_data("the fill has an invalid gap");
  std::size_t segments = 0;
  for (std::size_t i = 0; i < fill.loops.size(); ++i) {
    if (const char* fault = fault_of(fill.loops[i])) {
      return invalid_data("loop " + std::to_string(i + 1) + " of the fill " + fault);
    }
    segments += fill.loops[i].points.size() / 3;
  }
  if (segments > kMaxFillSegments) {
    return fail(ErrorCode::kLimitExceeded, "the fill has more than 1000000 segments");
  }
  return {};
}

Cubic fill_segment(const FillLoop& loop, std::size_t i) noexcept {
  const Point* p = loop.points.data() + 3 * i;
  return Cubic{{p[0], p[1], p[2], p[3]}};
}

Rect fill_bounds(const Fill& fill) noexcept {
  Rect area;
  for (const FillLoop& loop : fill.loops) {
    for (std::size_t i = 0; 3 * i + 3 < loop.points.size(); ++i) {
      area.extend(bounds(fill_segment(loop, i)));
    }
  }
  return area;
}

void flatten_fill(const Fill& fill, double tolerance_mm, Outline& out) {
  out.clear();
  for (const FillLoop& loop : fill.loops) {
    for (std::size_t i = 0; 3 * i + 3 < loop.points.size(); ++i) {
      const Cubic c = fill_segment(loop, i);
      const int steps = flatten_steps(c, 1.0, tolerance_mm);
      for (int k = 0; k < steps; ++k) {
        out.points.push_back(evaluate(c, static_cast<double>(k) / steps));
      }
    }
    out.ends.push_back(out.points.size());
  }
}

}  // namespace felt
