#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "desktop/files/drawing_file.h"
#include "felt/document/edit.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// What a recovery folder is made of (journal.h says how it is used):
///   base-N.felt   the drawing when generation N began
///   edits-N       what became of it since: a log (store/journal_log.h) of the records below
///   tail          the gesture in work: {serial of the last edit}, then events as text
/// The highest N with a whole base counts.
enum class JournalRecord : std::uint8_t {
  kStart = 1,   ///< u64: serial of the last edit before
  kEdit = 2,    ///< u64 serial, then an edit blob
  kHead = 3,    ///< page, material, colour, layer in use: a drawing without strokes, as .felt bytes
  kSaved = 4,   ///< all of it is in a file of the person's
  kTail = 5,    ///< u64 serial; the first record of `tail`
  kEvents = 6,  ///< lines of an event script
};

/// Writes a recovery folder on a thread of its own. Everything but the constructor and destructor
/// only puts something into a queue; what is in the queue is handed to the system 20 ms later.
/// After an error it stops writing and says so once.
class JournalWriter {
 public:
  /// `tell` is called on the writer's thread: with the reason when it stopped, or with "" when the
  /// log has grown so long that a new base should come.
  JournalWriter(std::string folder, std::function<void(const std::string&)> tell);
  /// Writes what is in the queue, and stops.
  ~JournalWriter();

  /// Another drawing: what is there is forgotten.
  void begin(std::shared_ptr<const Drawing> drawing);
  /// The same drawing, as it is after all that was told: the log begins anew.
  void renew(std::shared_ptr<const Drawing> drawing);
  void edit(const Edit& edit);
  void head(Drawing head);
  void saved();
  /// A gesture begins, with what it depends on.
  void begin_tail(std::vector<Event> events);
  void event(const Event& event);
  /// Nothing came of it.
  void end_tail();

  /// Waits until all that was told is written, or was given up. For tests and at the end.
  void flush();

 private:
  struct Base {
    std::shared_ptr<const Drawing> drawing;
    bool is_another = false;
  };
  struct Saved {};
  struct BeginTail {
    std::vector<Event> events;
  };
  struct EndTail {};
  using Item = std::variant<Base, Edit, Drawing, Saved, BeginTail, Event, EndTail>;

  struct Log {
    int generation = 0;
    int fd = -1;
    std::uint64_t bytes = 0;
    std::string pending;
  };

  void push(Item item);
  void run();
  void take(const Base& base);
  void take(const Edit& edit);
  void take(const Drawing& head);
  void take(const Saved& saved);
  void take(const BeginTail& tail);
  void take(const Event& event);
  void take(const EndTail& tail);
  void add(JournalRecord type, std::string_view bytes);
  void write_out();
  bool put(int fd, std::string_view bytes);
  void finish_base(bool wait);
  void close_logs(std::size_t keep);
  void give_up(const std::string& why);
  [[nodiscard]] std::string path(const char* name, int generation) const;

  std::string folder_;
  std::function<void(const std::string&)> tell_;
  std::mutex mutex_;
  std::condition_variable wake_, rest_;
  std::vector<Item> queue_;
  std::uint64_t flushes_wanted_ = 0, flushes_done_ = 0;
  bool stop_ = false;
  // The writer's thread only.
  std::vector<Log> logs_;
  std::future<Result<void>> base_;
  int generation_ = 0;
  std::uint64_t serial_ = 0;
  int tail_fd_ = -1;
  std::string tail_text_;
  std::uint64_t tail_bytes_ = 0;
  bool has_edits_ = false, asked_for_base_ = false, has_given_up_ = false;
  std::thread thread_;
};

}  // namespace felt::desktop
