#include "felt/driver/port_guard.h"

#include <errno.h>
#include <linux/sockios.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <optional>
#include <span>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr int kTries =
    20;  // attempts to send the last message; each waits until the port accepts more
constexpr int kTryMs = 50;
constexpr int kListenMs = 200;  // wait for the answers to the last message before the guard exits
constexpr int kMaxReads = 16;
constexpr int kPriority = 85;  // above the haptic loop (LoopOptions::fifo_priority)
constexpr char kBeat = 1, kSpeak = 2, kRest = 3;  // signs of the program
constexpr std::int64_t kLookNs = kMs;             // between two looks whether the guard has exited

std::int64_t monotonic_now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kSecond + now.tv_nsec;
}

// Writes without waiting. A connection that the peer has closed must not raise SIGPIPE.
ssize_t write_to(int port, std::span<const std::byte> bytes) noexcept {
  const ssize_t count = ::send(port, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return count < 0 && errno == ENOTSOCK ? ::write(port, bytes.data(), bytes.size()) : count;
}

void close_all(unsigned from, unsigned to) noexcept {
  constexpr unsigned kMax = 65'535;  // for kernels older than close_range() (5.9)
  if (close_range(from, to, 0) == 0) return;
  for (unsigned i = from; i <= std::min(to, kMax); ++i) ::close(static_cast<int>(i));
}

void keep_only(int one, int other) noexcept {
  const auto low = static_cast<unsigned>(std::min(one, other));
  const auto high = static_cast<unsigned>(std::max(one, other));
  if (low > 0) close_all(0, low - 1);
  if (high > low + 1) close_all(low + 1, high - 1);
  close_all(high + 1, UINT_MAX);
}

}  // namespace

// Everything here runs in the new process, and some of it in the program, too. It may only make
// calls that are safe between fork() and exec() of a program with threads (signal-safety(7)): no
// allocation, no locks, no destructors.
struct PortGuard::Process {
  static std::span<const std::byte> words_of(const Watch& watch) noexcept {
    return std::span(watch.words).first(watch.size);
  }
  static void say(const Watch& watch) noexcept;
  static bool discard_answers(const Watch& watch) noexcept;
  static void say_finally(const Watch& watch) noexcept;
  [[noreturn]] static void keep_watch(const Watch& watch) noexcept;
};

void PortGuard::Process::say(const Watch& watch) noexcept {
  std::size_t sent = 0;
  for (int i = 0; i < kTries && sent < watch.size; ++i) {
    const ssize_t count = write_to(watch.port, words_of(watch).subspan(sent));
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (count < 0 && errno == EAGAIN) {
      pollfd room{.fd = watch.port, .events = POLLOUT, .revents = 0};
      poll(&room, 1, kTryMs);
    } else if (count == 0 || errno != EINTR) {
      return;
    }
  }
}

// Discards the answers that have arrived on a connection of the guard's own. Returns false if the
// peer has closed it, so that the guard can no longer protect the device.
bool PortGuard::Process::discard_answers(const Watch& watch) noexcept {
  std::array<char, 256> room{};
  for (int i = 0; watch.use == Use::kOwnConnection && i < kMaxReads; ++i) {
    const ssize_t count = ::recv(watch.port, room.data(), room.size(), MSG_DONTWAIT);
    if (count == 0) return false;
    if (count < 0) return errno == EAGAIN || errno == EINTR;
  }
  return true;
}

// Sends the last words for the last time. If unread answers were left on the guard's own
// connection, its end would be a reset, and the peer could lose the last words. Therefore reads
// until the peer has closed the connection, or has sent nothing for a while.
void PortGuard::Process::say_finally(const Watch& watch) noexcept {
  say(watch);
  if (watch.use != Use::kOwnConnection) return;
  ::shutdown(watch.port, SHUT_WR);
  for (int i = 0; i < kMaxReads; ++i) {
    pollfd answers{.fd = watch.port, .events = POLLIN, .revents = 0};
    if (poll(&answers, 1, kListenMs) <= 0 || !discard_answers(watch)) break;
  }
}

