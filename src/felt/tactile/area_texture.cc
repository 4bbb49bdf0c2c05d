#include "felt/tactile/area_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"
#include "felt/tactile/swell_paper.h"

namespace felt {
namespace {

constexpr double kTestStepMm = 0.25;
/// A shorter piece of a texture would feel like a dot.
constexpr double kShortestPieceMm = 3.0;
/// An edge is covered if it is at most so far from ink. Fills end in the middle of their lines.
constexpr double kCoveredMm = 0.2;

Rect bounds_of(const Outline& polygons) {
  Rect box;
  for (const Point& p : polygons.points) box.extend(p);
  return box;
}

bool is_inside(const Outline& polygons, Point p, bool inside = false) {
  for (std::size_t k = 0; k < polygons.contour_count(); ++k) {
    if (contains(polygons.contour(k), p, FillRule::kEvenOdd)) inside = !inside;
  }
  return inside;
}

/// Returns the smallest distance from a point to ink, or more than `limit_mm`.
bool has_ink_within(const TouchLines& ink, const TouchGrid& near_ink, Point p, double limit_mm) {
  bool has_ink = false;
  near_ink.visit_near(p, [&](std::uint32_t i) {
    const TouchPoint& q = ink.points[i];
    has_ink = has_ink || distance(q.at, p) - q.half_mm < limit_mm;
  });
  return has_ink;
}

/// Finds the pieces of straight rows that are far enough from everything.
class TextureRows {
 public:
  TextureRows(const TextureArea& area, std::size_t& tests_left)
      : area_(area), tests_left_(tests_left), box_(bounds_of(area.edges)) {
    for (const Outline& above : area.above) above_boxes_.push_back(bounds_of(above));
  }

  /// Adds the pieces of parallel rows in a direction. Dots: one every kPitchMm.
  bool add(Vec along, double pitch_mm, bool are_dots, std::vector<TextureLine>& lines) {
    const Vec across = perp(along);
    double low = 1e300, high = -1e300, from = 1e300, to = -1e300;
    for (const Point corner : {Point{box_.x0, box_.y0}, Point{box_.x1, box_.y0},
                               Point{box_.x1, box_.y1}, Point{box_.x0, box_.y1}}) {
      const Vec v = corner - Point{};
      low = std::min(low, dot(v, across));
      high = std::max(high, dot(v, across));
      from = std::min(from, dot(v, along));
      to = std::max(to, dot(v, along));
    }
    const double step = are_dots ? pitch_mm : kTestStepMm;
    // Rows at multiples of the pitch, so that neighbouring areas have them in common.
    for (double row = std::ceil(low / pitch_mm) * pitch_mm; row <= high; row += pitch_mm) {
      const double first = std::ceil(from / step);
      const double last = std::floor(to / step);
      if (!add_row(along, row * across, step, first, last, are_dots, lines)) return false;
    }
    return true;
  }

 private:
  bool add_row(Vec along, Vec offset, double step, double first, double last, bool are_dots,
               std::vector<TextureLine>& lines) {
    bool is_open = false;  // a piece from `start` to `end`
    Point start{}, end{};
    const auto close = [&] {
      if (is_open && distance(start, end) >= kShortestPieceMm) lines.push_back({start, end});
      is_open = false;
    };
    for (double k = first; k <= last; ++k) {
      const std::size_t tests = area_.edges.points.size() + 1;
      if (tests > tests_left_) return false;
      tests_left_ -= tests;
      const Point p = Point{} + offset + (k * step) * along;
      if (!is_free(p)) {
        close();
      } else if (are_dots) {
        lines.push_back({p, p});
      } else {
        if (!is_open) start = p;
        is_open = true;
        end = p;
      }
    }
    close();
    return true;
  }

  [[nodiscard]] bool is_free(Point p) const {
    if (!is_inside(area_.edges, p)) return false;
    for (std::size_t i = 0; i < area_.above.size(); ++i) {
      if (!above_boxes_[i].inflated(SwellRules::kWhiteMm).contains(p)) continue;
      if (is_inside(area_.above[i], p) || is_near_edge(area_.above[i], p)) return false;
    }
    return !is_near_edge(area_.edges, p) &&
           !has_ink_within(area_.ink, area_.near_ink, p,
                           SwellRules::kWhiteMm + 0.5 * SwellRules::kLineMm);
  }
  /// Texture lines have a width, too: the white space is measured between the edges of the ink.
  [[nodiscard]] static bool is_near_edge(const Outline& polygons, Point p) {
    const double limit = SwellRules::kWhiteMm + SwellRules::kLineMm;
    for (std::size_t k = 0; k < polygons.contour_count(); ++k) {
      const std::span<const Point> contour = polygons.contour(k);
      for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
        if (nearest_on_line(contour[j], contour[i], p).distance_squared < limit * limit) {
          return true;
        }
      }
    }
    return false;
  }

  const TextureArea& area_;
  std::size_t& tests_left_;
  Rect box_;
  std::vector<Rect> above_boxes_;
};

}  // namespace

std::optional<std::vector<TextureLine>> texture_of(const TextureArea& area, std::size_t kind,
                                                   std::size_t& tests_left) {
  constexpr double kPitch = SwellRules::kPitchMm;
  constexpr double kHalf = 0.5 * std::numbers::sqrt2;
  constexpr Vec kAcross{1, 0}, kDown{0, 1}, kSlanted{kHalf, kHalf};
  std::vector<TextureLine> lines;
  TextureRows rows(area, tests_left);
  bool is_done = true;
  switch (kind % SwellRules::kTextures) {
    case 0:
      is_done = rows.add(kAcross, kPitch, false, lines);
      break;
    case 1:
      is_done = rows.add(kDown, kPitch, false, lines);
      break;
    case 2:
      is_done = rows.add(kAcross, 1.6 * kPitch, true, lines);
      break;
    case 3:
      is_done = rows.add(kAcross, 2.0 * kPitch, false, lines) &&
                rows.add(kDown, 2.0 * kPitch, false, lines);
      break;
    default:
      is_done = rows.add(kSlanted, kPitch, false, lines);
      break;
  }
  if (!is_done) return std::nullopt;
  return lines;
}

std::vector<std::vector<Point>> bare_edges(const Outline& edges, const TouchLines& ink,
                                           const TouchGrid& near_ink) {
  constexpr double kStep = 0.25;  // less than half a line, whose round ends close the rest
  constexpr double kSimplerMm = 0.02;
  std::vector<std::vector<Point>> bare;
  for (std::size_t k = 0; k < edges.contour_count(); ++k) {
    const std::span<const Point> contour = edges.contour(k);
    std::vector<Point> points;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point a = contour[i], b = contour[(i + 1) % contour.size()];
      const double steps = std::max(1.0, std::ceil(distance(a, b) / kStep));
      for (double j = 0.0; j < steps; ++j) points.push_back(lerp(a, b, j / steps));
    }
    if (points.empty()) continue;
    points.push_back(points.front());
    std::vector<Point> run;
    for (const Point& p : points) {
      if (!has_ink_within(ink, near_ink, p, kCoveredMm)) {
        run.push_back(p);
        continue;
      }
      if (run.size() > 1) bare.push_back(simplified(run, kSimplerMm));
      run.clear();
    }
    if (run.size() > 1) bare.push_back(simplified(run, kSimplerMm));
  }
  return bare;
}

}  // namespace felt
