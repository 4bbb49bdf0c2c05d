#include "felt/io/inkml/inkml_model.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "felt/base/hash.h"
#include "felt/io/limits.h"
#include "felt/io/number_list.h"
#include "felt/io/xml/material_texts.h"
#include "felt/io/xml/xml_text.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/edit/mend_joints.h"
#include "felt/stroke/width_profile.h"

namespace felt::inkml {
namespace {

using Next = NumberList::Next;

void append_shortest(std::string& out, double value) {
  std::array<char, 32> text;
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

std::string hex(std::uint64_t value) {
  std::array<char, 20> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, 16).ptr};
}

/// Reads points: "x y x y ...".
bool read_points(std::string_view text, std::vector<Point>& points) {
  NumberList numbers(text);
  for (;;) {
    Point p;
    const Next next = numbers.next(p.x);
    if (next == Next::kEnd) return true;
    if (next == Next::kBad || numbers.next(p.y) != Next::kNumber) return false;
    points.push_back(p);
  }
}

/// Reads breakpoints, positions and widths: "u W u W ...".
bool read_width_list(std::string_view text, std::vector<WidthKnot>& widths) {
  NumberList numbers(text);
  for (;;) {
    double u = 0.0, width_mm = 0.0;
    const Next next = numbers.next(u);
    if (next == Next::kEnd) return true;
    if (next == Next::kBad || numbers.next(width_mm) != Next::kNumber) return false;
    widths.push_back({u, width_mm});
  }
}

/// Reads one tone for each breakpoint: "t t ...".
bool read_tone_list(std::string_view text, std::vector<WidthKnot>& widths) {
  NumberList numbers(text);
  for (WidthKnot& knot : widths) {
    if (numbers.next(knot.tone) != Next::kNumber) return false;
    if (!(knot.tone >= 0.0 && knot.tone <= 1.0)) return false;
  }
  double more = 0.0;
  return numbers.next(more) == Next::kEnd;
}

/// Reads the kinds of the joints: "scs" is smooth, corner, smooth.
bool read_joint_kinds(std::string_view text, std::vector<JointKind>& joints) {
  for (const char c : text) {
    if (c != 's' && c != 'c') return false;
    joints.push_back(c == 's' ? JointKind::kSmooth : JointKind::kCorner);
  }
  return true;
}

Result<void> append_name(std::string& out, const char* key, std::string_view name) {
  if (name.size() > limits::kMaxNameBytes) {
    return fail(ErrorCode::kLimitExceeded, "a name of more than 4096 bytes cannot be written");
  }
  out += std::string(" felt:") + key + "=\"";
  if (auto ok = append_xml_attribute(out, name); !ok) return ok;
  out += '"';
  return {};
}

Result<void> check_range(const StrokeData& d) {
  for (const Point& p : d.points) {
    if (!is_in_range(p)) {
      return fail(ErrorCode::kLimitExceeded, "a coordinate beyond 1e9 mm cannot be written");
    }
  }
  for (const WidthKnot& knot : d.widths) {
    if (!(knot.width_mm <= kMaxCoordinateMm)) {
      return fail(ErrorCode::kLimitExceeded, "a width beyond 1e9 mm cannot be written");
    }
  }
  return {};
}

}  // namespace

std::uint64_t trace_sum(std::span<const WidePoint> trace) noexcept {
  Fnv1a sum;
  sum.add_value(static_cast<std::uint64_t>(trace.size()));
  const auto add = [&](double v) {
    sum.add_value(static_cast<std::int64_t>(std::llround(v * kStepsPerMm)));
  };
  for (const WidePoint& p : trace) {
    add(p.position.x);
    add(p.position.y);
    add(p.width_mm);
  }
  return sum.value();
}

Result<void> append_model(std::string& out, std::string_view id, std::string_view number,
                          const Stroke& stroke, std::span<const WidePoint> trace) {
  const StrokeData& d = stroke.data();
  if (auto ok = check_range(d); !ok) return ok;
  if (auto ok = append_name(out, "id", id); !ok) return ok;
  if (!number.empty()) {
    if (auto ok = append_name(out, "number", number); !ok) return ok;
  }
  if (auto ok = append_name(out, "material", d.medium); !ok) return ok;
  out += d.closed ? " felt:closed=\"true\"" : "";
  out += " felt:points=\"";
  for (const Point& p : d.points) {
    append_shortest(out, p.x);
    out += ' ';
    append_shortest(out, p.y);
    out += ' ';
  }
  out.back() = '"';
  out += " felt:joints=\"";
  for (const JointKind kind : d.joints) out += kind == JointKind::kSmooth ? 's' : 'c';
  out += "\" felt:widths=\"";
  for (const WidthKnot& knot : d.widths) {
    append_shortest(out, knot.u);
    out += ' ';
    append_shortest(out, knot.width_mm);
    out += ' ';
  }
  out.back() = '"';
  if (has_own_tone(d.widths)) {
    out += " felt:tones=\"";
    for (const WidthKnot& knot : d.widths) {
      append_shortest(out, knot.tone);
      out += ' ';
    }
    out.back() = '"';
  }
  out += " felt:trace=\"" + hex(trace_sum(trace)) + '"';
  return {};
}

