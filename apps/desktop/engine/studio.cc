#include "desktop/engine/studio.h"
#include "desktop/engine/copied_options.h"
#include "desktop/engine/first_options.h"
#include "desktop/engine/text_of.h"
#include "desktop/engine/usual_color.h"

#include <algorithm>
#include <utility>

#include "felt/stroke/color_text.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kProcessNs = 4'000'000;  // period of a studio that is not live

/// Returns the pressure to use if a hand does not sense it. A tool may define it by an option.
double absent_pressure(const Session& session) {
  const Result<OptionValue> value =
      session.option(std::string(session.tool().info().id) + ".mouse_pressure");
  const auto* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : HandScriptOptions{}.absent_pressure;
}

}  // namespace

Studio::Studio(StudioOptions options, QObject* parent)
    : QObject(parent),
      options_(std::move(options)),
      loop_({options_.device, options_.live, options_.rest_ns, options_.reads_forces}) {
  if (options_.connect_early) options_.connect_early(*this);
  make_session(Document{}, {}, InitialOptions::kFirst);
  connect_loop();
  loop_.start();
  loop_.schedule(true, pen_activity());
}

Studio::~Studio() {
  loop_.stop();
  loop_.disconnect(this);
}

/// Connects the studio to its loop. These slots are the first of each signal, so that slots that
/// are connected later find an updated session.
void Studio::connect_loop() {
  connect(&loop_, &HapticLoop::due, this, &Studio::process);
  connect(&loop_, &HapticLoop::started, this, &Studio::publish);
  connect(&loop_, &HapticLoop::stopped, this, &Studio::drain);
  const auto apply_device = [this] {
    static_cast<void>(session_->apply({event_time_ns(), loop_.used_device()}));
  };
  connect(&loop_, &HapticLoop::device_replaced, this, [this, apply_device] {
    apply_device();
    pen_ = {};
  });
  connect(&loop_, &HapticLoop::device_changed, this, &Studio::report_changes);
  connect(&loop_, &HapticLoop::force_limit_changed, this, [this, apply_device] {
    apply_device();
    report_changes();
  });
  connect(&loop_, &HapticLoop::refused, this, &Studio::refused);
}

void Studio::make_session(Document document, std::span<const std::string> materials,
                          InitialOptions from) {
  Q_EMIT session_began(document);
  SessionOptions options;
  options.document = std::move(document);
  options.materials = options_.materials;
  options.on_event = [this](const Event& event) { Q_EMIT event_applied(event); };
  options.on_edit = [this](const Edit& edit) {
    edits_.push_back(edit);
    Q_EMIT edit_applied(edit);
  };
  auto session = std::make_unique<Session>(make_tools(), std::move(options));
  // The device is set by an event, so that a recording contains everything that determines the
  // drawing.
  static_cast<void>(session->apply({event_time_ns(), loop_.used_device()}));
  const std::unique_ptr<Session> before = std::exchange(session_, std::move(session));
  of_drawing_.clear();
  add_materials_of_drawing(materials);  // must precede the options, which may name one of the
                                        // materials
  const std::int64_t now_ns = event_time_ns();
  if (before && from == InitialOptions::kOfLastSession) {
    copy_options(*before, *session_, now_ns);
  } else if (options_.first_options) {
    apply_first_options(now_ns);
  }
  reported_selection_ = session_->selection_count();
  reported_layer_ = session_->layer();
}

/// Applies the initial options of this program that differ from the library's defaults.
void Studio::apply_first_options(std::int64_t now_ns) {
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
    static_cast<void>(session_->apply({now_ns, SetOption{"ink.color", color_to_text(ink)}}));
  }
}

void Studio::open(Document document, const Page& page, std::span<const std::string> materials,
                  std::optional<Rgba> ink) {
  open(std::move(document), page, materials, ink, InitialOptions::kOfLastSession);
}

void Studio::start_over(const Page& page) {
  open(Document{}, page, {}, {}, InitialOptions::kFirst);
  Q_EMIT tool_changed();
}

