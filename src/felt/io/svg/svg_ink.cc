#include "felt/io/svg/svg_ink.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/io/limits.h"
#include "felt/io/svg/svg_center_line.h"
#include "felt/io/svg/svg_clip.h"
#include "felt/io/svg/svg_dashes.h"
#include "felt/io/svg/svg_fill.h"
#include "felt/io/svg/svg_line_width.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_sharp_line.h"
#include "felt/io/svg/svg_variable_width.h"
#include "felt/io/xml/material_texts.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

/// Notice for ink that is farther from (0, 0) than files can store.
constexpr const char* kFar = "extends beyond 1e9 mm and was skipped";
constexpr const char* kOutsideFrame = "is outside the frame that shows it and was skipped";

Rect bounds_mm(const SvgShape& shape) {
  Rect box;
  for (const SvgContour& c : shape.contours) {
    for (const Point& p : c.points) box.extend(apply(shape.to_mm, p));
  }
  return box;
}

/// Returns true if all points lie on one straight line, so that a fill shows nothing.
bool is_flat(const std::vector<Point>& points) {
  const Point a = points.front();
  Vec longest;
  for (const Point& p : points) {
    if (norm_squared(p - a) > norm_squared(longest)) longest = p - a;
  }
  const double size = norm_squared(longest);
  return std::all_of(points.begin(), points.end(),
                     [&](Point p) { return std::fabs(cross(longest, p - a)) <= 1e-12 * size; });
}

/// Returns true if no loop covers an area. `loops` are contours or loops of a fill.
template <class Loops>
bool are_flat(const Loops& loops) {
  return std::all_of(loops.begin(), loops.end(),
                     [](const auto& loop) { return is_flat(loop.points); });
}

bool shows_filling(const SvgShape& shape) {
  return shape.fill && !are_flat(shape.contours);
}

bool is_far(const Rect& r) {
  return !(r.x0 >= -kMaxCoordinateMm && r.y0 >= -kMaxCoordinateMm && r.x1 <= kMaxCoordinateMm &&
           r.y1 <= kMaxCoordinateMm);
}

std::optional<Page> page_of(double width_mm, double height_mm) {
  const auto fits = [](double mm) { return mm >= Page::kMinMm && mm <= Page::kMaxMm; };
  if (!fits(width_mm) || !fits(height_mm)) return std::nullopt;
  return Page{width_mm, height_mm};
}

/// "297 210 #rrggbbaa"
std::optional<Page> written_page(std::string_view text) {
  SvgScan scan(text);
  double width = 0.0, height = 0.0;
  if (!scan.number(width) || !scan.take(' ') || !scan.number(height) || !scan.take(' ')) {
    return std::nullopt;
  }
  const std::optional<Rgba> paper = color_from_text(scan.rest());
  std::optional<Page> page = page_of(width, height);
  if (page && paper) page->paper = *paper;
  return paper ? page : std::nullopt;
}

}  // namespace

void SvgInk::say(const SvgShape& shape, std::string what) {
  notice(shape.line_number, svg_element_text(shape.element, shape.id), std::move(what));
}

void SvgInk::notice(std::int64_t line, std::string element, std::string what) {
  report_.add(line, svg_clean_name(element), std::move(what));
}

void SvgInk::root(const SvgRoot& root) {
  is_ours_ = root.is_ours;
  has_page_attribute_ = !root.page.empty();
  Drawing& drawing = builder_.drawing();
  for (const std::string_view text : root.materials) {
    if (add_material_text(drawing.materials, text)) continue;
    notice(0, "svg", "has an invalid or too long material, which was skipped");
  }
  const auto set_page = [&drawing](const std::optional<Page>& page) {
    drawing.has_page = page.has_value();
    drawing.page = page.value_or(Page{});
  };
  has_size_ = root.is_ours || root.width_mm || root.height_mm;
  if (root.is_ours && has_page_attribute_) {
    set_page(written_page(root.page));
    drawing.page.surface = root.surface;
    return;
  }
  if (!root.begins_at_zero || !root.width_mm || !root.height_mm) return;
  set_page(page_of(*root.width_mm, *root.height_mm));
  if (!drawing.has_page) {
    notice(0, "svg", "has an invalid page size, which was ignored");
  } else if (is_ours_) {
    drawing.page.paper = {0, 0, 0, 0};
  }
}

