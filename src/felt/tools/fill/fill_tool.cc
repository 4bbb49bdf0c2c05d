#include "felt/tools/fill/fill_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/tools/fill/fill_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kFillUses = {
    {{.hint = "Tap an area to fill it, or drag across several. Tap again to remove the fill.",
      .second_modifier = "removes fills",
      .path = ToolPath::kAcross}}};
constexpr std::array<std::string_view, 1> kFillEdits = {"Fill"};
constexpr ToolInfo kFillInfo{.id = "fill",
                             .label = "Fill",
                             .help = "Fills the areas between lines. Fills follow their lines.",
                             .shortcut = 'k',
                             .options = kFillOptions,
                             .kind = ToolKind::kFills,
                             .uses = kFillUses,
                             .edits = kFillEdits,
                             .act = {.title = "Fill",
                                     .caption = "A tap fills the area between lines, a drag "
                                                "fills several. The colour follows the lines "
                                                "when you change them.",
                                     .seconds = 8.0}};
/// Distance between the points of a drag that are looked at, in mm.
constexpr double kFillStepMm = 0.5;
constexpr double kMaxFillSteps = 200.0;
/// A gesture that stays nearer to its start than this is a tap.
constexpr double kTapMm = 2.0;
constexpr double kEdgeToleranceMm = 0.05;

/// Returns the part of the page whose strokes count in drawings of very many strokes.
Rect reach_of(Point pen) {
  constexpr double kReachMm = 150.0;
  return {pen.x - kReachMm, pen.y - kReachMm, pen.x + kReachMm, pen.y + kReachMm};
}

void draw_bridge(Overlay& overlay, const TipLink& link, Overlay::Role role) {
  const Point middle = link.corner.value_or(link.to.point);
  overlay.lines.push_back({link.from.point, middle, role});
  if (link.corner) overlay.lines.push_back({middle, link.to.point, role});
  overlay.dots.push_back({link.from.point, role});
  overlay.dots.push_back({link.to.point, role});
}

/// Returns the outer edge of an area as a path that pushes the pen away from it, or nullopt if it
/// is too short or too long to be felt.
std::optional<GuideLine> ridge_of(const Fill& area, double strength) {
  Outline outline;
  flatten_fill(area, kEdgeToleranceMm, outline);
  GuideLine line{GuideKind::kErrorAmplifying, {}, true, strength, {}};
  if (outline.contour_count() == 0) return std::nullopt;
  line.points.assign(outline.contour(0).begin(), outline.contour(0).end());
  if (line.points.size() > 1 && line.points.back() == line.points.front()) line.points.pop_back();
  return check_guide(line) ? std::optional(std::move(line)) : std::nullopt;
}

}  // namespace

std::unique_ptr<Tool> make_fill() {
  return std::make_unique<FillTool>();
}

FillTool::FillTool() : GestureTool(kFillInfo), settings_(fill_settings(options())) {}

void FillTool::take_options(const OptionValues& options) {
  settings_ = fill_settings(options);
}

ToolResult FillTool::hover(const PenSample&, const Scene&) {
  return {};
}

ToolResult FillTool::begin(const PenSample& sample, const Scene& scene) {
  stop_hovering();
  start_ = pen_ = on_page(sample.position);
  gesture_.emplace(scene, map_.after(scene.document, {}, reach_of(start_)), settings_.gap_mm,
                   (sample.buttons & kSecondModifier) != 0);
  if (visit(pen_, scene)) edit_ = gesture_->edit(scene);
  feel_edge(sample);
  return {.preview = edit_};
}

ToolResult FillTool::move(const PenSample& sample, const Scene& scene) {
  const Point from = std::exchange(pen_, on_page(sample.position));
  const double steps =
      std::clamp(std::ceil(distance(from, pen_) / kFillStepMm), 1.0, kMaxFillSteps);
  bool has_new = false;
  for (double i = 1.0; i <= steps; ++i) {
    has_new = visit(lerp(from, pen_, i / steps), scene) || has_new;
  }
  feel_edge(sample);
  if (!has_new) return {.same_preview = true};
  edit_ = gesture_->edit(scene);
  return {.preview = edit_};
}

bool FillTool::visit(Point p, const Scene& scene) {
  return gesture_->visit(p, scene);
}

/// Makes the edge of the area under the pen a ridge. It stays while the pen is outside of all areas
/// that the gesture has reached.
void FillTool::feel_edge(const PenSample& sample) {
  const double strength = settings_.ridge * settings_.strength;
  if (strength == 0.0) return;
  const Fill* area = gesture_->area_at(pen_);
  if (area && area != felt_) {
    if (ridge_) ridge_number_ = ridge_->hold();
    ridge_.reset();
    felt_ = area;
    if (auto line = ridge_of(*area, strength)) ridge_.emplace(*std::move(line), ++ridge_number_);
  }
  if (ridge_) ridge_->update(sample);
}

ToolResult FillTool::end(const Scene& scene) {
  ToolResult result;
  if (edit_ && !edit_->empty()) result.commit = std::move(edit_);
  const bool is_tap = distance(start_, pen_) < kTapMm;
  const Layer* layer = scene.document.layer(scene.layer);
  if (gesture_->is_empty() && !gesture_->removes() && is_tap && layer && can_fill_in(*layer)) {
    FillMap* map = map_.after(scene.document, {}, reach_of(start_));
    if (map) gap_ = map->find_gap(start_, settings_.gap_mm);
  }
  stop();
  return result;
}

void FillTool::drop() {
  stop();
}

void FillTool::stop_hovering() {
  gap_.reset();
}

void FillTool::stop() {
  gesture_.reset();
  edit_.reset();
  felt_ = nullptr;
  if (ridge_) ridge_number_ = ridge_->hold();
  ridge_.reset();
}

ForceModel FillTool::force(const Scene& scene) const {
  return make_fill_force(settings_, scene, ridge_ && !is_waiting() ? &*ridge_ : nullptr);
}

void FillTool::draw(Overlay& overlay) const {
  if (is_waiting()) return;
  if (gesture_) {
    for (const TipLink& bridge : gesture_->bridges()) {
      draw_bridge(overlay, bridge, Overlay::Role::kGuide);
    }
  }
  if (!gap_) return;
  draw_bridge(overlay, *gap_, Overlay::Role::kSnap);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f mm", gap_->length_mm);
  overlay.labels.push_back({gap_->from.point, text.data()});
}

}  // namespace felt