void Studio::open(Document document, const Page& page, std::span<const std::string> materials,
                  std::optional<Rgba> ink, InitialOptions options) {
  loop_.wake();
  drain();
  static_cast<void>(session_->finish());
  edits_.clear();
  const SurfaceMaterial surface = session_->surface();
  make_session(std::move(document), materials, options);
  apply_page(page);
  if (ink) {
    static_cast<void>(
        session_->apply({event_time_ns(), SetOption{"ink.color", color_to_text(*ink)}}));
  }
  const bool has_other_surface = session_->surface() != surface;
  publish();
  set_modified(false);
  Q_EMIT opened();
  if (has_other_surface) Q_EMIT option_changed(QLatin1String(kSurfaceOptionId));
  Q_EMIT page_changed();
  Q_EMIT selection_changed();
  Q_EMIT layer_changed();
  Q_EMIT shown();
}

void Studio::set_modified(bool modified) {
  has_other_changes_ = modified;
  if (modified) ++other_changes_;
  if (!modified) saved_position_ = session_->history().position();
  report_modified(modified);
}

ChangeMark Studio::change_mark() const noexcept {
  return {session_->history().position(), other_changes_};
}

void Studio::set_saved(const ChangeMark& mark) {
  saved_position_ = mark.position;
  if (mark.other_changes == other_changes_) has_other_changes_ = false;
  update_modified();
}

/// Updates is_modified(). It becomes false again when undo or redo return to the state that was
/// saved.
void Studio::update_modified() {
  report_modified(has_other_changes_ || session_->history().position() != saved_position_);
}

void Studio::report_modified(bool modified) {
  if (std::exchange(is_modified_, modified) != modified) Q_EMIT modified_changed(modified);
}

bool Studio::apply(decltype(Event::what) what) {
  loop_.wake();
  drain();
  const auto* option = std::get_if<SetOption>(&what);
  const std::string current_id = option ? session_->current_option_id(option->id) : std::string();
  const QString option_id = QString::fromStdString(current_id);
  // The surface and its colour are saved with the drawing. Therefore a change of them is an
  // unsaved change, unless the drawing is empty.
  const bool is_of_drawing = (current_id == kSurfaceOptionId || current_id == kInkColorId) &&
                             session_->document().stroke_count() > 0;
  const OptionValue before =
      is_of_drawing ? session_->option(option->id).value_or(OptionValue{}) : OptionValue{};
  const auto* material = std::get_if<UseMaterial>(&what);
  const std::string text = material ? material->text : std::string();
  const Result<void> done = session_->apply({event_time_ns(), std::move(what)});
  publish();
  if (done && !text.empty()) add_material(text);
  if (is_of_drawing && done &&
      session_->option(option_id.toStdString()).value_or(OptionValue{}) != before) {
    set_modified(true);
  }
  if (done && option_id == QLatin1String(kSurfaceOptionId)) set_surface_of_page();
  if (!option_id.isEmpty() && done) Q_EMIT option_changed(option_id);
  report_changes();
  Q_EMIT shown();
  if (!done) Q_EMIT refused(text_of(done.error()));
  return done.has_value();
}

void Studio::finish_gesture() {
  process();
  // The gesture is ended by an event, so that a recording contains it.
  if (session_->gesture_in_progress()) apply(loop_.used_device());
}

