#include "felt/io/svg/svg_fill.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "felt/io/ndjson/json_text.h"
#include "felt/io/svg/svg_nonzero.h"
#include "felt/stroke/outline/outline.h"

namespace felt {
namespace {

constexpr double kAreaToleranceMm = 0.02;
/// Bound of the work to find crossings of one shape: less than 0.2 s.
constexpr std::size_t kMaxEdgePairs = 20'000'000;

FillLoop loop_of(const SvgContour& contour, const Affine& to_mm) {
  FillLoop loop{contour.points, {}};
  if (loop.points.front() != loop.points.back()) {
    const Point a = loop.points.back(), b = loop.points.front();
    loop.points.insert(loop.points.end(), {lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b});
  }
  for (Point& p : loop.points) p = apply(to_mm, p);
  loop.points.back() = loop.points.front();
  return loop;
}

double side_of(Point p, Point a, Point b) {
  return cross(b - a, p - a);
}

/// Returns how often a closed polygon winds around a point.
int winding(std::span<const Point> polygon, Point p) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.y <= p.y && b.y > p.y && side_of(p, a, b) > 0.0) ++turns;
    if (a.y > p.y && b.y <= p.y && side_of(p, a, b) < 0.0) --turns;
  }
  return turns;
}

/// Returns twice the signed area of a polygon. Its sign is that of winding() inside.
double signed_area(std::span<const Point> polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    area += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return area;
}

enum class SvgCrossings { kNone, kSome, kUnknown };

/// An edge of a polygon with its bounds.
struct OutlineEdge {
  Point a, b;
  Rect box;
};

/// Returns whether two edges of the polygons properly cross each other. Compares only edges that
/// overlap in x, from left to right; the result is unknown if that takes more than kMaxEdgePairs
/// comparisons.
SvgCrossings crossings_of(const Outline& outline) {
  std::vector<OutlineEdge> edges;
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    const auto polygon = outline.contour(k);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      OutlineEdge edge{polygon[i], polygon[(i + 1) % polygon.size()], {}};
      edge.box.extend(edge.a);
      edge.box.extend(edge.b);
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const OutlineEdge& e, const OutlineEdge& f) { return e.box.x0 < f.box.x0; });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, box] = edges[i];
    for (std::size_t k = i + 1; k < edges.size() && edges[k].box.x0 <= box.x1; ++k) {
      if (++pairs > kMaxEdgePairs) return SvgCrossings::kUnknown;
      const auto& [c, d, other] = edges[k];
      if (other.y0 > box.y1 || other.y1 < box.y0) continue;
      if (side_of(c, a, b) * side_of(d, a, b) < 0.0 && side_of(a, c, d) * side_of(b, c, d) < 0.0) {
        return SvgCrossings::kSome;
      }
    }
  }
  return SvgCrossings::kNone;
}

/// Returns true if contour k separates painted from unpainted parts by the non-zero rule. Requires
/// that the contours do not cross.
bool separates(const Outline& outline, std::size_t k) {
  const auto own = outline.contour(k);
  int around = 0;
  for (std::size_t i = 0; i < outline.contour_count(); ++i) {
    if (i != k) around += winding(outline.contour(i), own.front());
  }
  const double area = signed_area(own);
  const int inside = around + (area > 0.0 ? 1 : area < 0.0 ? -1 : 0);
  return (around == 0) != (inside == 0);
}

/// Splits off and returns the text before `mark`, or all of it if it has no such mark.
std::string_view split_off(std::string_view& text, char mark) {
  const std::size_t at = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return part;
}

template <class Number>
bool parse(std::string_view text, Number& out) {
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && rest == text.data() + text.size();
}

}  // namespace

SvgArea svg_area(const std::vector<SvgContour>& contours, const Affine& to_mm, bool even_odd) {
  SvgArea area;
  for (const SvgContour& contour : contours) area.fill.loops.push_back(loop_of(contour, to_mm));
  if (even_odd || !check_fill(area.fill)) return area;
  Outline outline;
  flatten_fill(area.fill, kAreaToleranceMm, outline);
  const SvgCrossings crossings = crossings_of(outline);
  if (crossings != SvgCrossings::kNone) {
    area.may_lack_parts =
        crossings == SvgCrossings::kUnknown || !resolve_crossings(area.fill.loops);
    return area;
  }
  if (contours.size() == 1) return area;
  std::vector<FillLoop> kept;
  for (std::size_t k = 0; k < contours.size(); ++k) {
    if (separates(outline, k)) kept.push_back(std::move(area.fill.loops[k]));
  }
  area.fill.loops = std::move(kept);
  return area;
}

std::string fill_pieces_text(const Fill& fill) {
  std::string text;
  append_number(text, fill.max_gap_mm);
  text += ';';
  for (const FillLoop& loop : fill.loops) {
    for (std::size_t i = 0; i < loop.pieces.size(); ++i) {
      const FillPiece& piece = loop.pieces[i];
      if (i > 0) text += ',';
      if (!piece.stroke) {
        text += '-';
        continue;
      }
      text += std::to_string(piece.stroke.value) + ' ';
      append_number(text, piece.from);
      text += ' ';
      append_number(text, piece.to);
    }
    text += ';';
  }
  return text;
}

bool read_fill_pieces(std::string_view text, Fill& fill) {
  Fill read = fill;
  if (!parse(split_off(text, ';'), read.max_gap_mm)) return false;
  for (FillLoop& loop : read.loops) {
    std::string_view pieces = split_off(text, ';');
    loop.pieces.clear();
    while (!pieces.empty()) {
      std::string_view one = split_off(pieces, ',');
      FillPiece piece;
      if (one != "-") {
        const std::string_view id = split_off(one, ' '), from = split_off(one, ' ');
        if (!parse(id, piece.stroke.value) || !parse(from, piece.from) || !parse(one, piece.to)) {
          return false;
        }
      }
      loop.pieces.push_back(piece);
    }
  }
  if (!text.empty() || !check_fill(read)) return false;
  fill = std::move(read);
  return true;
}

}  // namespace felt
