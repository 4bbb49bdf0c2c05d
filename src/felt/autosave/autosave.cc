#include "felt/autosave/autosave.h"

#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

#include "felt/material/material_file.h"
#include "felt/session/layer_edit.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

constexpr int kBasePartsPerCommit =
    8;  // half a MiB, so that edits need not wait for the whole base

/// Returns a name for this process. The system may reuse process numbers, so the name also contains
/// a random number.
std::string process_name() {
  std::uint32_t random = 0;
  static_cast<void>(::getrandom(&random, sizeof random, GRND_NONBLOCK));
  return std::to_string(::getpid()) + '-' + std::to_string(random);
}

/// Returns true if a gesture of the current tool depends on the selection.
bool depends_on_selection(const Session& session) {
  return session.tool().info().id == "transform";
}

/// Returns the current layer, or an empty id if no layer is open.
LayerId layer_of_ink(const Session& session) {
  const Layer* layer = session.document().layer(session.layer());
  return layer && is_open(*layer) ? layer->id : LayerId{};
}

/// Returns the events that set the state on which the next gesture of a new session depends.
std::vector<Event> context_of(const Session& session) {
  std::vector<Event> events;
  const auto add = [&events](decltype(Event::what) what) {
    events.push_back({0, std::move(what)});
  };
  const auto add_option = [&](const std::string& id) {
    if (const Result<OptionValue> value = session.option(id)) add(SetOption{id, *value});
  };
  add(UseDevice{session.device(), session.option_defaults()});
  for (const AnyMaterial& own : not_built_in(session.materials())) {
    add(UseMaterial{write_material(own)});
  }
  for (const std::string& id : session.option_ids()) add_option(id);
  add(SelectTool{std::string(session.tool().info().id)});
  add(LayerEvent{LayerEvent::Do::kUse, layer_of_ink(session), {}});
  if (!session.out_of_view().empty()) add(UseView{session.out_of_view()});
  return events;
}

}  // namespace

// --- Edit thread

Autosave::Autosave(AutosaveOptions options)
    : options_(std::move(options)), process_(process_name()) {
  if (options_.live) thread_ = std::thread([this] { run(); });
}

Autosave::~Autosave() {
  detach();
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  } else {
    process();
    finish();
  }
}

void Autosave::session_began(const Session& session, Drawing drawing, std::string name,
                             std::optional<std::string> path, bool modified) {
  layer_ = layer_of_ink(session);
  selection_count_ = 0;
  post({.drawing = std::make_unique<Drawing>(std::move(drawing)),
        .name = std::move(name),
        .path = std::move(path),
        .modified = modified,
        .context = context_of(session)});
}

void Autosave::event_applied(const Session& session, const Event& event) {
  AutosaveMessage message{.event = event, .gesture_in_progress = session.gesture_in_progress()};
  if (!std::holds_alternative<PenEvent>(event.what)) {
    add_layer_in_use(session, message);
  } else if (!message.gesture_in_progress && session.selection_count() != selection_count_ &&
             depends_on_selection(session)) {
    selection_count_ = session.selection_count();
    message.selection = session.selection();
  }
  post(std::move(message));
}

void Autosave::edit_applied(const Session& session, const Edit& edit) {
  AutosaveMessage message{.edit = edit};
  add_layer_in_use(session, message);
  post(std::move(message));
}

void Autosave::add_layer_in_use(const Session& session, AutosaveMessage& message) {
  const LayerId now = layer_of_ink(session);
  if (std::exchange(layer_, now) == now) return;
  message.context.push_back({0, LayerEvent{LayerEvent::Do::kUse, layer_, {}}});
}

void Autosave::post(AutosaveMessage message) {
  if (message.path) message.stamp = FileStamp::of(*message.path);
  bool was_empty = false;
  {
    const std::lock_guard lock(mutex_);
    was_empty = queue_.empty();
    queue_.push_back(std::move(message));
  }
  if (was_empty && !has_ring_) wake_.notify_all();
}

