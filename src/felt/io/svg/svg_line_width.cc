#include "felt/io/svg/svg_line_width.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "felt/io/svg/svg_variable_width.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Number of samples of a curved segment. A straight segment has a single width.
constexpr int kSamples = 8;
/// Distance of a knot from a corner, in u. The width changes between the knots on both sides.
constexpr double kCornerU = 1e-3;

class Stretched {
 public:
  Stretched(const SvgCenterLine& line, const Affine& to_mm, const Affine& back, double width)
      : line_(line), back_(back), size_(width * std::fabs(determinant(to_mm))) {}

  std::vector<WidthKnot> knots() const {
    std::vector<WidthKnot> knots;
    const std::size_t n = line_.segment_count();
    for (std::size_t i = 0; i < n; ++i) {
      const Cubic c{{line_.points[3 * i], line_.points[3 * i + 1], line_.points[3 * i + 2],
                     line_.points[3 * i + 3]}};
      const int samples = flatness(c) <= 1e-9 ? 1 : kSamples;
      for (int k = 0; k <= samples; ++k) {
        const double t = static_cast<double>(k) / samples;
        add(knots, static_cast<double>(i) + t, width_at(c, t), i + (k == samples ? 1 : 0), k == 0);
      }
    }
    return knots;
  }

 private:
  [[nodiscard]] double width_at(const Cubic& c, double t) const noexcept {
    return size_ * norm(apply(back_, tangent(c, t)));
  }

  /// Adds a knot. At a corner the width changes abruptly, so each side of the corner has its own
  /// knot; both are moved away from the corner by kCornerU.
  void add(std::vector<WidthKnot>& knots, double u, double width, std::size_t joint,
           bool begins) const {
    const double end = static_cast<double>(line_.segment_count());
    const bool is_corner =
        joint > 0 && joint < line_.segment_count() && line_.joints[joint - 1] == JointKind::kCorner;
    if (u == static_cast<double>(joint) && is_corner) u += begins ? kCornerU : -kCornerU;
    if (!knots.empty() && !(u > knots.back().u)) return;
    knots.push_back({std::min(u, end), width});
  }

  const SvgCenterLine& line_;
  Affine back_;
  double size_;
};

}  // namespace

SvgLineWidths svg_line_widths(const SvgCenterLine& line, const Affine& to_mm, double width) {
  SvgLineWidths result;
  const double n = static_cast<double>(line.segment_count());
  if (svg_is_similarity(to_mm)) {
    const double mm = width * std::sqrt(std::fabs(determinant(to_mm)));
    result.knots = {{0.0, mm}, {n, mm}};
  } else {
    const std::optional<Affine> back = inverse({to_mm.a, to_mm.b, to_mm.c, to_mm.d, 0.0, 0.0});
    if (!back) return result;
    result.knots = Stretched(line, to_mm, *back, width).knots();
    result.is_stretched = true;
  }
  for (WidthKnot& k : result.knots) {
    if (k.width_mm >= kMinWidthMm) continue;
    k.width_mm = kMinWidthMm;
    result.was_thin = true;
  }
  take_tone_of_width(result.knots);
  return result;
}

}  // namespace felt
