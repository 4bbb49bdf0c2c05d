#include "replay_machine.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/formats/line_drawing.h"
#include "felt/material/materials.h"
#include "felt/tools/medium_line.h"
#include "felt/tools/pressing.h"
#include "input.h"
#include "option_text.h"

namespace felt::cli {
namespace {

/// What other tools do to ink is not compared with the way of the hand.
constexpr const char* kDrawingTool = "pencil";

/// Some 200 s of aims, 20 MB.
constexpr std::size_t kManyEvents = 200'000;
constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

double number_option(const Session& session, const char* id, double otherwise) {
  const Result<OptionValue> value = session.option(id);
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : otherwise;
}

/// The medium that the pencil has now, or null.
const Medium* pencil_medium(const Session& session) {
  const Result<OptionValue> value = session.option("pencil.material");
  const auto* id = value ? std::get_if<std::string>(&*value) : nullptr;
  return id ? session.materials().find_medium(*id) : nullptr;
}

/// An input that is no stream of lines.
Result<OpenedDrawing> read_whole(const Input& input) {
  Result<OpenedDrawing> opened = input.read_drawing({});
  if (opened) return opened;
  return fail(opened.error().code, input.name() + ": " + opened.error().message);
}

/// A script must be told of every line that is wrong: what it draws depends on it.
Result<Sketch> read_lines(const Input& input) {
  LineReader reader(input.reader());
  LineBatch batch;
  LineStrokes strokes;
  Sketch sketch;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kBatchBytes);
    if (!more) return fail(more.error().code, input.name() + ": " + more.error().message);
    if (!*more) return sketch;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      Result<std::optional<SketchStroke>> stroke = strokes.read(line);
      if (!stroke) {
        return fail(stroke.error().code,
                    fmt::format("{}:{}: {}", input.name(), line.number(), stroke.error().message));
      }
      if (*stroke) sketch.push_back(**std::move(stroke));
    }
  }
}

bool presses(const HandEvent& aim) {
  return aim.target.z < 0.0 || aim.pressure.value_or(0.0) > 0.0;
}

}  // namespace

ReplayMachine::ReplayMachine(const ReplaySettings& settings, Document document, Observer observer)
    : settings_(settings),
      observer_(std::move(observer)),
      stylus_(settings.device, settings.hand),
      session_(make_tools(), {.device = settings.device.capabilities,
                              .materials = settings.materials,
                              .document = std::move(document),
                              .on_event = observer_.event,
                              .on_edit = [this](const Edit& edit) { see_edit(edit); }}),
      probe_(make_tools(), {.device = settings.device.capabilities,
                            .materials = settings.materials,
                            .document = {},
                            .on_event = {},
                            .on_edit = {}}),
      player_(stylus_, &stylus_, session_, player_options()) {}

PlayerOptions ReplayMachine::player_options() {
  PlayerOptions options;
  options.period_ns = settings_.device.capabilities.period_ns;
  options.forces = settings_.force;
  options.on_tick = [this](const TickReport& report) { see_tick(report); };
  options.read_import = [](const ImportEvent& import) { return read_sketch(import.path); };
  options.is_cancelled = [this] { return see_turn(); };
  return options;
}

bool ReplayMachine::see_turn() {
  if (observer_.turn && !events_.empty()) {
    const std::int64_t start_ns = events_.front().time_ns;
    const auto all = static_cast<double>(events_.back().time_ns - start_ns);
    const auto done = static_cast<double>(pen_.time_ns - start_ns);
    observer_.turn(session_, all > 0.0 ? std::clamp(done / all, 0.0, 1.0) : 1.0);
  }
  if (observer_.until_ns && pen_.time_ns >= *observer_.until_ns) {
    is_stopped_ = true;
    if (observer_.stopped) observer_.stopped(session_, pen_);
  }
  return is_stopped_ || !observed_;
}

HandScriptOptions ReplayMachine::hand_options() const {
  HandScriptOptions options = settings_.script;
  const SurfaceMaterial& sheet = probe_.sheet().material();
  const Result<OptionValue> id = probe_.option("pencil.material");
  const auto* name = id ? std::get_if<std::string>(&*id) : nullptr;
  const Medium* tool = name ? probe_.materials().find_medium(*name) : nullptr;
  set_surface(options, sheet, probe_.device(), tool);
  return options;
}

Result<void> ReplayMachine::set_option(const std::string& id, const std::string& text) {
  const Result<OptionValue> present = probe_.option(id);
  if (!present) return tl::unexpected(present.error());
  const Result<OptionValue> value = value_like(*present, text);
  if (!value) return fail(value.error().code, id + ": " + value.error().message);
  const Event event{0, SetOption{id, *value}};
  if (Result<void> known = probe_.apply(event); !known) return known;
  return session_.apply(event);
}

Result<void> ReplayMachine::add(const Event& event) {
  if (const auto* import = std::get_if<ImportEvent>(&event.what)) {
    const Result<Sketch> sketch = read_sketch(import->path);
    if (!sketch) return tl::unexpected(sketch.error());
  } else if (std::holds_alternative<SelectTool>(event.what) ||
             std::holds_alternative<SetOption>(event.what) ||
             std::holds_alternative<UseMaterial>(event.what)) {
    if (Result<void> known = probe_.apply(event); !known) return known;
  } else if (const auto* aim = std::get_if<HandEvent>(&event.what)) {
    note_aim(event.time_ns, *aim);
  }
  events_.push_back(event);
  return {};
}

