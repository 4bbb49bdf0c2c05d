#include "felt/tools/guide/guide_tool.h"

#include <array>
#include <utility>

#include "felt/document/stroke_index.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guide/guide_handles.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kGuideUses = {
    {{.hint = "Drag to place a guide, or drag a guide by a handle or a line.",
      .first_modifier = "steps of 15°",
      .second_modifier = "removes the guide",
      .path = ToolPath::kFree}}};
constexpr std::array<std::string_view, 3> kGuideEdits = {"Add guide", "Change guide",
                                                         "Remove guide"};
constexpr ToolInfo kGuideInfo{
    .id = "guide",
    .label = "Guide",
    .help = "Places rulers, grids, mirror axes and other guides, and moves and turns them.",
    .shortcut = 'y',
    .options = kGuideToolOptions,
    .kind = ToolKind::kGuides,
    .uses = kGuideUses,
    .edits = kGuideEdits};

constexpr double kHandleReachMm = 4.0, kLineReachMm = 2.0;  // guide.md

}  // namespace

std::unique_ptr<Tool> make_guide() {
  return std::make_unique<GuideTool>();
}

GuideTool::GuideTool() : GestureTool(kGuideInfo), settings_(guide_tool_settings(options())) {}

void GuideTool::take_options(const OptionValues& options) {
  settings_ = guide_tool_settings(options);
}

/// Finds the handle or line under the pen: the nearest handle within reach, or else the nearest
/// line. The newest guide counts if several are equally near.
void GuideTool::look(Point pen, const Scene& scene) {
  grip_.reset();
  handles_.clear();
  if (!scene.document.shows_guides()) return;
  double nearest_mm = kHandleReachMm;
  for (const auto& [id, guide] : scene.document.guides()) {
    const std::vector<Point> handles = guide_handles(*guide);
    handles_.insert(handles_.end(), handles.begin(), handles.end());
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const double mm = distance(handles[i], pen);
      if (mm > nearest_mm) continue;
      nearest_mm = mm;
      grip_ = Grip{id, guide, i};
    }
  }
  if (grip_) return;
  nearest_mm = kLineReachMm;
  for (const auto& [id, guide] : scene.document.guides()) {
    const Rect bounds = bounds_.of(guide, scene.document);
    const bool is_far = distance_squared(bounds, pen) > nearest_mm * nearest_mm;
    if (!bounds.empty() && is_far) continue;
    const double mm = distance_to_guide(*guide, scene.document, pen);
    if (mm > nearest_mm) continue;
    nearest_mm = mm;
    grip_ = Grip{id, guide, std::nullopt};
  }
}

ToolResult GuideTool::hover(const PenSample& sample, const Scene& scene) {
  look(on_page(sample.position), scene);
  return {};
}

ToolResult GuideTool::begin(const PenSample& sample, const Scene& scene) {
  touch_ = on_page(sample.position);
  look(touch_, scene);
  removes_ = (sample.buttons & kSecondModifier) != 0;
  return move(sample, scene);
}

ToolResult GuideTool::move(const PenSample& sample, const Scene& scene) {
  edit_ = edit_at(on_page(sample.position), (sample.buttons & kFirstModifier) != 0, scene);
  return {.preview = edit_};
}

std::optional<Edit> GuideTool::edit_at(Point pen, bool in_steps, const Scene& scene) const {
  if (!grip_) return removes_ ? std::nullopt : added(pen, in_steps, scene);
  if (removes_) return Edit{"Remove guide", {}, {}, {}, {{grip_->id, grip_->guide, nullptr}}};
  const GuideTurn turn = in_steps ? GuideTurn::kInSteps : GuideTurn::kFree;
  const Vec by_mm = pen - touch_;
  const DrawingGuide& before = *grip_->guide;
  DrawingGuide after = before;
  if (grip_->handle) {
    // The handle keeps its distance from the pen, so that it does not jump at the touch.
    const Point handle = guide_handles(before)[*grip_->handle];
    if (by_mm != Vec{}) after = with_guide_handle(before, *grip_->handle, handle + by_mm, turn);
  } else {
    after = moved_guide(before, by_mm);
  }
  if (after == before || !check_drawing_guide(after)) return std::nullopt;
  return Edit{"Change guide",
              {},
              {},
              {},
              {{grip_->id, grip_->guide, std::make_shared<const DrawingGuide>(std::move(after))}}};
}

std::optional<Edit> GuideTool::added(Point pen, bool in_steps, const Scene& scene) const {
  DrawingGuide guide{settings_.kind};
  guide.axes = settings_.axes;
  guide.strength = settings_.hold;
  if (settings_.kind == DrawingGuideKind::kTrace) {
    const std::optional<StrokeHit> hit = scene.index.nearest(touch_, kHandleReachMm);
    if (!hit) return std::nullopt;
    guide.stroke = hit->stroke;
  } else {
    guide = placed_guide(guide, touch_, pen, settings_.points,
                         in_steps ? GuideTurn::kInSteps : GuideTurn::kFree);
  }
  if (!check_drawing_guide(guide) || scene.document.guides().size() >= kMaxDrawingGuides) {
    return std::nullopt;
  }
  Edit edit{"Add guide", {}};
  edit.guides.push_back({scene.document.new_guide_id(), nullptr,
                         std::make_shared<const DrawingGuide>(std::move(guide))});
  edit.toggles_guides = !scene.document.shows_guides();
  return edit;
}

ToolResult GuideTool::end(const Scene&) {
  ToolResult result;
  if (edit_ && !edit_->empty()) result.commit = std::move(edit_);
  drop();
  return result;
}

void GuideTool::drop() {
  edit_.reset();
  grip_.reset();
  handles_.clear();
  removes_ = false;
}

void GuideTool::stop_hovering() {
  drop();
}

ForceModel GuideTool::force(const Scene& scene) const {
  const Medium& medium = medium_of(scene, scene.medium);
  ForceModel model(make_surface_force(scene.surface,
                                      scaled_medium(medium, settings_.strength, settings_.strength),
                                      scene.device, surface_grain(scene.surface)));
  model.set_fade_id(
      FeelId("guide").with_surface(scene.surface, medium).with(settings_.strength).value());
  return model;
}

void GuideTool::draw(Overlay& overlay) const {
  if (is_waiting()) return;
  std::vector<Point> handles = handles_;
  if (in_gesture()) {
    handles.clear();
    if (edit_ && edit_->guides.front().after) {
      handles = guide_handles(*edit_->guides.front().after);
    }
  }
  for (const Point p : handles) overlay.dots.push_back({p, Overlay::Role::kHandle});
  if (grip_ && grip_->handle && !in_gesture()) {
    overlay.rings.push_back({guide_handles(*grip_->guide)[*grip_->handle], kHandleReachMm});
  }
}

}  // namespace felt
