#include "desktop/files/journal_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "felt/io/event_writer.h"
#include "felt/store/byte_stream.h"
#include "felt/store/edit_blob.h"
#include "felt/store/journal_log.h"

namespace felt::desktop {
namespace {

using namespace std::chrono_literals;
constexpr auto kGather = 20ms;
constexpr std::uint64_t kLongLogBytes = std::uint64_t{50} << 20;
constexpr std::uint64_t kMaxTailBytes = std::uint64_t{64} << 20;  // ten minutes without a lift

std::string number_bytes(std::uint64_t value) {
  std::string bytes;
  ByteWriter(bytes).u64(value);
  return bytes;
}

}  // namespace

JournalWriter::JournalWriter(std::string folder, std::function<void(const std::string&)> tell)
    : folder_(std::move(folder)), tell_(std::move(tell)), thread_([this] { run(); }) {}

JournalWriter::~JournalWriter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void JournalWriter::begin(std::shared_ptr<const Drawing> drawing) {
  push(Base{std::move(drawing), true});
}
void JournalWriter::renew(std::shared_ptr<const Drawing> drawing) {
  push(Base{std::move(drawing), false});
}
void JournalWriter::edit(const Edit& edit) {
  push(edit);
}
void JournalWriter::head(Drawing head) {
  push(std::move(head));
}
void JournalWriter::saved() {
  push(Saved{});
}
void JournalWriter::begin_tail(std::vector<Event> events) {
  push(BeginTail{std::move(events)});
}
void JournalWriter::event(const Event& event) {
  push(event);
}
void JournalWriter::end_tail() {
  push(EndTail{});
}

void JournalWriter::push(Item item) {
  bool was_empty = false;
  {
    const std::lock_guard lock(mutex_);
    was_empty = queue_.empty();
    queue_.push_back(std::move(item));
  }
  if (was_empty) wake_.notify_all();
}

void JournalWriter::flush() {
  std::unique_lock lock(mutex_);
  const std::uint64_t wanted = ++flushes_wanted_;
  wake_.notify_all();
  rest_.wait(lock, [this, wanted] { return flushes_done_ >= wanted; });
}

void JournalWriter::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto is_urgent = [this] { return stop_ || flushes_wanted_ > flushes_done_; };
    wake_.wait(lock, [&] { return is_urgent() || !queue_.empty(); });
    // More comes within the same moment: one write for all of it.
    wake_.wait_for(lock, kGather, is_urgent);
    const bool is_last = stop_, wait = is_urgent();
    const std::uint64_t flush = flushes_wanted_;
    std::vector<Item> items = std::exchange(queue_, {});
    lock.unlock();
    for (const Item& item : items) {
      if (has_given_up_ && !std::holds_alternative<Base>(item)) continue;
      std::visit([this](const auto& what) { take(what); }, item);
    }
    items.clear();
    write_out();
    finish_base(wait);
    lock.lock();
    flushes_done_ = flush;
    rest_.notify_all();
    if (is_last && queue_.empty()) break;
  }
  close_logs(0);
  if (tail_fd_ >= 0) ::close(tail_fd_);
}

std::string JournalWriter::path(const char* name, int generation) const {
  return folder_ + "/" + name + std::to_string(generation);
}

void JournalWriter::take(const Base& base) {
  write_out();
  finish_base(true);
  take(EndTail{});
  if (base.is_another || std::exchange(has_given_up_, false)) close_logs(0);
  ++generation_;
  Log log{generation_, -1, 0, {}};
  log.fd = ::open(path("edits-", generation_).c_str(),
                  O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_APPEND, 0600);
  if (log.fd < 0) return give_up(std::strerror(errno));
  append_log_record(log.pending, static_cast<std::uint8_t>(JournalRecord::kStart),
                    number_bytes(serial_));
  logs_.push_back(std::move(log));
  asked_for_base_ = false;
  // Beside this thread: a drawing of 100,000 strokes takes a while, and the log must go on.
  base_ = std::async(std::launch::async,
                     [name = path("base-", generation_) + ".felt", drawing = base.drawing] {
                       return write_felt(name, *drawing);
                     });
}

