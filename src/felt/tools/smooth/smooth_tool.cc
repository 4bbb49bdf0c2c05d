#include "felt/tools/smooth/smooth_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/tools/pressing.h"
#include "felt/tools/smooth/smooth_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kSmoothUses = {
    {{.hint = "Rub along a line to smooth it; press harder to smooth it more.",
      .size = "radius_mm",
      .path = ToolPath::kAlong}}};
constexpr std::array<std::string_view, 1> kSmoothEdits = {"Smooth"};
constexpr ToolInfo kSmoothInfo{
    .id = "smooth",
    .label = "Smooth",
    .help = "Smooths the jitter out of lines and keeps their shape.",
    .shortcut = 's',
    .options = kSmoothOptions,
    .kind = ToolKind::kEdits,
    .uses = kSmoothUses,
    .edits = kSmoothEdits,
    .act = {.title = "Smooth",
            .caption = "Rub along a shaky line to remove the jitter and keep the shape.",
            .seconds = 16.0}};
constexpr const char* kSmoothLabel = "Smooth";
/// Maximum distance along the line between two applications of the iron within one sample.
constexpr double kIronStepMm = 1.0;
constexpr double kMaxIronSteps = 100.0;
/// Longer lines are not ironed, because nobody draws such a line by hand and ironing it would take
/// too long.
constexpr double kLongestLineMm = 20'000.0;
/// Time constant of the low-pass for the roughness that the user feels.
constexpr double kFeelSeconds = 0.040;

double seconds_off(std::int64_t a_ns, std::int64_t b_ns) {
  return 1e-9 * std::fabs(static_cast<double>(a_ns) - static_cast<double>(b_ns));
}

}  // namespace

std::unique_ptr<Tool> make_smooth() {
  return std::make_unique<SmoothTool>();
}

SmoothTool::SmoothTool() : GestureTool(kSmoothInfo), settings_(smooth_settings(options())) {}

void SmoothTool::take_options(const OptionValues& options) {
  settings_ = smooth_settings(options);
}

ToolResult SmoothTool::hover(const PenSample& sample, const Scene& scene) {
  hold_.take(scene, on_page(sample.position));
  return {};
}

ToolResult SmoothTool::begin(const PenSample& sample, const Scene& scene) {
  return take(sample, scene);
}

ToolResult SmoothTool::take(const PenSample& sample, const Scene& scene) {
  if (!hold_.take(scene, on_page(sample.position))) return {};
  if (hold_.map().length_mm() > kLongestLineMm) return {};
  replacement_.emplace(scene.document, hold_.id());
  ironing_.emplace(*hold_.stroke(), hold_.map(), settings_.iron);
  connected_.emplace(BrushOptions{});
  last_ns_ = preview_ns_ = force_ns_ = sample.time_ns;
  const auto points = static_cast<std::int64_t>(hold_.stroke()->data().points.size());
  preview_interval_ns_ = std::max(kPreviewNs, kPreviewNsPerPoint * points);
  iron(sample, scene, true);
  feel(kLongestStepS);
  return {};
}

ToolResult SmoothTool::move(const PenSample& sample, const Scene& scene) {
  if (!ironing_) return take(sample, scene);
  iron(sample, scene, hold_.follow(scene, on_page(sample.position)));
  // The expensive steps are spread over samples: filtering, then the preview, then the felt
  // roughness.
  if (std::exchange(is_caught_up_, false)) {
    std::optional<Stroke> ironed = ironing_->shown();
    if (!ironed) return {.same_preview = true};
    return {.preview = edit(*std::move(ironed), scene)};
  }
  const double unshown = seconds_off(preview_ns_, sample.time_ns);
  const double unfelt = seconds_off(force_ns_, sample.time_ns);
  if (has_changed_ && unshown >= 1e-9 * static_cast<double>(preview_interval_ns_)) {
    preview_ns_ = sample.time_ns;
    has_changed_ = false;
    is_caught_up_ = true;
    ironing_->catch_up();
  } else if (unfelt >= 1e-9 * static_cast<double>(kPreviewNs)) {
    force_ns_ = sample.time_ns;
    feel(std::min(unfelt, kLongestStepS));
  }
  return {.same_preview = true};
}

