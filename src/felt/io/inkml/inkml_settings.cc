#include "felt/io/inkml/inkml_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "felt/io/number_list.h"
#include "felt/stroke/color_text.h"

namespace felt::inkml {
namespace {

constexpr std::uint8_t kMarkerAlpha = 0x7f;  // alpha of a highlighter without a stated transparency
constexpr double kMaxBrushMm = 1000.0;

struct NamedColor {
  std::string_view name;
  Rgba color;
};
/// The sixteen colour names of CSS 1, and orange.
constexpr std::array kInkmlColors = {
    NamedColor{"black", {0, 0, 0, 255}},      NamedColor{"silver", {192, 192, 192, 255}},
    NamedColor{"gray", {128, 128, 128, 255}}, NamedColor{"white", {255, 255, 255, 255}},
    NamedColor{"maroon", {128, 0, 0, 255}},   NamedColor{"red", {255, 0, 0, 255}},
    NamedColor{"purple", {128, 0, 128, 255}}, NamedColor{"fuchsia", {255, 0, 255, 255}},
    NamedColor{"green", {0, 128, 0, 255}},    NamedColor{"lime", {0, 255, 0, 255}},
    NamedColor{"olive", {128, 128, 0, 255}},  NamedColor{"yellow", {255, 255, 0, 255}},
    NamedColor{"navy", {0, 0, 128, 255}},     NamedColor{"blue", {0, 0, 255, 255}},
    NamedColor{"teal", {0, 128, 128, 255}},   NamedColor{"aqua", {0, 255, 255, 255}},
    NamedColor{"orange", {255, 165, 0, 255}}};

bool is_true(std::string_view text) {
  return text == "true" || text == "1" || text == "T";
}

}  // namespace

Context Context::overlaid(const Context& more) const noexcept {
  Context result = *this;
  if (more.format >= 0) result.format = more.format;
  if (more.source >= 0) result.source = more.source;
  if (more.brush >= 0) result.brush = more.brush;
  if (more.transform >= 0) result.transform = more.transform;
  if (more.canvas >= 0) result.canvas = more.canvas;
  return result;
}

void Settings::notice(const pugi::xml_node& node, std::string what) {
  report_.add(input_.line_of(node), XmlInput::describe(node), std::move(what));
}

bool Settings::define(const pugi::xml_node& node, Context& defined) {
  const std::string_view name = xml_local_name(node.name());
  if (name == "context") {
    defined = read_context(node);
  } else if (name == "brush") {
    defined.brush = read_brush(node);
  } else if (name == "traceFormat") {
    defined.format = add_format(node);
  } else if (name == "inkSource") {
    defined.source = read_source(node);
    defined.format = sources_[static_cast<std::size_t>(defined.source)].format;
  } else if (name == "canvas") {
    defined.canvas = read_canvas(node);
  } else if (name == "canvasTransform") {
    defined.transform = read_transform(node);
  } else if (name == "mapping") {
    if (const std::optional<Affine> map = read_mapping(node)) {
      mappings_.push_back(*map);
      remember(node, mapping_ids_, static_cast<int>(mappings_.size()) - 1);
    }
  } else {
    return name == "timestamp";
  }
  return true;
}

Context Settings::referred(const pugi::xml_node& node) {
  Context context;
  if (const int i = find(node, "contextRef", context_ids_); i >= 0) {
    context = contexts_[static_cast<std::size_t>(i)];
  }
  Context own;
  own.source = find(node, "inkSourceRef", source_ids_);
  if (own.source >= 0) own.format = sources_[static_cast<std::size_t>(own.source)].format;
  if (const int i = find(node, "traceFormatRef", format_ids_); i >= 0) own.format = i;
  own.brush = find(node, "brushRef", brush_ids_);
  own.canvas = find(node, "canvasRef", canvas_ids_);
  own.transform = find(node, "canvasTransformRef", transform_ids_);
  return context.overlaid(own);
}

int Settings::find(const pugi::xml_node& node, const char* attribute, const Ids& ids) {
  const std::string_view text = node.attribute(attribute).value();
  if (text.empty()) return -1;
  if (text.front() != '#') {
    notice(node, "refers to '" + std::string(text) + "' in another document, which is not read");
    return -1;
  }
  if (text == "#DefaultBrush" || text == "#DefaultCanvas" || text == "#DefaultContext" ||
      text == "#DefaultTraceFormat" || text == "#DefaultInkSource") {
    return -1;
  }
  const auto found = ids.find(text.substr(1));
  if (found != ids.end()) return found->second;
  notice(node, std::string("has a ") + attribute + " to something that does not exist");
  return -1;
}

void Settings::remember(const pugi::xml_node& node, Ids& ids, int index) {
  const char* id =
      node.attribute("xml:id") ? node.attribute("xml:id").value() : node.attribute("id").value();
  if (*id != '\0') ids.emplace(id, index);
}

Context Settings::read_context(const pugi::xml_node& node) {
  // A format in the context overrides that of its device, whichever comes first.
  Context device, own;
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = xml_local_name(child.name());
    Context defined;
    if (name == "context" || !define(child, defined)) {
      notice(child, "is unknown in a context and was skipped");
    }
    Context& part = name == "inkSource" ? device : own;
    part = part.overlaid(defined);
  }
  const Context context = referred(node).overlaid(device).overlaid(own);
  contexts_.push_back(context);
  remember(node, context_ids_, static_cast<int>(contexts_.size()) - 1);
  return context;
}

