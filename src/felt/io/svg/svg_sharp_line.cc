#include "felt/io/svg/svg_sharp_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "felt/stroke/stroke.h"

namespace felt {
namespace {

/// Corners that differ less than this from a round one stay round.
constexpr double kVisibleMm = 0.05;
/// The drawn width is smoothed where it begins to change, but not at a jump (kJump). A jump at both
/// ends of a cone keeps its sides straight: a change of the width by this part of the cone's
/// length.
constexpr double kEdgeStep = 3.0 * kSvgJumpU;

enum class Turn { kRound, kMiter, kBevel, kFlatEnd };

/// A part of the line between two sharp corners or ends.
struct SharpRun {
  std::vector<Cubic> curves;
  double length = 0.0;

  [[nodiscard]] Point first() const { return curves.front().p[0]; }
  [[nodiscard]] Point last() const { return curves.back().p[3]; }
  [[nodiscard]] Vec first_direction() const { return tangent(curves.front(), 0.0); }
  [[nodiscard]] Vec last_direction() const { return tangent(curves.back(), 1.0); }

  void add(const Cubic& c) {
    curves.push_back(c);
    length += arc_length(c);
  }
};

/// Removes handles that are too short to be seen at this width, because their direction would be
/// that of a flat end or a corner.
Cubic without_tiny_handles(Cubic c, double width) {
  const double tiny = 0.05 * width;
  if (distance(c.p[0], c.p[3]) < width) return c;
  if (distance(c.p[0], c.p[1]) < tiny) c.p[1] = c.p[0];
  if (distance(c.p[3], c.p[2]) < tiny) c.p[2] = c.p[3];
  return c;
}

/// Returns the part of a run without `from_first` and `from_last` mm at its ends; nothing if no
/// length is left.
std::vector<Cubic> trimmed(const SharpRun& run, double from_first, double from_last) {
  std::vector<Cubic> result;
  const double end = run.length - from_last;
  double at = 0.0;
  for (const Cubic& c : run.curves) {
    const double length = arc_length(c);
    const double a = std::max(from_first - at, 0.0), b = std::min(end - at, length);
    at += length;
    if (!(b - a > 1e-6)) continue;
    result.push_back(sub_segment(c, a > 0.0 ? parameter_at_length(c, a) : 0.0,
                                 b < length ? parameter_at_length(c, b) : 1.0));
  }
  return result;
}

/// Draws the centre line.
class SharpPen {
 public:
  SharpPen(Point begin, double width) : width_(width) {
    line_.contour.points = {begin};
    line_.widths = {{width, width}};
  }

  void go(Point p, double width) { go(p, {width, width}); }

  void go(Point p, SvgSharpWidth width) {
    const Cubic c = straight(here(), p);
    line_.contour.points.insert(line_.contour.points.end(), {c.p[1], c.p[2], p});
    line_.widths.push_back(width);
  }

  void follow(const std::vector<Cubic>& curves) {
    for (const Cubic& c : curves) {
      line_.contour.points.insert(line_.contour.points.end(), {c.p[1], c.p[2], c.p[3]});
      line_.widths.push_back({width_, width_});
    }
  }

  /// Fills the cone around the disc here and the point `tip`. The thinnest ink is a small disc, so
  /// its centre stays as far from the tip as that disc fits into the cone.
  void spike(Point tip) {
    const Point from = here();
    const double width = line_.widths.back().after_mm;
    const double step = kEdgeStep * distance(from, tip);
    if (!(width > kMinWidthMm + 2.0 * step)) return;
    line_.widths.back().after_mm = width - step;
    go(from + (1.0 - kMinWidthMm / width) * (tip - from), {kMinWidthMm, kMinWidthMm + step});
    go(from, {kMinWidthMm + step, width});
  }

  /// Fills both corners of the flat end at `end` of the line, which has the direction `along`.
  void flat_end(Point end, Vec along) {
    const Vec side = 0.5 * width_ * perp(along);
    spike(end + side);
    spike(end - side);
  }

  [[nodiscard]] Point here() const { return line_.contour.points.back(); }
  [[nodiscard]] SvgSharpLine take() { return std::move(line_); }

 private:
  SvgSharpLine line_;
  double width_;
};

class Sharpener {
 public:
  Sharpener(const SvgContour& contour, const SvgSharpForm& form)
      : form_(form), radius_(0.5 * form.width_mm), closed_(contour.closed) {
    split(contour);
  }