bool Studio::import(const QString& path, std::span<const StrokePtr> strokes,
                    std::span<const FillPtr> fills) {
  loop_.wake();
  drain();
  const Result<void> done =
      session_->import(event_time_ns(), {path.toStdString(), true}, strokes, fills);
  publish();
  report_changes();
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

bool Studio::use_device(const QString& id) {
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(id, page_.area());
  if (!device) {
    Q_EMIT refused(text_of(device.error()));
    return false;
  }
  loop_.use_device(*std::move(device));
  return true;
}

void Studio::point(const PointerEvent& pointed) {
  PointerEvent event = pointed;
  event.height_mm = height_of_bodies_mm(event.position);
  pen_.hand = event.position;
  loop_.point(event, session_->surface(), session_->device(), absent_pressure(*session_));
}

void Studio::lend_pen(bool lent) {
  if (lent) finish_gesture();
  drain();
  is_held_from_ink_ = is_pen_elsewhere() && in_contact(pen_.sample);
  is_pen_lent_ = lent;
  report_elsewhere();
}

void Studio::process() {
  if (in_process_) return;  // a slot called process() again
  in_process_ = true;
  const bool has_samples = drain();
  publish();
  report_changes();
  loop_.schedule(has_samples, pen_activity());
  in_process_ = false;
  loop_.check_device();  // last, because a slot may replace a device that fails
}

void Studio::advance(std::int64_t ns) {
  if (loop_.is_live()) return;
  const std::int64_t end_ns = now_ns() + ns;
  std::int64_t process_ns = now_ns() + kProcessNs;
  while (now_ns() < end_ns) {
    loop_.step();
    if (now_ns() < process_ns) continue;
    process();
    process_ns = now_ns() + kProcessNs;
  }
  process();
}

/// Returns the time for an event. The time is later than that of every sample that the session has
/// handled, and usually earlier than that of the next samples, because the events of a recording
/// must have increasing times.
std::int64_t Studio::event_time_ns() {
  constexpr std::int64_t kInTransitNs = 5'000'000;
  return last_event_ns_ = std::max(last_event_ns_, now_ns() - kInTransitNs);
}

/// Clears the selection when the pencil first touches the surface. Otherwise a colour that the user
/// chooses for the next line would also change the selected lines, such as those of a paste.
/// Applies an event, so that a recording contains this change.
void Studio::deselect_for_drawing(const PenSample& sample) {
  const bool begins = !std::exchange(was_in_contact_, in_contact(sample)) && in_contact(sample);
  const ToolKind kind = session_->tool().info().kind;
  const bool draws = kind == ToolKind::kDraws || kind == ToolKind::kShapes;
  if (!begins || session_->selection().empty() || !draws) return;
  static_cast<void>(session_->apply({sample.time_ns, SelectStrokes{SelectStrokes::What::kNone}}));
}

/// Lifts the pen of a sample while a ring is open or the pen is elsewhere, and until a touch that
/// began meanwhile ends. pen() has the sample as it is.
void Studio::lift_if_elsewhere(PenSample& sample) {
  const bool touches = in_contact(sample);
  touches_for_ring_ = (session_->ring() || touches_for_ring_) && touches;
  is_held_from_ink_ = is_pen_elsewhere() && touches;
  is_below_page_ = is_below_page_ && touches;
  if (touches_for_ring_ || is_held_from_ink_) lift(sample);
}

void Studio::handle_sample(PenSample& sample) {
  sample.time_ns = last_event_ns_ = std::max(last_event_ns_, sample.time_ns);
  const PenSample as_read = sample;
  lift_if_elsewhere(sample);
  deselect_for_drawing(sample);
  if (const Result<void> done = session_->sample(sample); !done) {
    Q_EMIT refused(text_of(done.error()));
  }
  pen_.is_known = has_news_ = true;
  pen_.sample = as_read;
  pen_.asked = loop_.tick().asked;
  pen_.sent = loop_.tick().sent;
  if (!loop_.is_pointed()) pen_.hand = {sample.position.x, sample.position.y};
  Q_EMIT sampled(sample);
}

/// Handles all waiting samples. Returns false if no samples were waiting.
bool Studio::drain() {
  return loop_.read_samples([this](PenSample& sample) { handle_sample(sample); });
}

HapticLoop::PenActivity Studio::pen_activity() const {
  if (in_contact(pen_.sample)) return HapticLoop::PenActivity::kContact;
  return session_->gesture_in_progress() ? HapticLoop::PenActivity::kGesture
                                         : HapticLoop::PenActivity::kNone;
}

/// Emits the signals for what changed. Their slots may call any function of the studio.
void Studio::report_changes() {
  report_elsewhere();
  for (const Edit& edit : std::exchange(edits_, {})) {
    update_modified();
    Q_EMIT edited(edit);
  }
  if (std::string id(session_->tool().info().id); id != reported_tool_) {
    reported_tool_ = std::move(id);
    Q_EMIT tool_changed();
  }
  if (std::exchange(reported_selection_, session_->selection_count()) !=
      session_->selection_count()) {
    Q_EMIT selection_changed();
  }
  if (std::exchange(reported_layer_, session_->layer()) != session_->layer())
    Q_EMIT layer_changed();
  if (std::exchange(has_news_, false)) Q_EMIT shown();
}

}  // namespace felt::desktop
