#include "felt/autosave/saver.h"

#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <variant>

#include "felt/autosave/live_ink.h"
#include "felt/autosave/working_store.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPartsATurn = 8;  // of a base: half a MiB, so that edits need not wait for all of it

struct Begin {
  StoredDrawing drawing;
  std::string name, path;
  bool modified = false;
};
struct Rename {
  std::string name, path;
};
struct Modified {
  bool is_modified = false;
};
struct Head {
  StoredDrawing head;
};
struct Told {
  Event event;
  bool gesture_in_work = false;
};
struct Context {
  std::vector<Event> events;
};
using Item = std::variant<Begin, Rename, Modified, Head, Told, Context, Edit, Selection>;

/// Says which process a folder is of, and no other has: a number may come again.
std::string process_name() {
  std::uint32_t any = 0;
  static_cast<void>(::getrandom(&any, sizeof any, GRND_NONBLOCK));
  return std::to_string(::getpid()) + '-' + std::to_string(any);
}

}  // namespace

struct Saver::Work {
  explicit Work(SaverOptions given) : options(std::move(given)) {}

  // --- Any thread
  void push(Item item);
  void set_status(SaverStatus now);

  // --- The saver's thread
  void run();
  void turn();
  void take_samples();
  void take(Begin& begin);
  void take(Rename& rename);
  void take(Modified& modified);
  void take(Head& head);
  void take(Told& told);
  void take(Context& context);
  void take(Edit& edit);
  void take(Selection& selection);
  void follow(const Event& event);
  void set_modified(bool modified);
  void write_out();
  Result<void> write();
  Result<void> write_base();
  Result<void> make_store(std::size_t root);
  void fail_over(const Error& error);
  void let_go();
  void finish();
  [[nodiscard]] bool is_idle() const;

  const SaverOptions options;
  const std::string process = process_name();

  std::mutex mutex;
  std::condition_variable wake, rest;
  std::vector<Item> queue;
  SaverStatus status;
  std::uint64_t flushes_wanted = 0, flushes_done = 0;
  bool stop = false, has_work = false;
  std::atomic<bool> has_ring{false};

  std::mutex ring_mutex;  // held while memory is copied, never while a disk is waited for
  Servo::Ring* ring = nullptr;
  std::int64_t offset_ns = 0;
  std::vector<PenSample> drained;

  // The saver's thread only.
  StoredDrawing drawing;  // as it is after all that was told: the replica
  WorkingAbout about;
  LiveInk live;
  LiveInk::Changes changes;
  std::vector<Edit> edits;  // not in the store yet
  std::optional<WorkingStore> store;
  std::vector<WorkingStore> old;  // what the store takes the place of, once its base is whole
  std::size_t root = 0;
  int drawing_number = 0, store_number = 0;
  bool has_begun = false, about_is_told = false;
  std::int64_t newest_ns = INT64_MIN;  // that was told, on the session's clock
  std::string why;
  Clock::time_point next_try, next_first;
  std::thread thread;
};

Saver::Saver(SaverOptions options) : work_(std::make_unique<Work>(std::move(options))) {
  if (work_->options.live) work_->thread = std::thread([work = work_.get()] { work->run(); });
}

Saver::~Saver() {
  detach();
  {
    const std::lock_guard lock(work_->mutex);
    work_->stop = true;
  }
  work_->wake.notify_all();
  if (work_->thread.joinable()) {
    work_->thread.join();
  } else {
    work_->turn();
    work_->finish();
  }
}

void Saver::begin(StoredDrawing drawing, std::string name, std::string path, bool modified) {
  work_->push(Begin{std::move(drawing), std::move(name), std::move(path), modified});
}
void Saver::rename(std::string name, std::string path) {
  work_->push(Rename{std::move(name), std::move(path)});
}
void Saver::modified(bool is_modified) {
  work_->push(Modified{is_modified});
}
void Saver::forget() {
  work_->push(Modified{false});
}
void Saver::head(StoredDrawing head) {
  head.document = Document();
  work_->push(Head{std::move(head)});
}
void Saver::edit(const Edit& edit) {
  work_->push(edit);
}
void Saver::event(const Event& event, bool gesture_in_work) {
  work_->push(Told{event, gesture_in_work});
}
void Saver::context(std::vector<Event> events) {
  work_->push(Context{std::move(events)});
}
void Saver::selection(Selection selection) {
  work_->push(std::move(selection));
}

void Saver::attach(Servo::Ring& ring, std::int64_t offset_ns) {
  detach();
  {
    const std::lock_guard lock(work_->ring_mutex);
    work_->ring = &ring;
    work_->offset_ns = offset_ns;
  }
  const std::lock_guard lock(work_->mutex);
  work_->has_ring = true;
  work_->wake.notify_all();
}

void Saver::detach() {
  const std::lock_guard lock(work_->ring_mutex);
  work_->take_samples();
  work_->ring = nullptr;
  work_->has_ring = false;
}

void Saver::flush() {
  std::unique_lock lock(work_->mutex);
  if (!work_->thread.joinable()) {
    lock.unlock();
    do work_->turn();
    while (!work_->is_idle());
    return;
  }
  const std::uint64_t wanted = ++work_->flushes_wanted;
  work_->wake.notify_all();
  work_->rest.wait(lock, [this, wanted] { return work_->flushes_done >= wanted; });
}