int Settings::read_brush(const pugi::xml_node& node) {
  Brush brush;
  if (const int i = find(node, "brushRef", brush_ids_); i >= 0) {
    brush = brushes_[static_cast<std::size_t>(i)];
  }
  double height_mm = 0.0;
  bool is_marker = false, has_transparency = false;
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) != "brushProperty") continue;
    const std::string_view name = child.attribute("name").value();
    const std::string_view value = child.attribute("value").value();
    if (name == "height") {
      const auto unit = mm_of_unit(child.attribute("units").value());
      height_mm = number_of(value).value_or(0.0) * unit.value_or(1.0);
    }
    is_marker = is_marker || (name == "rasterOp" && value == "maskPen");
    has_transparency = has_transparency || name == "transparency";
    read_property(child, brush);
  }
  if (is_marker && !has_transparency) brush.color.a = kMarkerAlpha;
  if (brush.width_mm && height_mm > 0.0 && std::fabs(height_mm - *brush.width_mm) > 1e-3) {
    notice(node, "is a broad nib; its longer side was used as the width");
    brush.width_mm = std::max(*brush.width_mm, height_mm);
  }
  if (brush.width_mm && !(*brush.width_mm > 0.0 && *brush.width_mm <= kMaxBrushMm)) {
    notice(node, "has an impossible width, which was skipped");
    brush.width_mm.reset();
  }
  brushes_.push_back(brush);
  remember(node, brush_ids_, static_cast<int>(brushes_.size()) - 1);
  return static_cast<int>(brushes_.size()) - 1;
}

void Settings::read_property(const pugi::xml_node& node, Brush& brush) {
  const std::string_view name = node.attribute("name").value();
  const std::string_view value = node.attribute("value").value();
  if (name == "color") {
    read_color(node, brush);
  } else if (name == "width") {
    const auto unit = mm_of_unit(node.attribute("units").value());
    const auto number = number_of(value);
    if (!number) {
      notice(node, "is not a valid width and was skipped");
      return;
    }
    if (!unit) notice(node, "has no unit of length; mm was assumed");
    brush.width_mm = *number * unit.value_or(1.0);
  } else if (name == "transparency") {
    const auto number = number_of(value);
    if (number) brush.color.a = static_cast<std::uint8_t>(255.0 - std::clamp(*number, 0.0, 255.0));
  } else if (name == "ignorePressure") {
    brush.ignores_pressure = is_true(value);
  } else if (name == "tip") {
    if (value != "ellipse")
      notice(node, "of form '" + std::string(value) + "' was replaced by a round one");
  } else if (name != "height" && name != "rasterOp" && name != "antiAliased" &&
             name != "fitToCurve") {
    notice(node, "'" + std::string(name) + "' is unknown and was skipped");
  }
}

void Settings::read_color(const pugi::xml_node& node, Brush& brush) {
  const std::string_view text = node.attribute("value").value();
  const auto named = std::find_if(kInkmlColors.begin(), kInkmlColors.end(),
                                  [&](const NamedColor& c) { return c.name == text; });
  const std::optional<Rgba> color =
      named != kInkmlColors.end() ? std::optional(named->color) : color_from_text(text);
  if (!color) {
    notice(node, "is not a known colour; it was read as black");
    return;
  }
  const std::uint8_t alpha = text.size() == 9 ? color->a : brush.color.a;
  brush.color = *color;
  brush.color.a = alpha;
}

