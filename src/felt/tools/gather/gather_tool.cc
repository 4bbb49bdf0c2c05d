#include "felt/tools/gather/gather_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "felt/tools/gather/gather_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kGatherUses = {
    {{.hint = "Brush along rough strokes to press them into one line.",
      .size = "radius_mm",
      .path = ToolPath::kAlong}}};
constexpr std::array<std::string_view, 1> kGatherEdits = {"Gather"};
constexpr ToolInfo kGatherInfo{.id = "gather",
                               .label = "Gather",
                               .help = "Presses a bundle of rough strokes into one line.",
                               .shortcut = 'g',
                               .options = kGatherOptions,
                               .kind = ToolKind::kEdits,
                               .uses = kGatherUses,
                               .edits = kGatherEdits,
                               .act = {.title = "Gather",
                                       .caption = "Brush along rough strokes, and they become "
                                                  "one line. The bundle resists until it is one.",
                                       .seconds = 14.0}};
/// Time constant of the low-pass for the spread that the user feels.
constexpr double kSpreadSeconds = 0.040;
constexpr double kLongestFeelS = 0.100;

std::int64_t nanoseconds_off(std::int64_t a_ns, std::int64_t b_ns) {
  // In floating point, because times of any size may come from a recording.
  return static_cast<std::int64_t>(
      std::min(std::fabs(static_cast<double>(a_ns) - static_cast<double>(b_ns)), 1e18));
}

}  // namespace

std::unique_ptr<Tool> make_gather() {
  return std::make_unique<GatherTool>();
}

GatherTool::GatherTool() : GestureTool(kGatherInfo), settings_(gather_settings(options())) {}

void GatherTool::take_options(const OptionValues& options) {
  settings_ = gather_settings(options);
}

ToolResult GatherTool::hover(const PenSample& sample, const Scene&) {
  pen_ = on_page(sample.position);
  return {};
}

ToolResult GatherTool::begin(const PenSample& sample, const Scene&) {
  pen_ = on_page(sample.position);
  brush_.emplace(*pen_, settings_.radius_mm);
  preview_ns_ = feel_ns_ = sample.time_ns;
  return {};
}

ToolResult GatherTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  if (brush_->move(*pen_, scene)) has_changed_ = true;
  if (has_changed_ && nanoseconds_off(sample.time_ns, preview_ns_) >= preview_interval_ns_) {
    return preview(sample, scene);
  }
  feel(sample);
  return {.same_preview = true};
}

ToolResult GatherTool::preview(const PenSample& sample, const Scene& scene) {
  preview_ns_ = sample.time_ns;
  has_changed_ = false;
  bundle_ = brushed_bundle(*brush_);
  std::size_t points = 0;
  for (const auto& [id, stroke] : brush_->strokes()) points += stroke.points.size();
  preview_interval_ns_ =
      std::max(kPreviewNs, kPreviewNsPerPoint * static_cast<std::int64_t>(points));
  return {.preview = gather_edit(scene.document, bundle_, {.width = settings_.width})};
}

void GatherTool::feel(const PenSample& sample) {
  const std::int64_t waited_ns = nanoseconds_off(sample.time_ns, feel_ns_);
  if (waited_ns < kFeelNs) return;
  feel_ns_ = sample.time_ns;
  const double seconds = std::min(1e-9 * static_cast<double>(waited_ns), kLongestFeelS);
  const double now = spread_mm(*brush_, bundle_, *pen_);
  spread_mm_ += seconds / (kSpreadSeconds + seconds) * (now - spread_mm_);
}

ToolResult GatherTool::end(const Scene& scene) {
  ToolResult result;
  result.commit = gather_edit(scene.document, brushed_bundle(*brush_), {.width = settings_.width});
  stop();
  return result;
}

void GatherTool::drop() {
  stop();
}

void GatherTool::stop_hovering() {
  pen_.reset();
}

void GatherTool::stop() {
  brush_.reset();
  bundle_ = {};
  has_changed_ = false;
  preview_interval_ns_ = kPreviewNs;
  spread_mm_ = 0.0;
}

ForceModel GatherTool::force(const Scene& scene) const {
  return make_gather_force(scene, spread_mm_, settings_.strength);
}

void GatherTool::draw(Overlay& overlay) const {
  if (is_waiting() || !pen_) return;
  overlay.rings.push_back({*pen_, settings_.radius_mm, Overlay::Role::kReach});
  if (!brush_ || bundle_.count < 2) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f mm apart", spread_mm_);
  overlay.labels.push_back({*pen_ + settings_.radius_mm * Vec{0.8, -0.8}, text.data()});
}

}  // namespace felt