SaverStatus Saver::status() const {
  const std::lock_guard lock(work_->mutex);
  return work_->status;
}

void Saver::turn() {
  work_->turn();
}

void Saver::Work::push(Item item) {
  bool was_empty = false;
  {
    const std::lock_guard lock(mutex);
    was_empty = queue.empty();
    queue.push_back(std::move(item));
  }
  if (was_empty && !has_ring) wake.notify_all();
}

void Saver::Work::set_status(SaverStatus now) {
  bool is_news = false;
  {
    const std::lock_guard lock(mutex);
    is_news = now.state != status.state || now.why != status.why;
    status = now;
  }
  if (is_news && options.on_status) options.on_status(now);
}

void Saver::Work::run() {
  std::unique_lock lock(mutex);
  for (Clock::time_point begun;;) {
    const auto is_urgent = [this] { return stop || flushes_wanted > flushes_done; };
    // Nobody wakes this thread for the samples of the loop.
    if (!has_ring && !has_work) {
      wake.wait(lock, [&] { return is_urgent() || has_ring || !queue.empty(); });
    }
    // Nor does the rest of a base wait. A slow commit counts: the next one comes sooner.
    const auto gather = is_idle() ? options.gather : std::chrono::milliseconds(0);
    wake.wait_until(lock, std::max(begun + gather, Clock::now() + gather / 4), is_urgent);
    begun = Clock::now();
    const bool is_last = stop;
    const std::uint64_t wanted = flushes_wanted;
    lock.unlock();
    turn();
    while (wanted > flushes_done && !is_idle()) turn();
    lock.lock();
    has_work = !store || !is_idle() || root > 0;
    flushes_done = wanted;
    rest.notify_all();
    if (is_last && queue.empty()) break;
  }
  lock.unlock();
  finish();
}

/// No part of a base waits to be written.
bool Saver::Work::is_idle() const {
  return !store || !store->base_in_work();
}

/// Requires ring_mutex.
void Saver::Work::take_samples() {
  if (!ring) return;
  std::array<PenSample, 256> batch;
  for (std::size_t n = 0; (n = ring->pop(batch)) > 0;) {
    for (PenSample& sample : std::span(batch).first(n)) {
      sample.time_ns += offset_ns;
      drained.push_back(sample);
    }
  }
}

void Saver::Work::turn() {
  // What was handed over before is told before: else it would look like more than was told.
  std::vector<PenSample> samples;
  {
    const std::lock_guard lock(ring_mutex);
    take_samples();
    samples.swap(drained);
  }
  std::vector<Item> items;
  {
    const std::lock_guard lock(mutex);
    items.swap(queue);
  }
  for (const PenSample& sample : samples) live.sample(sample);
  for (Item& item : items) {
    std::visit([this](auto& what) { take(what); }, item);
  }
  items.clear();
  LiveInk::Changes now = live.take();
  if (now.clear) changes = {true, {}};
  std::move(now.chunks.begin(), now.chunks.end(), std::back_inserter(changes.chunks));
  write_out();
}

void Saver::Work::take(Begin& begin) {
  drawing = std::move(begin.drawing);
  about = {std::move(begin.name), std::move(begin.path), begin.modified, {}};
  live.begin();
  edits.clear();
  has_begun = true;
  ++drawing_number;
  // The last one is saved, or nobody wants it; yet it goes only when this one is whole.
  // What never came to be whole is worth nothing as long as an older one is there, and a try every
  // few seconds must not fill the disk with such.
  const bool is_whole = store && !store->base_in_work();
  if (store && (is_whole || old.empty())) old.push_back(*std::exchange(store, {}));
  if (store) static_cast<void>(std::move(*std::exchange(store, {})).remove());
  next_try = {};
  why.clear();
  root = 0;
}

void Saver::Work::take(Rename& rename) {
  about.name = std::move(rename.name);
  about.path = std::move(rename.path);
  about_is_told = false;
}

void Saver::Work::take(Modified& modified) {
  set_modified(modified.is_modified);
}

void Saver::Work::set_modified(bool modified) {
  if (about.modified == modified) return;
  about.modified = modified;
  about_is_told = false;
}

void Saver::Work::take(Head& head) {
  head.head.document = std::move(drawing.document);
  head.head.layer = drawing.layer;
  drawing = std::move(head.head);
  about_is_told = false;
}

/// What of an event is said of the drawing, not of its strokes.
void Saver::Work::follow(const Event& event) {
  if (const auto* layer = std::get_if<LayerEvent>(&event.what)) {
    if (layer->what != LayerEvent::Do::kUse) return;
    drawing.layer = layer->layer;
    about_is_told = false;
  }
  const auto* option = std::get_if<SetOption>(&event.what);
  const auto* text = option ? std::get_if<std::string>(&option->value) : nullptr;
  if (!text) return;
  if (option->id == "sheet.material") {
    drawing.page.surface = *text;
    about_is_told = false;
  } else if (option->id == "sheet.color") {
    if (const auto color = color_from_text(*text)) drawing.color = *color;
    about_is_told = false;
  }
}

