#include "felt/io/svg_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "felt/io/grain_mask.h"
#include "felt/io/ndjson_writer.h"
#include "felt/io/xml_text.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

constexpr double kFarthestMm = 1e9;

/// A place on the grid of path coordinates. Integers, so that differences are exact.
struct GridPoint {
  std::int64_t x = 0, y = 0;
};

GridPoint on_grid(Point p) noexcept {
  return {std::llround(p.x * kSvgStepsPerMm), std::llround(p.y * kSvgStepsPerMm)};
}

/// steps / 10^4 in the fewest characters, and a space before it where one is needed.
void append_steps(std::string& out, std::int64_t steps) {
  const bool after_number =
      !out.empty() &&
      (out.back() == '.' || std::isdigit(static_cast<unsigned char>(out.back())) != 0);
  if (steps < 0)
    out += '-';
  else if (after_number)
    out += ' ';
  const auto size = static_cast<std::uint64_t>(std::abs(steps));
  constexpr auto kOne = static_cast<std::uint64_t>(kSvgStepsPerMm);
  if (size >= kOne || size == 0) out += std::to_string(size / kOne);
  if (size % kOne == 0) return;
  std::string digits = std::to_string(kOne + size % kOne);
  digits.erase(digits.find_last_not_of('0') + 1);
  out += '.';
  out.append(digits, 1);
}

/// Writes path commands relative to the place reached so far.
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

  void cubic(const Point* p) {
    command('c');
    relative(p[0]);
    relative(p[1]);
    here_ = relative(p[2]);
  }

  void close() {
    out_ += 'z';
    last_ = 'z';
    here_ = begin_;
  }

 private:
  /// A repeated command need not be named again.
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

/// A length of the sheet without the noise of its last digits.
void append_length(std::string& out, double mm) {
  append_number(out, std::round(mm * 1e6) / 1e6);
}

void append_pair(std::string& out, double a, double b) {
  append_number(out, a);
  out += ',';
  append_number(out, b);
}

/// The centre line, exactly: every number in the shortest form that reads back the same.
void append_center_line(std::string& out, const StrokeData& d) {
  out += "M ";
  append_pair(out, d.points[0].x, d.points[0].y);
  out += " C";
  for (std::size_t i = 1; i < d.points.size(); ++i) {
    out += ' ';
    append_pair(out, d.points[i].x, d.points[i].y);
  }
  if (d.closed) out += " Z";
}

/// Knots of Inkscape's PowerStroke: place and HALF width. Halving a double is exact.
void append_power_knots(std::string& out, const StrokeData& d) {
  // Round a closed path the first knot follows the last one.
  const std::size_t count = d.widths.size() - (d.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += " | ";
    append_pair(out, d.widths[i].u, 0.5 * d.widths[i].width_mm);
  }
}

void append_path_effect(std::string& out, const StrokeData& d, const std::string& number) {
  out += "<defs><inkscape:path-effect id=\"width" + number +
         "\" effect=\"powerstroke\" is_visible=\"true\" lpeversion=\"1.3\" scale_width=\"1\" "
         "interpolator_type=\"Linear\" interpolator_beta=\"0.2\" start_linecap_type=\"round\" "
         "end_linecap_type=\"round\" linejoin_type=\"round\" miter_limit=\"4\" "
         "sort_points=\"true\" not_jump=\"false\" offset_points=\"";
  append_power_knots(out, d);
  out += "\"/></defs>\n";
}

/// Where a rectangle or picture is.
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

/// The picture in all that SVG viewers understand, the old ones too.
void append_mask(std::string& out, const Rect& area, std::string_view png,
                 const std::string& number) {
  std::string place;
  append_area(place, area);
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
  append_number(out, std::round(color.a * (1e4 / 255.0)) / 1e4);  // enough to tell all 256
  out += "\" ";
}

/// Ends the start of the root element and begins a rectangle over all of it.
void append_paper(std::string& out, const Rect& area, Rgba color) {
  out += ">\n<rect id=\"paper\"";
  append_area(out, area);
  append_color(out, color);
}

void append_joints(std::string& out, const StrokeData& d) {
  for (std::size_t i = 0; i < d.joints.size(); ++i) {
    if (i > 0) out += ' ';
    out += d.joints[i] == JointKind::kSmooth ? "smooth" : "corner";
  }
}

