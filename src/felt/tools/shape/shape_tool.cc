#include "felt/tools/shape/shape_tool.h"

#include <array>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/shape/shape_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kShapeUses = {
    {{.hint = "Drag from one corner of the shape to the opposite one.",
      .first_modifier = "square, circle, steps of 15°",
      .second_modifier = "from the centre",
      .path = ToolPath::kFree}}};
constexpr std::array<std::string_view, 1> kShapeEdits = {"Shape"};
constexpr ToolInfo kShapeInfo{.id = "shape",
                              .label = "Shape",
                              .help = "Draws straight lines, rectangles and ellipses.",
                              .shortcut = 'u',
                              .options = kShapeOptions,
                              .kind = ToolKind::kShapes,
                              .uses = kShapeUses,
                              .edits = kShapeEdits,
                              .act = {.title = "Shapes",
                                      .caption = "Drag from corner to corner: a line, a "
                                                 "rectangle or an ellipse. Shift makes a square "
                                                 "or a circle.",
                                      .seconds = 8.0}};

}  // namespace

std::unique_ptr<Tool> make_shape() {
  return std::make_unique<ShapeTool>();
}

ShapeTool::ShapeTool() : GestureTool(kShapeInfo), settings_(shape_settings(options())) {}

void ShapeTool::take_options(const OptionValues& options) {
  settings_ = shape_settings(options);
}

ToolResult ShapeTool::hover(const PenSample&, const Scene&) {
  return {};
}

ToolResult ShapeTool::begin(const PenSample& sample, const Scene& scene) {
  touch_ = on_page(sample.position);
  return move(sample, scene);
}

ToolResult ShapeTool::move(const PenSample& sample, const Scene& scene) {
  const ShapeRules rules{(sample.buttons & kFirstModifier) != 0,
                         (sample.buttons & kSecondModifier) != 0};
  shape_ =
      shape_stroke(settings_.kind,
                   shape_corners(settings_.kind, touch_, on_page(sample.position), rules), scene);
  return {};
}

ToolResult ShapeTool::end(const Scene& scene) {
  ToolResult result;
  if (shape_) {
    EditBuilder builder(scene.document);
    builder.add(scene.layer, std::make_shared<const Stroke>(*std::move(shape_)));
    result.commit = std::move(builder).build("Shape");
  }
  shape_.reset();
  return result;
}

void ShapeTool::drop() {
  shape_.reset();
}

ForceModel ShapeTool::force(const Scene& scene) const {
  return make_shape_force(settings_, scene);
}

void ShapeTool::draw(Overlay& overlay) const {
  if (!in_gesture() || !shape_) return;
  overlay.ink_color = shape_->color();
  const WidthKnot& knot = shape_->widths().front();
  for (int i = 0; i < shape_->segment_count(); ++i) {
    overlay.ink.push_back({shape_->segment(i), knot.width_mm, knot.width_mm, knot.tone, knot.tone});
  }
}

}  // namespace felt
