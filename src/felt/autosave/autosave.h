#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/live_ink.h"
#include "felt/document/edit.h"
#include "felt/document/selection.h"
#include "felt/rt/servo.h"
#include "felt/session/event.h"
#include "felt/session/session.h"
#include "felt/store/felt_file.h"

namespace felt {

/// The state of the autosave: whether it works, and in which folder.
struct AutosaveStatus {
  enum class State {
    kWorking,    ///< saves to the first folder
    kElsewhere,  ///< the first folder failed; saves to another
    kFailing,    ///< no folder works; tries again regularly
  };
  State state = State::kWorking;
  std::string why;     ///< the last failure, for the user; "" if `state` is kWorking
  std::string folder;  ///< folder of the database; "" if `state` is kFailing

  friend bool operator==(const AutosaveStatus&, const AutosaveStatus&) = default;
};

struct AutosaveOptions {
  /// Folders for databases, the preferred one first; see autosave_roots().
  std::vector<std::string> roots;
  /// Called on the autosave thread when AutosaveStatus::state or `why` changes. The initial state
  /// is kWorking.
  std::function<void(const AutosaveStatus&)> on_status = {};
  /// Called on the autosave thread after each commit. The argument is a time on the session's
  /// clock, in ns: everything that the session received up to that time is on the disk, together
  /// with all samples that the autosave has read from the haptic loop's ring.
  std::function<void(std::int64_t)> on_commit = {};
  /// Time for which messages are collected before a commit.
  std::chrono::milliseconds gather{20};
  /// `retry` is the time until the next attempt if all folders failed; `retry_first` is the time
  /// until the next attempt to return to the first folder while another folder works.
  std::chrono::milliseconds retry{5'000}, retry_first{60'000};
  /// If the edits since the last base (a complete copy of the drawing in the database) are larger
  /// than this, a new base is written.
  std::uint64_t max_log_bytes = std::uint64_t{32} << 20;
  /// The name of an SQLite file system (VFS), for tests of faults. If null, the system's file
  /// system is used.
  const char* vfs = nullptr;
  /// If false, no thread is started, and a test calls process().
  bool live = true;
};

/// A change for the autosave to save. The autosave applies each member that is set, in the order of
/// the members.
struct AutosaveMessage {
  /// The new drawing of the session. The previous drawing has been saved or discarded.
  std::unique_ptr<Drawing> drawing = {};
  /// Page, palette, view and all other parts of the drawing that no event reports. The document and
  /// active layer of `head` are ignored.
  std::unique_ptr<Drawing> head = {};
  std::optional<std::string> name = {};  ///< the drawing's name, as shown to the user
  /// Path of the user's file, which was just read or saved; "" if the drawing has no file.
  std::optional<std::string> path = {};
  std::optional<FileStamp> stamp = {};  ///< of that file; post() sets it
  /// True if the drawing has unsaved changes. An edit also sets it to true.
  std::optional<bool> modified = {};
  std::optional<Selection> selection = {};
  std::optional<Event> event = {};  ///< an event that the session accepted
  /// True if a gesture was in progress before `event`. Used only if `event` is a pen sample.
  bool gesture_in_progress = false;
  std::optional<Edit> edit = {};  ///< an edit that the document applied
  /// Events that set the state on which the next gesture depends: options, tool, device, active
  /// layer.
  std::vector<Event> context = {};
};

/// Protects a drawing against a crash of the program or the machine: writes all changes of a
/// session to an AutosaveDatabase within 20 ms.
///
///   Autosave autosave({.roots = autosave_roots()});
///   autosave.session_began(session, drawing, "Untitled", "", false);
///   options.on_event = [&](const Event& event) { autosave.event_applied(session, event); };
///   options.on_edit = [&](const Edit& edit) { autosave.edit_applied(session, edit); };
///   autosave.attach(servo.for_autosave(), offset_ns);
///   autosave.post({.name = "harbour.felt", .path = path, .modified = false});   // after a save
///
/// Calls on the edit thread put messages into a queue. The autosave thread applies them to its
/// replica of the drawing (the strokes are shared) and writes them to the database. It also reads
/// samples directly from the haptic loop, through a ring buffer that only the autosave reads. So
/// ink is saved even if the edit thread hangs. Only the destructor and flush() wait for a disk.
/// While the disk stalls, messages wait in the queue, and the samples of up to 16 s wait in the
/// ring. All of these are committed when the disk works again.
///
/// After an error, a database is not used again. Instead, the replica is written to a new database
/// in the next folder that works.
///
/// Call all functions on the edit thread unless noted otherwise.
class Autosave {
 public:
  explicit Autosave(AutosaveOptions options);
  /// Commits the queue and stops the thread. Deletes the database if there are no unsaved changes
  /// (`modified`), otherwise leaves it for recovery, as after a crash.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Starts saving a session that has this drawing. `path` is as in AutosaveMessage; nullopt if the
  /// file was neither read nor saved since the last path.
  void session_began(const Session& session, Drawing drawing, std::string name,
                     std::optional<std::string> path, bool modified);
  /// Queues an event that the session accepted. Call from SessionOptions::on_event.
  void event_applied(const Session& session, const Event& event);
  /// Queues an edit that the document applied. Call from SessionOptions::on_edit.
  void edit_applied(const Session& session, const Edit& edit);
  /// Adds a message to the queue.
  void post(AutosaveMessage message);