void SvgInk::paper(Rgba color) {
  Drawing& drawing = builder_.drawing();
  if (drawing.has_page && !has_page_attribute_) drawing.page.paper = color;
}

void SvgInk::add_shape(SvgShape shape) {
  has_part_ = false;
  const bool lowest = std::exchange(may_be_paper_, false);
  if (lowest && take_as_paper(shape)) return;
  if (outside_frame(shape)) return;
  if (shape.variable_width && add_wide(shape)) return;
  if (shows_filling(shape)) add_fill(shape);
  if (shape.line) add_line(shape);
}

bool SvgInk::take_as_paper(const SvgShape& shape) {
  const bool is_plain =
      shape.element == "rect" && shape.fill && !shape.line && !shape.is_cut && !is_ours_;
  Drawing& drawing = builder_.drawing();
  if (!is_plain || !drawing.has_page) return false;
  const Rect box = bounds_mm(shape), page = drawing.page.area();
  const double off = std::max({std::fabs(box.x0 - page.x0), std::fabs(box.y0 - page.y0),
                               std::fabs(box.x1 - page.x1), std::fabs(box.y1 - page.y1)});
  if (!(off <= 0.01) || shape.group != 0) return false;
  drawing.page.paper = shape.fill->color;
  say(shape, "fills the page and was used as the paper colour");
  return true;
}

bool SvgInk::outside_frame(SvgShape& shape) {
  if (!shape.frame) return false;
  const Rect box = bounds_mm(shape);
  if (shape.frame->contains(box, 1e-6)) {
    shape.frame.reset();
    return false;
  }
  if (shape.frame->misses(box)) {
    say(shape, kOutsideFrame);
    return true;
  }
  if (shape.line || shape.variable_width) {
    say(shape, "extends beyond the frame that shows it; its lines end about there");
  }
  return false;
}

bool SvgInk::add_wide(const SvgShape& shape) {
  Result<SvgWideStroke> wide = svg_wide_stroke(*shape.variable_width, shape.to_mm);
  if (!wide) {
    say(shape,
        "lost its variable width (" + wide.error().message + "); its outline was used instead");
    return false;
  }
  if (shape.variable_width->is_ours) {
    wide->data.color = shape.variable_width->color;
    wide->data.medium = svg_clean_name(wide->data.medium);
  } else {
    wide->data.medium = kSolidMedium;
    wide->data.color = shape.fill ? shape.fill->color : shape.line->color;
  }
  for (std::string& what : wide->notices) say(shape, std::move(what));
  push(shape, std::move(wide->data), shape.variable_width->is_ours);
  return true;
}

namespace {

/// Returns how the line of a shape ends and turns, if it is wide enough for sharp_line(). A line
/// that a transform stretches has no single width, so its ends and corners become round.
std::optional<SvgSharpForm> sharp_form(const SvgShape& shape) {
  const SvgLine& line = *shape.line;
  if (line.cap == SvgCap::kRound && line.join == SvgJoin::kRound) return std::nullopt;
  const double width_mm = line.width * std::sqrt(std::fabs(determinant(shape.to_mm)));
  if (!(width_mm >= kMinSharpWidthMm && width_mm <= kMaxSharpWidthMm)) return std::nullopt;
  if (!svg_is_similarity(shape.to_mm)) return std::nullopt;
  for (const SvgContour& c : shape.contours) {
    if (c.segment_count() > kMaxSharpSegments) return std::nullopt;
  }
  return SvgSharpForm{width_mm, line.cap, line.join, line.miter_limit};
}

/// Replaces the widths of a line, which are constant, by those at the joints of its contour.
void set_widths(std::vector<WidthKnot>& knots, const SvgCenterLine& line,
                const std::vector<SvgSharpWidth>& widths) {
  const double end = static_cast<double>(line.segment_count());
  knots.clear();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const bool is_last = i + 1 == widths.size();
    const double u = is_last ? end : line.place(static_cast<double>(i));
    if (knots.empty() || u > knots.back().u) knots.push_back({u, widths[i].before_mm});
    if (widths[i].after_mm != widths[i].before_mm && !is_last) {
      knots.push_back({knots.back().u + kSvgJumpU, widths[i].after_mm});
    }
  }
}