int Settings::add_format(const pugi::xml_node& node) {
  std::string problem;
  formats_.push_back(read_format(node, problem));
  if (!problem.empty()) notice(node, problem + "; the rest was skipped");
  remember(node, format_ids_, static_cast<int>(formats_.size()) - 1);
  return static_cast<int>(formats_.size()) - 1;
}

int Settings::read_source(const pugi::xml_node& node) {
  Source source;
  source.format = find(node, "traceFormatRef", format_ids_);
  for (const pugi::xml_node& child : node.children()) {
    const std::string_view name = xml_local_name(child.name());
    if (name == "traceFormat") source.format = add_format(child);
    if (name != "channelProperties") continue;
    for (const pugi::xml_node& property : child.children()) {
      if (std::string_view(property.attribute("name").value()) != "resolution") continue;
      if (source.resolutions.size() == kMaxChannels) break;
      source.resolutions.push_back({property.attribute("channel").value(),
                                    number_of(property.attribute("value").value()).value_or(0.0),
                                    property.attribute("units").value()});
    }
  }
  sources_.push_back(std::move(source));
  remember(node, source_ids_, static_cast<int>(sources_.size()) - 1);
  return static_cast<int>(sources_.size()) - 1;
}

int Settings::read_canvas(const pugi::xml_node& node) {
  int format = find(node, "traceFormatRef", format_ids_);
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) == "traceFormat") format = add_format(child);
  }
  canvases_.push_back(format);
  remember(node, canvas_ids_, static_cast<int>(canvases_.size()) - 1);
  return static_cast<int>(canvases_.size()) - 1;
}

// Reads the first mapping, which converts from the device to the canvas. A second mapping would be
// the inverse.
int Settings::read_transform(const pugi::xml_node& node) {
  std::optional<Affine> map;
  int number = 0;
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) != "mapping") continue;
    ++number;
    if (map || number > 2) break;
    map = read_mapping(child);
    if (map && number == 2) map = inverse(*map);
  }
  if (!map) notice(node, "has no supported mapping; its coordinates were not changed");
  transforms_.push_back(map.value_or(Affine{}));
  remember(node, transform_ids_, static_cast<int>(transforms_.size()) - 1);
  return static_cast<int>(transforms_.size()) - 1;
}

// <mapping type="affine"><affine>a c e, b d f</affine></mapping>: a row for X, a row for Y.
std::optional<Affine> Settings::read_mapping(const pugi::xml_node& node) {
  if (const int i = find(node, "mappingRef", mapping_ids_); i >= 0) {
    return mappings_[static_cast<std::size_t>(i)];
  }
  const std::string_view type = node.attribute("type").value();
  if (type == "identity" || (type.empty() && !node.first_child())) return Affine{};
  if (type != "affine") {
    notice(node, "of type '" + std::string(type) + "' is not supported");
    return std::nullopt;
  }
  std::string text;
  for (const pugi::xml_node& child : node.children()) {
    if (xml_local_name(child.name()) == "affine") text = xml_text_of(child);
  }
  std::replace(text.begin(), text.end(), ',', ' ');
  std::array<double, 6> m{};
  NumberList numbers(text);
  for (double& v : m) {
    if (numbers.next(v) != NumberList::Next::kNumber) {
      notice(node, "does not have a matrix of two rows of three numbers");
      return std::nullopt;
    }
  }
  double more = 0.0;
  if (numbers.next(more) != NumberList::Next::kEnd) {
    notice(node, "is not two-dimensional and is not supported");
    return std::nullopt;
  }
  return Affine{m[0], m[3], m[1], m[4], m[2], m[5]};
}

const Format& Settings::format(const Context& context) const {
  return context.format < 0 ? default_format_ : formats_[static_cast<std::size_t>(context.format)];
}

const std::vector<Resolution>& Settings::resolutions(const Context& context) const {
  return context.source < 0 ? no_resolutions_
                            : sources_[static_cast<std::size_t>(context.source)].resolutions;
}

const Brush* Settings::brush(const Context& context) const {
  return context.brush < 0 ? nullptr : &brushes_[static_cast<std::size_t>(context.brush)];
}

const Affine* Settings::transform(const Context& context) const {
  return context.transform < 0 ? nullptr
                               : &transforms_[static_cast<std::size_t>(context.transform)];
}

const Format* Settings::canvas_format(const Context& context) const {
  if (context.canvas < 0) return nullptr;
  const int format = canvases_[static_cast<std::size_t>(context.canvas)];
  return format < 0 ? nullptr : &formats_[static_cast<std::size_t>(format)];
}

}  // namespace felt::inkml