void Autosave::attach(Servo::Ring& ring, std::int64_t offset_ns) {
  detach();
  {
    const std::lock_guard lock(ring_mutex_);
    ring_ = &ring;
    ring_offset_ns_ = offset_ns;
  }
  const std::lock_guard lock(mutex_);
  has_ring_ = true;
  wake_.notify_all();
}

void Autosave::detach() {
  const std::lock_guard lock(ring_mutex_);
  take_samples();
  ring_ = nullptr;
  has_ring_ = false;
}

void Autosave::flush() {
  std::unique_lock lock(mutex_);
  if (!thread_.joinable()) {
    lock.unlock();
    do process();
    while (!is_idle());
    return;
  }
  const std::uint64_t wanted = ++flushes_wanted_;
  wake_.notify_all();
  flushed_.wait(lock, [this, wanted] { return flushes_done_ >= wanted; });
}

AutosaveStatus Autosave::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void Autosave::set_status(AutosaveStatus now) {
  bool is_other = false;
  {
    const std::lock_guard lock(mutex_);
    is_other = now.state != status_.state || now.why != status_.why;
    status_ = now;
  }
  if (is_other && options_.on_status) options_.on_status(now);
}

// --- Autosave thread

void Autosave::run() {
  std::unique_lock lock(mutex_);
  for (Clock::time_point begun;;) {
    const auto is_urgent = [this] { return stop_ || flushes_wanted_ > flushes_done_; };
    // The haptic loop does not wake this thread for its samples.
    if (!has_ring_ && !has_work_) {
      wake_.wait(lock, [&] { return is_urgent() || has_ring_ || !queue_.empty(); });
    }
    // If a base is incomplete, its next parts are written without a pause. After a slow commit the
    // pause is shorter.
    const auto gather = is_idle() ? options_.gather : std::chrono::milliseconds(0);
    wake_.wait_until(lock, std::max(begun + gather, Clock::now() + gather / 4), is_urgent);
    begun = Clock::now();
    const bool is_last = stop_;
    const std::uint64_t wanted = flushes_wanted_;
    lock.unlock();
    process();
    while (wanted > flushes_done_ && !is_idle()) process();
    lock.lock();
    has_work_ = !database_ || !is_idle() || root_ > 0;
    flushes_done_ = wanted;
    flushed_.notify_all();
    if (is_last && queue_.empty()) break;
  }
  lock.unlock();
  finish();
}

/// Returns true if no part of a base is left to write.
bool Autosave::is_idle() const {
  return !database_ || !database_->base_in_progress();
}

/// Copies the samples out of the ring. Requires that ring_mutex_ is held.
void Autosave::take_samples() {
  if (!ring_) return;
  std::array<PenSample, 256> batch;
  for (std::size_t n = 0; (n = ring_->pop(batch)) > 0;) {
    for (PenSample& sample : std::span(batch).first(n)) {
      sample.time_ns += ring_offset_ns_;
      samples_.push_back(sample);
    }
  }
}

void Autosave::process() {
  // Reads the ring before the queue, so that the sample of every queued event is read before the
  // event. In the other order LiveInk could mistake such a sample for one that the session has not
  // received.
  std::vector<PenSample> samples;
  {
    const std::lock_guard lock(ring_mutex_);
    take_samples();
    samples.swap(samples_);
  }
  std::vector<AutosaveMessage> messages;
  {
    const std::lock_guard lock(mutex_);
    messages.swap(queue_);
  }
  for (const PenSample& sample : samples) live_ink_.add_loop_sample(sample);
  for (AutosaveMessage& message : messages) apply(message);
  messages.clear();
  LiveInk::Changes now = live_ink_.take_changes();
  if (now.clear) live_changes_ = {true, {}};
  std::move(now.chunks.begin(), now.chunks.end(), std::back_inserter(live_changes_.chunks));
  write_out();
}

