#include "felt/io/svg/svg_fill.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "felt/io/ndjson/json_text.h"
#include "felt/io/svg/svg_nonzero.h"

namespace felt {
namespace {

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
  area.may_lack_parts = !make_even_odd(area.fill.loops);
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