std::optional<Result<NamedStroke>> read_model(const pugi::xml_node& node, const std::string& prefix,
                                              std::span<const WidePoint> trace, Rgba color) {
  const auto ours = [&](const char* key) {
    return std::string_view(node.attribute((prefix + key).c_str()).value());
  };
  if (prefix.empty() || !node.attribute((prefix + "points").c_str())) return std::nullopt;
  if (ours("trace") != hex(trace_sum(trace))) {
    return invalid_data(
        "was changed by another program: its points were read, not the stored curve");
  }
  StrokeData d;
  d.medium = ours("material");
  d.closed = ours("closed") == "true";
  d.color = color;
  if (d.medium.size() > limits::kMaxNameBytes || ours("id").size() > limits::kMaxNameBytes) {
    return invalid_data("has a name of more than 4096 bytes; its points were read");
  }
  if (!read_points(ours("points"), d.points) || !read_joint_kinds(ours("joints"), d.joints) ||
      !read_width_list(ours("widths"), d.widths)) {
    return invalid_data("has a damaged curve; its points were read");
  }
  if (!ours("tones").empty() && !read_tone_list(ours("tones"), d.widths)) {
    return invalid_data(
        "has invalid tones (one number from 0 to 1 per width is needed); its points were read");
  }
  mend_rounding(d);
  Result<Stroke> stroke = Stroke::create(std::move(d));
  if (!stroke) {
    return invalid_data("has a damaged curve; its points were read: " + stroke.error().message);
  }
  return NamedStroke{std::string(ours("id")), *std::move(stroke)};
}

namespace {

std::string page_text(const Page& page, Rgba paper) {
  std::string text;
  append_shortest(text, page.width_mm);
  text += ' ';
  append_shortest(text, page.height_mm);
  text += ' ' + color_to_text(paper);
  return text;
}

std::optional<Page> page_of_text(std::string_view text) {
  Page page;
  const std::size_t space = text.rfind(' ');
  if (space == std::string_view::npos) return std::nullopt;
  const std::optional<Rgba> paper = color_from_text(text.substr(space + 1));
  NumberList numbers(text.substr(0, space));
  if (!paper || numbers.next(page.width_mm) != Next::kNumber ||
      numbers.next(page.height_mm) != Next::kNumber) {
    return std::nullopt;
  }
  const auto fits = [](double v) { return v >= Page::kMinMm && v <= Page::kMaxMm; };
  if (!fits(page.width_mm) || !fits(page.height_mm)) return std::nullopt;
  page.paper = *paper;
  return page;
}

}  // namespace

Result<void> append_page(std::string& out, const Drawing& drawing,
                         const std::optional<Rgba>& paper) {
  if (drawing.has_page) {
    out += " felt:page=\"" + page_text(drawing.page, paper.value_or(drawing.page.paper)) + '"';
  }
  if (!drawing.page.surface.empty()) {
    if (auto ok = append_name(out, "surface", drawing.page.surface); !ok) return ok;
  }
  for (std::size_t i = 0; i < drawing.materials.size(); ++i) {
    out += " felt:material" + std::to_string(i + 1) + "=\"";
    if (auto ok = append_xml_attribute(out, drawing.materials[i]); !ok) return ok;
    out += '"';
  }
  return {};
}

bool read_page(const pugi::xml_node& root, const std::string& prefix, Drawing& drawing) {
  const auto ours = [&](const std::string& key) {
    return std::string_view(root.attribute((prefix + key).c_str()).value());
  };
  const std::optional<Page> page = page_of_text(ours("page"));
  drawing.has_page = page.has_value();
  drawing.page = page.value_or(Page{});
  drawing.page.surface = ours("surface");
  bool all = true;
  for (std::size_t i = 1; i <= limits::kMaxMaterialTexts; ++i) {
    const std::string_view text = ours("material" + std::to_string(i));
    if (!text.empty()) all = add_material_text(drawing.materials, text) && all;
  }
  return all;
}

}  // namespace felt::inkml