/// Returns true if the line turns at a joint by an angle that shows: up to 10 degrees, a pointed
/// corner reaches at most 0.4 % of half the width beyond a round one.
bool has_corner(const SvgContour& contour) {
  constexpr double kSeenDeg = 10.0;
  const std::size_t joints = contour.segment_count() - (contour.closed ? 0 : 1);
  for (std::size_t i = 0; i < joints; ++i) {
    if (svg_joint_angle_deg(contour.points, i) > kSeenDeg) return true;
  }
  return false;
}

}  // namespace

void SvgInk::notice_ends(const SvgShape& shape) {
  const bool has_ends =
      !shape.line->dashes.empty() || std::any_of(shape.contours.begin(), shape.contours.end(),
                                                 [](const SvgContour& c) { return !c.closed; });
  if (has_ends && shape.line->cap != SvgCap::kRound) {
    say(shape, "has flat or square ends, which became round");
  }
  if (shape.line->join != SvgJoin::kRound &&
      std::any_of(shape.contours.begin(), shape.contours.end(), has_corner)) {
    say(shape, "has pointed or cut corners, which became round");
  }
}

namespace {

/// Converts dashes with flat ends to dashes with round ends: shortens each dash by the line width,
/// so that its round ends reach exactly as far as the flat ends did. A dash that is not longer than
/// the line width becomes a dot in its middle.
struct RoundDashes {
  std::vector<double> pattern;
  double offset = 0.0;
  bool has_dots = false, runs_together = false;
};
RoundDashes round_dashes(const SvgLine& line) {
  RoundDashes result{line.dashes, line.dash_offset};
  const auto inset = [&](std::size_t i) { return 0.5 * std::min(line.width, line.dashes[i]); };
  const std::size_t count = line.dashes.size();
  for (std::size_t i = 0; i < count; i += 2) {
    if (line.dashes[i] == 0.0) return {line.dashes, line.dash_offset};  // this dash is invisible
    result.pattern[i] -= 2.0 * inset(i);
    result.pattern[i + 1] += inset(i) + inset((i + 2) % count);
    result.has_dots = result.has_dots || line.dashes[i] < line.width;
    result.runs_together = result.runs_together || result.pattern[i + 1] <= line.width;
  }
  result.offset -= inset(0);
  return result;
}

/// Returns the sum of the gaps between dashes.
double gaps_of(const SvgLine& line) {
  double gaps = 0.0;
  for (std::size_t i = 1; i < line.dashes.size(); i += 2) gaps += line.dashes[i];
  return gaps;
}

/// Returns the exact ink of a straight line with flat or square ends that a transform stretches.
/// `moved` is the line on the page.
std::optional<SvgSharpLine> stretched_line(const SvgShape& shape, const SvgContour& moved) {
  const SvgLine& line = *shape.line;
  const std::optional<Affine> to_user = inverse(shape.to_mm);
  if (line.cap == SvgCap::kRound || !to_user || svg_is_similarity(shape.to_mm)) return {};
  if (moved.closed || moved.segment_count() != 1 || flatness(moved.segment(0)) > 1e-6) return {};
  const Point a = moved.points.front(), b = moved.points.back();
  const Vec along = normalized(apply(*to_user, b - a));
  const Vec half = 0.5 * line.width * apply(shape.to_mm, perp(along));
  const Vec more =
      line.cap == SvgCap::kSquare ? 0.5 * line.width * apply(shape.to_mm, along) : Vec();
  return slanted_line(a - more, b + more, half);
}

/// Returns true if stretched_line() draws the whole shape.
bool keeps_ends(const SvgShape& shape) {
  return shape.line->dashes.empty() &&
         std::all_of(shape.contours.begin(), shape.contours.end(), [&](const SvgContour& c) {
           if (c.segment_count() != 1) return false;
           SvgContour moved = c;
           for (Point& p : moved.points) p = apply(shape.to_mm, p);
           return stretched_line(shape, moved).has_value();
         });
}

}  // namespace