/// Once a new base is whole, the generations before it are no longer needed.
void JournalWriter::finish_base(bool wait) {
  if (!base_.valid()) return;
  if (!wait && base_.wait_for(0s) != std::future_status::ready) return;
  const Result<void> done = base_.get();
  if (!done) return give_up(done.error().message);
  close_logs(1);
}

void JournalWriter::close_logs(std::size_t keep) {
  while (logs_.size() > keep) {
    ::close(logs_.front().fd);
    // While the program lives on; at the end the folder goes or stays as a whole.
    if (keep > 0 || !stop_) {
      ::unlink((path("base-", logs_.front().generation) + ".felt").c_str());
      ::unlink(path("edits-", logs_.front().generation).c_str());
    }
    logs_.erase(logs_.begin());
  }
}

void JournalWriter::add(JournalRecord type, std::string_view bytes) {
  for (Log& log : logs_) append_log_record(log.pending, static_cast<std::uint8_t>(type), bytes);
}

void JournalWriter::take(const Edit& edit) {
  std::string bytes = number_bytes(++serial_);
  if (const Result<void> done = append_edit_blob(bytes, edit); !done) {
    return give_up(done.error().message);
  }
  add(JournalRecord::kEdit, bytes);
  has_edits_ = true;
  // What the gesture came to is in the log: the tail of an older serial no longer counts.
  tail_text_.clear();
}

void JournalWriter::take(const Drawing& head) {
  if (const Result<std::string> bytes = felt_bytes(head)) add(JournalRecord::kHead, *bytes);
}

void JournalWriter::take(const Saved&) {
  add(JournalRecord::kSaved, {});
}

void JournalWriter::take(const BeginTail& tail) {
  if (tail_fd_ < 0) {
    tail_fd_ = ::open((folder_ + "/tail").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND, 0600);
    if (tail_fd_ < 0) return give_up(std::strerror(errno));
  }
  // The edits before it must be there before it is.
  write_out();
  if (::ftruncate(tail_fd_, 0) != 0) return give_up(std::strerror(errno));
  tail_bytes_ = 0;
  std::string head;
  append_log_record(head, static_cast<std::uint8_t>(JournalRecord::kTail), number_bytes(serial_));
  if (!put(tail_fd_, head)) return;
  for (const Event& event : tail.events) take(event);
}

void JournalWriter::take(const Event& event) {
  if (tail_fd_ >= 0 && tail_bytes_ < kMaxTailBytes) append_event_line(tail_text_, event);
}

void JournalWriter::take(const EndTail&) {
  tail_text_.clear();
  if (tail_fd_ >= 0 && ::ftruncate(tail_fd_, 0) != 0) give_up(std::strerror(errno));
}

void JournalWriter::write_out() {
  if (has_given_up_) return;
  for (Log& log : logs_) {
    if (log.pending.empty()) continue;
    if (!put(log.fd, log.pending)) return;
    log.bytes += log.pending.size();
    log.pending.clear();
    // A power cut too: an edit is seldom, and nobody waits here.
    if (has_edits_) ::fdatasync(log.fd);
  }
  has_edits_ = false;
  if (!tail_text_.empty() && tail_fd_ >= 0) {
    std::string record;
    append_log_record(record, static_cast<std::uint8_t>(JournalRecord::kEvents), tail_text_);
    tail_bytes_ += record.size();
    if (!put(tail_fd_, record)) return;
    tail_text_.clear();
  }
  if (logs_.size() == 1 && logs_.front().bytes > kLongLogBytes && !asked_for_base_) {
    asked_for_base_ = true;
    tell_({});
  }
}

bool JournalWriter::put(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      give_up(std::strerror(errno));
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

void JournalWriter::give_up(const std::string& why) {
  if (std::exchange(has_given_up_, true)) return;
  tell_(why.empty() ? "unknown" : why);
}

}  // namespace felt::desktop
