#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/selection.h"
#include "felt/rt/servo.h"
#include "felt/session/event.h"
#include "felt/store/felt_file.h"

namespace felt {

/// How well a drawing is kept.
struct SaverStatus {
  enum class State {
    kWorking,    ///< in the first place
    kElsewhere,  ///< the first place failed, a later one works
    kFailing,    ///< nowhere; it is tried again and again
  };
  State state = State::kWorking;
  std::string why;     ///< the last failure, for a person; "" while kWorking
  std::string folder;  ///< where it is kept; "" while kFailing

  friend bool operator==(const SaverStatus&, const SaverStatus&) = default;
};

struct SaverOptions {
  /// Where stores may be, the best place first: working_roots().
  std::vector<std::string> roots;
  /// Told whenever it is another one than before; the first time only if it is not kWorking. On
  /// the saver's thread.
  std::function<void(const SaverStatus&)> on_status = {};
  /// Told after each commit: all that the session was told up to this time of its clock is kept,
  /// and all ink that the loop has made. On the saver's thread.
  std::function<void(std::int64_t)> on_commit = {};
  /// How long what is told is gathered before it is committed.
  std::chrono::milliseconds gather{20};
  /// After all places failed, and after the first one did.
  std::chrono::milliseconds retry{5'000}, retry_first{60'000};
  /// A new base is written once the edits since the last one have so many bytes.
  std::uint64_t longest_log_bytes = std::uint64_t{32} << 20;
  /// For tests of faults: SQLite's name of a file system.
  const char* vfs = nullptr;
  /// False: no thread; turn() is called by a test.
  bool live = true;
};

/// Keeps a drawing from being lost when the program or the machine dies: what it is told goes into
/// a WorkingStore within 20 ms, by a thread of its own that also drains the haptic loop's ring for
/// the saver. So what a person draws is kept even while the edit thread hangs. SaverFeed
/// (saver_feed.h) tells it what a session does.
///
/// Nothing here but the constructor, the destructor and flush() ever waits for a disk: calls put
/// something into a queue. While the disk stalls, the queue and the ring (16 s) grow, and all of it
/// is committed afterwards.
///
/// The saver keeps a replica of the document (shared strokes). When a store fails, it is never
/// touched again; the replica goes into a new one, in the next place that works.
///
/// Edit thread, but for what says otherwise.
class Saver {
 public:
  explicit Saver(SaverOptions options);
  /// Commits what was told, and stops. The store goes where all was saved (modified(false)) or
  /// nobody wants it (forget()); else it stays, as after a crash.
  ~Saver();
  Saver(const Saver&) = delete;
  Saver& operator=(const Saver&) = delete;

  /// Another drawing is on the desk. What was there before is saved, or nobody wants it.
  void begin(StoredDrawing drawing, std::string name, std::string path, bool modified);
  /// It is called so now, and is in this file.
  void rename(std::string name, std::string path);
  /// Whether there is something that no file of the person's has. An edit says so by itself.
  void modified(bool is_modified);
  /// The person does not want it kept.
  void forget();
  /// Page, palette, view and whatever else no event says; the document in it counts for nothing,
  /// and neither does the layer in use.
  void head(StoredDrawing head);
  /// The document took this.
  void edit(const Edit& edit);
  /// The session took this; whether a gesture was in work just before.
  void event(const Event& event, bool gesture_in_work);
  /// What the next gesture depends on: all options, the tool, the device; of a new session.
  void context(std::vector<Event> events);
  void selection(Selection selection);

  /// The loop hands its samples over here from now on; `offset_ns` is the session's clock less the
  /// loop's. The ring must live until detach(), which waits for no disk.
  void attach(Servo::Ring& ring, std::int64_t offset_ns);
  void detach();

  /// Waits until all that was told is committed, or is known not to be. For tests and at the end.
  void flush();
  /// Any thread.
  [[nodiscard]] SaverStatus status() const;
  /// Not live: takes what waits, and commits it.
  void turn();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace felt