  SvgSharpLine run() {
    if (runs_.empty() || (closed_ && turns_.front() == Turn::kRound)) return {};
    if (!closed_ && runs_.size() == 1 && turns_.front() == Turn::kFlatEnd &&
        runs_[0].length < form_.width_mm - 1e-6) {
      return short_line(runs_[0]);
    }
    const bool fits = round_what_does_not_fit();
    SvgSharpLine line = draw();
    line.is_exact = fits;
    return line;
  }

 private:
  /// Returns how the line turns from one direction to another.
  [[nodiscard]] Turn turn_between(Vec a, Vec b) const {
    const double half = 0.5 * angle_between(a, b), narrow = std::cos(half);
    if (form_.join == SvgJoin::kMiter && narrow * form_.miter_limit >= 1.0) {
      return radius_ * (1.0 / narrow - 1.0) > kVisibleMm ? Turn::kMiter : Turn::kRound;
    }
    if (form_.join == SvgJoin::kRound) return Turn::kRound;
    return radius_ * (1.0 - narrow) > kVisibleMm ? Turn::kBevel : Turn::kRound;
  }

  /// Splits the contour at its sharp corners. A closed contour begins at the first of them.
  void split(const SvgContour& contour) {
    std::vector<Cubic> curves;
    for (std::size_t i = 0; i < contour.segment_count(); ++i) {
      const Cubic c = contour.segment(i);
      if (control_length(c) > 1e-6) curves.push_back(without_tiny_handles(c, form_.width_mm));
    }
    if (curves.empty() && form_.cap == SvgCap::kSquare) {
      curves.push_back(square_dot(contour.points.front()));
    }
    if (curves.empty()) return;
    const std::size_t n = curves.size();
    const auto before = [&](std::size_t i) {
      return turn_between(tangent(curves[(i + n - 1) % n], 1.0), tangent(curves[i % n], 0.0));
    };
    std::size_t begin = 0;
    while (closed_ && begin + 1 < n && before(begin) == Turn::kRound) ++begin;
    const Turn end = form_.cap == SvgCap::kRound ? Turn::kRound : Turn::kFlatEnd;
    turns_.push_back(closed_ ? before(begin) : end);
    runs_.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      const Turn turn = k == 0 ? Turn::kRound : before(begin + k);
      if (turn != Turn::kRound) {
        turns_.push_back(turn);
        runs_.emplace_back();
      }
      runs_.back().add(curves[(begin + k) % n]);
    }
    turns_.push_back(turns_.front());
    if (!closed_ && form_.cap == SvgCap::kSquare) extend();
  }

  /// As in SVG, a dot has no direction, so its square is parallel to the axes.
  [[nodiscard]] Cubic square_dot(Point p) {
    closed_ = false;
    form_.cap = SvgCap::kButt;
    return straight(p - Vec{radius_, 0.0}, p + Vec{radius_, 0.0});
  }

  /// Square ends are flat ends of a line that is longer by half of its width.
  void extend() {
    SharpRun& first = runs_.front();
    const Point a = first.first();
    const Cubic lead = straight(a - radius_ * first.first_direction(), a);
    first.curves.insert(first.curves.begin(), lead);
    first.length += radius_;
    const Point b = runs_.back().last();
    runs_.back().add(straight(b, b + radius_ * runs_.back().last_direction()));
  }

  /// Returns the length that the turn takes away from the runs on both sides.
  [[nodiscard]] double room(Turn turn) const {
    return turn == Turn::kBevel || turn == Turn::kFlatEnd ? radius_ : 0.0;
  }

