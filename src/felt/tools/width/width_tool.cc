#include "felt/tools/width/width_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/tools/brush_bump.h"

namespace felt {
namespace {

constexpr std::string_view kHint = "Rub a line to make it broader or thinner.";
constexpr std::array<ToolUse, 2> kWidthUses = {{{.mode = "scale",
                                                 .hint = kHint,
                                                 .first_modifier = "thinner",
                                                 .second_modifier = "thicker",
                                                 .size = "reach_mm",
                                                 .path = ToolPath::kAway},
                                                {.hint = kHint,
                                                 .first_modifier = "thinner",
                                                 .second_modifier = "thicker",
                                                 .size = "reach_mm",
                                                 .path = ToolPath::kAlong}}};
constexpr std::array<std::string_view, 1> kWidthEdits = {"Width"};
constexpr ToolInfo kWidthInfo{
    .id = "width",
    .label = "Width",
    .help = "Makes lines broader and thinner, here and there or as a whole.",
    .shortcut = 'w',
    .options = kWidthOptions,
    .kind = ToolKind::kEdits,
    .uses = kWidthUses,
    .edits = kWidthEdits,
    .act = {.title = "Width",
            .caption = "Press on a finished line to make it broader.",
            .seconds = 14.0}};
constexpr std::string_view kWidthLabel = "Width";
/// Maximum distance along the line between two applications of the brush within one sample.
constexpr double kBrushStepMm = 1.0;
constexpr double kMaxBrushSteps = 200.0;  // farther than a hand moves in a sample
/// Time constant of the low-pass for the stops, so that the force does not jump.
constexpr double kStopSeconds = 0.030;
/// Maximum number of lines marked while several are scaled.
constexpr std::size_t kMaxMarked = 64;

std::string text_of(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

bool may_be_edited(const Document& document, StrokeId id) {
  if (!document.find(id)) return false;
  const Layer* layer = document.layer(document.layer_of(id));
  return layer && layer->visible && !layer->locked;
}

}  // namespace

std::unique_ptr<Tool> make_width() {
  return std::make_unique<WidthTool>();
}

WidthTool::WidthTool() : GestureTool(kWidthInfo), settings_(width_settings(options())) {}

void WidthTool::take_options(const OptionValues& options) {
  settings_ = width_settings(options);
  direction_ = settings_.direction;
}

ToolResult WidthTool::hover(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  hold_.take(scene, pen_);
  return {};
}

ToolResult WidthTool::begin(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  return take(sample, scene);
}

ToolResult WidthTool::take(const PenSample& sample, const Scene& scene) {
  if (!hold_.take(scene, pen_)) return {};
  find_lines(scene);
  const Stroke& stroke = *hold_.stroke();
  origin_ = pen_;
  factor_ = 1.0;
  touch_u_ = hold_.place().u;
  last_ns_ = preview_ns_ = sample.time_ns;
  rate_mm_per_s_ = 0.0;
  if (settings_.mode == WidthMode::kBrush) {
    brush_.emplace(stroke, hold_.map(), settings_.reach_mm, settings_.map.max_mm);
  } else if (settings_.mode == WidthMode::kRetrace) {
    retrace_.emplace(stroke, hold_.map());
    width_map_ = WidthMap(settings_.map);
    width_map_.begin();
  }
  apply(sample, scene, true);
  return {};
}

/// Sets edit_ to the held line. In the mode `scale`, if that line is selected, adds all other
/// selected lines.
void WidthTool::find_lines(const Scene& scene) {
  EditBuilder builder(scene.document);
  std::size_t points = hold_.stroke()->data().points.size();
  builder.replace(hold_.id(), hold_.stroke());
  if (settings_.mode == WidthMode::kScale && scene.selection.find(hold_.id())) {
    for (const auto& [id, marks] : scene.selection.strokes()) {
      if (id == hold_.id() || !may_be_edited(scene.document, id)) continue;
      builder.replace(id, scene.document.find(id));
      points += marks.size();
    }
  }
  edit_ = std::move(builder).build(std::string(kWidthLabel));
  // Puts the held line first. The others keep their order.
  const auto held = std::find_if(edit_.changes.begin(), edit_.changes.end(),
                                 [&](const StrokeChange& c) { return c.id == hold_.id(); });
  std::rotate(edit_.changes.begin(), held, held + 1);
  preview_interval_ns_ =
      std::max(kPreviewNs, kPreviewNsPerPoint * static_cast<std::int64_t>(points));
}

ToolResult WidthTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  if (!is_working()) return take(sample, scene);
  apply(sample, scene, hold_.follow(scene, pen_));
  const double waited = static_cast<double>(sample.time_ns) - static_cast<double>(preview_ns_);
  if (!has_changed_ || std::fabs(waited) < static_cast<double>(preview_interval_ns_)) {
    return {.same_preview = true};
  }
  preview_ns_ = sample.time_ns;
  update_edit();
  return {.preview = edit_};
}

void WidthTool::apply(const PenSample& sample, const Scene& scene, bool is_near) {
  const double seconds = seconds_between(last_ns_, sample.time_ns, kLongestStepS);
  last_ns_ = sample.time_ns;
  direction_ = (sample.buttons & kFirstModifier) != 0    ? WidthDirection::kThinner
               : (sample.buttons & kSecondModifier) != 0 ? WidthDirection::kThicker
                                                         : settings_.direction;
  switch (settings_.mode) {
    case WidthMode::kBrush: {
      const auto pressing = Pressing(scene.surface, scene.device).of(sample);
      const double pressure = pressing.value_or(settings_.map.absent_pressure);
      const double rate = is_near ? brush_rate(pressure) : 0.0;
      if (is_near && hold_.way_mm()) brush(seconds, 0.5 * (rate_mm_per_s_ + rate));
      rate_mm_per_s_ = rate;
      update_stops(seconds);
      break;
    }
    case WidthMode::kRetrace:
      if (is_near) retrace(sample, scene);
      break;
    case WidthMode::kScale: {
      const double factor = std::exp2((origin_.y - pen_.y) / kDoublingMm);
      has_changed_ = has_changed_ || factor != factor_;
      factor_ = factor;
      break;
    }
  }
}

double WidthTool::brush_rate(double pressure) const noexcept {
  switch (direction_) {
    case WidthDirection::kPressure:
      return settings_.rate_mm_per_s * (pressure - 0.5);
    case WidthDirection::kThicker:
      return settings_.rate_mm_per_s * 0.5 * pressure;
    case WidthDirection::kThinner:
      return settings_.rate_mm_per_s * -0.5 * pressure;
  }
  return 0.0;
}

/// Spreads the change of width since the last sample over the distance that the pen has moved since
/// then.
void WidthTool::brush(double seconds, double rate) {
  const double amount = rate * seconds, way = hold_.way_mm().value_or(0.0);
  if (amount == 0.0) return;
  has_changed_ = true;
  const StrokeHold::Place& here = hold_.place();
  if (way == 0.0) {
    brush_->add(here.u, here.length_mm, amount);
    return;
  }
  const int steps =
      static_cast<int>(std::clamp(std::ceil(std::fabs(way) / kBrushStepMm), 1.0, kMaxBrushSteps));
  for (int i = 0; i < steps; ++i) {
    double length = here.length_mm - way * (1.0 - (i + 0.5) / steps);
    const double whole = hold_.map().length_mm();
    if (hold_.stroke()->closed()) length -= whole * std::floor(length / whole);
    length = std::clamp(length, 0.0, whole);
    brush_->add(hold_.map().u_at(length), length, amount / steps);
  }
}

void WidthTool::retrace(const PenSample& sample, const Scene& scene) {
  const auto pressure = Pressing(scene.surface, scene.device).of(sample);
  const double width = width_map_.push({pen_, pressure, sample.time_ns}).width_mm;
  if (hold_.way_mm()) {
    retrace_->go(*hold_.way_mm(), width);
    has_changed_ = retrace_->has_drawn();
  } else {
    retrace_->jump(hold_.place().length_mm, width);
  }
}

void WidthTool::update_stops(double seconds) {
  const double width = width_here();
  const auto nearness = [](double room_mm) { return bump(std::max(0.0, room_mm) / kStopMm); };
  const double broadest = nearness(settings_.map.max_mm - width);
  // A line of normal width is always within kStopMm of the minimum width, so at this limit the stop
  // begins at half of kStopMm.
  const double thinnest = nearness(2.0 * (width - kMinWidthMm));
  WidthStops aim;
  aim.harder = direction_ == WidthDirection::kThinner ? thinnest : broadest;
  aim.lighter = direction_ == WidthDirection::kPressure ? thinnest : 0.0;
  const double share = seconds / (kStopSeconds + seconds);
  stops_.harder += share * (aim.harder - stops_.harder);
  stops_.lighter += share * (aim.lighter - stops_.lighter);
}

double WidthTool::width_here() const {
  const StrokeHold::Place& here = hold_.place();
  if (brush_) return brush_->width_mm(here.u, here.length_mm);
  const Stroke& shown = is_working() ? *edit_.changes.front().after : *hold_.stroke();
  return shown.width_mm(here.u);
}

void WidthTool::set_widths(StrokeChange& change, std::vector<WidthKnot> widths) {
  if (std::ranges::equal(widths, change.before->widths())) {
    change.after = change.before;
    return;
  }
  StrokeData data = change.before->data();
  data.widths = std::move(widths);
  // If the profile is not valid, the last valid one is kept.
  if (auto made = Stroke::create(std::move(data))) {
    change.after = std::make_shared<const Stroke>(*std::move(made));
  }
}

void WidthTool::update_edit() {
  has_changed_ = false;
  if (brush_) {
    std::array<double, 2> pinned{touch_u_, hold_.place().u};
    std::ranges::sort(pinned);
    set_widths(edit_.changes.front(), brush_->profile(pinned));
  } else if (retrace_) {
    set_widths(edit_.changes.front(), retrace_->profile());
  } else {
    for (StrokeChange& change : edit_.changes) {
      set_widths(change, scaled(change.before->widths(), factor_, settings_.map.max_mm));
    }
  }
}

ToolResult WidthTool::end(const Scene&) {
  ToolResult result;
  if (is_working()) {
    update_edit();
    std::erase_if(edit_.changes, [](const StrokeChange& c) { return c.after == c.before; });
    if (is_working()) result.commit = std::move(edit_);
  }
  stop();
  return result;
}

void WidthTool::drop() {
  stop();
}

void WidthTool::stop() {
  edit_ = {};
  brush_.reset();
  retrace_.reset();
  hold_.release();  // because the held stroke has changed
  stops_ = {};
  has_changed_ = false;
}

ForceModel WidthTool::force(const Scene& scene) const {
  WidthFeel feel{.stops = stops_, .direction = direction_, .origin_y_mm = {}};
  if (is_working() && settings_.mode == WidthMode::kScale) feel.origin_y_mm = origin_.y;
  return make_width_force(settings_, scene, feel);
}

void WidthTool::draw(Overlay& overlay) const {
  if (!hold_.holds() || is_waiting()) return;
  const Stroke& shown = is_working() ? *edit_.changes.front().after : *hold_.stroke();
  draw_reach(overlay, shown);
  const Point at = hold_.place().point;
  const double width = width_here();
  overlay.rings.push_back({at, 0.5 * width + 0.5, Overlay::Role::kReach});
  std::string text = text_of("%.2f mm", width);
  if (is_working() && settings_.mode == WidthMode::kScale) {
    overlay.lines.push_back({origin_, {origin_.x, pen_.y}, Overlay::Role::kVector});
    text = text_of("x %.2f", factor_);
  }
  overlay.labels.push_back({at + Vec{0.5 * width + 1.5, -(0.5 * width + 1.5)}, text});
}

void WidthTool::draw_reach(Overlay& overlay, const Stroke& shown) const {
  const ArcMap& map = hold_.map();
  const double n = shown.segment_count(), whole = map.length_mm();
  double first = hold_.place().length_mm, last = first;
  if (settings_.mode == WidthMode::kScale) {
    add_span(overlay, shown, 0.0, n, Overlay::Role::kSpan);
    for (std::size_t i = 1; i < std::min(edit_.changes.size(), kMaxMarked); ++i) {
      const Stroke& other = *edit_.changes[i].after;
      add_span(overlay, other, 0.0, other.segment_count(), Overlay::Role::kSpan);
    }
    return;
  }
  if (settings_.mode == WidthMode::kBrush) {
    first -= settings_.reach_mm;
    last += settings_.reach_mm;
  } else if (retrace_ && retrace_->has_drawn()) {
    first = retrace_->first_mm();
    last = retrace_->last_mm();
  }
  if (last - first >= whole) {
    add_span(overlay, shown, 0.0, n, Overlay::Role::kSpan);
  } else if (last > first) {
    const bool open = !shown.closed();
    add_span(overlay, shown, map.u_at(open ? std::max(first, 0.0) : first),
             map.u_at(open ? std::min(last, whole) : last), Overlay::Role::kSpan);
  }
}

}  // namespace felt
