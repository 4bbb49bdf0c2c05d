#include "felt/replay/replay_machine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/constants.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/visible_strokes.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/replay/option_text.h"
#include "felt/session/session_medium.h"
#include "felt/tools/medium_line.h"
#include "felt/tools/pressing.h"

namespace felt {
namespace {

/// Returns true if the tool draws. Only then is ink compared with the path of the hand.
bool draws(const Session& session) {
  return session.tool().info().kind == ToolKind::kDraws;
}

/// Number of queued events that is_full() reports: about 200 s of aims, 20 MB.
constexpr std::size_t kManyEvents = 200'000;

/// Half the extent of the workspace, in mm. It exceeds the largest coordinate in a script.
constexpr double kEndlessMm = 1e10;

double drawing_number(const Session& session, std::string_view option, double otherwise) {
  const Result<OptionValue> value = session.option(drawing_option(session, option));
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : otherwise;
}

/// Makes the simulated stylus in the hand of the settings, and sets `hand` to the input of that
/// hand.
std::unique_ptr<Device> make_stylus(const ReplaySettings& settings, HandInput*& hand) {
  if (settings.person) {
    auto held = std::make_unique<FeedbackHand>(settings.device, *settings.person);
    hand = held.get();
    return held;
  }
  auto stylus = std::make_unique<SimulatedStylus>(settings.device, settings.hand);
  hand = stylus.get();
  return stylus;
}

bool is_plane_only(const Session& session) {
  return session.option("surface.plane_only") == OptionValue(true);
}

/// Returns how the hand draws with the medium of the session on its surface, as that is felt.
HandScriptOptions on_surface(HandScriptOptions options, const Session& session) {
  set_surface(options, session.surface(), session.device(),
              session.materials().find_medium(drawing_medium(session)));
  if (is_plane_only(session)) options.friction = 0.0;
  return options;
}

bool presses(const HandEvent& aim) {
  return aim.target.z < 0.0 || aim.pressure.value_or(0.0) > 0.0;
}

}  // namespace

ReplaySettings replay_settings(const StylusPreset& device, const SimulatedHand& hand, bool force,
                               std::optional<double> rate_hz, std::optional<int> delay_ticks) {
  ReplaySettings settings{.device = device, .hand = hand, .force = force, .script = {}};
  Capabilities& can = settings.device.capabilities;
  can.workspace_min.x = can.workspace_min.y = -kEndlessMm;
  can.workspace_max.x = can.workspace_max.y = kEndlessMm;
  if (rate_hz) can.period_ns = std::llround(1e9 / *rate_hz);
  if (delay_ticks) can.delay_ticks = *delay_ticks;
  settings.script = script_options_for(settings.device, hand);
  if (!force) {
    if (!device.has_trigger) settings.script.contact = ContactBy::kPressure;
    can.senses_pressure = true;
  }
  return settings;
}

ReplayMachine::ReplayMachine(const ReplaySettings& settings, Document document, Observer observer)
    : settings_(settings),
      observer_(std::move(observer)),
      stylus_(make_stylus(settings, hand_)),
      preview_ns_(settings.person ? std::llround(1e9 * settings.person->preview_s) : 0),
      session_(make_tools(), {.device = settings.device.capabilities,
                              .materials = settings.materials,
                              .document = std::move(document),
                              .on_event = observer_.event,
                              .on_edit = [this](const Edit& edit) { handle_edit(edit); }}),
      probe_(make_tools(), {.device = settings.device.capabilities,
                            .materials = settings.materials,
                            .document = {},
                            .on_event = {},
                            .on_edit = {}}),
      player_(*stylus_, hand_, session_, player_options()) {}

PlayerOptions ReplayMachine::player_options() {
  PlayerOptions options;
  options.period_ns = settings_.device.capabilities.period_ns;
  options.forces = settings_.force;
  options.on_tick = [this](const TickReport& report) { handle_tick(report); };
  if (settings_.read_import) {
    options.read_import = [this](const ImportEvent& import) {
      return settings_.read_import(import.path);
    };
  }
  options.is_cancelled = [this] { return handle_turn(); };
  return options;
}

bool ReplayMachine::handle_turn() {
  if (settings_.device.plays_cues && settings_.force) count_cues();
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

/// Counts the cues that the device would play, as the window plays them (CuePlayer).
void ReplayMachine::count_cues() {
  const Medium* medium = session_.materials().find_medium(drawing_medium(session_));
  if (medium) cue_law_.set_feel(cue_feel_of(*medium, session_.surface()));
  if (const auto event = cue_watch_.look(session_, pen_)) cue_law_.report(*event);
  const std::optional<Cue> cue = cue_law_.step(cue_input_of(pen_, session_.surface()));
  stats_.cues = stats_.cues.value_or(0) + (cue && cue->waveform != CueWaveform::kNone);
}

HandScriptOptions ReplayMachine::hand_options() const {
  HandScriptOptions options = on_surface(settings_.script, probe_);
  if (settings_.person) {  // a person feels mass and friction, and compensates for them
    options.hand = settings_.person->grip();
    options.device_mass_kg = options.device_friction_n = options.friction = 0.0;
  }
  return options;
}

double ReplayMachine::expected_friction_n() const {
  const double device_n = settings_.device.mechanics.friction_n;
  const bool has_force = settings_.force && probe_.device().has_force();
  if (!has_force) return device_n;
  const HandScriptOptions options = on_surface(settings_.script, probe_);
  const double strength = drawing_number(probe_, "strength", 1.0);
  const double push_n = 0.5 * options.full_n;
  const double own_n = std::min(device_n, strength * kPencilOnPaper * push_n);
  return device_n + std::max(0.0, strength * options.friction * push_n - own_n);
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
  const auto* import = std::get_if<ImportEvent>(&event.what);
  if (import && settings_.read_import) {
    const auto strokes = settings_.read_import(import->path);
    if (!strokes) return tl::unexpected(strokes.error());
  } else if (import || std::holds_alternative<SelectTool>(event.what) ||
             std::holds_alternative<SetOption>(event.what) ||
             std::holds_alternative<UseMaterial>(event.what) ||
             std::holds_alternative<UseGuide>(event.what)) {
    if (Result<void> known = probe_.apply(event); !known) return known;
  } else if (const auto* aim = std::get_if<HandEvent>(&event.what)) {
    add_aim(event.time_ns, *aim);
  }
  events_.push_back(event);
  return {};
}

void ReplayMachine::add_aim(std::int64_t time_ns, const HandEvent& aim) {
  if (in_stroke_) {
    if (meant_.back().start_ns < 0) meant_.back().start_ns = time_ns + preview_ns_;
    return;
  }
  const bool is_down = presses(aim) && draws(probe_);
  if (is_down && !hand_is_down_) meant_.push_back({time_ns + preview_ns_, {}});
  if (is_down) meant_.back().path.push_back(on_page(aim.target));
  hand_is_down_ = is_down;
}

void ReplayMachine::begin_stroke() {
  in_stroke_ = true;
  meant_.push_back({-1, {}});
}

void ReplayMachine::stroke_drawn(const std::vector<Point>& meant) {
  // The intended path is the stroke. The aims differ from it because they compensate for mass and
  // friction.
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
  for (const StrokePtr& stroke : visible_strokes(session_.document())) {
    ++taken.strokes;
    taken.segments += stroke->segment_count();
  }
  return taken;
}

/// Lets the hand carry out its last aim before the play ends.
void ReplayMachine::await_preview() {
  const auto last = std::find_if(events_.rbegin(), events_.rend(), [](const Event& event) {
    return std::holds_alternative<HandEvent>(event.what);
  });
  if (preview_ns_ == 0 || last == events_.rend()) return;
  Event wait = *last;
  wait.time_ns = events_.back().time_ns + preview_ns_ + 100 * kMs;
  events_.push_back(std::move(wait));
}

Result<void> ReplayMachine::play() {
  if (is_stopped_) events_.clear();
  if (events_.empty()) return {};
  await_preview();
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

void ReplayMachine::handle_tick(const TickReport& report) {
  if (in_contact(report.sample) && !in_contact(pen_)) ++stats_.touches;
  pen_ = report.sample;
  if (in_contact(report.sample)) {
    ++stats_.ticks_in_contact;
    stats_.sent_sum_n += norm(report.sent);
  }
  if (!observer_.tick || !observed_) return;
  const Pressing pressing(session_.surface(), settings_.device.capabilities);
  const std::optional<double> pressure = pressing.of(report.sample);
  observed_ = observer_.tick({report, pressure, width_at(report, pressure)});
}

std::optional<double> ReplayMachine::width_at(const TickReport& report,
                                              std::optional<double> pressure) {
  const bool was_down = std::exchange(pen_is_down_, in_contact(report.sample));
  if (!pen_is_down_) return std::nullopt;
  if (!was_down) {
    InkFitOptions ink;
    ink.width_map = {.min_mm = drawing_number(session_, "min_width_mm", 0.3),
                     .max_mm = drawing_number(session_, "max_width_mm", 6.0),
                     .gamma = drawing_number(session_, "gamma", 1.0)};
    const Medium* medium = session_.materials().find_medium(drawing_medium(session_));
    widths_ = WidthMap((medium ? drawn_with(*medium, ink) : ink).width_map);
  }
  return widths_
      .push({on_page(report.sample.position), pressure, report.sample.time_ns,
             report.sample.tilt_deg})
      .width_mm;
}

void ReplayMachine::handle_edit(const Edit& edit) {
  cue_watch_.edited();
  for (const StrokeChange& change : edit.changes) {
    changed_.insert(change.id);
    if (change.after && draws(session_)) ink_.push_back({pen_.time_ns, *change.after});
  }
}

/// Compares finished ink with the last path that began before the ink was finished.
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

}  // namespace felt
