#include "felt/io/svg/svg_walk.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "felt/io/limits.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_shapes.h"

namespace felt {
namespace {

/// Elements that paint nothing themselves.
constexpr std::array<std::string_view, 28> kSilent{
    "clipPath",  "color-profile",  "cursor",
    "defs",      "desc",           "filter",
    "font",      "font-face",      "glyph",
    "hatch",     "linearGradient", "marker",
    "mask",      "mesh",           "meshgradient",
    "metadata",  "missing-glyph",  "path-effect",
    "pattern",   "radialGradient", "solidcolor",
    "stop",      "style",          "symbol",
    "title",     "view",           "linearGradientStop",
    "solidColor"};
constexpr std::array<std::string_view, 6> kAnimations{
    "animate", "animateColor", "animateMotion", "animateTransform", "discard", "set"};
constexpr std::array<std::string_view, 3> kScripts{"handler", "listener", "script"};

/// Number of bytes that are subtracted from the budget for `use` for each node and each attribute.
constexpr std::int64_t kNodeBytes = 16;
/// Largest number of children that are examined: of a switch, and of a shape, to find animations.
constexpr int kMaxChoices = 1000;
constexpr int kMaxOfShape = 50;

template <class List>
bool is_one_of(std::string_view name, const List& list) noexcept {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_given(std::string_view reference) noexcept {
  return !reference.empty() && !svg_same_word(reference, "none") &&
         !svg_same_word(reference, "inherit") && !svg_same_word(reference, "initial");
}

/// Returns the size of a viewport: the size of the `use` that repeats it, or its own size, or that
/// of the outer viewport, whichever is given first.
double viewport_size(const pugi::xml_node& node, const pugi::xml_node& use, const char* name,
                     SvgAxis axis, const SvgUnits& units) {
  if (use) {
    if (const auto size = svg_length(use.attribute(name).value(), axis, units)) return *size;
  }
  if (const auto size = svg_length(node.attribute(name).value(), axis, units)) return *size;
  return axis == SvgAxis::kX ? units.view_width : units.view_height;
}

}  // namespace

SvgWalker::SvgWalker(SvgDocument& document, std::size_t text_size, SvgSceneSink& sink)
    : document_(document),
      sink_(sink),
      segments_left_(std::min(limits::kMaxSvgSegments, limits::kSpareSvgSegments + text_size / 2)),
      repeats_left_(limits::kMaxSvgUseElements),
      repeat_bytes_left_(limits::kMaxSvgUseBytes) {}

void SvgWalker::notice(const pugi::xml_node& node, std::string what) {
  sink_.notice(document_.line_of(node), svg_element_text(node.name(), node.attribute("id").value()),
               std::move(what));
}

Result<void> SvgWalker::walk() {
  if (auto ok = begin(); !ok) return ok;
  for (pugi::xml_node next = document_.root().next_sibling(); next; next = next.next_sibling()) {
    if (next.type() == pugi::node_element)
      notice(next, "was skipped: it follows the end of the drawing");
  }
  while (!stack_.empty()) {
    Frame& top = stack_.back();
    const pugi::xml_node node = top.next;
    if (!node) {
      stack_.pop_back();
      continue;
    }
    top.next = top.only_one ? pugi::xml_node() : node.next_sibling();
    if (node.type() != pugi::node_element) {
      // Nodes of text also take time when a `use` repeats them, so they are subtracted from the
      // budget, too.
      if (top.repeats && (repeat_bytes_left_ -= kNodeBytes) < 0) top.next = pugi::xml_node();
      continue;
    }
    if (!within_budget(node, top.repeats)) continue;
    visit(node, top);
  }
  return {};
}

/// Limits the work for `use`, which could repeat the same elements without end.
bool SvgWalker::within_budget(const pugi::xml_node& node, bool repeats) {
  if (!repeats) return true;
  for (const pugi::xml_attribute& a : node.attributes()) {
    repeat_bytes_left_ -= static_cast<std::int64_t>(std::strlen(a.value())) + kNodeBytes;
  }
  if (--repeats_left_ >= 0 && repeat_bytes_left_ >= 0) return true;
  notice(node, "was skipped: too many elements are repeated by 'use'");
  return false;
}

bool SvgWalker::passes_conditions(const pugi::xml_node& node) const {
  if (const pugi::xml_attribute needed = node.attribute("requiredExtensions")) {
    if (!svg_trimmed(needed.value()).empty()) return false;
  }
  const pugi::xml_attribute languages = node.attribute("systemLanguage");
  if (!languages) return true;
  SvgScan scan(languages.value());
  while (!scan.empty()) {
    const std::string_view one = svg_trimmed(scan.until(','));
    if (svg_same_word(one.substr(0, 2), "en") && (one.size() == 2 || one[2] == '-')) return true;
  }
  return false;
}

void SvgWalker::visit(const pugi::xml_node& node, const Frame& from) {
  Element e{node, {}, {}, from.state};
  if (const pugi::xml_attribute space = node.attribute("xmlns")) {
    e.state.default_is_svg = space.value() == kSvgElementNamespace || space.value()[0] == '&';
  }
  e.name = document_.svg_name(node, e.state.default_is_svg);
  if (e.name.empty()) return;
  const bool is_target = from.is_use && e.name == "symbol";
  if (is_one_of(e.name, kSilent) && !is_target) return;
  if (is_one_of(e.name, kAnimations))
    return notice(node, "was skipped: animation is not supported");
  if (is_one_of(e.name, kScripts)) return notice(node, "was skipped: scripts are not run");
  if (!passes_conditions(node)) return;
  if (resolve(e)) dispatch(e, from);
}

/// Computes style and transform. Returns false if the element is not displayed.
bool SvgWalker::resolve(Element& e) {
  State& s = e.state;
  e.declared.variables = s.variables;
  if (!svg_declared(e.node, document_.style_sheet(), clean_style_, e.declared)) {
    notice(e.node, "was read without some of its styles, because the style sheet is too complex");
  }
  s.variables = e.declared.variables;
  read_colors(e);
  s.style = svg_style(e.declared, s.style, s.units);
  s.units.font_size = s.style.font_size;
  for (SvgPaint* paint : {&s.style.fill, &s.style.stroke}) {
    if (paint->kind == SvgPaint::Kind::kContextFill)
      *paint = s.context_fill;
    else if (paint->kind == SvgPaint::Kind::kContextStroke)
      *paint = s.context_stroke;
  }
  if (!s.style.displayed && !is_layer(e)) {
    notice(e.node, "is hidden in the file and was skipped");
    return false;
  }
  if (!is_layer(e) && blend_of(e) == BlendMode::kNormal) apply_opacity(e);
  apply_transform(e);
  notice_effects(e);
  return true;
}

/// Reports values that could not be read. Browsers reject colours with icc-color(); Inkscape writes
/// them together with the colour profile, and then the colour before icc-color() counts.
void SvgWalker::read_colors(Element& e) {
  constexpr std::array<std::pair<SvgProperty, std::string_view>, 2> kPaints{
      {{SvgProperty::kFill, "fill"}, {SvgProperty::kStroke, "stroke"}}};
  for (const auto& [property, name] : kPaints) {
    const bool is_icc = e.declared[property].find("icc-color(") != std::string_view::npos;
    if (!is_icc || document_.has_color_profile()) continue;
    e.declared.set(property, "black");
    e.declared.unread = name;
  }
  if (e.declared.unread.empty()) return;
  const bool is_color = e.declared.value_of(e.declared.unread) == "black";
  notice(e.node, "has a " + std::string(e.declared.unread) + " that could not be read, " +
                     (is_color ? "and became black" : "which was ignored"));
}

/// Begins a transparent group, if parts of the element may overlap. Otherwise, its colours become
/// transparent.
void SvgWalker::apply_opacity(Element& e) {
  State& s = e.state;
  const double opacity = s.style.opacity;
  if (opacity >= 1.0) return;
  const bool is_shape = is_svg_shape(e.name), is_image = e.name == "image";
  const bool has_both = s.style.fill.kind != SvgPaint::Kind::kNone &&
                        s.style.stroke.kind != SvgPaint::Kind::kNone && e.name != "line";
  const bool overlaps = is_shape ? has_both : !is_image;
  if (overlaps && opacity > 0.0 && s.group == 0) {
    s.group = ++groups_;
    s.group_opacity = opacity;
    return;
  }
  s.opacity *= opacity;
  if (overlaps && opacity > 0.0) {
    notice(e.node,
           "is transparent inside a transparent group; the transparency was applied to "
           "each stroke");
  }
}

/// The properties translate, rotate and scale apply before `transform`, in this order.
void SvgWalker::apply_transform(Element& e) {
  State& s = e.state;
  std::string text;
  const auto add = [&](SvgProperty p, const char* name) {
    const std::string_view value = e.declared[p];
    if (!is_given(value)) return;
    text += name;
    for (const char c : value) text += c;
    text += ") ";
  };
  add(SvgProperty::kTranslate, "translate(");
  add(SvgProperty::kRotate, "rotate(");
  add(SvgProperty::kScale, "scale(");
  text += e.declared[SvgProperty::kTransform];
  if (!text.empty()) {
    if (const std::optional<Affine> m = svg_transform(text)) {
      // The root is a box on the page: it turns about its middle, and lengths are pixels of the
      // page.
      const bool is_root = root_size_px_ && e.node == document_.root();
      SvgUnits units = s.units;
      if (is_root) units.view_width = root_size_px_->x;
      if (is_root) units.view_height = root_size_px_->y;
      std::string_view origin_text = e.declared[SvgProperty::kTransformOrigin];
      if (is_root && origin_text.empty()) origin_text = "center";
      const Vec origin = svg_transform_origin(origin_text, units);
      const Affine moved =
          origin == Vec{} ? *m : then(then(translation(-1.0 * origin), *m), translation(origin));
      s.to_mm = is_root ? then(s.to_mm,
                               then(then(scaling(1.0 / kSvgMmPerPx), moved), scaling(kSvgMmPerPx)))
                        : then(moved, s.to_mm);
    } else {
      notice(e.node, "has an invalid transform, which was ignored");
    }
  }
}

void SvgWalker::notice_effects(Element& e) {
  const auto check = [&](SvgProperty p, const char* what) {
    if (is_given(e.declared[p])) notice(e.node, what);
  };
  check(SvgProperty::kClipPath, "has a clip path, which was ignored");
  // Our own masks show the grain of the surface, which is not part of the line.
  const bool is_grain =
      !document_.ours(e.node, "widths").empty() &&
      e.declared[SvgProperty::kMask].starts_with("url(#" + std::string(kSvgMaskId));
  if (!is_grain) check(SvgProperty::kMask, "has a mask, which was ignored");
  check(SvgProperty::kFilter, "has a filter, which was ignored");
  check(SvgProperty::kZoom, "has a zoom, which was ignored");
  const std::string_view blend = e.declared[SvgProperty::kMixBlendMode];
  if (is_given(blend) && !svg_same_word(blend, "normal") && blend_of(e) == BlendMode::kNormal) {
    notice(e.node, "has a blend mode, which was ignored");
  }
  if (is_given(e.declared[SvgProperty::kClipPath]) || is_given(e.declared[SvgProperty::kMask])) {
    e.state.is_cut = true;
  }
}

void SvgWalker::dispatch(Element& e, const Frame& from) {
  if (e.name == "g" || e.name == "a") {
    if (is_layer(e)) {
      has_layers(e) && !e.state.layer.group ? enter_layer_group(e) : enter_layer(e);
    } else if (blend_of(e) != BlendMode::kNormal) {
      enter_blended(e);
    }
    return push(e, from);
  }
  if (is_svg_shape(e.name)) return visit_shape(e);
  if (e.name == "image") return visit_image(e);
  if (e.name == "use") return visit_use(e, from);
  if (e.name == "svg") return visit_svg(e, from);
  if (e.name == "symbol") return visit_symbol(e, from);
  if (e.name == "switch") return visit_switch(e, from);
  notice(e.node, "is not a stroke and was skipped");
}

void SvgWalker::push(const Element& e, const Frame& from) {
  if (stack_.size() >= static_cast<std::size_t>(limits::kMaxXmlDepth)) {
    return notice(e.node, "was skipped: it is nested more than 256 deep");
  }
  Frame frame;
  frame.node = e.node;
  frame.next = e.node.first_child();
  frame.repeats = from.repeats;
  frame.state = e.state;
  stack_.push_back(std::move(frame));
}

void SvgWalker::visit_switch(Element& e, const Frame& from) {
  int children = 0;
  for (const pugi::xml_node child : e.node.children()) {
    if (++children > kMaxChoices) return notice(e.node, "has too many choices and was skipped");
    if (from.repeats) repeat_bytes_left_ -= kNodeBytes;
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = document_.svg_name(child, e.state.default_is_svg);
    const bool is_known = is_svg_shape(name) || name == "g" || name == "a" || name == "svg" ||
                          name == "use" || name == "switch" || name == "text" || name == "image";
    if (!is_known || !passes_conditions(child)) continue;
    push(e, from);
    if (stack_.back().node == e.node) {
      stack_.back().next = child;
      stack_.back().only_one = true;
    }
    return;
  }
}

void SvgWalker::visit_use(Element& e, const Frame& from) {
  const std::string_view href = svg_trimmed(svg_href(e.node));
  if (href.empty()) return;
  if (href.front() != '#') {
    return notice(e.node, "was skipped: it is in another file, which is not read");
  }
  const pugi::xml_node target = document_.find(href.substr(1));
  if (!target) return notice(e.node, "was skipped: the element it refers to is not in the file");
  const bool is_cycle =
      target == e.node ||
      std::any_of(stack_.begin(), stack_.end(), [&](const Frame& f) { return f.node == target; });
  if (is_cycle) return notice(e.node, "was skipped: it refers to itself");
  const auto length = [&](const char* name, SvgAxis axis) {
    return svg_length(e.node.attribute(name).value(), axis, e.state.units).value_or(0.0);
  };
  e.state.to_mm =
      then(translation({length("x", SvgAxis::kX), length("y", SvgAxis::kY)}), e.state.to_mm);
  e.state.context_fill = e.state.style.fill;
  e.state.context_stroke = e.state.style.stroke;
  const std::size_t depth = stack_.size();
  push(e, from);
  if (stack_.size() == depth) return;
  Frame& frame = stack_.back();
  frame.next = target;
  frame.only_one = frame.is_use = frame.repeats = true;
}

void SvgWalker::visit_svg(Element& e, const Frame& from) {
  const SvgUnits& units = e.state.units;
  const pugi::xml_node use = from.is_use ? from.node : pugi::xml_node();
  const double x = svg_length(e.node.attribute("x").value(), SvgAxis::kX, units).value_or(0.0);
  const double y = svg_length(e.node.attribute("y").value(), SvgAxis::kY, units).value_or(0.0);
  const double w = viewport_size(e.node, use, "width", SvgAxis::kX, units);
  const double h = viewport_size(e.node, use, "height", SvgAxis::kY, units);
  if (!(w > 0.0) || !(h > 0.0)) return;
  enter_viewport(e, {x, y, x + w, y + h}, !e.state.style.overflows);
  push(e, from);
}

void SvgWalker::visit_symbol(Element& e, const Frame& from) {
  const SvgUnits& units = e.state.units;
  const double w = viewport_size(pugi::xml_node(), from.node, "width", SvgAxis::kX, units);
  const double h = viewport_size(pugi::xml_node(), from.node, "height", SvgAxis::kY, units);
  if (!(w > 0.0) || !(h > 0.0)) return;
  enter_viewport(e, {0.0, 0.0, w, h}, !e.state.style.overflows);
  push(e, from);
}

void SvgWalker::enter_viewport(Element& e, const Rect& place, bool clips) {
  State& s = e.state;
  if (clips) {
    SvgFrame frame = s.frame.value_or(SvgFrame());
    if (frame.cut(place, s.to_mm)) {
      s.frame = std::move(frame);
    } else {
      notice(e.node, "is clipped to too many rotated frames; this one was ignored");
    }
  }
  s.to_mm = then(translation({place.x0, place.y0}), s.to_mm);
  s.units.view_width = place.width();
  s.units.view_height = place.height();
  if (const std::optional<Rect> box = svg_view_box(e.node.attribute("viewBox").value())) {
    s.to_mm = then(svg_view_transform(*box, place.width(), place.height(),
                                      e.node.attribute("preserveAspectRatio").value()),
                   s.to_mm);
    s.units.view_width = box->width();
    s.units.view_height = box->height();
  }
}

bool SvgWalker::is_paper(const Element& e) const {
  return is_ours_ && e.name == "rect" && stack_.size() == 1 &&
         std::string_view(e.node.attribute("id").value()) == "paper";
}

void SvgWalker::visit_shape(Element& e) {
  int children = 0;
  for (const pugi::xml_node child : e.node.children()) {
    if (++children > kMaxOfShape) break;
    if (is_one_of(document_.svg_name(child, e.state.default_is_svg), kAnimations)) {
      notice(child, "was skipped: animation is not supported");
    } else if (is_one_of(document_.svg_name(child, e.state.default_is_svg), kScripts)) {
      notice(child, "was skipped: scripts are not run");
    }
  }
  if (is_paper(e)) {
    const SvgStyle& style = e.state.style;
    return sink_.paper(svg_faded(style.fill.color, style.fill_opacity));
  }
  if (!e.state.style.visible) return notice(e.node, "is hidden in the file and was skipped");
  SvgOutline outline = svg_outline(e.name, e.node, e.declared, e.state.units, segments_left_);
  if (!outline.problem.empty()) {
    notice(e.node, "was read up to an error: " + outline.problem);
  }
  for (const SvgContour& c : outline.contours) {
    segments_left_ -= std::min(segments_left_, c.segment_count());
  }
  if (!outline.contours.empty()) emit(e, std::move(outline.contours));
}

/// Reads the geometry of a picture. As in SVG 2, a missing size is that of the picture.
void SvgWalker::visit_image(const Element& e) {
  if (!e.state.style.visible) return notice(e.node, "is hidden in the file and was skipped");
  const auto length = [&](const char* name, SvgProperty p, SvgAxis axis) {
    const std::string_view styled = e.declared[p];
    const auto value =
        svg_length(styled.empty() ? e.node.attribute(name).value() : styled, axis, e.state.units);
    return value;
  };
  SvgImage image;
  image.element = e.name;
  image.id = e.node.attribute("id").value();
  image.line_number = document_.line_of(e.node);
  image.href = svg_href(e.node);
  image.x = length("x", SvgProperty::kX, SvgAxis::kX).value_or(0.0);
  image.y = length("y", SvgProperty::kY, SvgAxis::kY).value_or(0.0);
  image.width = length("width", SvgProperty::kWidth, SvgAxis::kX);
  image.height = length("height", SvgProperty::kHeight, SvgAxis::kY);
  image.aspect = e.node.attribute("preserveAspectRatio").value();
  image.to_mm = e.state.to_mm;
  image.opacity = e.state.opacity * e.state.group_opacity;
  image.frame = e.state.frame;
  begin_content(e);
  sink_.image(image);
}

/// Passes the layer of an element to the sink, unless it is the current one.
void SvgWalker::begin_content(const Element& e) {
  if (has_layer_ && current_layer_ == e.state.layer.number) return;
  sink_.layer(e.state.layer);
  has_layer_ = true;
  current_layer_ = e.state.layer.number;
}

}  // namespace felt
