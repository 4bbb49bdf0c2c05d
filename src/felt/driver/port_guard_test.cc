#include "felt/driver/port_guard.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>

#include "felt/base/constants.h"

namespace felt::port_guard_test {
namespace {

constexpr std::int64_t kNeverNs = 3'600'000 * kMs;
constexpr int kLongMs = 8000;  // an upper bound; no test waits that long
constexpr std::string_view kWords("\x02\x05\0\0\0\0\0\0\0\0", 10);

// A pseudo-terminal: the board's end, and the port that a program opens.
class Port {
 public:
  Port() {
    board_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_EQ(grantpt(board_), 0);
    EXPECT_EQ(unlockpt(board_), 0);
    std::array<char, 128> name{};
    EXPECT_EQ(ptsname_r(board_, name.data(), name.size()), 0);
    port_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    termios raw{};
    EXPECT_EQ(tcgetattr(port_, &raw), 0);
    cfmakeraw(&raw);
    EXPECT_EQ(tcsetattr(port_, TCSANOW, &raw), 0);
  }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  ~Port() {
    ::close(port_);
    ::close(board_);
  }
  [[nodiscard]] int get() const { return port_; }
  std::unique_ptr<PortGuard> guard(std::int64_t patience_ns) const {
    return PortGuard::start(port_, std::as_bytes(std::span(kWords)), patience_ns);
  }
  // Returns the next bytes that the board receives, as many as kWords has.
  std::string receive() const {
    std::string received;
    while (received.size() < kWords.size()) {
      pollfd waits{.fd = board_, .events = POLLIN, .revents = 0};
      if (poll(&waits, 1, kLongMs) <= 0) break;
      std::array<char, 64> room{};
      const ssize_t count = ::read(board_, room.data(), kWords.size() - received.size());
      if (count <= 0) break;
      received.append(room.data(), static_cast<std::size_t>(count));
    }
    return received;
  }
  [[nodiscard]] bool is_quiet() const {
    pollfd waits{.fd = board_, .events = POLLIN, .revents = 0};
    return poll(&waits, 1, 0) == 0;
  }

