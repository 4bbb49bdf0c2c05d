#include "desktop/engine/studio.h"
#include "desktop/engine/copied_options.h"
#include "desktop/engine/first_options.h"
#include "desktop/engine/usual_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "felt/stroke/color_text.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

// Ticks between two turns.
constexpr int kNear = 1;
constexpr int kFar = 4;
constexpr int kResting = 16;
constexpr std::int64_t kAfterTickNs = 60'000;     // the tick is over by then, as a rule
constexpr int kMostLateLooks = 4;                 // after that many the next tick is waited for
constexpr std::int64_t kNearNs = 100'000'000;     // since the pen was moved
constexpr std::int64_t kRestingNs = 500'000'000;  // likewise
constexpr std::int64_t kTurnNs = 4'000'000;       // of a studio that is not live

/// What a hand that senses no pressure stands for, by the tool's own option where it has one.
double absent_pressure(const Session& session) {
  const Result<OptionValue> value =
      session.option(std::string(session.tool().info().id) + ".mouse_pressure");
  const auto* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : HandScriptOptions{}.absent_pressure;
}

}  // namespace

Studio::Studio(StudioOptions options, QObject* parent)
    : QObject(parent), options_(std::move(options)) {
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(options_.device);
  if (!device) device = open_pen_device(QStringLiteral("tablet"));
  device_ = *std::move(device);
  make_session(Document{}, {});
  start_loop();
  connect(&timer_, &TickTimer::due, this, &Studio::turn);
  set_pace(true);
}

Studio::~Studio() {
  stop_loop();
}

void Studio::listen(StudioListener listener) {
  listener_ = std::move(listener);
  if (listener_.loop && servo_) listener_.loop(servo_.get(), clock_start_ns_);
}

void Studio::make_session(Document document, std::span<const std::string> materials) {
  if (options_.on_session) options_.on_session(document);
  SessionOptions options;
  options.document = std::move(document);
  options.materials = options_.materials;
  options.on_event = [this](const Event& event) {
    if (options_.on_event) options_.on_event(event);
    if (listener_.event) listener_.event(event);
  };
  options.on_edit = [this](const Edit& edit) {
    edits_.push_back(edit);
    if (listener_.edit) listener_.edit(edit);
  };
  auto session = std::make_unique<Session>(make_tools(), std::move(options));
  // Said as events, so that whoever records them has all that the drawing depends on.
  static_cast<void>(session->apply({event_time_ns(), used_device()}));
  const std::unique_ptr<Session> before = std::exchange(session_, std::move(session));
  brought_.clear();
  take_materials(materials);  // before the options, which may name one of them
  const std::int64_t now_ns = event_time_ns();
  if (before) {
    copy_options(*before, *session_, now_ns);
  } else if (options_.first_options) {
    take_first_options(now_ns);
  }
  told_selection_ = session_->selection_count();
  told_layer_ = session_->layer();
}

/// Where this program begins with other options than the library.
void Studio::take_first_options(std::int64_t now_ns) {
  for (const auto& tool : session_->tools()) {
    const std::string owner(tool->info().id);
    for (const OptionSpec& row : tool->info().options) {
      const OptionValue first = default_value(as_at_first(tool->info().kind, row));
      if (first == default_value(row)) continue;
      const std::string id = owner + "." + std::string(row.id);
      static_cast<void>(session_->apply({now_ns, SetOption{id, first}}));
    }
  }
  if (const Medium* medium = find_medium(kFirstMedium)) {
    const Rgba ink = usual_color({}, {}, medium->color_rgb, {});
    static_cast<void>(session_->apply({now_ns, SetOption{"sheet.color", color_to_text(ink)}}));
  }
}

void Studio::open(Document document, const SheetPage& page, std::span<const std::string> materials,
                  std::optional<Rgba> ink) {
  wake();
  drain();
  static_cast<void>(session_->finish());
  edits_.clear();
  const SurfaceMaterial sheet = session_->sheet().material();
  make_session(std::move(document), materials);
  take_page(page);
  if (ink) {
    static_cast<void>(
        session_->apply({event_time_ns(), SetOption{"sheet.color", color_to_text(*ink)}}));
  }
  const bool has_other_sheet = session_->sheet().material() != sheet;
  publish();
  set_modified(false);
  Q_EMIT opened();
  if (has_other_sheet) Q_EMIT option_changed(QLatin1String(kSheetMaterialId));
  Q_EMIT page_changed();
  Q_EMIT selection_changed();
  Q_EMIT layer_changed();
  Q_EMIT shown();
}

void Studio::set_modified(bool modified) {
  has_other_changes_ = modified;
  if (modified) ++other_changes_;
  if (!modified) saved_position_ = session_->history().position();
  tell_modified(modified);
}

ChangeMark Studio::change_mark() const noexcept {
  return {session_->history().position(), other_changes_};
}

void Studio::set_saved(const ChangeMark& mark) {
  saved_position_ = mark.position;
  if (mark.other_changes == other_changes_) has_other_changes_ = false;
  follow_history();
}

/// Undoing everything since the last save, or doing it again, is no change any more.
void Studio::follow_history() {
  tell_modified(has_other_changes_ || session_->history().position() != saved_position_);
}

