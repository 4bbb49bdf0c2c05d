#include "felt/tools/guide_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "felt/tools/guide_choice.h"
#include "felt/tools/guide_shape.h"

namespace felt {
namespace {

using Kind = DrawingGuideKind;
using Role = Overlay::Role;
constexpr double kParallelsMm = 10.0;  // chosen: sparse enough to see the drawing
constexpr double kBodyMm = 18.0;       // breadth of a ruler
constexpr int kFanLines = 36;
constexpr double kQuarter = 0.5 * std::numbers::pi;

/// Returns the part of the line through p with direction d that is within the page (Liang and
/// Barsky).
std::optional<std::pair<Point, Point>> on_page_part(Point p, Vec d, const Rect& page) {
  double t0 = -1e9, t1 = 1e9;
  const double ways[4] = {-d.x, d.x, -d.y, d.y};
  const double rooms[4] = {p.x - page.x0, page.x1 - p.x, p.y - page.y0, page.y1 - p.y};
  for (int i = 0; i < 4; ++i) {
    if (ways[i] == 0.0 && rooms[i] < 0.0) return std::nullopt;
    if (ways[i] < 0.0) t0 = std::max(t0, rooms[i] / ways[i]);
    if (ways[i] > 0.0) t1 = std::min(t1, rooms[i] / ways[i]);
  }
  if (!(t0 < t1)) return std::nullopt;
  return std::pair(p + t0 * d, p + t1 * d);
}

/// Adds the lines of one guide.
class GuidePicture {
 public:
  GuidePicture(Overlay& overlay, const DrawingGuide& guide, const Document& document,
               const Rect& page)
      : overlay_(overlay),
        guide_(guide),
        document_(document),
        page_(page),
        along_(direction_of(guide.angle_rad)),
        aside_{-along_.y, along_.x} {}

  void draw() {
    switch (guide_.kind) {
      case Kind::kRuler:
        return ruler();
      case Kind::kLine:
        return infinite(guide_.origin, along_, Role::kRule);
      case Kind::kParallels:
        infinite(guide_.origin, along_, Role::kRule);
        return family(guide_.angle_rad, kParallelsMm, Role::kTick);
      case Kind::kSetSquare:
        return set_square();
      case Kind::kProtractor:
        return protractor();
      case Kind::kCompass:
        ring(4.0, Role::kRule);
        ring(20.0, Role::kTick);
        return cross(6.0);
      case Kind::kEllipse:
        ellipse(1.0, Role::kRule);
        return cross(4.0);
      case Kind::kEllipses:
        for (int i = 1; i <= 8; ++i) ellipse(0.25 * i, i == 4 ? Role::kRule : Role::kTick);
        return cross(4.0);
      case Kind::kPerspective:
        return perspective();
      case Kind::kGrid:
        family(guide_.angle_rad, guide_.size_mm, Role::kTick);
        return family(guide_.angle_rad + kQuarter, guide_.size_mm, Role::kTick);
      case Kind::kIsometricGrid:
        for (int i = 0; i < 3; ++i) {
          family(guide_.angle_rad + i * std::numbers::pi / 3.0,
                 0.5 * std::numbers::sqrt3 * guide_.size_mm, Role::kTick);
        }
        return;
      case Kind::kSymmetry:
        for (int i = 0; i < guide_.axes; ++i) {
          infinite(guide_.origin,
                   direction_of(guide_.angle_rad + i * std::numbers::pi / guide_.axes),
                   Role::kAxis);
        }
        return ring(3.0, Role::kAxis);
      case Kind::kTrace:
        return trace();
      case Kind::kTeacher:
        overlay_.outlines.push_back({guide_.points, false, Role::kRule});
        return;
    }
  }

 private:
  void line(Point from, Point to, Role role) { overlay_.lines.push_back({from, to, role}); }
  void ring(double radius_mm, Role role) {
    overlay_.rings.push_back({guide_.origin, radius_mm, role});
  }
  void cross(double half_mm) {
    line(guide_.origin - half_mm * along_, guide_.origin + half_mm * along_, Role::kTick);
    line(guide_.origin - half_mm * aside_, guide_.origin + half_mm * aside_, Role::kTick);
  }
  void infinite(Point through, Vec d, Role role) {
    if (const auto part = on_page_part(through, d, page_)) line(part->first, part->second, role);
  }

