#include "felt/tools/pull/pull_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "felt/tools/pull/brush_gesture.h"
#include "felt/tools/pull/bulge_gesture.h"
#include "felt/tools/pull/grab_gesture.h"
#include "felt/tools/pull/pull_force.h"
#include "felt/tools/pull/push_gesture.h"
#include "felt/tools/pull/sweep_gesture.h"

namespace felt {
namespace {

constexpr std::string_view kPullHint = "Drag a line to bend it; drag back to undo the bend.";
constexpr std::string_view kEnds = "ends and corners move along, or stay";
constexpr std::array<ToolUse, 6> kPullUses = {{
    {.mode = "push",
     .hint = "Push lines away from the side of the pen.",
     .size = "nib_radius_mm",
     .path = ToolPath::kAcross},
    {.mode = "grab", .hint = kPullHint, .first_modifier = kEnds, .size = "grab_radius_mm"},
    {.mode = "sweep", .hint = kPullHint, .first_modifier = kEnds, .size = "grab_radius_mm"},
    {.mode = "bulge",
     .hint = "Drag away from the touch to spread the lines around it; drag back to undo.",
     .size = "radius_mm"},
    {.mode = "pinch",
     .hint = "Drag away from the touch to draw the lines to it; drag back to undo.",
     .size = "radius_mm"},
    {.hint = kPullHint, .first_modifier = kEnds, .size = "radius_mm"},
}};
constexpr std::array<std::string_view, 5> kPullEdits = {"Pull", "Push", "Redraw", "Bulge", "Pinch"};
constexpr ToolInfo kPullInfo{
    .id = "pull",
    .label = "Pull",
    .help = "Corrects lines: grab one and pull it into shape, or push it from outside.",
    .shortcut = 'a',
    .options = kPullOptions,
    .kind = ToolKind::kEdits,
    .uses = kPullUses,
    .edits = kPullEdits,
    .act = {.title = "Pull and push",
            .caption = "Is a line not quite right? Grab it and pull. Like a wire, it resists more "
                       "the further you pull.",
            .seconds = 16.0}};

}  // namespace

PullTool::PullTool() : GestureTool(kPullInfo) {}

void PullTool::take_options(const OptionValues& options) {
  settings_ = pull_settings(options);
}

/// Returns true if a touch acts on all lines within a distance, instead of grabbing one.
bool PullTool::reaches_by_size() const noexcept {
  return settings_.mode == PullMode::kPush || settings_.mode >= PullMode::kBulge;
}

BrushOptions PullTool::brush_for(const PenSample& sample) const {
  BrushOptions brush = settings_.brush;
  if ((sample.buttons & kFirstModifier) != 0) brush.free_ends = !brush.free_ends;
  return brush;
}

ToolResult PullTool::hover(const PenSample& sample, const Scene& scene) {
  hovers_ = true;
  pen_ = on_page(sample.position);
  const auto hit =
      reaches_by_size() ? std::nullopt : scene.index.nearest(pen_, settings_.grab_radius_mm);
  has_target_ = hit.has_value();
  if (!hit) return {};
  StrokePtr stroke = scene.document.find(hit->stroke);
  if (!target_ || target_->stroke != stroke) target_ = std::make_unique<Target>(std::move(stroke));
  target_->u = hit->u;
  target_->point = hit->point;
  target_->is_free = brush_for(sample).free_ends;
  return {};
}

ToolResult PullTool::begin(const PenSample& sample, const Scene& scene) {
  hovers_ = has_target_ = false;
  if (settings_.mode >= PullMode::kBulge) {
    connected_.emplace(settings_.brush);
    gesture_ = make_bulge(sample, scene, settings_.bulge);
    return {};
  }
  if (settings_.mode == PullMode::kPush) {
    gesture_ = make_push(sample, scene, settings_.push);
    return move(sample, scene);
  }
  connected_.emplace(settings_.brush);
  const auto hit = scene.index.nearest(on_page(sample.position), settings_.grab_radius_mm);
  if (!hit) return {};
  const BrushOptions brush = brush_for(sample);
  switch (settings_.mode) {
    case PullMode::kGrab: {
      GrabOptions grab = settings_.grab;
      grab.pins_joints = !brush.free_ends;
      gesture_ = make_grab(sample, scene, *hit, grab, settings_.offset);
      break;
    }
    case PullMode::kSweep:
      gesture_ = make_sweep(sample, scene, *hit, settings_.sweep);
      break;
    case PullMode::kBrush:
    case PullMode::kPush:
    case PullMode::kBulge:
    case PullMode::kPinch:
      gesture_ = make_brush(sample, scene, *hit, brush, settings_.offset);
      break;
  }
  return {};
}

ToolResult PullTool::move(const PenSample& sample, const Scene& scene) {
  ToolResult result{.same_preview = true};
  if (gesture_) result.preview = gesture_->move(sample, scene);
  if (result.preview && connected_) connected_->complete(*result.preview, scene);
  return result;
}

ToolResult PullTool::end(const Scene& scene) {
  ToolResult result;
  if (gesture_) {
    Edit edit = gesture_->end(scene);
    if (connected_) connected_->complete(edit, scene);
    if (!edit.empty()) result.commit = std::move(edit);
  }
  drop();
  return result;
}

void PullTool::drop() {
  gesture_.reset();
  connected_.reset();
  target_.reset();  // because the document may change soon
  has_target_ = false;
}

ForceModel PullTool::force(const Scene& scene) const {
  return make_pull_force(settings_, scene, gesture_ ? gesture_->feel() : PullFeel{});
}

void PullTool::draw(Overlay& overlay) const {
  if (gesture_) {
    gesture_->draw(overlay);
  } else if (hovers_ && reaches_by_size()) {
    const bool pushes = settings_.mode == PullMode::kPush;
    overlay.rings.push_back({pen_, pushes ? settings_.push.radius_mm : settings_.bulge.radius_mm,
                             Overlay::Role::kReach});
  } else if (hovers_ && has_target_) {
    draw_target(overlay);
  }
}

/// Marks the ink that a touch would change.
void PullTool::draw_target(Overlay& overlay) const {
  const Stroke& stroke = *target_->stroke;
  overlay.dots.push_back({target_->point, Overlay::Role::kHandle});
  overlay.lines.push_back({pen_, target_->point, Overlay::Role::kTether});
  if (settings_.mode == PullMode::kBrush) {
    BrushOptions brush = settings_.brush;
    brush.free_ends = target_->is_free;
    const BrushReach reach = brush_reach(stroke, target_->map, target_->u, brush);
    add_span(overlay, stroke, reach.first_u(target_->map), reach.last_u(target_->map),
             Overlay::Role::kSpan);
    overlay.rings.push_back({target_->point, brush.radius_mm, Overlay::Role::kReach});
  } else {
    const double i = std::min(std::floor(target_->u), stroke.segment_count() - 1.0);
    add_span(overlay, stroke, i, i + 1.0, Overlay::Role::kSpan);
  }
}

std::unique_ptr<Tool> make_pull() {
  return std::make_unique<PullTool>();
}

}  // namespace felt