void Studio::tell_modified(bool modified) {
  if (std::exchange(is_modified_, modified) != modified) Q_EMIT modified_changed(modified);
}

bool Studio::apply(decltype(Event::what) what) {
  wake();
  drain();
  const auto* option = std::get_if<SetOption>(&what);
  const QString option_id = option ? QString::fromStdString(option->id) : QString();
  // A drawing is kept with its sheet's material and colour; an empty one is nothing to be asked
  // about.
  const bool is_of_drawing =
      option_id.startsWith(QLatin1String("sheet.")) && session_->document().stroke_count() > 0;
  const OptionValue before =
      is_of_drawing ? session_->option(option->id).value_or(OptionValue{}) : OptionValue{};
  const auto* material = std::get_if<UseMaterial>(&what);
  const std::string text = material ? material->text : std::string();
  const Result<void> done = session_->apply({event_time_ns(), std::move(what)});
  publish();
  if (done && !text.empty()) note_material(text);
  if (is_of_drawing && done &&
      session_->option(option_id.toStdString()).value_or(OptionValue{}) != before) {
    set_modified(true);
  }
  if (done && option_id == QLatin1String(kSheetMaterialId)) name_surface();
  if (!option_id.isEmpty() && done) Q_EMIT option_changed(option_id);
  tell();
  Q_EMIT shown();
  if (!done) Q_EMIT refused(text_of(done.error()));
  return done.has_value();
}

void Studio::finish_gesture() {
  turn();
  // Said as an event that ends gestures, so that a recording has it.
  if (session_->gesture_in_work()) apply(used_device());
}

bool Studio::import(const QString& path, std::span<const SketchStroke> strokes) {
  wake();
  drain();
  const Result<void> done = session_->import(event_time_ns(), {path.toStdString(), true}, strokes);
  publish();
  tell();
  Q_EMIT shown();
  if (!done) Q_EMIT refused(text_of(done.error()));
  return done.has_value();
}

void Studio::borrow_tool(const QString& id) {
  if (borrowed_++ > 0) return;
  home_tool_ = QString::fromUtf8(session_->tool().info().id.data(),
                                 qsizetype(session_->tool().info().id.size()));
  if (!apply(SelectTool{id.toStdString()})) borrowed_ = 0;
}

void Studio::give_back_tool() {
  if (borrowed_ == 0 || --borrowed_ > 0) return;
  apply(SelectTool{home_tool_.toStdString()});
}

void Studio::point(const PointerEvent& event) {
  wake();
  last_point_ns_ = now_ns();
  pen_.hand = event.position;
  PointerEvent of_loop = event;
  of_loop.time_ns -= clock_start_ns_;
  if (hand_) {
    hand_->set_surface(session_->sheet().material(), session_->device());
    hand_->set_absent_pressure(absent_pressure(*session_));
    hand_->point(of_loop);
  }
  if (options_.live) wake_at(std::min(wake_ns_, next_tick_ns() + kAfterTickNs));
}

void Studio::set_mouse_pressure(MousePressure mouse) {
  mouse_pressure_ = mouse;
  if (hand_) hand_->set_mouse(mouse);
}

std::int64_t Studio::now_ns() const noexcept {
  if (!options_.live) return virtual_ns_;
  return clock_start_ns_ + (thread_ ? thread_->now_ns() : 0);
}

std::int64_t Studio::next_tick_ns() const noexcept {
  const std::int64_t now = now_ns(), period_ns = servo_->options().period_ns;
  if (!thread_) return now + period_ns;
  const std::int64_t first_ns = clock_start_ns_ + thread_->first_due_ns();
  return now < first_ns ? first_ns : now + period_ns - (now - first_ns) % period_ns;
}

void Studio::turn() {
  if (in_turn_) return;  // a slot of ours asked for a paint
  in_turn_ = true;
  const bool has_samples = drain();
  publish();
  tell();
  set_pace(has_samples);
  in_turn_ = false;
  look_at_device();  // last: who hears of a fault may change the device
}

void Studio::advance(std::int64_t ns) {
  if (options_.live) return;
  const std::int64_t end_ns = virtual_ns_ + ns, period_ns = servo_->options().period_ns;
  std::int64_t turn_ns = virtual_ns_ + kTurnNs;
  while (virtual_ns_ < end_ns) {
    virtual_ns_ += period_ns;
    servo_->step(virtual_ns_ - clock_start_ns_);
    if (virtual_ns_ < turn_ns) continue;
    turn();
    turn_ns = virtual_ns_ + kTurnNs;
  }
  turn();
}

void Studio::set_forces(bool on) {
  wake();
  if (on) {
    servo_->arm();
  } else {
    servo_->disarm();
  }
  if (std::exchange(forces_on_, on) != on) Q_EMIT forces_changed(on);
}

/// The time of what is told to the session now. Behind the samples that it has seen, and as a rule
/// before those that the loop is about to hand over: a recording has one order.
std::int64_t Studio::event_time_ns() {
  constexpr std::int64_t kOnTheWayNs = 5'000'000;
  return told_ns_ = std::max(told_ns_, now_ns() - kOnTheWayNs);
}