  /// Adds ticks along an edge from the origin: one a millimetre, longer ones at 5 and 10 mm.
  void ticks(Vec edge, Vec inwards, double length_mm) {
    const int step = length_mm <= kMaxGuideLines ? 1 : 10;
    const int last = static_cast<int>(std::min(length_mm, 10.0 * kMaxGuideLines));
    for (int mm = 0; mm <= last; mm += step) {
      const Point foot = guide_.origin + static_cast<double>(mm) * edge;
      const double tick_mm = mm % 10 == 0 ? 4.0 : mm % 5 == 0 ? 3.0 : 1.8;
      line(foot, foot + tick_mm * inwards, Role::kTick);
    }
  }
  void ruler() {
    const Point start = guide_.origin, end = start + guide_.size_mm * along_;
    line(start, end, Role::kRule);
    line(end, end + kBodyMm * aside_, Role::kTick);
    line(end + kBodyMm * aside_, start + kBodyMm * aside_, Role::kTick);
    line(start + kBodyMm * aside_, start, Role::kTick);
    ticks(along_, aside_, guide_.size_mm);
  }
  void set_square() {
    const Point first = guide_.origin + guide_.size_mm * along_,
                second = guide_.origin + guide_.second_mm * aside_;
    overlay_.outlines.push_back({{first, guide_.origin, second}, true, Role::kRule});
    ticks(along_, aside_, guide_.size_mm);
    ticks(aside_, along_, guide_.second_mm);
  }
  void protractor() {
    const double radius_mm = guide_.size_mm;
    ring(radius_mm, Role::kRule);
    for (int deg = 0; deg < 360; ++deg) {
      const Vec d = direction_of(guide_.angle_rad + deg * std::numbers::pi / 180.0);
      const double tick = deg % 10 == 0 ? 0.9 : deg % 5 == 0 ? 0.94 : 0.97;
      line(guide_.origin + tick * radius_mm * d, guide_.origin + radius_mm * d, Role::kTick);
    }
    for (int i = 0; i < ray_count(guide_); ++i) {
      const Vec d = direction_of(guide_.angle_rad + i * guide_.step_rad);
      line(guide_.origin + 0.15 * radius_mm * d, guide_.origin + 0.88 * radius_mm * d,
           i == 0 ? Role::kRule : Role::kTick);
    }
    cross(0.08 * radius_mm);
  }
  void ellipse(double scale, Role role) {
    Overlay::Outline outline{{}, true, role};
    constexpr int kSteps = 96;
    for (int i = 0; i < kSteps; ++i) {
      const Vec d = direction_of(2.0 * std::numbers::pi * i / kSteps);
      outline.points.push_back(guide_.origin + (scale * guide_.size_mm * d.x) * along_ +
                               (scale * guide_.second_mm * d.y) * aside_);
    }
    overlay_.outlines.push_back(std::move(outline));
  }
  /// Returns the point of the edge of the page at a distance along it from its first corner.
  [[nodiscard]] Point point_on_edge(double at_mm) const {
    const double width = page_.width(), height = page_.height();
    Point to{page_.x0, page_.y0};
    for (const Vec side : {Vec{width, 0}, Vec{0, height}, Vec{-width, 0}, Vec{0, -height}}) {
      const double length = norm(side);
      const double part = std::min(at_mm, length);
      if (length > 0.0) to = to + (part / length) * side;
      at_mm -= part;
    }
    return to;
  }
  /// Adds the lines from each vanishing point to equally spaced points of the edge of the page, and
  /// the horizon.
  void perspective() {
    const double width = page_.width(), height = page_.height();
    for (const Point from : guide_.points) {
      for (int i = 0; i < kFanLines; ++i) {
        const Point to = point_on_edge(2.0 * (width + height) * i / kFanLines);
        const double far = distance(from, to);
        if (far > 0.0) fan_line(from, (1.0 / far) * (to - from));
      }
      overlay_.rings.push_back({from, 2.0, Role::kRule});
    }
    if (guide_.points.size() > 1) {
      const Vec horizon = guide_.points[1] - guide_.points[0];
      if (norm(horizon) > 0.0) {
        infinite(guide_.points[0], (1.0 / norm(horizon)) * horizon, Role::kRule);
      }
    }
  }
  void fan_line(Point from, Vec d) {
    const auto part = on_page_part(from, d, page_);
    if (!part) return;
    const bool starts_inside = dot(part->first - from, d) < 0.0;
    line(starts_inside ? from : part->first, part->second, Role::kTick);
  }
  /// Adds parallel lines at this spacing, one of them through the origin.
  void family(double angle_rad, double spacing_mm, Role role) {
    const Vec d = direction_of(angle_rad), n{-d.y, d.x};
    double low = 0.0, high = 0.0;
    bool is_first = true;
    for (const Point corner : {Point{page_.x0, page_.y0}, Point{page_.x1, page_.y0},
                               Point{page_.x0, page_.y1}, Point{page_.x1, page_.y1}}) {
      const double at = dot(corner - guide_.origin, n) / spacing_mm;
      low = is_first ? at : std::min(low, at);
      high = is_first ? at : std::max(high, at);
      is_first = false;
    }
    constexpr int kDenseLines = kMaxGuideLines / 3;
    double step = 1.0;
    for (const double coarser : {2.0, 5.0, 10.0, 100.0, 1000.0, 1e5}) {
      if ((high - low) / step <= kDenseLines) break;
      step = coarser;
    }
    if (!((high - low) / step <= kMaxGuideLines)) return;  // a page of kilometres
    for (double k = std::ceil(low / step) * step; k <= high; k += step) {
      infinite(guide_.origin + (k * spacing_mm) * n, d, role);
    }
  }
  void trace() {
    const StrokePtr stroke = document_.find(guide_.stroke);
    if (!stroke) return;
    Overlay::Outline outline{{}, false, Role::kRule};
    const int n = stroke->segment_count();
    const int steps = n > 2000 ? 1 : 12;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < steps; ++k) {
        outline.points.push_back(evaluate(stroke->segment(i), static_cast<double>(k) / steps));
      }
    }
    outline.points.push_back(stroke->position(n));
    overlay_.outlines.push_back(std::move(outline));
  }

