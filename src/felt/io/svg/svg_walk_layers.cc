// Layers, groups of layers and groups with a blend mode.
#include <algorithm>

#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_walk.h"

namespace felt {

/// Returns the blend mode of a group or a layer. Modes that Feltline does not have, and those of
/// other elements, are normal.
BlendMode SvgWalker::blend_of(const Element& e) {
  if (e.name != "g" && e.name != "a") return BlendMode::kNormal;
  return blend_mode_of(svg_trimmed(e.declared[SvgProperty::kMixBlendMode]))
      .value_or(BlendMode::kNormal);
}

/// Returns the blend mode of a layer; normal if other programs' files have too many.
BlendMode SvgWalker::blend_of_layer(const Element& e) {
  const BlendMode blend = blend_of(e);
  if (blend == BlendMode::kNormal || is_ours_) return blend;
  if (++blended_groups_ <= limits::kMaxSvgBlendedGroups) return blend;
  notice(e.node, "has a blend mode, which was ignored: the file has more than 200 such groups");
  return BlendMode::kNormal;
}

bool SvgWalker::is_layer(const Element& e) const {
  return document_.inkscape(e.node, "groupmode") == "layer";
}

bool SvgWalker::has_layers(const Element& e) const {
  const auto children = e.node.children();
  return std::any_of(children.begin(), children.end(), [this](const pugi::xml_node& child) {
    return document_.inkscape(child, "groupmode") == "layer";
  });
}

/// Begins a layer that contains layers. Its content outside of these becomes layers of its own.
void SvgWalker::enter_layer_group(Element& e) {
  State& s = e.state;
  s.layer.label = document_.inkscape(e.node, "label");
  s.layer.number = ++layers_;
  s.layer.group =
      SvgLayer::Group{s.layer.label,     s.layer.number,
                      s.style.displayed, document_.sodipodi(e.node, "insensitive") == "true",
                      s.style.opacity,   blend_of_layer(e)};
}

/// Makes a group with a blend mode a layer of its own, as soon as it has content. If there are too
/// many, it becomes a group without a blend mode.
void SvgWalker::enter_blended(Element& e) {
  if (++blended_groups_ > limits::kMaxSvgBlendedGroups) {
    notice(e.node, "has a blend mode, which was ignored: the file has more than 200 such groups");
    return apply_opacity(e);
  }
  State& s = e.state;
  s.layer.label = e.node.attribute("id").value();
  s.layer.opacity *= s.style.opacity;
  s.layer.blend = blend_of(e);
  s.layer.number = ++layers_;
}

void SvgWalker::enter_layer(Element& e) {
  State& s = e.state;
  s.layer.label = document_.inkscape(e.node, "label");
  s.layer.visible = s.layer.visible && s.style.displayed;
  s.layer.locked = s.layer.locked || document_.sodipodi(e.node, "insensitive") == "true";
  s.layer.opacity *= s.style.opacity;
  if (const BlendMode blend = blend_of_layer(e); blend != BlendMode::kNormal) s.layer.blend = blend;
  s.layer.number = ++layers_;
  current_layer_ = s.layer.number;
  has_layer_ = true;
  sink_.layer(s.layer);
}

}  // namespace felt