void SvgInk::add_line(SvgShape& shape) {
  SvgLine line = *shape.line;
  sharp_ = sharp_form(shape);
  const bool is_flat = gaps_of(line) > 0.0 && line.cap == SvgCap::kButt && !sharp_;
  if (is_flat) {
    RoundDashes round = round_dashes(line);
    const bool changes = round.pattern != line.dashes;
    line.dashes = std::move(round.pattern);
    line.dash_offset = round.offset;
    if (round.has_dots) say(shape, "has flat dashes shorter than its width, which became dots");
    if (round.runs_together) say(shape, "has dashes that merge, because their ends became round");
    if (changes) line.cap = shape.line->cap = SvgCap::kRound;
  }
  const bool has_gaps = line.dashes.empty() || gaps_of(line) > 0.0;
  if (!sharp_ && !keeps_ends(shape)) notice_ends(shape);
  if (line.color.a < 255 && (shape.contours.size() > 1 || !line.dashes.empty())) {
    say(shape, "is transparent and has several parts; it became darker at their crossings");
  }
  // Contours are moved out of the shape, so that a long path is not in memory twice.
  for (SvgContour& contour : shape.contours) {
    if (line.dashes.empty()) {
      add_contour(shape, std::move(contour), line.color, line.width);
      continue;
    }
    auto dashes =
        svg_dashes(contour, line.dashes, line.dash_offset, line.cap != SvgCap::kButt, dashes_left_);
    if (!dashes) {
      say(shape, "has too many dashes and became a solid line");
      add_contour(shape, std::move(contour), line.color, line.width);
      continue;
    }
    dashes_left_ -= std::min(dashes_left_, dashes->size());
    if (!has_gaps) *dashes = joined_dashes(*std::move(dashes));
    for (SvgContour& dash : *dashes) add_contour(shape, std::move(dash), line.color, line.width);
  }
}

/// Begins a layer if strokes of the current layer would cover the fill: the fills of a layer are
/// below its strokes.
void SvgInk::begin_cover_layer(const SvgShape& shape, const Rect& box) {
  const auto is_covered = [&box](const Rect& ink) { return ink.intersects(box); };
  if (std::none_of(layer_ink_.begin(), layer_ink_.end(), is_covered)) return;
  if (cover_layers_ == kMaxCoverLayers || builder_.layer_count() >= limits::kMaxSvgLayers) {
    return say(shape, "has a fill that was put below the lines that it covers");
  }
  ++cover_layers_;
  if (group_.has_layer) {
    say(shape, "covers lines of its transparent group, which show through");
  }
  add_layer(top_state_);
}

void SvgInk::add_fill(const SvgShape& shape) {
  if (determinant(shape.to_mm) == 0.0)
    return say(shape, "has no extent after its transform and was skipped");
  SvgArea area = svg_area(shape.contours, shape.to_mm, shape.fill->even_odd);
  if (shape.frame) clip_fill(area.fill, *shape.frame);
  if (are_flat(area.fill.loops)) {
    if (shape.frame && !shape.line) say(shape, kOutsideFrame);
    return;
  }
  const Rect box = fill_bounds(area.fill);
  if (is_far(box)) return say(shape, kFar);
  area.fill.color = shape.fill->color;
  if (auto ok = check_fill(area.fill); !ok) {
    return say(shape, "does not form a fill and was skipped: " + ok.error().message);
  }
  if (!shape.pieces.empty() && !read_fill_pieces(shape.pieces, area.fill)) {
    say(shape, "lost the references to the strokes around its fill");
  }
  if (area.may_lack_parts) {
    say(shape, "crosses itself; parts that it covers twice may lack their fill");
  }
  ready_layer();
  begin_cover_layer(shape, box);
  ready_layer();
  builder_.add_fill(builder_.layer_count() - 1, std::make_shared<const Fill>(std::move(area.fill)),
                    shape.id);
}

/// Adds one contour as a stroke with a width in user units, or as several strokes end to end if it
/// is longer than a stroke may be.
void SvgInk::add_contour(const SvgShape& shape, SvgContour contour, Rgba color, double width) {
  constexpr std::size_t kMax = limits::kMaxSvgStrokeSegments;
  const std::size_t count = contour.segment_count();
  if (count <= kMax) return add_part(shape, std::move(contour), color, width);
  say(shape, "has more than 250000 segments and was split into several strokes");
  for (std::size_t begin = 0; begin < count; begin += kMax) {
    const auto first = contour.points.begin() + static_cast<std::ptrdiff_t>(3 * begin);
    const std::size_t points = 3 * std::min(kMax, count - begin) + 1;
    SvgContour part{{first, first + static_cast<std::ptrdiff_t>(points)}, false};
    add_part(shape, std::move(part), color, width);
  }
}

