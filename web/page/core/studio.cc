#include "web/page/core/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "desktop/engine/first_options.h"
#include "desktop/engine/usual_color.h"
#include "felt/formats/drawing_materials.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/material/material_file.h"
#include "felt/stroke/color_text.h"
#include "web/page/core/files.h"

namespace felt::page {
namespace {

constexpr std::int64_t kProcessTicks = 4;        // the work of the edit thread, every 4 ms
constexpr std::int64_t kRestNs = 3'000'000'000;  // then a pen without forces rests
constexpr double kEndlessMm = 1e10;              // the paper is moved under the device
constexpr const char* kSurfaceOption = "surface.material";

double absent_pressure(const Session& session) {
  const Result<OptionValue> value =
      session.option(std::string(session.tool().info().id) + ".mouse_pressure");
  const auto* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : HandScriptOptions{}.absent_pressure;
}

/// Returns the material of the same kind and id.
std::optional<AnyMaterial> find_in(const Materials& materials, const AnyMaterial& material) {
  const std::string_view id = id_of(material);
  if (std::holds_alternative<Medium>(material)) {
    const Medium* medium = materials.find_medium(id);
    return medium ? std::optional<AnyMaterial>(*medium) : std::nullopt;
  }
  const SurfaceMaterial* surface = materials.find_surface(id);
  return surface ? std::optional<AnyMaterial>(*surface) : std::nullopt;
}

void copy_options(const Session& from, Session& to, std::int64_t now_ns) {
  for (const std::string& id : from.option_ids()) {
    const Result<OptionValue> value = from.option(id), present = to.option(id);
    if (!value || (present && *present == *value)) continue;
    static_cast<void>(to.apply({now_ns, SetOption{id, *value}}));
  }
  const std::string tool(from.tool().info().id);
  if (tool != to.tool().info().id) static_cast<void>(to.apply({now_ns, SelectTool{tool}}));
}

}  // namespace

void Studio::make_session(Document document, std::span<const std::string> materials, Options from) {
  if (on_edit) on_edit(nullptr);
  SessionOptions options;
  options.document = std::move(document);
  options.on_event = [this](const Event& event) {
    if (on_event) on_event(event);
  };
  options.on_edit = [this](const Edit& edit) {
    if (on_edit) on_edit(&edit);
  };
  auto session = std::make_unique<Session>(make_tools(), std::move(options));
  const std::unique_ptr<Session> before = std::exchange(session_, std::move(session));
  if (from == Options::kDefaults) return;
  static_cast<void>(session_->apply({event_time_ns(), UseDevice{stylus_->capabilities()}}));
  for (const std::string& text : materials) {
    static_cast<void>(session_->apply({event_time_ns(), UseMaterial{text}}));
  }
  if (from == Options::kOfLastSession) copy_options(*before, *session_, event_time_ns());
  if (from == Options::kFirst) apply_first_options();
}

Result<void> Studio::restore(const Drawing& drawing, std::span<const Event> events) {
  stop_play();
  page_ = drawing.page;
  carried_ = {drawing.palette, drawing.view, drawing.extras, drawing.names};
  const std::int64_t before_ns = now_ns_;
  last_event_ns_ = 0;
  make_session(drawing.document, {}, Options::kDefaults);
  Result<void> done;
  for (const Event& event : events) {
    if (std::holds_alternative<ImportEvent>(event.what)) continue;
    const std::uint32_t before = session_->surface().color_rgb;
    done = session_->apply(event);
    if (!done) break;
    use_surface_of_session(before);
    last_event_ns_ = event.time_ns;
  }
  if (Result<void> finished = session_->finish(); done && !finished) done = finished;
  now_ns_ = std::max(before_ns, last_event_ns_);
  ahead_ns_ += now_ns_ - before_ns;
  pen_ = {};
  static_cast<void>(use_device(device_id_));
  return done;
}

void Studio::apply_first_options(const Tool& tool) {
  for (const OptionSpec& row : tool.info().options) {
    const OptionValue first = default_value(desktop::as_at_first(tool.info().kind, row));
    if (first == default_value(row)) continue;
    const std::string id = std::string(tool.info().id) + "." + std::string(row.id);
    static_cast<void>(session_->apply({event_time_ns(), SetOption{id, first}}));
  }
}

void Studio::complete_options(std::span<const Event> events) {
  for (const auto& tool : session_->tools()) {
    const std::string prefix = std::string(tool->info().id) + ".";
    const bool is_known = std::any_of(events.begin(), events.end(), [&](const Event& event) {
      const auto* option = std::get_if<SetOption>(&event.what);
      return option && option->id.starts_with(prefix);
    });
    if (!is_known) apply_first_options(*tool);
  }
}

/// Applies the initial options of the desktop program.
void Studio::apply_first_options() {
  for (const auto& tool : session_->tools()) apply_first_options(*tool);
  if (const Medium* medium = find_medium(desktop::kFirstMedium)) {
    const Rgba ink = desktop::usual_color({}, {}, medium->color_rgb, {});
    static_cast<void>(
        session_->apply({event_time_ns(), SetOption{"ink.color", color_to_text(ink)}}));
  }
}

std::vector<std::string> Studio::add_materials(std::span<const std::string> texts) {
  std::vector<std::string> others;
  for (const std::string& text : texts) {
    const Result<AnyMaterial> material = read_material(text);
    if (!material) continue;
    const std::optional<AnyMaterial> known = find_in(session_->materials(), *material);
    if (!known) {
      static_cast<void>(session_->apply({event_time_ns(), UseMaterial{text}}));
    } else if (known != *material) {
      others.push_back(label_of(*material));
    }
  }
  return others;
}

bool Studio::open(const Drawing& drawing) {
  finish();
  stop_play();
  make_session(drawing.document, drawing.materials, Options::kOfLastSession);
  set_page(drawing.page);
  carried_ = {drawing.palette, drawing.view, drawing.extras, drawing.names};
  const std::string& surface = drawing.page.surface;
  const bool has_surface = surface.empty() || apply(SetOption{kSurfaceOption, surface}).has_value();
  if (drawing.color != Rgba{}) {
    static_cast<void>(apply(SetOption{"ink.color", color_to_text(drawing.color)}));
  }
  if (drawing.layer) {
    static_cast<void>(apply(LayerEvent{.what = LayerEvent::Do::kUse, .layer = drawing.layer}));
  }
  return has_surface;
}

void Studio::set_page(const Page& page) {
  page_ = page;
}

Result<void> Studio::use_device(std::string_view id) {
  const bool is_simulated = id.starts_with("simulated:");
  const StylusPreset* found = find_stylus_preset(is_simulated ? id.substr(10) : id);
  if (!found || found->capabilities.has_force() != is_simulated) {
    return fail(ErrorCode::kNotFound, "unknown pen device \"" + std::string(id) + "\"");
  }
  if (session_) process();
  StylusPreset preset = *found;
  preset.capabilities.workspace_min.x = preset.capabilities.workspace_min.y = -kEndlessMm;
  preset.capabilities.workspace_max.x = preset.capabilities.workspace_max.y = kEndlessMm;
  servo_.reset();
  device_id_ = id;
  stylus_ = std::make_unique<SimulatedStylus>(preset, typical_hand());
  hand_options_ = script_options_for(preset, typical_hand());
  start_loop();
  if (!session_) return {};
  pen_ = {};
  return session_->apply({event_time_ns(), UseDevice{stylus_->capabilities()}});
}

void Studio::start_loop() {
  ServoOptions options;
  options.period_ns = stylus_->capabilities().period_ns;
  options.limits = limits_for(stylus_->capabilities());
  start_ns_ = now_ns_;
  servo_ = std::make_unique<Servo>(*stylus_, options);
  servo_->set_strength(strength_);
  servo_->set_session_offset(start_ns_);
  hand_ = std::make_unique<PointerHand>(*stylus_, hand_options_);
  if (forces_) servo_->arm();
}

void Studio::set_forces(bool on) {
  forces_ = on;
  on ? servo_->arm() : servo_->disarm();
}

void Studio::set_strength(double share) {
  if (std::isnan(share)) return;
  strength_ = std::clamp(share, 0.0, 1.0);
  servo_->set_strength(strength_);
}

// --- Input

void Studio::point(PointerSample sample) {
  if (play_) {
    if (!sample.touching) return;
    stop_play();
  }
  advance_to(sample.time_ns);
  sample.time_ns += ahead_ns_;
  awake_ns_ = now_ns_;
  pen_.hand = sample.position;
  hand_->set_surface(session_->surface(), session_->device());
  hand_->set_absent_pressure(absent_pressure(*session_));
  hand_->point({sample.time_ns - start_ns_, sample.position, sample.touching, sample.pressure,
                sample.buttons, sample.tilt_deg});
  has_point_ = true;
  touches_down_ = sample.touching && !in_contact(pen_.sample);
}

/// Makes the session's surface that of the page. A paper with the usual colour of the surface
/// before gets that of the new surface.
void Studio::use_surface_of_session(std::uint32_t before_rgb) {
  const SurfaceMaterial& surface = session_->surface();
  page_.surface = surface.id;
  if (surface.color_rgb == before_rgb) return;
  page_.paper = desktop::usual_color(page_.paper, before_rgb, surface.color_rgb, Page{}.paper);
}

Result<void> Studio::apply(decltype(Event::what) what) {
  awake_ns_ = now_ns_;
  process();
  const auto* option = std::get_if<SetOption>(&what);
  const bool is_surface = option && session_->current_option_id(option->id) == kSurfaceOption;
  const std::uint32_t before = session_->surface().color_rgb;
  Result<void> done = session_->apply({event_time_ns(), std::move(what)});
  if (done && is_surface) use_surface_of_session(before);
  publish();
  return done;
}

Result<void> Studio::import(const std::string& path, std::span<const StrokePtr> strokes,
                            std::span<const FillPtr> fills) {
  process();
  Result<void> done = session_->import(event_time_ns(), {path, true}, strokes, fills);
  publish();
  return done;
}

void Studio::finish() {
  process();
  if (session_->gesture_in_progress()) note(session_->finish());
}

// --- The loop

bool Studio::may_rest() const noexcept {
  return !play_ && !has_force() && now_ns_ - awake_ns_ > kRestNs &&
         !session_->gesture_in_progress() && !in_contact(pen_.sample);
}

void Studio::advance_to(std::int64_t time_ns) {
  time_ns += ahead_ns_;
  if (time_ns <= now_ns_) return;
  if (play_) {
    const double more =
        (play_speed() - 1.0) * static_cast<double>(std::min(time_ns - now_ns_, kLongestNs));
    ahead_ns_ += static_cast<std::int64_t>(std::max(more, 0.0));
    time_ns += static_cast<std::int64_t>(std::max(more, 0.0));
  }
  const std::int64_t period_ns = servo_->options().period_ns;
  if (may_rest()) {
    now_ns_ = time_ns;
    return;
  }
  if (!play_ && time_ns - now_ns_ > kLongestNs) {
    now_ns_ = time_ns - kLongestNs;
    publish();
  }
  while (now_ns_ + period_ns <= time_ns) step();
  process();
}

void Studio::end_frame(std::int64_t time_ns) {
  advance_to(time_ns);
  // The hand plays the aims of a pointer with a delay (AimTrack); the first ink does not wait for
  // it.
  const bool comes_down = std::exchange(touches_down_, false);
  for (int i = 0; i < kMaxTicksAhead; ++i) {
    if (!has_point_ && !(comes_down && !in_contact(pen_.sample))) return;
    step();
    process();
  }
}

/// Lets one tick pass.
void Studio::step() {
  has_point_ = false;
  now_ns_ += servo_->options().period_ns;
  if (is_full_module() && play_) step_play();
  const TickReport& report = servo_->step(now_ns_ - start_ns_);
  if (on_tick) on_tick(report);
  if (++ticks_to_process_ >= kProcessTicks) process();
}

/// Does the work of the edit thread: handles the waiting samples and publishes a force.
void Studio::process() {
  ticks_to_process_ = 0;
  std::array<PenSample, 64> batch;
  for (std::size_t n = 0; (n = servo_->for_edit().pop(batch)) > 0;) {
    for (const PenSample& sample : std::span(batch).first(n)) handle(sample);
  }
  while (servo_->for_autosave().pop(batch) > 0) {  // nobody reads this queue here
  }
  publish();
}

void Studio::handle(PenSample sample) {
  sample.time_ns = last_event_ns_ = std::max(last_event_ns_, sample.time_ns + start_ns_);
  // The first touch of a tool that draws clears the selection, as in the desktop program.
  const bool begins = !std::exchange(was_in_contact_, in_contact(sample)) && in_contact(sample);
  const ToolKind kind = session_->tool().info().kind;
  if (begins && !session_->selection().empty() &&
      (kind == ToolKind::kDraws || kind == ToolKind::kShapes)) {
    note(session_->apply({sample.time_ns, SelectStrokes{SelectStrokes::What::kNone}}));
  }
  note(session_->sample(sample));
  pen_.is_known = true;
  pen_.sample = sample;
  const TickReport& tick = servo_->latest();
  pen_.asked = tick.asked;
  pen_.sent = tick.sent;
  if (on_sample) on_sample(sample);
}

/// Keeps a refusal of the session for take_refusal().
void Studio::note(Result<void> done) {
  if (!done) refusal_ = std::move(done);
}

void Studio::publish() {
  servo_->heartbeat(now_ns_ - start_ns_);
  if (is_full_module() && has_forces_) servo_->publish(session_->force());
}

/// Returns the time for an event, which is not before the samples that the session has handled.
std::int64_t Studio::event_time_ns() {
  return last_event_ns_ = std::max(last_event_ns_, now_ns_);
}

}  // namespace felt::page
