#include "felt/tools/lasso/lasso_tool.h"

#include <array>
#include <string>
#include <utility>

#include "felt/tools/lasso/lasso_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kLassoUses = {
    {{.hint = "Draw around lines to select them, or click one.",
      .first_modifier = "adds",
      .second_modifier = "subtracts",
      .size = "click_radius_mm",
      .path = ToolPath::kAround}}};
constexpr ToolInfo kLassoInfo{
    .id = "lasso",
    .label = "Lasso",
    .help = "Selects the lines that you draw around; a short touch selects one line.",
    .shortcut = 'v',
    .options = kLassoOptions,
    .kind = ToolKind::kSelects,
    .uses = kLassoUses,
    .act = {.title = "Select",
            .caption = "Draw a loop around lines to select them, or touch one.",
            .seconds = 10.0}};

LassoCombine combine_of(std::uint32_t buttons, LassoCombine option) {
  if (buttons & kFirstModifier) return LassoCombine::kAdd;
  if (buttons & kSecondModifier) return LassoCombine::kSubtract;
  return option;
}

std::vector<Point> rectangle(Point a, Point b) {
  return {a, {b.x, a.y}, b, {a.x, b.y}};
}

std::string count_text(std::size_t strokes, std::size_t partial) {
  std::string text = std::to_string(strokes) + (strokes == 1 ? " line" : " lines");
  if (partial > 0) text += ", " + std::to_string(partial) + " in part";
  return text;
}

}  // namespace

std::unique_ptr<Tool> make_lasso() {
  return std::make_unique<LassoTool>();
}

LassoTool::LassoTool() : GestureTool(kLassoInfo) {}

ToolResult LassoTool::hover(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  const auto hit = scene.index.nearest(pen_, settings_.click_radius_mm);
  under_pen_ = hit ? scene.document.find(hit->stroke) : nullptr;
  selected_.look(scene.document, scene.selection);
  return {};
}

ToolResult LassoTool::begin(const PenSample& sample, const Scene& scene) {
  pen_ = start_ = on_page(sample.position);
  combine_ = combine_of(sample.buttons, settings_.combine);
  way_.begin(start_);
  preview_.begin();
  selected_.look(scene.document, scene.selection);
  return {};
}

ToolResult LassoTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  way_.add(pen_);
  if (settings_.mode == LassoMode::kRectangle) {
    Rect box;
    box.extend(start_);
    box.extend(pen_);
    preview_.look(rectangle(start_, pen_), box, settings_.take, scene.document, scene.index);
  } else {
    preview_.look(way_.points(), way_.bounds(), settings_.take, scene.document, scene.index);
  }
  return {.same_preview = true};
}

std::vector<Point> LassoTool::outline() const {
  return settings_.mode == LassoMode::kRectangle ? rectangle(start_, pen_) : way_.finished();
}

ToolResult LassoTool::end(const Scene& scene) {
  const std::vector<Point> points = outline();
  ToolResult result;
  if (points.size() >= 3 && swept_area_mm2(points) >= kMinAreaMm2) {
    const Selection taken =
        taken_by(LassoArea(points), settings_.take, scene.document, scene.index);
    result.selection = combined(scene.document, scene.selection, taken, combine_);
  } else if (way_.bounds().width() <= kClickMm && way_.bounds().height() <= kClickMm) {
    result.selection = click(scene);
  }
  if (result.selection) selected_.look_at_all(scene.document, *result.selection);
  drop();
  return result;
}

Selection LassoTool::click(const Scene& scene) const {
  Selection taken;
  if (const auto hit = scene.index.nearest(start_, settings_.click_radius_mm)) {
    taken.set_whole(hit->stroke, scene.document.find(hit->stroke)->data().points.size());
  }
  return combined(scene.document, scene.selection, taken, combine_);
}

void LassoTool::drop() {
  way_.clear();
  preview_.begin();
  under_pen_ = nullptr;
}

void LassoTool::take_options(const OptionValues& options) {
  settings_ = lasso_settings(options);
}

ForceModel LassoTool::force(const Scene& scene) const {
  return make_lasso_force(settings_, scene);
}

void LassoTool::draw(Overlay& overlay) const {
  if (in_gesture()) {
    if (combine_ != LassoCombine::kReplace) selected_.draw(overlay);
    preview_.draw(overlay);
    std::vector<Point> points = settings_.mode == LassoMode::kRectangle
                                    ? rectangle(start_, pen_)
                                    : std::vector(way_.points().begin(), way_.points().end());
    overlay.outlines.push_back({std::move(points), true, Overlay::Role::kSelected});
    if (const std::size_t count = preview_.count()) {
      overlay.labels.push_back({pen_, count_text(count, 0)});
    }
    return;
  }
  if (!selected_.empty()) {
    selected_.draw(overlay);
    const Rect& box = selected_.box();
    overlay.labels.push_back(
        {{box.x1, box.y0}, count_text(selected_.stroke_count(), selected_.partial_count())});
  }
  if (under_pen_) {
    add_span(overlay, *under_pen_, 0.0, under_pen_->segment_count(), Overlay::Role::kSpan);
    overlay.rings.push_back({pen_, settings_.click_radius_mm, Overlay::Role::kReach});
  }
}

}  // namespace felt