 private:
  int board_ = -1;
  int port_ = -1;
};

TEST(PortGuard, SpeaksWhenItIsEnded) {
  const Port port;
  auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  guard->beat();
  EXPECT_TRUE(port.is_quiet());
  guard.reset();
  EXPECT_EQ(port.receive(), kWords);
  EXPECT_TRUE(port.is_quiet()) << "once";
}

TEST(PortGuard, SpeaksOnceForEachSilenceAfterABeat) {
  const Port port;
  auto guard = port.guard(20 * kMs);
  ASSERT_NE(guard, nullptr);
  for (int i = 0; i < 3; ++i) {
    guard->beat();
    EXPECT_EQ(port.receive(), kWords) << i;
    usleep(60'000);
    EXPECT_TRUE(port.is_quiet()) << i;
  }
}

// A separate program that calls beat() every millisecond until a test kills or stops it.
class Program {
 public:
  Program(const Port& port, std::int64_t patience_ns) {
    std::array<int, 2> ready{};
    EXPECT_EQ(pipe(ready.data()), 0);
    process_ = ::fork();
    if (process_ == 0) {
      const auto guard = port.guard(patience_ns);
      for (;;) {
        if (guard) guard->beat();
        static_cast<void>(!::write(ready[1], "x", 1));
        usleep(1000);
      }
    }
    char one = 0;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(::read(ready[0], &one, 1), 1);
    fcntl(ready[1], F_SETFL, O_NONBLOCK);  // the program must not block if nobody reads
    ::close(ready[1]);
    ready_ = ready[0];
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    ::close(ready_);
  }
  void signal(int number) const { ::kill(process_, number); }

 private:
  pid_t process_ = -1;
  int ready_ = -1;
};

TEST(PortGuard, SpeaksForAProgramThatWasKilled) {
  const Port port;
  const Program program(port, kNeverNs);
  EXPECT_TRUE(port.is_quiet());
  program.signal(SIGKILL);
  EXPECT_EQ(port.receive(), kWords);
}

TEST(PortGuard, SpeaksForAProgramThatWasStopped) {
  const Port port;
  const Program program(port, 50 * kMs);
  program.signal(SIGSTOP);
  EXPECT_EQ(port.receive(), kWords);
}

// The guard must close all other files. Otherwise it would keep another port's connection open.
TEST(PortGuard, HoldsNothingElseOpen) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const Port port;
  const auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  ::close(ends[1]);
  pollfd waits{.fd = ends[0], .events = POLLIN, .revents = 0};
  ASSERT_EQ(poll(&waits, 1, kLongMs), 1);
  char one = 0;
  EXPECT_EQ(::read(ends[0], &one, 1), 0);
  ::close(ends[0]);
}

// Some threads allocate all the time, so that during some of the forks one of them holds the lock
// of the allocator.
TEST(PortGuard, StartsFromAProgramWithThreads) {
  const Port port;
  std::atomic<bool> is_over{false};
  std::thread other([&] {
    while (!is_over) std::string(1000, 'x').append("y");
  });
  for (int i = 0; i < 30; ++i) {
    auto guard = port.guard(kNeverNs);
    ASSERT_NE(guard, nullptr);
    guard->beat();
    guard.reset();
    EXPECT_EQ(port.receive(), kWords);
  }
  is_over = true;
  other.join();
}

// Returns a child process of this program (proc_pid_stat(5), field 4), or 0 if it has no child.
pid_t child_of_ours() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    if (!std::getline(stat, line)) continue;
    std::istringstream rest(line.substr(line.rfind(')') + 1));
    std::string state;
    pid_t parent = 0;
    if (rest >> state >> parent && parent == getpid()) {
      return static_cast<pid_t>(std::stol(entry.path().filename().string()));
    }
  }
  return 0;
}

// The guard may be killed; the next beat reports it.
TEST(PortGuard, R49_TellsThatItWasKilled) {
  const Port port;
  auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  EXPECT_TRUE(guard->beat());
  const pid_t process = child_of_ours();
  ASSERT_GT(process, 0);
  ASSERT_EQ(::kill(process, SIGKILL), 0);
  int beats = 0;
  while (guard->beat() && beats < kLongMs) {
    ++beats;
    usleep(1000);
  }
  EXPECT_LT(beats, kLongMs);
  guard->speak();
  EXPECT_EQ(port.receive(), kWords) << "our program says them itself";
  guard.reset();
  EXPECT_EQ(port.receive(), kWords) << "also at the end";
}

// A guard that is stopped accepts heartbeats, but would not act.
TEST(PortGuard, R49_TellsThatItIsStopped) {
  const Port port;
  const auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  const pid_t process = child_of_ours();
  ASSERT_GT(process, 0);
  ASSERT_EQ(::kill(process, SIGSTOP), 0);
  int beats = 0;
  for (; guard->beat() && beats < 200; ++beats) usleep(1000);
  EXPECT_LT(beats, 200) << "long before its socket is full";
  ASSERT_EQ(::kill(process, SIGCONT), 0);
  for (beats = 0; !guard->beat() && beats < kLongMs; ++beats) usleep(1000);
  EXPECT_LT(beats, kLongMs) << "it protects again";
}

TEST(PortGuard, R49_AStoppedGuardIsContinuedWhenItIsEnded) {
  const Port port;
  auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  const pid_t process = child_of_ours();
  ASSERT_GT(process, 0);
  ASSERT_EQ(::kill(process, SIGSTOP), 0);
  guard.reset();  // would wait for ever
  EXPECT_EQ(port.receive(), kWords);
}