  /// Makes corners and ends round if the run between them is too short. Returns false if there are
  /// any.
  bool round_what_does_not_fit() {
    bool fits = true;
    const std::size_t last = turns_.size() - 1;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[k].length >= room(turns_[k]) + room(turns_[k + 1]) - 1e-6) continue;
      fits = false;
      for (Turn* turn : {&turns_[k], &turns_[k + 1]}) {
        if (room(*turn) > 0.0) *turn = Turn::kRound;
      }
      if (closed_ && k == 0) turns_[last] = turns_[0];
      if (closed_ && k + 1 == last) turns_[0] = turns_[last];
    }
    return fits;
  }

  SvgSharpLine draw() {
    const auto part = [this](std::size_t k) {
      return trimmed(runs_[k], room(turns_[k]), room(turns_[k + 1]));
    };
    std::vector<Cubic> curves = part(0);
    const auto begin_of = [&](std::size_t k) {
      const SharpRun& run = runs_[k];
      if (!curves.empty()) return curves.front().p[0];
      return run.first() + room(turns_[k]) * run.first_direction();
    };
    const SharpRun& first = runs_.front();
    const Point begin = begin_of(0);
    SharpPen pen(begin, form_.width_mm);
    if (!closed_ && turns_[0] == Turn::kFlatEnd) {
      pen.flat_end(first.first(), first.first_direction());
    }
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      pen.follow(curves);
      const bool is_last = k + 1 == runs_.size();
      if (is_last && !closed_) break;
      if (!is_last) curves = part(k + 1);
      const Point next = is_last ? begin : begin_of(k + 1);
      corner(pen, turns_[k + 1], runs_[k], runs_[(k + 1) % runs_.size()], next);
    }
    const SharpRun& end = runs_.back();
    if (!closed_ && turns_.back() == Turn::kFlatEnd) {
      pen.flat_end(end.last(), end.last_direction());
    }
    SvgSharpLine line = pen.take();
    line.contour.closed = closed_;
    if (closed_) line.contour.points.back() = begin;
    return line;
  }

  /// Draws the corner between two runs; the pen is at the end of the first one and ends at `next`.
  void corner(SharpPen& pen, Turn turn, const SharpRun& a, const SharpRun& b, Point next) const {
    const Vec in = a.last_direction(), out = b.first_direction();
    const Point at = a.last();
    const double narrow = std::cos(0.5 * angle_between(in, out));
    if (turn == Turn::kMiter) pen.spike(at + radius_ / narrow * normalized(in - out));
    if (turn != Turn::kBevel) return;
    // Both runs end flat. The disc at the corner touches the cut, and two cones from it fill the
    // triangle up to the cut.
    pen.flat_end(at, in);
    pen.go(at, std::max(kMinWidthMm, form_.width_mm * narrow));
    const double outer = cross(in, out) > 0.0 ? -radius_ : radius_;
    pen.spike(at + outer * perp(in));
    pen.spike(at + outer * perp(out));
    pen.go(next, form_.width_mm);
    pen.flat_end(at, out);
  }

  /// Returns a line that is shorter than its width: a line across it. A bent one becomes a dot.
  [[nodiscard]] SvgSharpLine short_line(const SharpRun& run) const {
    const Vec along = run.last() - run.first();
    const double length = norm(along);
    const Point middle = lerp(run.first(), run.last(), 0.5);
    if (length < 0.98 * run.length || length < kMinWidthMm) {
      SvgSharpLine dot;
      dot.contour.points.assign(4, middle);
      dot.widths.assign(2, {form_.width_mm, form_.width_mm});
      dot.is_exact = false;
      return dot;
    }
    const Vec across = normalized(perp(along)), half = (radius_ - 0.5 * length) * across;
    SharpPen pen(middle - half, length);
    const auto ends = [&](double side) {
      for (const double k : {-0.5, 0.5}) pen.spike(middle + side * radius_ * across + k * along);
    };
    ends(-1.0);
    pen.go(middle + half, length);
    ends(1.0);
    return pen.take();
  }

  SvgSharpForm form_;
  double radius_;
  bool closed_;
  std::vector<SharpRun> runs_;
  std::vector<Turn> turns_;  ///< before each run, and after the last one
};

}  // namespace

SvgSharpLine sharp_line(const SvgContour& contour, const SvgSharpForm& form) {
  SvgSharpLine line = Sharpener(contour, form).run();
  if (!line.contour.points.empty()) return line;
  const SvgSharpWidth same{form.width_mm, form.width_mm};
  return {contour, std::vector<SvgSharpWidth>(contour.segment_count() + 1, same)};
}

std::optional<SvgSharpLine> slanted_line(Point a, Point b, Vec half_end) {
  const double length = distance(a, b), end = norm(half_end);
  const Vec along = normalized(b - a);
  const double width = 2.0 * std::fabs(cross(along, half_end));
  if (!(width >= kMinSharpWidthMm && width <= kMaxSharpWidthMm)) return std::nullopt;
  // A disc that touches both sides also touches the end if its centre is `end` away from it: the
  // distance to the end is that times the sine of the slant, which is half the width over `end`.
  if (!(length >= 2.0 * end)) return std::nullopt;
  SharpPen pen(a + end * along, width);
  pen.spike(a + half_end);
  pen.spike(a - half_end);
  pen.go(b - end * along, width);
  pen.spike(b + half_end);
  pen.spike(b - half_end);
  return pen.take();
}

}  // namespace felt