void append_widths(std::string& out, const StrokeData& d) {
  for (std::size_t i = 0; i < d.widths.size(); ++i) {
    if (i > 0) out += ' ';
    append_pair(out, d.widths[i].u, d.widths[i].width_mm);
  }
}

void append_tones(std::string& out, const StrokeData& d) {
  for (std::size_t i = 0; i < d.widths.size(); ++i) {
    if (i > 0) out += ' ';
    append_number(out, d.widths[i].tone);
  }
}

bool within_reach(const Rect& r) noexcept {
  return r.x0 >= -kFarthestMm && r.y0 >= -kFarthestMm && r.x1 <= kFarthestMm && r.y1 <= kFarthestMm;
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
        text.cubic(p);
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
  out += "\" version=\"1.1\" felt:version=\"1\" ";
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

Result<void> append_svg_stroke(std::string& out, const SketchStroke& stroke, std::size_t number,
                               double tolerance_mm, const GrainMask* mask) {
  if (!within_reach(stroke.stroke.bounds())) {
    return fail(ErrorCode::kLimitExceeded, "the stroke reaches farther than 1e9 mm");
  }
  const StrokeData& d = stroke.stroke.data();
  std::string names;
  names += "felt:id=\"";
  if (auto ok = append_xml_attribute(names, stroke.id); !ok) return ok;
  names += "\" felt:material=\"";
  if (auto ok = append_xml_attribute(names, d.material); !ok) return ok;
  const std::string count = std::to_string(number);
  std::string picture;
  if (mask) {
    Result<std::string> png = mask->png(kMmPerInch * mask->width / mask->area.width());
    if (!png) return tl::unexpected(png.error());
    picture = *std::move(png);
  }
  append_path_effect(out, d, count);
  if (mask) append_mask(out, mask->area, picture, count);
  out += "<path id=\"stroke" + count + "\" d=\"";
  append_path_data(out, outline_path(stroke.stroke, tolerance_mm));
  out += '"';
  append_color(out, d.color);
  if (mask) out += "mask=\"url(#" + std::string(kSvgMaskId) + count + ")\" ";
  out += "stroke=\"none\" inkscape:path-effect=\"#width" + count + "\" inkscape:original-d=\"";
  append_center_line(out, d);
  out += "\" " + names + "\" felt:closed=\"" + (d.closed ? "true" : "false") + "\" felt:joints=\"";
  append_joints(out, d);
  out += "\" felt:widths=\"";
  append_widths(out, d);
  if (has_own_tone(d.widths)) {
    out += "\" felt:tones=\"";
    append_tones(out, d);
  }
  out += "\"/>\n";
  return {};
}

namespace {

std::string page_text(const std::optional<SheetPage>& page) {
  if (!page) return "none";
  std::string text;
  append_number(text, page->width_mm);
  text += ' ';
  append_number(text, page->height_mm);
  // All eight digits: the colour of an opaque paper too says that it is one.
  const Rgba paper = page->paper;
  text += ' ' + color_to_text({paper.r, paper.g, paper.b, 255});
  constexpr std::string_view kDigits = "0123456789abcdef";
  text += kDigits[paper.a >> 4];
  text += kDigits[paper.a & 15];
  return text;
}

}  // namespace

Result<std::string> svg_model_text(const LayeredSketch& drawing) {
  std::string out = "felt:page=\"" + page_text(drawing.page) + "\" ";
  const auto attribute = [&out](const std::string& name, std::string_view text) {
    out += "felt:" + name + "=\"";
    auto ok = append_xml_attribute(out, text);
    out += "\" ";
    return ok ? ok : tl::unexpected(with_context(ok.error(), "the drawing's " + name));
  };
  const std::string& surface = drawing.page ? drawing.page->surface : drawing.surface;
  if (!surface.empty()) {
    if (auto ok = attribute("surface", surface); !ok) {
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

Result<void> append_svg_layer_begin(std::string& out, const SketchLayer& layer,
                                    std::size_t number) {
  std::string label;
  if (auto ok = append_xml_attribute(label, layer.name); !ok) return ok;
  out += "<g id=\"layer" + std::to_string(number) +
         "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + label + '"';
  if (layer.locked) out += " sodipodi:insensitive=\"true\"";
  out += layer.visible ? " style=\"display:inline\">\n" : " style=\"display:none\">\n";
  return {};
}

void append_svg_layer_end(std::string& out) {
  out += "</g>\n";
}

void append_svg_tail(std::string& out) {
  out += "</svg>\n";
}

}  // namespace felt
