// Layers, transparent groups, pictures, and the page of files without a size.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/io/limits.h"
#include "felt/io/svg/svg_ink.h"
#include "felt/io/svg/svg_length.h"

namespace felt {
namespace {

/// Returns a box around the fill and the line of a shape. A mitre may reach beyond it.
Rect painted_box_mm(const SvgShape& shape) {
  Rect box;
  for (const SvgContour& c : shape.contours) {
    for (const Point& p : c.points) box.extend(apply(shape.to_mm, p));
  }
  if (!shape.line) return box;
  const Affine& m = shape.to_mm;
  const double scale = std::max(std::hypot(m.a, m.b), std::hypot(m.c, m.d));
  return box.inflated(0.5 * shape.line->width * scale);
}

void fade(SvgShape& shape, double opacity) {
  if (shape.fill) shape.fill->color = svg_faded(shape.fill->color, opacity);
  if (shape.line) shape.line->color = svg_faded(shape.line->color, opacity);
  if (shape.variable_width) {
    shape.variable_width->color = svg_faded(shape.variable_width->color, opacity);
  }
  shape.group = 0;
}

/// Returns the map from the pixels of a picture to the page; nothing if the picture has no area.
std::optional<Affine> place_of(const SvgImage& image, const PictureData& data) {
  const double w = data.width_px, h = data.height_px;
  const double width = image.width.value_or(image.height ? *image.height * w / h : w);
  const double height = image.height.value_or(image.width ? *image.width * h / w : h);
  if (!(width > 0.0) || !(height > 0.0)) return std::nullopt;
  const Affine in_frame = svg_view_transform({0.0, 0.0, w, h}, width, height, image.aspect);
  const Affine place = then(then(in_frame, translation({image.x, image.y})), image.to_mm);
  return is_picture_place(place) ? std::optional(place) : std::nullopt;
}

}  // namespace

void SvgInk::layer(const SvgLayer& layer) {
  end_group();
  begin_layer(layer);
}

void SvgInk::begin_layer(const SvgLayer& layer) {
  if (builder_.layer_count() >= limits::kMaxSvgLayers) {
    return notice(0, "svg", "has more than 10000 layers; the others were merged into the last");
  }
  std::string name = layer.number == 0 ? kSvgLayerName : svg_clean_name(layer.label);
  layer_state_ = {std::move(name), layer.visible, layer.locked, layer.opacity, {}, layer.blend};
  if (layer.group) {
    const SvgLayer::Group& group = *layer.group;
    layer_state_.group = std::make_shared<const LayerGroup>(LayerGroup{{group.number},
                                                                       svg_clean_name(group.label),
                                                                       group.visible,
                                                                       group.locked,
                                                                       group.opacity,
                                                                       group.blend});
  }
  add_layer(layer_state_);
}

void SvgInk::add_layer(LayerState state) {
  top_state_ = std::move(state);
  builder_.add_layer(top_state_);
  layer_ink_.clear();
  top_is_empty_ = true;
  needs_layer_ = false;
}

/// Makes sure that the top layer is the one for the next stroke or fill.
void SvgInk::ready_layer() {
  if (builder_.layer_count() == 0) begin_layer({});
  if (needs_layer_) add_layer(layer_state_);
  top_is_empty_ = false;
}

void SvgInk::shape(SvgShape shape) {
  if (shape.group != group_.number) end_group();
  if (shape.group == 0 || group_.has_layer) return add_shape(std::move(shape));
  group_.number = shape.group;
  group_.opacity = shape.group_opacity;
  const bool overlaps = overlaps_group(shape);
  group_.waiting.push_back(std::move(shape));
  if (overlaps) begin_group_layer();
}

/// Returns true if parts of a shape may overlap each other or another shape of the group.
bool SvgInk::overlaps_group(const SvgShape& shape) {
  const Rect box = painted_box_mm(shape);
  const bool has_many_parts =
      shape.line && (shape.fill || shape.contours.size() > 1 || !shape.line->dashes.empty());
  const bool overlaps = has_many_parts || group_.boxes.size() >= kMaxWaiting ||
                        std::any_of(group_.boxes.begin(), group_.boxes.end(),
                                    [&box](const Rect& other) { return other.intersects(box); });
  group_.boxes.push_back(box);
  return overlaps;
}

/// Moves the waiting shapes of the group to a layer with the opacity of the group.
void SvgInk::begin_group_layer() {
  if (builder_.layer_count() == 0) begin_layer({});
  if (cover_layers_ == kMaxCoverLayers || builder_.layer_count() + 2 > limits::kMaxSvgLayers) {
    say(group_.waiting.front(),
        "is in a transparent group; the transparency was applied to each stroke");
    const Group group = std::exchange(group_, Group());
    for (SvgShape shape : group.waiting) {
      fade(shape, group.opacity);
      add_shape(std::move(shape));
    }
    return;
  }
  ++cover_layers_;
  LayerState state = layer_state_;
  state.opacity *= group_.opacity;
  if (top_is_empty_ && !needs_layer_) {
    builder_.set_state(builder_.layer_count() - 1, state);
    top_state_ = std::move(state);
  } else {
    add_layer(std::move(state));
  }
  needs_layer_ = false;
  group_.has_layer = true;
  std::vector<SvgShape> waiting = std::exchange(group_.waiting, {});
  for (SvgShape& shape : waiting) add_shape(std::move(shape));
}

void SvgInk::end_group() {
  Group group = std::exchange(group_, Group());
  needs_layer_ = needs_layer_ || group.has_layer;
  for (SvgShape& shape : group.waiting) {
    fade(shape, group.opacity);
    add_shape(std::move(shape));
  }
}

void SvgInk::image(const SvgImage& image) {
  end_group();
  may_be_paper_ = false;
  const auto say_of_image = [&](std::string what) {
    notice(image.line_number, svg_element_text(image.element, image.id), std::move(what));
  };
  const bool has_area = image.width.value_or(1.0) > 0.0 && image.height.value_or(1.0) > 0.0;
  if (!has_area) return say_of_image("has a width or height of 0 or less and was skipped");
  const auto data = pictures_.load(image.href);
  if (!data) return say_of_image(data.error().message);
  const std::optional<Affine> place = place_of(image, **data);
  if (!place) return say_of_image("is too large, too small or too far from the page; skipped");
  auto picture = std::make_shared<const LayerPicture>(LayerPicture{*data, *place, true});
  if (image.frame && image.frame->misses(bounds_of(*picture))) {
    return say_of_image("is outside the frame that shows it and was skipped");
  }
  const bool is_sliced = image.aspect.find("slice") != std::string_view::npos;
  if (is_sliced || (image.frame && !image.frame->contains(bounds_of(*picture), 1e-3))) {
    say_of_image("extends beyond the frame that shows it, and is shown as a whole");
  }
  if (!add_picture(image, std::move(picture))) {
    say_of_image("was skipped: a drawing has at most 200 pictures and 10000 layers");
  }
}

/// Adds a picture as a layer. In our own files, a picture belongs to the layer of the file around
/// it.
bool SvgInk::add_picture(const SvgImage& image, LayerPicturePtr picture) {
  if (builder_.layer_count() == 0) begin_layer({});
  if (!pictures_.count() || builder_.layer_count() + 2 > limits::kMaxSvgLayers) return false;
  const bool is_first = top_is_empty_ && !needs_layer_;
  LayerState state = layer_state_;
  if (!is_ours_) {
    state.opacity *= image.opacity;
    if (layer_state_.name == kSvgLayerName) {
      state.name = image.id.empty() ? "Picture" : svg_clean_name(image.id);
    }
  }
  state.picture = std::move(picture);
  if (is_first) {
    builder_.set_state(builder_.layer_count() - 1, state);
    top_state_ = std::move(state);
    top_is_empty_ = false;
  } else {
    add_layer(std::move(state));
    top_is_empty_ = false;
  }
  needs_layer_ = !is_ours_;
  return true;
}

/// Sets the page of a file without a size: from the corner of the drawing to the end of its ink, as
/// resvg does.
void SvgInk::set_page_around_ink(Drawing& drawing) {
  Rect ink = ink_bounds(drawing.document);
  for (const Layer& layer : drawing.document.layers()) {
    if (layer.picture && layer.visible) ink.extend(bounds_of(*layer.picture));
  }
  const auto fits = [](double mm) { return mm >= Page::kMinMm && mm <= Page::kMaxMm; };
  if (ink.empty() || !fits(ink.x1) || !fits(ink.y1)) return;
  drawing.has_page = true;
  drawing.page.width_mm = ink.x1;
  drawing.page.height_mm = ink.y1;
}

}  // namespace felt