void PortGuard::Process::keep_watch(const Watch& watch) noexcept {
  setsid();
  // It must act in time on a busy computer, too. It sleeps nearly always. If this is not permitted,
  // it runs as other processes do.
  const sched_param scheduling{.sched_priority = kPriority};
  sched_setscheduler(0, SCHED_FIFO, &scheduling);
  keep_only(watch.port, watch.connection);
  const timespec patience{.tv_sec = watch.patience_ns / kSecond,
                          .tv_nsec = watch.patience_ns % kSecond};
  bool has_beaten = false;
  for (;;) {
    pollfd beats{.fd = watch.connection, .events = POLLIN, .revents = 0};
    const int ready = ppoll(&beats, 1, has_beaten ? &patience : nullptr, nullptr);
    if (ready == 0) {
      say(watch);
      has_beaten = false;
      continue;
    }
    std::array<char, 64> room{};
    const ssize_t count = ready > 0 ? ::read(watch.connection, room.data(), room.size()) : -1;
    const bool goes_on = count > 0 || (count < 0 && errno == EINTR);
    if (!goes_on) {
      say_finally(watch);
      _exit(0);
    }
    if (!discard_answers(watch)) _exit(0);
    for (ssize_t i = 0; i < count; ++i) {
      const char sign = room[static_cast<std::size_t>(i)];
      has_beaten = sign == kBeat;
      if (sign == kSpeak) say(watch);
    }
  }
}

std::unique_ptr<PortGuard> PortGuard::start(int port, std::span<const std::byte> last_words,
                                            std::int64_t patience_ns, Use use) {
  if (port < 0 || last_words.size() > kMaxBytes) return nullptr;
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return nullptr;
  Watch watch{.port = port, .connection = ends[1], .patience_ns = patience_ns, .use = use};
  std::copy(last_words.begin(), last_words.end(), watch.words.begin());
  watch.size = last_words.size();
  // All signals are blocked before the fork, so that none of our signal handlers ever runs in the
  // guard.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t process = ::fork();
  if (process == 0) Process::keep_watch(watch);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    return nullptr;
  }
  watch.connection = ends[0];
  return std::unique_ptr<PortGuard>(new PortGuard(process, watch));
}

PortGuard::~PortGuard() {
  ::close(watch_.connection);
  ::kill(process_, SIGCONT);  // if it was stopped, it would not notice its end
  const std::optional<int> status = exit_status(kEndNs);
  if (status && WIFEXITED(*status)) return;  // it has written the last words
  if (!status) ::kill(process_, SIGKILL);
  Process::say_finally(watch_);
  // Not even a killed process exits while it waits in the kernel for its port.
  if (!status) static_cast<void>(exit_status(kEndNs));
}

// Returns how the guard has exited, as waitpid() reports it, or nullopt if it still runs.
std::optional<int> PortGuard::exit_status(std::int64_t within_ns) const noexcept {
  const std::int64_t until_ns = monotonic_now_ns() + within_ns;
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(process_, &status, WNOHANG);
    if (ended == process_) return status;
    if (ended < 0 && errno != EINTR) return SIGKILL;  // somebody else has waited for it
    if (monotonic_now_ns() >= until_ns) return std::nullopt;
    const timespec pause{.tv_sec = 0, .tv_nsec = kLookNs};
    nanosleep(&pause, nullptr);
  }
}

bool PortGuard::send(char sign) noexcept {
  return ::send(watch_.connection, &sign, 1, MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
}

// The bytes that the guard has not read yet (unix(7), SIOCOUTQ) show whether it runs. If it had no
// time to read for a moment, enough heartbeats are waiting for it, so that is not an error.
bool PortGuard::beat() noexcept {
  int unread = 0;
  if (::ioctl(watch_.connection, SIOCOUTQ, &unread) != 0) unread = 0;
  const std::int64_t now_ns = unread > 0 ? monotonic_now_ns() : 0;
  if (unread_since_ns_ == 0 || unread == 0) unread_since_ns_ = now_ns;
  is_alive_ = send(kBeat) && now_ns - unread_since_ns_ < kMaxUnreadNs;
  return is_alive_;
}

void PortGuard::speak() noexcept {
  if (send(kSpeak) && is_alive_) return;
  static_cast<void>(write_to(watch_.port, Process::words_of(watch_)));
}

void PortGuard::rest() noexcept {
  static_cast<void>(send(kRest));
}

}  // namespace felt
