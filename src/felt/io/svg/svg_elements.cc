#include "felt/io/svg/svg_elements.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

#include "felt/base/base64.h"
#include "felt/io/exact_numbers.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/io/svg/svg_fill.h"
#include "felt/io/svg/svg_pattern_effect.h"
#include "felt/io/xml/xml_text.h"
#include "felt/render/styled_outline.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// A point on the grid of path coordinates. Integers, so that differences are exact.
struct GridPoint {
  std::int64_t x = 0, y = 0;
};

GridPoint on_grid(Point p) noexcept {
  return {std::llround(p.x * kSvgStepsPerMm), std::llround(p.y * kSvgStepsPerMm)};
}

/// Returns true if a number with this first character needs a space before it: ".5.5" are two
/// numbers.
bool needs_space(std::string_view before, char first) noexcept {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (first == '-' || before.empty() || !is_digit(before.back())) return false;
  if (first != '.') return true;
  while (!before.empty() && is_digit(before.back())) before.remove_suffix(1);
  return before.empty() || before.back() != '.';
}

/// Appends a number of steps as mm, in as few characters as possible: "-1.5", ".003", "20".
void append_steps(std::string& out, std::int64_t steps) {
  constexpr auto kPerMm = static_cast<std::int64_t>(kSvgStepsPerMm);
  std::array<char, 32> text;
  char* end = text.data();
  if (steps < 0) *end++ = '-';
  const std::int64_t whole = std::abs(steps) / kPerMm;
  std::int64_t rest = std::abs(steps) % kPerMm;
  if (whole != 0 || rest == 0) end = std::to_chars(end, text.data() + text.size(), whole).ptr;
  if (rest != 0) *end++ = '.';
  for (std::int64_t unit = kPerMm / 10; rest != 0; rest %= unit, unit /= 10) {
    *end++ = static_cast<char>('0' + rest / unit);
  }
  if (needs_space(out, text.front())) out += ' ';
  out.append(text.data(), end);
}

/// Writes path commands relative to the current point.
class PathText {
 public:
  explicit PathText(std::string& out) : out_(out) {}

  void move(Point p) {
    here_ = on_grid(p);
    begin_ = here_;
    out_ += 'M';
    last_ = 'M';
    append_steps(out_, here_.x);
    append_steps(out_, here_.y);
  }

  void line(Point p) {
    command('l');
    here_ = relative(p);
  }

  /// Appends a curve, with its points rounded to whole steps.
  void cubic(const Point* p) {
    command('c');
    relative(p[0]);
    relative(p[1]);
    here_ = relative(p[2]);
  }

  /// Appends a curve of an outline. Skips it if all its points are within a step of the current
  /// point. Draws a line instead if the handles are within kFlatSteps of that line.
  void edge(const Point* p) {
    const GridPoint h0 = on_grid(p[0]), h1 = on_grid(p[1]), end = on_grid(p[2]);
    const auto length = std::hypot(end.x - here_.x, end.y - here_.y);
    if (is_near(h0, 1) && is_near(h1, 1) && is_near(end, 1)) return;
    const auto beside = [&](GridPoint h) {
      const std::int64_t dx = end.x - here_.x, dy = end.y - here_.y;
      const std::int64_t hx = h.x - here_.x, hy = h.y - here_.y;
      const auto off = static_cast<double>(dx * hy - dy * hx);
      const auto along = static_cast<double>(dx * hx + dy * hy);
      return std::fabs(off) <= kFlatSteps * length && along >= 0.0 && along <= length * length;
    };
    if (length < kLongestSteps && beside(h0) && beside(h1)) return line(p[2]);
    cubic(p);
  }

  void close() {
    out_ += 'z';
    last_ = 'z';
    here_ = begin_;
  }

 private:
  /// Largest distance of a handle from the line that replaces a curve. The distance between curve
  /// and line is then at most three quarters of this distance.
  static constexpr double kFlatSteps = 2.0;
  /// Maximum length of a line that replaces a curve. It keeps products of differences exact.
  static constexpr double kLongestSteps = 1e7;

  [[nodiscard]] bool is_near(GridPoint g, std::int64_t steps) const noexcept {
    return std::abs(g.x - here_.x) <= steps && std::abs(g.y - here_.y) <= steps;
  }

  /// Appends a command letter, unless the previous command was the same.
  void command(char c) {
    if (last_ != c) out_ += c;
    last_ = c;
  }