/// The first touch of the pencil ends the selection (what was pasted is selected, too), so that a
/// colour chosen for the next line does not change those. As an event: a recording has it.
void Studio::deselect_for_drawing(const PenSample& sample) {
  const bool begins = !std::exchange(was_in_contact_, in_contact(sample)) && in_contact(sample);
  if (!begins || session_->selection().empty() || session_->tool().info().kind != ToolKind::kDraws)
    return;
  static_cast<void>(session_->apply({sample.time_ns, SelectStrokes{SelectStrokes::What::kNone}}));
}

void Studio::take(PenSample& sample) {
  sample.time_ns = told_ns_ = std::max(told_ns_, sample.time_ns + clock_start_ns_);
  deselect_for_drawing(sample);
  if (const Result<void> taken = session_->sample(sample); !taken) {
    Q_EMIT refused(text_of(taken.error()));
  }
  Q_EMIT sampled(sample);
}

void Studio::set_strength(double share) {
  if (std::isnan(share)) return;
  share = std::clamp(share, 0.0, 1.0);
  servo_->set_strength(share);
  if (std::exchange(strength_, share) != share) Q_EMIT strength_changed(share);
}

/// False: there were none.
bool Studio::drain() {
  if (!servo_) return false;
  std::array<PenSample, 256> batch;
  bool any = false;
  for (std::size_t n = 0; (n = servo_->for_edit().pop(batch)) > 0; any = true) {
    for (PenSample& sample : std::span(batch).first(n)) take(sample);
    pen_.sample = batch[n - 1];
  }
  const TickReport& tick = servo_->latest();
  // A device that fails gives no samples, but a person must know.
  const bool is_other = std::exchange(told_safety_, tick.safety.state) != tick.safety.state;
  if (!any) {
    if (is_other) Q_EMIT ticked(tick);
    return false;
  }
  pen_.is_known = true;
  pen_.asked = tick.asked;
  pen_.sent = tick.sent;
  // Where nobody points (a script leads the hand), the hand is where the pen is.
  if (!hand_ || last_point_ns_ == 0) {
    pen_.hand = {pen_.sample.position.x, pen_.sample.position.y};
  }
  has_news_ = true;
  Q_EMIT ticked(tick);
  return true;
}

void Studio::publish() {
  servo_->publish(session_->force());
  servo_->heartbeat(now_ns() - clock_start_ns_);
}

/// Says what is not as it was. Slots may look at everything, and may call back.
void Studio::tell() {
  for (const Edit& edit : std::exchange(edits_, {})) {
    follow_history();
    Q_EMIT edited(edit);
  }
  if (std::string id(session_->tool().info().id); id != told_tool_) {
    told_tool_ = std::move(id);
    Q_EMIT tool_changed();
  }
  if (std::exchange(told_selection_, session_->selection_count()) != session_->selection_count()) {
    Q_EMIT selection_changed();
  }
  if (std::exchange(told_layer_, session_->layer()) != session_->layer()) Q_EMIT layer_changed();
  if (std::exchange(has_news_, false)) Q_EMIT shown();
}

/// The next turn comes right after a tick: what it has read is seen some hundred microseconds
/// later. A tick that is late is looked for again, soon.
void Studio::set_pace(bool has_samples) {
  if (!options_.live) return;
  const std::int64_t now = now_ns(), period_ns = servo_->options().period_ns;
  if (thread_ && may_sleep(now)) return sleep();
  const std::int64_t rest_ns = now - last_point_ns_;
  const bool is_near = rest_ns < kNearNs || in_contact(pen_.sample) || !hand_;
  const int ticks = is_near ? kNear : rest_ns < kRestingNs ? kFar : kResting;
  late_looks_ = has_samples || !is_near ? 0 : late_looks_ + 1;
  if (late_looks_ > 0 && late_looks_ <= kMostLateLooks) return wake_at(now + kAfterTickNs);
  wake_at(next_tick_ns() + (ticks - 1) * period_ns + kAfterTickNs);
}

/// Nothing moves by itself: no motors, no body, no line that is being drawn.
bool Studio::may_sleep(std::int64_t now) const {
  return hand_ && !device_->device().capabilities().has_force() &&
         now - last_event_ns_ > options_.rest_ns && !in_contact(pen_.sample) &&
         !session_->gesture_in_work();
}

void Studio::sleep() {
  timer_.stop();
  if (thread_->is_paused()) return;
  thread_->pause();
  if (listener_.loop) listener_.loop(nullptr, 0);  // whoever looks for samples may rest, too
}

void Studio::wake() {
  last_event_ns_ = now_ns();
  if (!thread_ || !thread_->is_paused()) return;
  if (listener_.loop) listener_.loop(servo_.get(), clock_start_ns_);
  publish();  // a sign of life, or the loop would think that we were gone
  thread_->resume();
  wake_at(next_tick_ns() + kAfterTickNs);
}

void Studio::wake_at(std::int64_t time_ns) {
  wake_ns_ = time_ns;
  timer_.start(time_ns - now_ns());
}

}  // namespace felt::desktop