/// Returns the edit that replaces the stroke, with the changes of the strokes that follow.
Edit SmoothTool::edit(Stroke ironed, const Scene& scene) {
  Edit edit = replacement_->with(std::make_shared<const Stroke>(std::move(ironed)), kSmoothLabel);
  connected_->complete(edit, scene);
  return edit;
}

void SmoothTool::iron(const PenSample& sample, const Scene& scene, bool is_near) {
  const double seconds = seconds_between(last_ns_, sample.time_ns, kLongestStepS);
  last_ns_ = sample.time_ns;
  const double pressure = Pressing(scene.surface, scene.device).of(sample).value_or(kMousePressure);
  const double rate = is_near ? kDoseRate * settings_.amount * (0.2 + 1.6 * pressure) : 0.0;
  const double dose = 0.5 * (rate + std::exchange(rate_, rate)) * seconds;
  if (!is_near || !hold_.way_mm() || !(dose > 0.0)) return;
  has_changed_ = true;
  const double way = *hold_.way_mm(), whole = hold_.map().length_mm();
  // The number of steps is limited. If the pen jumps along a long line, it irons the line only at
  // some points.
  const int steps =
      static_cast<int>(std::clamp(std::ceil(std::fabs(way) / kIronStepMm), 1.0, kMaxIronSteps));
  for (int i = 0; i < steps; ++i) {
    double length = hold_.place().length_mm - way * (1.0 - (i + 0.5) / steps);
    if (hold_.stroke()->closed()) length -= whole * std::floor(length / whole);
    ironing_->add(std::clamp(length, 0.0, whole), settings_.radius_mm, dose / steps);
  }
}

void SmoothTool::feel(double seconds) {
  const double now = ironing_->roughness_mm(hold_.place().length_mm, 0.5 * settings_.radius_mm);
  rough_mm_ += seconds / (kFeelSeconds + seconds) * (now - rough_mm_);
}

ToolResult SmoothTool::end(const Scene& scene) {
  ToolResult result;
  if (ironing_) {
    if (std::optional<Stroke> done = ironing_->finished()) {
      result.commit = edit(*std::move(done), scene);
    }
  }
  stop();
  return result;
}

void SmoothTool::drop() {
  stop();
}

void SmoothTool::stop() {
  ironing_.reset();
  replacement_.reset();
  connected_.reset();
  hold_.release();  // because the held stroke has changed
  has_changed_ = is_caught_up_ = false;
  rate_ = rough_mm_ = 0.0;
}

ForceModel SmoothTool::force(const Scene& scene) const {
  return make_smooth_force(scene, rough_mm_, settings_.strength);
}

void SmoothTool::draw(Overlay& overlay) const {
  if (!hold_.holds() || is_waiting()) return;
  const ArcMap& map = hold_.map();
  const Stroke& stroke = *hold_.stroke();
  const StrokeHold::Place& here = hold_.place();
  overlay.rings.push_back({here.point, settings_.radius_mm, Overlay::Role::kReach});
  double first = here.length_mm - settings_.radius_mm, last = here.length_mm + settings_.radius_mm;
  if (last - first >= map.length_mm()) {
    add_span(overlay, stroke, 0.0, stroke.segment_count(), Overlay::Role::kSpan);
  } else {
    if (!stroke.closed()) first = std::max(first, 0.0);
    if (!stroke.closed()) last = std::min(last, map.length_mm());
    add_span(overlay, stroke, map.u_at(first), map.u_at(last), Overlay::Role::kSpan);
  }
  if (ironing_) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f mm rough", rough_mm_);
    overlay.labels.push_back({here.point + Vec{1.5, -1.5}, text.data()});
  }
}

}  // namespace felt