void Autosave::apply(AutosaveMessage& message) {
  if (message.drawing) {
    AutosaveInfo last = std::move(info_);
    replace_drawing(std::move(*message.drawing));
    if (!message.path) {
      info_.path = std::move(last.path);
      info_.stamp = last.stamp;
    }
  }
  if (message.head) {
    message.head->document = std::move(drawing_.document);
    message.head->layer = drawing_.layer;
    drawing_ = std::move(*message.head);
    is_info_written_ = false;
  }
  if (message.name) {
    info_.name = *std::move(message.name);
    is_info_written_ = false;
  }
  if (message.path) {
    info_.path = *std::move(message.path);
    info_.stamp = message.stamp;
    is_info_written_ = false;
  }
  if (message.modified) set_modified(*message.modified);
  if (message.selection) live_ink_.set_selection(*std::move(message.selection));
  if (message.event) {
    live_ink_.event_applied(*message.event, message.gesture_in_progress);
    newest_ns_ = std::max(newest_ns_, message.event->time_ns);
    apply_to_head(*message.event);
  }
  if (message.edit) {
    live_ink_.edit_applied(*message.edit);
    // Cannot fail, because the session's document has just applied the edit.
    if (const Result<void> done = drawing_.document.apply(*message.edit); !done) {
      why_ = done.error().message;
    }
    set_modified(true);
    if (database_) edits_.push_back(*std::move(message.edit));
  }
  for (const Event& event : message.context) {
    live_ink_.add_context(event);
    apply_to_head(event);
  }
}

/// Puts a database out of use. It is removed when another one is complete. If an older one exists,
/// this one never was complete, because old_ is removed then; so it is useless and is removed now,
/// because repeated attempts must not fill the disk.
void Autosave::retire(std::optional<AutosaveDatabase> database) {
  if (!database) return;
  if (old_) {
    static_cast<void>(std::move(*database).remove());
  } else {
    old_ = std::move(database);
  }
}

/// Starts to save another drawing.
void Autosave::replace_drawing(Drawing drawing) {
  drawing_ = std::move(drawing);
  info_ = {};
  live_ink_.clear();
  edits_.clear();
  has_drawing_ = true;
  ++drawing_number_;
  retire(std::exchange(database_, {}));
  next_try_ = {};
  why_.clear();
  root_ = 0;
}

void Autosave::set_modified(bool modified) {
  if (std::exchange(info_.modified, modified) != modified) is_info_written_ = false;
}

/// Applies events that change the drawing outside its document.
void Autosave::apply_to_head(const Event& event) {
  if (const auto* layer = std::get_if<LayerEvent>(&event.what)) {
    if (layer->what != LayerEvent::Do::kUse || !layer->layer) return;
    drawing_.layer = layer->layer;
    is_info_written_ = false;
  }
  const auto* option = std::get_if<SetOption>(&event.what);
  const auto* text = option ? std::get_if<std::string>(&option->value) : nullptr;
  if (!text) return;
  if (option->id == "surface.material") {
    drawing_.page.surface = *text;
    is_info_written_ = false;
  } else if (option->id == "ink.color") {
    if (const auto color = color_from_text(*text)) drawing_.color = *color;
    is_info_written_ = false;
  }
}

/// Writes to the current database, or to a new one in the first folder that works.
void Autosave::write_out() {
  if (!has_drawing_) return;
  const Clock::time_point now = Clock::now();
  if (database_ && root_ > 0 && now >= next_try_first_) try_first_root();
  if (!database_ && now < next_try_) return;
  while (open_next_database()) {
    const Result<void> written = write();
    if (written) break;
    fail_over(written.error());
  }
  live_changes_ = {};  // a new database starts with all chunks
  if (!database_) {
    root_ = 0;
    next_try_ = now + options_.retry;
    return set_status({AutosaveStatus::State::kFailing, why_, {}});
  }
  edits_.clear();
  if (is_idle()) remove_old();
  set_status(root_ == 0
                 ? AutosaveStatus{AutosaveStatus::State::kWorking, {}, database_->folder()}
                 : AutosaveStatus{AutosaveStatus::State::kElsewhere, why_, database_->folder()});
}