  /// Starts reading the haptic loop's samples from this ring. `offset_ns` is the time of the
  /// session's clock minus that of the loop's clock. The ring must exist until detach() is called;
  /// detach() does not wait for a disk.
  void attach(Servo::Ring& ring, std::int64_t offset_ns);
  void detach();

  /// Waits until the queue is committed or the commit has failed. For tests and for the end of the
  /// program.
  void flush();
  /// Returns the current status. Safe to call from any thread.
  [[nodiscard]] AutosaveStatus status() const;
  /// Processes the queue and commits. Requires AutosaveOptions::live == false.
  void process();

 private:
  using Clock = std::chrono::steady_clock;

  // --- Edit thread
  void add_layer_in_use(const Session& session, AutosaveMessage& message);

  // --- Any thread
  void set_status(AutosaveStatus now);

  // --- Autosave thread
  void run();
  void take_samples();
  void apply(AutosaveMessage& message);
  void apply_to_head(const Event& event);
  void replace_drawing(Drawing drawing);
  void set_modified(bool modified);
  void write_out();
  bool open_next_database();
  void try_first_root();
  Result<void> write();
  Result<void> write_base();
  Result<void> create_database(std::size_t root);
  void retire(std::optional<AutosaveDatabase> database);
  void fail_over(const Error& error);
  void remove_old();
  void finish();
  [[nodiscard]] bool is_idle() const;

  const AutosaveOptions options_;
  const std::string process_;  // unique name of this process

  // Used on the edit thread only: the state that the last messages contained.
  LayerId layer_;
  std::uint64_t selection_count_ = 0;

  mutable std::mutex mutex_;
  std::condition_variable wake_, flushed_;
  std::vector<AutosaveMessage> queue_;
  AutosaveStatus status_;
  std::uint64_t flushes_wanted_ = 0, flushes_done_ = 0;
  bool stop_ = false, has_work_ = false;
  std::atomic<bool> has_ring_{false};

  std::mutex ring_mutex_;  // held while memory is copied, never while waiting for a disk
  Servo::Ring* ring_ = nullptr;
  std::int64_t ring_offset_ns_ = 0;
  std::vector<PenSample> samples_;

  // Autosave thread.
  Drawing drawing_;  // the replica, after all messages so far
  AutosaveInfo info_;
  LiveInk live_ink_;
  LiveInk::Changes live_changes_;
  std::vector<Edit> edits_;  // edits that are not in the database yet
  std::optional<AutosaveDatabase> database_;
  std::optional<AutosaveDatabase> old_;  // to be removed when the base of `database_` is complete
  std::size_t root_ = 0;                 // index of the folder of `database_`
  int drawing_number_ = 0, database_number_ = 0;
  bool has_drawing_ = false, is_info_written_ = false;
  std::int64_t newest_ns_ = INT64_MIN;  // time of the newest event so far, on the session's clock
  std::string why_;                     // the last failure
  Clock::time_point next_try_, next_try_first_;
  std::thread thread_;
};

}  // namespace felt