  GridPoint relative(Point p) {
    const GridPoint g = on_grid(p);
    append_steps(out_, g.x - here_.x);
    append_steps(out_, g.y - here_.y);
    return g;
  }

  std::string& out_;
  GridPoint here_, begin_;
  char last_ = 0;
};

/// Appends a length in mm, without the noise in its last digits.
void append_length(std::string& out, double mm) {
  append_number(out, std::round(mm * 1e6) / 1e6);
}

/// Appends the centre line in steps; append_points() adds the rest of its precision.
void append_center_line(std::string& out, const StrokeData& d) {
  PathText text(out);
  text.move(d.points[0]);
  for (std::size_t i = 1; i + 2 < d.points.size(); i += 3) text.cubic(&d.points[i]);
  if (d.closed) text.close();
}

/// Appends the knots of Inkscape's PowerStroke: position and HALF width.
void append_power_knots(std::string& out, const StrokeData& d) {
  constexpr double kPlaces = 1e4;
  // On a closed path, Inkscape interpolates from the last knot to the first. So our last knot,
  // which repeats the first, is omitted.
  const std::size_t count = d.widths.size() - (d.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += " | ";
    append_number(out, std::round(d.widths[i].u * kPlaces) / kPlaces);
    out += ',';
    append_steps(out, std::llround(0.5 * d.widths[i].width_mm * kSvgStepsPerMm));
  }
}

/// Appends the PowerStroke. Attributes that are omitted have the value that Inkscape uses by
/// default.
void append_path_effect(std::string& out, const StrokeData& d, const std::string& number) {
  out += "<defs><inkscape:path-effect id=\"w" + number +
         "\" effect=\"powerstroke\" lpeversion=\"1.3\" "
         "interpolator_type=\"Linear\" start_linecap_type=\"round\" "
         "end_linecap_type=\"round\" linejoin_type=\"round\" offset_points=\"";
  append_power_knots(out, d);
  out += "\"/></defs>\n";
}

/// Appends the position and size of a rectangle or picture.
void append_area(std::string& out, const Rect& area) {
  const auto attribute = [&out](const char* name, double mm) {
    out += name;
    append_length(out, mm);
    out += '"';
  };
  attribute(" x=\"", area.x0);
  attribute(" y=\"", area.y0);
  attribute(" width=\"", area.width());
  attribute(" height=\"", area.height());
}

/// Appends a mask with the picture. Uses only features of SVG that even old viewers support.
void append_mask(std::string& out, const Rect& mm, std::string_view png,
                 const std::string& number) {
  std::string place;
  append_area(place, mm);
  out += "<defs><mask id=\"" + std::string(kSvgMaskId) + number +
         "\" maskUnits=\"userSpaceOnUse\"" + place + "><image" + place +
         " preserveAspectRatio=\"none\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xlink:href=\"data:image/png;base64," +
         base64_text(png) + "\"/></mask></defs>\n";
}

void append_color(std::string& out, Rgba color) {
  out += " fill=\"" + color_to_text({color.r, color.g, color.b, 255}) + "\" ";
  if (color.a == 255) return;
  out += "fill-opacity=\"";
  append_number(out, std::round(color.a * (1e4 / 255.0)) / 1e4);  // enough for all 256 values
  out += "\" ";
}

/// Ends the start tag of the root element and begins a rectangle that covers it.
void append_paper(std::string& out, const Rect& area, Rgba color) {
  out += ">\n<rect id=\"paper\"";
  append_area(out, area);
  append_color(out, color);
}

/// Appends the differences between the control points and the rounded centre line.
void append_points(std::string& out, const StrokeData& d) {
  std::vector<double> values, guesses;
  const std::size_t count = d.points.size() - (d.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const GridPoint g = on_grid(d.points[i]);
    values.insert(values.end(), {d.points[i].x, d.points[i].y});
    guesses.insert(guesses.end(), {static_cast<double>(g.x) / kSvgStepsPerMm,
                                   static_cast<double>(g.y) / kSvgStepsPerMm});
  }
  append_exact(out, values, guesses);
}

void append_joints(std::string& out, const StrokeData& d) {
  for (const JointKind kind : d.joints) out += kind == JointKind::kSmooth ? 's' : 'c';
}