/// If no database is open, creates one in the next folder that works. Returns false if no folder is
/// left.
bool Autosave::open_next_database() {
  while (!database_ && root_ < options_.roots.size()) {
    if (const Result<void> made = create_database(root_); !made) fail_over(made.error());
  }
  return database_.has_value();
}

/// Tries to return to the first folder. The database in the later folder is kept until the base of
/// the new one is complete.
void Autosave::try_first_root() {
  next_try_first_ = Clock::now() + options_.retry_first;
  std::optional<AutosaveDatabase> elsewhere = std::exchange(database_, {});
  if (create_database(0)) {
    root_ = 0;
    retire(std::move(elsewhere));
  } else {
    database_ = std::move(elsewhere);
  }
}

void Autosave::fail_over(const Error& error) {
  why_ = error.message;
  retire(std::exchange(database_, {}));
  ++root_;
  next_try_first_ = Clock::now() + options_.retry_first;
}

/// Creates a database. Its base is the replica of the drawing, which already contains all edits so
/// far.
Result<void> Autosave::create_database(std::size_t root) {
  const std::string name =
      process_ + '.' + std::to_string(drawing_number_) + '.' + std::to_string(++database_number_);
  auto made = AutosaveDatabase::create(options_.roots[root], name, options_.vfs);
  if (!made) return tl::unexpected(made.error());
  const auto begun = made->begin_base(std::make_shared<const Drawing>(drawing_));
  if (!begun) static_cast<void>(std::move(*made).remove());
  if (!begun) return begun;
  database_ = *std::move(made);
  edits_.clear();
  live_changes_ = {false, live_ink_.chunks()};
  is_info_written_ = false;
  return {};
}

Result<void> Autosave::write() {
  for (const Edit& edit : edits_) {
    if (auto added = database_->add_edit(edit); !added) return tl::unexpected(added.error());
  }
  if (!is_info_written_) {
    // Copies everything but the document, because the document may be large.
    Document document = std::exchange(drawing_.document, {});
    info_.head = drawing_;
    drawing_.document = std::move(document);
    if (auto ok = database_->put_info(info_); !ok) return ok;
  }
  if (live_changes_.clear) {
    if (auto ok = database_->clear_live(); !ok) return ok;
  }
  for (const LiveChunk& chunk : live_changes_.chunks) {
    if (auto ok = database_->add_live(chunk.kind, chunk.bytes); !ok) return ok;
  }
  if (auto ok = write_base(); !ok) return ok;
  if (auto ok = database_->commit(); !ok) return ok;
  is_info_written_ = true;
  if (options_.on_commit) options_.on_commit(std::max(newest_ns_, live_ink_.kept_ns()));
  return {};
}

/// Writes some parts of the new base. If no base is in progress, deletes some rows that are no
/// longer needed by any base.
Result<void> Autosave::write_base() {
  if (is_idle() && database_->edit_bytes() > options_.max_log_bytes) {
    auto begun = database_->begin_base(std::make_shared<const Drawing>(drawing_));
    if (!begun) return begun;
  }
  for (int i = 0; i < kBasePartsPerCommit && !is_idle(); ++i) {
    if (auto done = database_->write_base_part(); !done) return tl::unexpected(done.error());
  }
  if (!is_idle()) return {};
  return database_->tidy().map([](bool) {});
}

void Autosave::remove_old() {
  if (old_) static_cast<void>(std::move(*std::exchange(old_, {})).remove());
}

void Autosave::finish() {
  const bool stays = has_drawing_ && info_.modified;
  while (stays && !is_idle()) process();
  if (!stays) {
    remove_old();
    if (database_) static_cast<void>(std::move(*database_).remove());
  }
  database_.reset();
}

}  // namespace felt