void ReplayMachine::note_aim(std::int64_t time_ns, const HandEvent& aim) {
  if (in_stroke_) {
    if (meant_.back().start_ns < 0) meant_.back().start_ns = time_ns;
    return;
  }
  const bool is_down = presses(aim) && probe_.tool().info().id == kDrawingTool;
  if (is_down && !hand_is_down_) meant_.push_back({time_ns, {}});
  if (is_down) meant_.back().path.push_back(on_sheet(aim.target));
  hand_is_down_ = is_down;
}

void ReplayMachine::begin_stroke() {
  in_stroke_ = true;
  meant_.push_back({-1, {}});
}

void ReplayMachine::stroke_drawn(const std::vector<Point>& meant) {
  // What was meant is the stroke, not the aims, by which the hand makes up for mass and friction.
  meant_.back().path = meant;
  in_stroke_ = hand_is_down_ = false;
}

bool ReplayMachine::is_full() const noexcept {
  return events_.size() >= kManyEvents;
}

ReplayStats ReplayMachine::take_stats() {
  ReplayStats taken = std::exchange(stats_, {});
  taken.strokes_changed = std::ssize(changed_);
  changed_.clear();
  for (const SketchStroke& stroke : session_.sketch()) {
    ++taken.strokes;
    taken.segments += stroke.stroke.segment_count();
  }
  return taken;
}

Result<void> ReplayMachine::play() {
  if (is_stopped_) events_.clear();
  if (events_.empty()) return {};
  const Result<PlayReport> report = player_.play(events_);
  if (!report) return tl::unexpected(report.error());
  if (!observed_) return observed_;
  stats_.ticks += static_cast<std::int64_t>(report->ticks);
  stats_.simulated_s += 1e-9 * static_cast<double>(settings_.device.capabilities.period_ns) *
                        static_cast<double>(report->ticks);
  stats_.edits += static_cast<std::int64_t>(report->edits);
  stats_.soft_faults += report->safety.soft_faults;
  stats_.hard_faults += report->safety.hard_faults;
  stats_.max_asked_n = std::max(stats_.max_asked_n, report->largest_asked_n);
  stats_.max_sent_n = std::max(stats_.max_sent_n, report->largest_sent_n);
  next_ns_ = report->end_ns + settings_.device.capabilities.period_ns;
  compare_ink();
  events_.clear();
  return {};
}

void ReplayMachine::see_tick(const TickReport& report) {
  if (in_contact(report.sample) && !in_contact(pen_)) ++stats_.touches;
  pen_ = report.sample;
  if (in_contact(report.sample)) {
    ++stats_.ticks_in_contact;
    stats_.sent_sum_n += norm(report.sent);
  }
  if (!observer_.tick || !observed_) return;
  const Pressing pressing(session_.sheet().material(), settings_.device.capabilities);
  const std::optional<double> pressure = pressing.of(report.sample);
  observed_ = observer_.tick({report, pressure, width_at(report, pressure)});
}

std::optional<double> ReplayMachine::width_at(const TickReport& report,
                                              std::optional<double> pressure) {
  const bool was_down = std::exchange(pen_is_down_, in_contact(report.sample));
  if (!pen_is_down_) return std::nullopt;
  if (!was_down) {
    InkFitOptions ink;
    ink.width_map = {.min_mm = number_option(session_, "pencil.min_width_mm", 0.3),
                     .max_mm = number_option(session_, "pencil.max_width_mm", 6.0),
                     .gamma = number_option(session_, "pencil.gamma", 1.0)};
    const Medium* medium = pencil_medium(session_);
    widths_ = WidthMap((medium ? drawn_with(*medium, ink) : ink).width_map);
  }
  return widths_
      .push({on_sheet(report.sample.position), pressure, report.sample.time_ns,
             report.sample.lean_deg})
      .width_mm;
}

void ReplayMachine::see_edit(const Edit& edit) {
  for (const StrokeChange& change : edit.changes) {
    changed_.insert(change.id);
    if (change.after && session_.tool().info().id == kDrawingTool)
      ink_.push_back({pen_.time_ns, *change.after});
  }
}

/// Ink belongs to the last path that was begun before it was finished.
void ReplayMachine::compare_ink() {
  auto ink = ink_.begin();
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < meant_.size(); ++i) {
    const bool is_last = i + 1 == meant_.size();
    strokes.clear();
    for (; ink != ink_.end() && (is_last || ink->time_ns < meant_[i + 1].start_ns); ++ink) {
      if (ink->time_ns >= meant_[i].start_ns) strokes.push_back(ink->stroke);
    }
    stats_.distance.add(meant_[i].path, strokes);
  }
  stats_.strokes_meant += static_cast<std::int64_t>(meant_.size());
  meant_.clear();
  ink_.clear();
}

Result<OpenedDrawing> read_start(const std::string& path) {
  const Result<Input> input = Input::open(path);
  if (!input) return fail(input.error().code, input_name(path) + ": " + input.error().message);
  if (!input->is_lines()) return read_whole(*input);
  return read_lines(*input).map([](const Sketch& sketch) {
    OpenedDrawing opened;
    opened.drawing.document = document_of(sketch);
    return opened;
  });
}

Result<Sketch> read_sketch(const std::string& path) {
  const Result<Input> input = Input::open_regular(path);
  if (!input) return fail(input.error().code, input_name(path) + ": " + input.error().message);
  if (input->is_lines()) return read_lines(*input);
  return read_whole(*input).map(
      [](const OpenedDrawing& opened) { return visible_strokes(opened.drawing.document); });
}

}  // namespace felt::cli
