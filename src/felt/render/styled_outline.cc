#include "felt/render/styled_outline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <list>
#include <type_traits>
#include <utility>

#include "felt/render/style_layout.h"
#include "felt/render/style_pen.h"
#include "felt/render/style_spine.h"

namespace felt {
namespace {

/// Distance of the points of a spine, in widths. Rails and hatching need more points than the
/// curve itself, because they are cut at points of the spine.
constexpr double kFineStep = 0.125, kCoarseStep = 4.0;
/// The fraction of the tolerance for the centre line; the rest is for the edges.
constexpr double kCenterShare = 0.5;
/// The tolerance with which lines are measured, in widths.
constexpr double kMeasureShare = 0.01;
/// Lines shorter than this many widths have no style.
constexpr double kShortest = 0.5;
/// How far the shaft of an arrow reaches into the head, as a share of the head.
constexpr double kNotch = 0.25;
/// Largest distance between the ends of a line that is hatched, as a share of its length and of the
/// diagonal of its box: loops that are drawn by hand seldom meet exactly, but a spiral or a wave is
/// none (chosen by eye).
constexpr double kOpening = 0.1, kOpeningOfBox = 0.25;
/// Points that a dash may have, and a shape for each of its control points, for the limits of
/// dashes and repeats. A curve of a shape becomes at most 64 lines.
constexpr double kPointsOfDash = 64.0, kPointsOfControl = 24.0;

StyleShape arrow_head() {
  const auto line = [](Point a, Point b, std::vector<Point>& to) {
    to.insert(to.end(), {lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b});
  };
  const Point tip{1.0, 0.0}, left{0.0, -0.5}, notch{kNotch, 0.0}, right{0.0, 0.5};
  std::vector<Point> contour{tip};
  line(tip, left, contour);
  line(left, notch, contour);
  line(notch, right, contour);
  line(right, tip, contour);
  return {{std::move(contour)}};
}

double points_of(const StyleShape& shape) noexcept {
  std::size_t count = 0;
  for (const std::vector<Point>& contour : shape.contours) count += contour.size();
  return static_cast<double>(std::max<std::size_t>(count, 1));
}

template <class T>
bool has_bytes_of(std::span<const T> a, std::span<const T> b) noexcept {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

struct StrokeStyler::State {
  struct Kept {
    std::vector<Point> points;
    std::vector<WidthKnot> widths;
    std::vector<JointKind> joints;
    bool closed = false;
    MediumStyle style;
    double tolerance = 0.0;
    StyledInk ink;

    [[nodiscard]] bool is_of(const Stroke& stroke, const MediumStyle& how,
                             double tolerance_mm) const noexcept {
      const StrokeData& d = stroke.data();
      return tolerance == tolerance_mm && closed == d.closed && style == how &&
             has_bytes_of(std::span<const Point>(points), std::span<const Point>(d.points)) &&
             has_bytes_of(std::span<const WidthKnot>(widths),
                          std::span<const WidthKnot>(d.widths)) &&
             joints == d.joints;
    }
  };

  void flatten_coarsely(const Stroke& stroke, double tolerance);
  void set_marks(const Stroke& stroke);
  void flatten_stroke(const Stroke& stroke, double tolerance_mm);
  void make(const StyledRow& row, const StrokeStyle& style, double tolerance, StyledInk& ink);
  [[nodiscard]] bool goes_round() const noexcept;
  StyleSpan draw_arrows(const MediumStyle& how);
  void draw_line(const StyledRow& row, const StrokeStyle& style, StyleSpan range);

  Spine spine;
  StylePen pen;
  std::vector<Dab> dabs;
  std::vector<std::size_t> ends, corners;
  std::vector<RowMark> marks;  // of the ends
  StyleShape head = arrow_head();
  std::list<Kept> kept;         // the one that was used last is the last
  std::size_t kept_points = 0;  // in `kept`
  StyledInk loose;              // of a row
  std::size_t made = 0;
};

/// Sets the dabs of a stroke. A stroke with very many dabs is flattened coarsely.
void StrokeStyler::State::flatten_coarsely(const Stroke& stroke, double tolerance) {
  flatten(stroke, 0, stroke.segment_count(), tolerance, dabs, ends);
  for (int i = 0; i < 16 && dabs.size() > Spine::kMaxPoints; ++i) {
    tolerance *= 4.0;
    flatten(stroke, 0, stroke.segment_count(), tolerance, dabs, ends);
  }
}

/// Measures the segments with a tolerance that depends on the stroke only.
void StrokeStyler::State::set_marks(const Stroke& stroke) {
  double width = 0.0;
  for (const WidthKnot& knot : stroke.widths()) width += knot.width_mm;
  flatten_coarsely(stroke, kMeasureShare * width / static_cast<double>(stroke.widths().size()));
  marks.clear();
  double along = 0.0;
  std::size_t i = 0;
  for (const std::size_t end : ends) {
    for (; i < end; ++i) along += length_in_widths(dabs[i], dabs[i + 1]);
    marks.push_back({0, along});
  }
}

/// Sets the dabs of a stroke, their marks and their corners.
void StrokeStyler::State::flatten_stroke(const Stroke& stroke, double tolerance_mm) {
  set_marks(stroke);
  flatten_coarsely(stroke, kCenterShare * tolerance_mm);
  for (std::size_t k = 0; k < ends.size(); ++k) marks[k].dab = ends[k];
  corners.clear();
  const int n = stroke.segment_count();
  const auto is_corner = [&stroke](int before, int after) {
    return dot(tangent(stroke.segment(before), 1.0), tangent(stroke.segment(after), 0.0)) <
           Spine::kBlunt;
  };
  if (stroke.closed() && stroke.joint(n) == JointKind::kCorner && is_corner(n - 1, 0)) {
    corners.push_back(0);
  }
  for (int i = 1; i < n; ++i) {
    if (stroke.joint(i) == JointKind::kCorner && is_corner(i - 1, i)) {
      corners.push_back(ends[static_cast<std::size_t>(i) - 1]);
    }
  }
}

/// Returns true if the line encloses an area.
bool StrokeStyler::State::goes_round() const noexcept {
  if (spine.closed()) return true;
  Rect box;
  for (const SpinePoint& p : spine.points()) box.extend(p.center);
  const SpinePoint &first = spine.points().front(), &last = spine.points().back();
  return distance(first.center, last.center) <=
         std::min(kOpening * last.length, kOpeningOfBox * std::hypot(box.width(), box.height()));
}

/// Draws the arrow heads, and returns the part of the line for the rest of the style.
StyleSpan StrokeStyler::State::draw_arrows(const MediumStyle& how) {
  StyleSpan rest{0.0, spine.end()};
  if (spine.closed() || how.arrows == StyleArrows::kNone) return rest;
  const bool at_start = how.arrows != StyleArrows::kEnd, at_end = how.arrows != StyleArrows::kStart;
  const double size = std::min(how.arrow_length, spine.end() / (at_start && at_end ? 2.0 : 1.0));
  const double shaft = (1.0 - kNotch) * size;
  if (at_end) {
    pen.shape({spine.end() - size, spine.end()}, head);
    rest.to -= shaft;
  }
  if (at_start) {
    pen.shape({size, 0.0}, head);
    rest.from += shaft;
  }
  return rest;
}

void StrokeStyler::State::draw_line(const StyledRow& row, const StrokeStyle& style,
                                    StyleSpan range) {
  const MediumStyle& how = style.how;
  const auto most = static_cast<double>(kMaxPoints);
  switch (how.kind) {
    case StyleKind::kPlain:
      return pen.line(range, how.thin);
    case StyleKind::kDashes:
      for (const StyleSpan dash :
           dash_spans(spine, range, {how.length, how.gap, how.thin, most / kPointsOfDash})) {
        pen.line(dash, how.thin);
      }
      return;
    case StyleKind::kDouble:
      return pen.rails(range, how.thin);
    case StyleKind::kRepeat:
      for (const StyleSpan span : repeat_spans(
               spine, range,
               {how.length, how.gap, 0.0, most / (kPointsOfControl * points_of(style.shape))})) {
        pen.shape(span, style.shape);
      }
      return;
    case StyleKind::kStretch:
      return pen.shape(range, style.shape);
    case StyleKind::kHatch:
      pen.line(range, 1.0);
      if (row.units_per_mm > 0.0 && goes_round()) {
        pen.hatching(how.angle_deg, how.spacing_mm * row.units_per_mm, how.thin);
      }
  }
}

void StrokeStyler::State::make(const StyledRow& row, const StrokeStyle& style, double tolerance,
                               StyledInk& ink) {
  ++made;
  const bool is_fine = style.how.kind == StyleKind::kDouble;
  spine.build(row, is_fine ? kFineStep : kCoarseStep);
  pen.begin(spine, tolerance, ink);
  if (!(spine.end() >= kShortest)) {
    StrokeOutliner plain;
    ink.outline = plain.trace(row.dabs, row.closed, tolerance);
    return;
  }
  const StyleSpan rest = draw_arrows(style.how);
  draw_line(row, style, rest);
}

StrokeStyler::StrokeStyler() : state_(std::make_unique<State>()) {}
StrokeStyler::~StrokeStyler() = default;
StrokeStyler::StrokeStyler(StrokeStyler&&) noexcept = default;
StrokeStyler& StrokeStyler::operator=(StrokeStyler&&) noexcept = default;

const StyledInk& StrokeStyler::ink(const Stroke& stroke, const StrokeStyle& style,
                                   double tolerance_mm) {
  State& s = *state_;
  const auto found = std::find_if(s.kept.begin(), s.kept.end(), [&](const State::Kept& kept) {
    return kept.is_of(stroke, style.how, tolerance_mm);
  });
  if (found != s.kept.end()) {
    s.kept.splice(s.kept.end(), s.kept, found);
    return s.kept.back().ink;
  }
  while (!s.kept.empty() && (s.kept.size() >= kMaxKept || s.kept_points > kMaxPoints)) {
    s.kept_points -= s.kept.front().ink.outline.points.size();
    s.kept.pop_front();
  }
  const StrokeData& d = stroke.data();
  State::Kept& kept = s.kept.emplace_back(
      State::Kept{d.points, d.widths, d.joints, d.closed, style.how, tolerance_mm, {}});
  s.flatten_stroke(stroke, tolerance_mm);
  s.make({s.dabs, s.corners, d.closed, false, 1.0, s.marks}, style, tolerance_mm, kept.ink);
  s.kept_points += kept.ink.outline.points.size();
  return kept.ink;
}

const StyledInk& StrokeStyler::ink(const StyledRow& row, const StrokeStyle& style,
                                   double tolerance) {
  state_->make(row, style, tolerance, state_->loose);
  return state_->loose;
}

std::size_t StrokeStyler::made_count() const noexcept {
  return state_->made;
}

OutlinePath styled_path(const Stroke& stroke, const StrokeStyle* style, double tolerance_mm) {
  if (!style) return outline_path(stroke, tolerance_mm);
  StrokeStyler styler;
  const Outline& outline = styler.ink(stroke, *style, tolerance_mm).outline;
  OutlinePath path;
  path.points = outline.points;
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    path.verbs.push_back(OutlinePath::Verb::kMove);
    path.verbs.insert(path.verbs.end(), outline.contour(k).size() - 1, OutlinePath::Verb::kLine);
    path.verbs.push_back(OutlinePath::Verb::kClose);
  }
  return path;
}

}  // namespace felt