void Saver::Work::take(Told& told) {
  live.told(told.event, told.gesture_in_work);
  newest_ns = std::max(newest_ns, told.event.time_ns);
  follow(told.event);
}

void Saver::Work::take(Context& context) {
  for (const Event& event : context.events) {
    live.context(event);
    follow(event);
  }
}

void Saver::Work::take(Edit& edit) {
  live.edit();
  // It fits: the session's document has just taken it.
  if (const Result<void> done = drawing.document.apply(edit); !done) why = done.error().message;
  set_modified(true);
  if (store) edits.push_back(std::move(edit));
}

void Saver::Work::take(Selection& selection) {
  live.selection(std::move(selection));
}

/// Into the store there is, else into a new one, in the first place that takes it.
void Saver::Work::write_out() {
  if (!has_begun) return;
  const Clock::time_point now = Clock::now();
  if (store && root > 0 && now >= next_first) {
    next_first = now + options.retry_first;
    // The store elsewhere is kept until one in the first place is whole.
    std::optional<WorkingStore> elsewhere = std::exchange(store, {});
    const std::size_t place = std::exchange(root, 0);
    if (make_store(0)) {
      old.push_back(*std::move(elsewhere));
    } else {
      store = std::move(elsewhere);
      root = place;
    }
  }
  if (!store && now < next_try) return;
  while (!store && root < options.roots.size()) {
    if (const Result<void> made = make_store(root); !made) fail_over(made.error());
  }
  while (store) {
    const Result<void> written = write();
    if (written) break;
    fail_over(written.error());
    while (!store && root < options.roots.size()) {
      if (const Result<void> made = make_store(root); !made) fail_over(made.error());
    }
  }
  if (store) {
    changes = {};
    edits.clear();
    if (!store->base_in_work()) let_go();
    set_status(root == 0 ? SaverStatus{SaverStatus::State::kWorking, {}, store->folder()}
                         : SaverStatus{SaverStatus::State::kElsewhere, why, store->folder()});
    return;
  }
  changes = {};  // another store begins with all chunks
  root = 0;
  next_try = now + options.retry;
  set_status({SaverStatus::State::kFailing, why, {}});
}

void Saver::Work::fail_over(const Error& error) {
  why = error.message;
  if (store) old.push_back(*std::exchange(store, {}));
  ++root;
  next_first = Clock::now() + options.retry_first;
}

/// A new store with all there is: its base is the replica, so no edit waits for it.
Result<void> Saver::Work::make_store(std::size_t place) {
  const std::string name =
      process + '.' + std::to_string(drawing_number) + '.' + std::to_string(++store_number);
  Result<WorkingStore> made = WorkingStore::create(options.roots[place], name, options.vfs);
  if (!made) return tl::unexpected(made.error());
  const auto begun = made->begin_base(std::make_shared<const StoredDrawing>(drawing));
  if (!begun) static_cast<void>(std::move(*made).remove());
  if (!begun) return begun;
  store = *std::move(made);
  edits.clear();
  changes = {false, live.chunks()};
  about_is_told = false;
  return {};
}

Result<void> Saver::Work::write() {
  for (const Edit& edit : edits) {
    if (auto added = store->add_edit(edit); !added) return tl::unexpected(added.error());
  }
  if (!about_is_told) {
    // All of it but the strokes, of which there may be many.
    Document document = std::exchange(drawing.document, {});
    about.head = drawing;
    drawing.document = std::move(document);
    if (auto ok = store->put_about(about); !ok) return ok;
  }
  if (changes.clear) {
    if (auto ok = store->clear_live(); !ok) return ok;
  }
  for (const LiveChunk& chunk : changes.chunks) {
    if (auto ok = store->add_live(chunk.kind, chunk.bytes); !ok) return ok;
  }
  if (auto ok = write_base(); !ok) return ok;
  if (auto ok = store->commit(); !ok) return ok;
  about_is_told = true;
  if (options.on_commit) options.on_commit(std::max(newest_ns, live.kept_ns()));
  return {};
}

/// Some parts of a base, or some rows less that no base needs.
Result<void> Saver::Work::write_base() {
  if (!store->base_in_work() && store->edit_bytes() > options.longest_log_bytes) {
    if (auto ok = store->begin_base(std::make_shared<const StoredDrawing>(drawing)); !ok) return ok;
  }
  for (int i = 0; i < kPartsATurn && store->base_in_work(); ++i) {
    if (auto done = store->write_base_part(); !done) return tl::unexpected(done.error());
  }
  if (store->base_in_work()) return {};
  return store->tidy().map([](bool) {});
}

void Saver::Work::let_go() {
  for (WorkingStore& gone : std::exchange(old, {})) static_cast<void>(std::move(gone).remove());
}

void Saver::Work::finish() {
  const bool stays = has_begun && about.modified;
  while (stays && store && store->base_in_work()) turn();
  if (!stays) {
    let_go();
    if (store) static_cast<void>(std::move(*store).remove());
  }
  store.reset();
}

}  // namespace felt
