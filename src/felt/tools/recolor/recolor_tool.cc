#include "felt/tools/recolor/recolor_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "felt/document/stroke_index.h"
#include "felt/geometry/nearest.h"
#include "felt/tools/recolor/recolor_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kRecolorUses = {
    {{.hint = "Tap a line, or drag across several, to give them the current colour.",
      .first_modifier = "colour and medium",
      .size = "radius_mm",
      .path = ToolPath::kAcross}}};
constexpr std::array<std::string_view, 1> kRecolorEdits = {"Recolour"};
constexpr ToolInfo kRecolorInfo{
    .id = "recolor",
    .label = "Recolour",
    .help = "Gives lines that are already drawn the current colour or medium.",
    .shortcut = 'r',
    .options = kRecolorOptions,
    .kind = ToolKind::kEdits,
    .uses = kRecolorUses,
    .edits = kRecolorEdits,
    .act = {.title = "Recolour",
            .caption = "Lines that are already drawn can get another colour. Tap one, or drag "
                       "across several.",
            .seconds = 8.0}};
/// Maximum number of positions between two samples that are searched for lines.
constexpr double kMaxRecolorSteps = 200.0;

/// Adds the editable strokes whose ink is within radius_mm of the pen. Returns true if there was a
/// new one.
bool add_touched(const Scene& scene, Point pen, double radius_mm, std::set<StrokeId>& touched) {
  const std::size_t before = touched.size();
  const Rect around{pen.x - radius_mm, pen.y - radius_mm, pen.x + radius_mm, pen.y + radius_mm};
  scene.index.for_each_ink_in(around, [&](StrokeId id, int segment) {
    const StrokePtr& stroke = scene.document.find(id);
    if (!stroke || touched.contains(id)) return;
    const Nearest near = nearest(stroke->segment(segment), pen);
    const double half_mm = 0.5 * stroke->width_mm(segment + near.t);
    if (std::sqrt(near.distance_squared) <= radius_mm + half_mm) touched.insert(id);
  });
  return touched.size() > before;
}

}  // namespace

std::unique_ptr<Tool> make_recolor() {
  return std::make_unique<RecolorTool>();
}

RecolorTool::RecolorTool() : GestureTool(kRecolorInfo), settings_(recolor_settings(options())) {}

void RecolorTool::take_options(const OptionValues& options) {
  settings_ = recolor_settings(options);
}

ToolResult RecolorTool::hover(const PenSample& sample, const Scene&) {
  pen_ = on_page(sample.position);
  return {};
}

ToolResult RecolorTool::begin(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  gives_ = (sample.buttons & kFirstModifier) != 0 ? RecolorGives::kBoth : settings_.gives;
  if (add_touched(scene, *pen_, settings_.radius_mm, touched_)) edit_ = edit(scene);
  return {.preview = edit_};
}

ToolResult RecolorTool::move(const PenSample& sample, const Scene& scene) {
  const Point from = std::exchange(*pen_, on_page(sample.position));
  const double steps =
      std::clamp(std::ceil(distance(from, *pen_) / settings_.radius_mm), 1.0, kMaxRecolorSteps);
  bool has_new = false;
  for (double i = 1.0; i <= steps; ++i) {
    const Point at = lerp(from, *pen_, i / steps);
    has_new = add_touched(scene, at, settings_.radius_mm, touched_) || has_new;
  }
  if (!has_new) return {.same_preview = true};
  edit_ = edit(scene);
  return {.preview = edit_};
}

/// Returns the edit that changes the touched strokes. Strokes that look so already are left out.
Edit RecolorTool::edit(const Scene& scene) const {
  EditBuilder builder(scene.document);
  for (const StrokeId id : touched_) {
    const StrokePtr stroke = scene.document.find(id);
    StrokeData data = stroke->data();
    if (gives_ != RecolorGives::kMedium) data.color = scene.color;
    if (gives_ != RecolorGives::kColor) data.medium = scene.medium;
    if (data.color == stroke->color() && data.medium == stroke->medium()) continue;
    if (auto changed = Stroke::create(std::move(data))) {
      builder.replace(id, std::make_shared<const Stroke>(*std::move(changed)));
    }
  }
  return std::move(builder).build("Recolour");
}

ToolResult RecolorTool::end(const Scene&) {
  ToolResult result;
  if (edit_ && !edit_->empty()) result.commit = std::move(edit_);
  stop();
  return result;
}

void RecolorTool::drop() {
  stop();
}

void RecolorTool::stop_hovering() {
  pen_.reset();
}

void RecolorTool::stop() {
  touched_.clear();
  edit_.reset();
}

ForceModel RecolorTool::force(const Scene& scene) const {
  return make_recolor_force(settings_, scene);
}

void RecolorTool::draw(Overlay& overlay) const {
  if (is_waiting() || !pen_) return;
  overlay.rings.push_back({*pen_, settings_.radius_mm, Overlay::Role::kReach});
}

}  // namespace felt