  Overlay& overlay_;
  const DrawingGuide& guide_;
  const Document& document_;
  const Rect& page_;
  Vec along_, aside_;
};

}  // namespace

void add_guide_picture(Overlay& overlay, const DrawingGuide& guide, const Document& document,
                       const Rect& page) {
  GuidePicture(overlay, guide, document, page).draw();
}

void add_guide_pictures(Overlay& overlay, const Document& document, const Edit* preview,
                        const Rect& page) {
  const bool toggles = preview && preview->toggles_guides;
  if (document.shows_guides() == toggles) return;
  const auto change_of = [preview](GuideId id) -> const GuideChange* {
    if (!preview) return nullptr;
    const auto found = std::find_if(preview->guides.begin(), preview->guides.end(),
                                    [id](const GuideChange& c) { return c.id == id; });
    return found == preview->guides.end() ? nullptr : &*found;
  };
  for (const auto& [id, guide] : document.guides()) {
    if (!change_of(id)) add_guide_picture(overlay, *guide, document, page);
  }
  if (!preview) return;
  for (const GuideChange& c : preview->guides) {
    if (c.after) add_guide_picture(overlay, *c.after, document, page);
  }
}

Rect guide_extent(const DrawingGuide& guide) noexcept {
  constexpr double kAroundMm = 20.0;
  Rect extent;
  for (const Point p : guide.points) extent.extend(p);
  if (!guide.points.empty()) return extent;
  if (guide.kind == Kind::kTrace) return extent;  // that of its stroke
  extent.extend(guide.origin);
  const Vec along = direction_of(guide.angle_rad), aside{-along.y, along.x};
  const double size_mm = guide.size_mm, second_mm = guide.second_mm;
  switch (guide.kind) {
    case Kind::kRuler:
      extent.extend(guide.origin + size_mm * along);
      return extent.inflated(kBodyMm);
    case Kind::kSetSquare:
      extent.extend(guide.origin + size_mm * along);
      extent.extend(guide.origin + second_mm * aside);
      return extent;
    case Kind::kProtractor:
      return extent.inflated(size_mm);
    case Kind::kEllipse:
      return extent.inflated(std::max(size_mm, second_mm));
    case Kind::kEllipses:
      return extent.inflated(2.0 * std::max(size_mm, second_mm));
    default:
      return extent.inflated(kAroundMm);
  }
}

void add_ink_images(Overlay& overlay, const DrawingGuide& symmetry) {
  const SymmetryGroup group{symmetry.origin, symmetry.angle_rad, symmetry.axes, {}};
  for (int image = 1; image < 2 * group.axes; ++image) {
    overlay.ink_images.push_back(image_map(group, image));
  }
}

}  // namespace felt