// If somebody stops it again and again, its last words are written without it.
TEST(PortGuard, R49_AGuardThatDoesNotEndIsKilledAndItsWordsAreWritten) {
  const Port port;
  auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  const pid_t process = child_of_ours();
  ASSERT_GT(process, 0);
  std::atomic<bool> is_over{false};
  std::thread somebody([&] {
    while (!is_over && ::kill(process, SIGSTOP) == 0) {
    }
  });
  guard.reset();
  is_over = true;
  somebody.join();
  EXPECT_EQ(port.receive(), kWords);
}

// A connection that only the guard uses, with the other end of a network service.
class OwnConnection {
 public:
  OwnConnection() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()), 0);
  }
  OwnConnection(const OwnConnection&) = delete;
  OwnConnection& operator=(const OwnConnection&) = delete;
  ~OwnConnection() {
    hang_up();
    ::close(ends_[1]);
  }
  std::unique_ptr<PortGuard> guard(std::int64_t patience_ns) const {
    return PortGuard::start(ends_[1], std::as_bytes(std::span(kWords)), patience_ns,
                            PortGuard::Use::kOwnConnection);
  }
  void answer() const { EXPECT_EQ(::write(ends_[0], "answer", 6), 6); }
  std::string receive() const {
    std::array<char, 64> room{};
    pollfd waits{.fd = ends_[0], .events = POLLIN, .revents = 0};
    if (poll(&waits, 1, kLongMs) <= 0) return "nothing";
    const ssize_t count = ::read(ends_[0], room.data(), room.size());
    return {room.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }
  [[nodiscard]] bool is_quiet() const {
    pollfd waits{.fd = ends_[0], .events = POLLIN, .revents = 0};
    return poll(&waits, 1, 0) == 0;
  }
  void hang_up() {
    if (ends_[0] >= 0) ::close(ends_[0]);
    ends_[0] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

TEST(PortGuard, OnAConnectionOfItsOwnItReadsTheAnswersAndSpeaksAgain) {
  const OwnConnection line;
  auto guard = line.guard(20 * kMs);
  ASSERT_NE(guard, nullptr);
  for (int i = 0; i < 3; ++i) {
    guard->beat();
    EXPECT_EQ(line.receive(), kWords) << i;
    for (int k = 0; k < 100; ++k) line.answer();
  }
  guard.reset();
  EXPECT_EQ(line.receive(), kWords) << "in spite of answers that it had not read";
}

TEST(PortGuard, SpeaksWhenItIsAsked) {
  const OwnConnection line;
  const auto guard = line.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  guard->beat();
  guard->speak();
  EXPECT_EQ(line.receive(), kWords);
}

TEST(PortGuard, RestsUntilTheNextBeat) {
  const OwnConnection line;
  auto guard = line.guard(20 * kMs);
  ASSERT_NE(guard, nullptr);
  guard->beat();
  guard->rest();
  usleep(60'000);
  EXPECT_TRUE(line.is_quiet());
  guard->beat();
  EXPECT_EQ(line.receive(), kWords);
  guard->rest();
  guard.reset();
  EXPECT_EQ(line.receive(), kWords) << "the end of the program is not a rest";
}

TEST(PortGuard, TellsThatItsConnectionWasClosed) {
  OwnConnection line;
  const auto guard = line.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  EXPECT_TRUE(guard->beat());
  line.hang_up();
  int beats = 0;
  while (guard->beat() && beats < kLongMs) {
    ++beats;
    usleep(1000);
  }
  EXPECT_LT(beats, kLongMs);
}

TEST(PortGuard, BeatsNeverWait) {
  const Port port;
  const auto guard = port.guard(kNeverNs);
  ASSERT_NE(guard, nullptr);
  for (int i = 0; i < 200'000; ++i) guard->beat();  // more than the guard can read; must not block
  EXPECT_TRUE(port.is_quiet());
  EXPECT_EQ(PortGuard::start(-1, {}, kMs), nullptr);
}

}  // namespace
}  // namespace felt::port_guard_test