/// Appends the positions of the inner breakpoints, then the widths of all.
void append_widths(std::string& out, const StrokeData& d) {
  std::vector<double> values;
  for (std::size_t i = 1; i + 1 < d.widths.size(); ++i) values.push_back(d.widths[i].u);
  for (const WidthKnot& knot : d.widths) values.push_back(knot.width_mm);
  append_exact(out, values, std::vector<double>(values.size(), kSvgWidthGuess));
}

void append_tones(std::string& out, const StrokeData& d) {
  std::vector<double> values;
  for (const WidthKnot& knot : d.widths) values.push_back(knot.tone);
  append_exact(out, values, std::vector<double>(values.size(), kSvgWidthGuess));
}

bool within_reach(const Rect& r) noexcept {
  return r.x0 >= -kMaxCoordinateMm && r.y0 >= -kMaxCoordinateMm && r.x1 <= kMaxCoordinateMm &&
         r.y1 <= kMaxCoordinateMm;
}

}  // namespace

void append_path_data(std::string& out, const OutlinePath& path) {
  PathText text(out);
  const Point* p = path.points.data();
  for (const OutlinePath::Verb verb : path.verbs) {
    switch (verb) {
      case OutlinePath::Verb::kMove:
        text.move(*p++);
        break;
      case OutlinePath::Verb::kLine:
        text.line(*p++);
        break;
      case OutlinePath::Verb::kCubic:
        text.edge(p);
        p += 3;
        break;
      case OutlinePath::Verb::kClose:
        text.close();
        break;
    }
  }
}

void append_svg_head(std::string& out, const Rect& area, Rgba paper, std::string_view model) {
  const std::size_t begin = out.size();
  out +=
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" xmlns:felt=\"";
  out += kSvgNamespace;
  out += "\" version=\"1.1\" felt:version=\"";
  out += kSvgVersion;
  out += "\" ";
  if (!model.empty()) {
    out += "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" ";
    out += model;
  }
  out += "width=\"";
  append_length(out, area.width());
  out += "mm\" height=\"";
  append_length(out, area.height());
  out += "mm\" viewBox=\"";
  append_length(out, area.x0);
  for (const double v : {area.y0, area.width(), area.height()}) {
    out += ' ';
    append_length(out, v);
  }
  out += '"';
  std::string_view end = ">\n";
  if (paper.a > 0) {
    append_paper(out, area, paper);
    end = "/>\n";
  }
  out.resize(std::max(out.size(), begin + kSvgHeadBytes - end.size()), ' ');
  out += end;
}

void append_svg_group_begin(std::string& out) {
  out += "<g>\n";
}

void append_svg_group_end(std::string& out) {
  out += "</g>\n";
}

Result<void> append_svg_stroke(std::string& out, const SvgStrokeNames& given, const Stroke& stroke,
                               std::size_t number, double tolerance_mm, const GrainMask* mask,
                               const StrokeStyle* style) {
  if (!within_reach(stroke.bounds())) {
    return fail(ErrorCode::kLimitExceeded, "the stroke extends beyond 1e9 mm");
  }
  const StrokeData& d = stroke.data();
  const std::string count = std::to_string(number);
  std::string names;
  const auto append_name = [&names](const char* key, std::string_view name) {
    names += std::string(" felt:") + key + "=\"";
    Result<void> done = append_xml_attribute(names, name);
    names += '"';
    return done;
  };
  if (given.name != "s" + count) {
    if (auto ok = append_name("id", given.name); !ok) return ok;
  }
  if (!given.number.empty()) {
    if (auto ok = append_name("number", given.number); !ok) return ok;
  }
  if (d.medium != kSvgUsualMaterial) {
    if (auto ok = append_name("material", d.medium); !ok) return ok;
  }
  std::string picture;
  if (mask) {
    Result<std::string> png = mask->png(kMmPerInch * mask->width / mask->area.width());
    if (!png) return tl::unexpected(png.error());
    picture = *std::move(png);
  }
  if (has_pattern_effect(style)) {
    append_pattern_effect(out, stroke, *style, "w" + count);
  } else {
    append_path_effect(out, d, count);
  }
  if (mask) append_mask(out, mask->area, picture, count);
  out += "<path id=\"s" + count + "\" d=\"";
  append_path_data(out, styled_path(stroke, style, tolerance_mm));
  out += '"';
  append_color(out, d.color);
  if (mask) out += "mask=\"url(#" + std::string(kSvgMaskId) + count + ")\" ";
  out += "inkscape:path-effect=\"#w" + count + "\" inkscape:original-d=\"";
  append_center_line(out, d);
  out += '"' + names + " felt:joints=\"";
  append_joints(out, d);
  out += "\" felt:points=\"";
  append_points(out, d);
  out += "\" felt:widths=\"";
  append_widths(out, d);
  if (has_own_tone(d.widths)) {
    out += "\" felt:tones=\"";
    append_tones(out, d);
  }
  out += "\"/>\n";
  return {};
}

