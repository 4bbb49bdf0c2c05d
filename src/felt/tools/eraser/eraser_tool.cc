#include "felt/tools/eraser/eraser_tool.h"

#include <array>

#include "felt/tools/eraser/eraser_force.h"
#include "felt/tools/pressing.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kEraserUses = {{{.hint = "Erase what the ring touches.",
                                                  .first_modifier = "up to the crossings",
                                                  .second_modifier = "whole lines",
                                                  .size = "radius_mm",
                                                  .path = ToolPath::kAcross}}};
constexpr std::array<std::string_view, 1> kEraserEdits = {"Erase"};
constexpr std::array<ToolAct, 1> kEraserActs = {
    {{.name = "press",
      .title = "Felt steps",
      .caption = "Press the eraser until it clicks, and the whole line goes. The pencil has such "
                 "steps too: they hold the width of a line.",
      .seconds = 6.0}}};
constexpr ToolInfo kEraserInfo{
    .id = "eraser",
    .label = "Eraser",
    .help = "Erases the ink under it, lines up to their next crossings, or whole lines.",
    .shortcut = 'e',
    .options = kEraserOptions,
    .kind = ToolKind::kErases,
    .uses = kEraserUses,
    .edits = kEraserEdits,
    .act = {.title = "Erase",
            .caption = "Erase what is covered, a line up to its next crossing, or a whole line.",
            .seconds = 14.0},
    .more_acts = kEraserActs};

}  // namespace

std::unique_ptr<Tool> make_eraser() {
  return std::make_unique<EraserTool>();
}

EraserTool::EraserTool() : GestureTool(kEraserInfo) {}

EraserMode EraserTool::mode_of(const PenSample& sample) const noexcept {
  if ((sample.buttons & kSecondModifier) != 0) return EraserMode::kStroke;
  if ((sample.buttons & kFirstModifier) != 0) return EraserMode::kCrossing;
  return settings_.mode;
}

bool EraserTool::presses_through(const PenSample& sample, const Scene& scene) const noexcept {
  if (!settings_.press_through) return false;
  // A landing pen sinks in before its pressure means something.
  if (seconds_between(touch_ns_, sample.time_ns, 1.0) < PushClicks::kLandingS) return false;
  const std::optional<double> pressure = Pressing(scene.surface, scene.device).of(sample);
  return pressure.value_or(0.0) >= kPressThrough;
}

ToolResult EraserTool::preview(bool changed, const Scene& scene) const {
  if (!changed) return {.same_preview = true};
  return {.preview = erasing_->edit(scene)};
}

ToolResult EraserTool::hover(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  aim_.update(*pen_, sample.time_ns, mode_of(sample), settings_, scene);
  return {};
}

ToolResult EraserTool::begin(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  aim_.clear();
  mode_ = mode_of(sample);
  erasing_.emplace(settings_, mode_, &guard_);
  erases_whole_ = false;
  touch_ns_ = sample.time_ns;
  guard_.update(sample, mode_, settings_, scene);
  return preview(erasing_->begin(*pen_, sample.time_ns, scene), scene);
}

ToolResult EraserTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  const bool presses = !erases_whole_ && presses_through(sample, scene);
  if (presses) mode_ = EraserMode::kStroke;
  erases_whole_ = erases_whole_ || presses;
  guard_.update(sample, mode_, settings_, scene);
  bool changed = erasing_->move(*pen_, sample.time_ns, scene);
  if (presses) changed |= erasing_->press_through(sample.time_ns, scene);
  return preview(changed, scene);
}

ToolResult EraserTool::end(const Scene& scene) {
  erasing_->finish(scene);
  ToolResult result;
  if (!erasing_->empty()) result.commit = erasing_->edit(scene);
  erasing_.reset();
  guard_.end();
  return result;
}

void EraserTool::drop() {
  erasing_.reset();
  guard_.end();
}

void EraserTool::take_options(const OptionValues& options) {
  settings_ = eraser_settings(options);
  aim_.clear();
}

ForceModel EraserTool::force(const Scene& scene) const {
  return make_eraser_force(settings_, scene, guard_);
}

void EraserTool::draw(Overlay& overlay) const {
  if (!pen_) return;
  overlay.rings.push_back({*pen_, settings_.radius_mm, Overlay::Role::kReach});
  if (!in_gesture()) aim_.draw(overlay);
  guard_.draw(overlay);
}

}  // namespace felt
