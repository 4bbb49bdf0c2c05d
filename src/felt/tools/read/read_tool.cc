#include "felt/tools/read/read_tool.h"

#include <algorithm>
#include <array>
#include <utility>

#include "felt/geometry/polyline.h"
#include "felt/tools/read/read_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kReadUses = {
    {{.hint = "Touch a line and follow it: it holds the pen, its ends and crossings click.",
      .path = ToolPath::kAlong}}};
constexpr ToolInfo kReadInfo{
    .id = "read",
    .label = "Read",
    .help =
        "Reads a drawing without eyes: lines attract the pen, and are "
        "heard and spoken.",
    .shortcut = 'l',
    .options = kReadOptions,
    .kind = ToolKind::kReads,
    .uses = kReadUses,
    .act = {.title = "Read",
            .caption = "A drawing can be read without eyes: lines hold the "
                       "pen, ends and crossings click, and what is under "
                       "the pen is spoken.",
            .seconds = 8.0}};
/// The pen is on a line if it is this near to its ink: then the groove holds it.
constexpr double kOnLineMm = 2.0;
/// How far the pen moves before fills are searched again.
constexpr double kFillLookMm = 0.5;
constexpr double kFillToleranceMm = 0.05;
constexpr std::size_t kMaxFillShapes = 256;

double ink_distance(const StrokeHit& hit, const Document& document) {
  const StrokePtr& stroke = document.find(hit.stroke);
  const double half_mm = stroke ? 0.5 * stroke->width_mm(hit.u) : 0.0;
  return std::max(0.0, hit.distance_mm - half_mm);
}

}  // namespace

std::unique_ptr<Tool> make_read() {
  return std::make_unique<ReadTool>();
}

ReadTool::ReadTool() : GestureTool(kReadInfo), settings_(read_settings(options())) {}

void ReadTool::take_options(const OptionValues& options) {
  settings_ = read_settings(options);
  reading_.has_sound = settings_.has_sound;
}

ToolResult ReadTool::hover(const PenSample& sample, const Scene&) {
  pen_ = on_page(sample.position);
  return {};
}

ToolResult ReadTool::begin(const PenSample& sample, const Scene& scene) {
  stop();
  return move(sample, scene);
}

ToolResult ReadTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  track_.update(sample, scene, settings_);
  read(*pen_, scene);
  return {};
}

/// Finds what is under the pen: a mark, else a line, else a fill.
void ReadTool::read(Point pen, const Scene& scene) {
  Reading now;
  now.is_down = true;
  if (const auto& hit = track_.nearest()) now.distance_mm = ink_distance(*hit, scene.document);
  now.stroke = track_.stroke();
  now.length_mm = track_.length_mm();
  if (const LineMark* mark = track_.mark()) {
    now.kind = mark->lines > 1 ? Reading::Kind::kCrossing : Reading::Kind::kEnd;
    now.lines = mark->lines;
  } else if (now.distance_mm <= kOnLineMm) {
    now.kind = Reading::Kind::kLine;
  } else {
    now.stroke = {};
    now.length_mm = 0.0;
    now.fill = fill_at(pen, scene);
    if (now.fill.value != 0) now.kind = Reading::Kind::kFill;
  }
  report(now);
}

/// Replaces the reading, and counts what is new.
void ReadTool::report(const Reading& now) {
  const bool is_mark = now.kind == Reading::Kind::kEnd || now.kind == Reading::Kind::kCrossing;
  const bool is_other = now.kind != reading_.kind || now.stroke != reading_.stroke ||
                        now.fill != reading_.fill || now.lines != reading_.lines;
  const std::uint32_t news = reading_.news + (is_other ? 1U : 0U);
  const std::uint32_t clicks = reading_.clicks + (is_mark && is_other ? 1U : 0U);
  reading_ = now;
  reading_.has_sound = settings_.has_sound;
  reading_.news = news;
  reading_.clicks = clicks;
}

/// Returns the highest fill under the pen, or zero.
FillId ReadTool::fill_at(Point pen, const Scene& scene) {
  if (filled_at_ && distance(*filled_at_, pen) < kFillLookMm) return filled_;
  filled_at_ = pen;
  filled_ = {};
  if (shapes_.size() > kMaxFillShapes) shapes_.clear();
  for (const Layer& layer : scene.document.layers()) {
    const bool counts =
        layer.visible && (settings_.layers == ReadLayers::kVisible || layer.id == scene.layer);
    if (!counts) continue;
    for (const FillId id : layer.fills) {
      if (is_in(id, scene.document.find_fill(id), pen)) filled_ = id;
    }
  }
  return filled_;
}

bool ReadTool::is_in(const FillId& id, const FillPtr& fill, Point pen) {
  if (!fill || !fill_bounds(*fill).contains(pen)) return false;
  FillShape& shape = shapes_[id];
  if (shape.fill != fill) {
    shape.fill = fill;
    flatten_fill(*fill, kFillToleranceMm, shape.outline);
  }
  bool is_inside = false;  // by the even-odd rule, over all loops
  for (std::size_t k = 0; k < shape.outline.contour_count(); ++k) {
    if (contains(shape.outline.contour(k), pen, FillRule::kEvenOdd)) is_inside = !is_inside;
  }
  return is_inside;
}

ToolResult ReadTool::end(const Scene&) {
  stop();
  return {};
}

void ReadTool::drop() {
  stop();
}

void ReadTool::stop_hovering() {
  pen_.reset();
}

void ReadTool::stop() {
  track_.release();
  shapes_.clear();
  filled_at_.reset();
  report({});
}

ForceModel ReadTool::force(const Scene& scene) const {
  const GuideTrack* groove = is_waiting() ? nullptr : track_.groove();
  const LineMark* notch = is_waiting() ? nullptr : track_.notch();
  return make_read_force(settings_.strength, scene, groove, notch ? &notch->at : nullptr);
}

void ReadTool::draw(Overlay& overlay) const {
  if (is_waiting() || !in_gesture()) return;
  if (const auto& hit = track_.nearest()) {
    overlay.lines.push_back({*pen_, hit->point, Overlay::Role::kTether});
    overlay.dots.push_back({hit->point, Overlay::Role::kGuide});
  }
  // Cue devices click when the pen comes into the ring of a snap target.
  if (const LineMark* mark = track_.mark()) {
    overlay.rings.push_back({mark->at, ReadTrack::kLeaveMm, Overlay::Role::kSnap});
  }
}

}  // namespace felt