Result<void> append_svg_fill(std::string& out, std::string_view id, const Fill& fill) {
  if (!within_reach(fill_bounds(fill))) {
    return fail(ErrorCode::kLimitExceeded, "the fill extends beyond 1e9 mm");
  }
  out += "<path id=\"" + std::string(id) + "\" fill-rule=\"evenodd\" d=\"";
  for (const FillLoop& loop : fill.loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      out += i == 0 ? 'M' : i == 1 ? 'C' : ' ';
      append_number(out, loop.points[i].x);
      out += ' ';
      append_number(out, loop.points[i].y);
    }
    out += 'Z';
  }
  out += '"';
  append_color(out, fill.color);
  out += "felt:fill=\"" + fill_pieces_text(fill) + "\"/>\n";
  return {};
}

namespace {

std::string page_text(const Page* page) {
  if (!page) return "none";
  std::string text;
  append_number(text, page->width_mm);
  text += ' ';
  append_number(text, page->height_mm);
  // All eight digits, so that an opaque paper also states its alpha.
  const Rgba paper = page->paper;
  text += ' ' + color_to_text({paper.r, paper.g, paper.b, 255});
  constexpr std::string_view kDigits = "0123456789abcdef";
  text += kDigits[paper.a >> 4];
  text += kDigits[paper.a & 15];
  return text;
}

}  // namespace

Result<std::string> svg_model_text(const Drawing& drawing, const Page* page) {
  std::string out = "felt:page=\"" + page_text(page) + "\" ";
  const auto attribute = [&out](const std::string& name, std::string_view text) {
    out += "felt:" + name + "=\"";
    auto ok = append_xml_attribute(out, text);
    out += "\" ";
    return ok ? ok : tl::unexpected(with_context(ok.error(), "the drawing's " + name));
  };
  if (!drawing.page.surface.empty()) {
    if (auto ok = attribute("surface", drawing.page.surface); !ok) {
      return tl::unexpected(ok.error());
    }
  }
  for (std::size_t i = 0; i < drawing.materials.size(); ++i) {
    if (auto ok = attribute("material" + std::to_string(i + 1), drawing.materials[i]); !ok) {
      return tl::unexpected(ok.error());
    }
  }
  return out;
}

namespace {

/// Begins a layer, or a group of layers, whose attribute `id` is given.
template <class State>
Result<void> append_layer_begin(std::string& out, const State& state, const std::string& id) {
  std::string label;
  if (auto ok = append_xml_attribute(label, state.name); !ok) return ok;
  out += "<g id=\"" + id + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + label + '"';
  if (state.locked) out += " sodipodi:insensitive=\"true\"";
  out += state.visible ? " style=\"display:inline" : " style=\"display:none";
  if (state.opacity < 1.0) {
    out += ";opacity:";
    append_number(out, state.opacity);
  }
  if (state.blend != BlendMode::kNormal) {
    out += ";mix-blend-mode:";
    out += blend_mode_name(state.blend);
  }
  out += "\">\n";
  return {};
}

}  // namespace

Result<void> append_svg_layer_begin(std::string& out, const Layer& layer, std::size_t number) {
  return append_layer_begin(out, layer.state(), "layer" + std::to_string(number));
}

Result<void> append_svg_layer_group_begin(std::string& out, const LayerGroup& group) {
  return append_layer_begin(out, group, "group" + std::to_string(group.id.value));
}

void append_svg_picture(std::string& out, const LayerPicture& picture) {
  const Affine& m = picture.place;
  out += "<image xmlns:xlink=\"http://www.w3.org/1999/xlink\" transform=\"matrix(";
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) {
    append_number(out, x);
    out += ' ';
  }
  out.back() = ')';
  out += "\" width=\"" + std::to_string(picture.data->width_px) + "\" height=\"" +
         std::to_string(picture.data->height_px) +
         "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," +
         base64_text(picture.data->png) + "\"/>\n";
}

void append_svg_tail(std::string& out) {
  out += "</svg>\n";
}

}  // namespace felt