/// Moves a contour to the page and adds it, or its parts inside the frame.
void SvgInk::add_part(const SvgShape& shape, SvgContour moved, Rgba color, double width) {
  Rect box;
  for (Point& p : moved.points) {
    p = apply(shape.to_mm, p);
    box.extend(p);
  }
  if (is_far(box)) return say(shape, kFar);
  if (!shape.frame) return add_moved(shape, std::move(moved), color, width);
  for (SvgContour& part : clip_line(moved, *shape.frame)) {
    add_moved(shape, std::move(part), color, width);
  }
}

void SvgInk::add_moved(const SvgShape& shape, SvgContour moved, Rgba color, double width) {
  const bool is_point = std::all_of(moved.points.begin(), moved.points.end(),
                                    [&](Point p) { return p == moved.points.front(); });
  // As in SVG, a line without length and without caps shows nothing.
  if (is_point && (!shape.line || shape.line->cap == SvgCap::kButt)) return;
  std::vector<SvgSharpWidth> sharp_widths;
  if (shape.line && !sharp_) {
    if (std::optional<SvgSharpLine> slanted = stretched_line(shape, moved)) {
      moved = std::move(slanted->contour);
      sharp_widths = std::move(slanted->widths);
    }
  } else if (sharp_) {
    SvgSharpLine sharp = sharp_line(moved, *sharp_);
    if (!sharp.is_exact) say(shape, "has ends or corners too close together, which became round");
    moved = std::move(sharp.contour);
    sharp_widths = std::move(sharp.widths);
  }
  SvgCenterLine line = svg_center_line(moved);
  moved.points = std::vector<Point>();  // frees memory: paths can be long
  if (line.joined_short) {
    say(shape, "has parts shorter than 0.05 mm, which were joined to their neighbours");
  }
  SvgLineWidths widths = svg_line_widths(line, shape.to_mm, width);
  if (widths.knots.empty()) return say(shape, "has no extent after its transform and was skipped");
  if (!sharp_widths.empty()) {
    set_widths(widths.knots, line, sharp_widths);
  } else if (widths.is_stretched) {
    say(shape, "has a line that is stretched in one direction; its width was sampled");
  }
  if (widths.was_thin) say(shape, "is thinner than 0.05 mm and became that wide");
  StrokeData data;
  data.points = std::move(line.points);
  data.joints = std::move(line.joints);
  data.closed = line.closed;
  data.widths = std::move(widths.knots);
  data.color = color;
  data.medium = kSolidMedium;
  push(shape, std::move(data), false);
}

void SvgInk::push(const SvgShape& shape, StrokeData data, bool is_written) {
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke)
    return say(shape, "does not form a stroke and was skipped: " + stroke.error().message);
  const Rect box = stroke->bounds();
  if (is_far(box)) return say(shape, kFar);
  const bool is_ours = shape.variable_width && shape.variable_width->is_ours;
  std::string_view name, number;
  if (is_written) {
    name = shape.variable_width->id;
    number = shape.variable_width->number;
  } else if (!is_ours && !std::exchange(has_part_, true)) {
    name = shape.id;  // if a shape becomes several strokes, the first one gets its name
  }
  ready_layer();
  builder_.add(builder_.layer_count() - 1, *std::move(stroke), name, number);
  if (!is_ours_) layer_ink_.push_back(box);
}

void SvgInk::end() {
  end_group();
}

Imported SvgInk::take() {
  Imported result{std::move(builder_).build(), std::move(report_)};
  if (!has_size_) set_page_around_ink(result.drawing);
  return result;
}

std::string svg_clean_name(std::string_view text) {
  std::string clean;
  while (!text.empty() && clean.size() + 4 <= limits::kMaxNameBytes) {
    const std::string_view rest = text;
    std::uint32_t code = 0;
    if (!next_code_point(text, code)) {
      text = rest.substr(1);
      clean += '_';
    } else if ((code < 0x20 && code != '\t' && code != '\n' && code != '\r') || code == 0xfffe ||
               code == 0xffff) {
      clean += '_';
    } else {
      clean += rest.substr(0, rest.size() - text.size());
    }
  }
  return clean;
}

}  // namespace felt
