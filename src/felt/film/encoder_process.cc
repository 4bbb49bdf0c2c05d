#include "felt/film/encoder_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

extern char** environ;

namespace felt {
namespace {

constexpr std::size_t kMaxErrorBytes = 4096;
constexpr int kWaitMs = 20;
constexpr const char* kCancelled = "cancelled";

/// The attributes and file actions of posix_spawn, which must be destroyed.
class SpawnSetup {
 public:
  SpawnSetup() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  void pass(int fd, int as) { posix_spawn_file_actions_adddup2(&actions_, fd, as); }
  void open_null(int as) {
    posix_spawn_file_actions_addopen(&actions_, as, "/dev/null", O_WRONLY, 0);
  }
  int spawn(const std::vector<std::string>& words, pid_t& pid) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    return posix_spawnp(&pid, arguments[0], &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

tl::unexpected<Error> system_error(int reason) {
  return fail(reason == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo, std::strerror(reason));
}

}  // namespace

Result<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& words, int output_fd,
                                             std::function<bool()> is_cancelled) {
  // A socket instead of a pipe, because only send() can fail without the signal SIGPIPE.
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return system_error(errno);
  }
  EncoderProcess process(ends[0], ::memfd_create("felt-encoder-errors", MFD_CLOEXEC));
  process.is_cancelled_ = std::move(is_cancelled);
  // Copies above all descriptors of the program, so that no dup2 replaces one that follows.
  const int output = ::fcntl(output_fd, F_DUPFD_CLOEXEC, kOutputFd + 1);
  const int input = ::fcntl(ends[1], F_DUPFD_CLOEXEC, kOutputFd + 1);
  const int errors = ::fcntl(process.errors_, F_DUPFD_CLOEXEC, kOutputFd + 1);
  int failed = output < 0 || input < 0 || errors < 0 ? errno : 0;
  if (failed == 0) {
    SpawnSetup setup;
    setup.pass(input, STDIN_FILENO);
    setup.open_null(STDOUT_FILENO);
    setup.pass(errors, STDERR_FILENO);
    setup.pass(output, kOutputFd);
    failed = setup.spawn(words, process.pid_);
    if (failed != 0) process.pid_ = -1;
  }
  for (const int fd : {ends[1], output, input, errors}) {
    if (fd >= 0) ::close(fd);
  }
  if (failed != 0) return system_error(failed);
  return process;
}

EncoderProcess::EncoderProcess(EncoderProcess&& other) noexcept
    : input_(std::exchange(other.input_, -1)),
      errors_(std::exchange(other.errors_, -1)),
      pid_(std::exchange(other.pid_, -1)),
      is_cancelled_(std::move(other.is_cancelled_)) {}

EncoderProcess::~EncoderProcess() {
  close_input();
  if (pid_ > 0) {
    ::kill(-pid_, SIGKILL);  // with the processes that it started
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (errors_ >= 0) ::close(errors_);
}

void EncoderProcess::close_input() noexcept {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
}

Result<void> EncoderProcess::send(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN || errno == EINTR) {
      pollfd ready{input_, POLLOUT, 0};
      ::poll(&ready, 1, kWaitMs);
      if (is_cancelled()) return fail(ErrorCode::kIo, kCancelled);
    } else {
      return system_error(errno);
    }
  }
  return {};
}

Result<void> EncoderProcess::finish() {
  close_input();
  if (pid_ < 0) return fail(ErrorCode::kIo, "has already ended");
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
    if (ended == pid_) break;
    if (ended < 0 && errno != EINTR) return system_error(errno);
    if (is_cancelled()) return fail(ErrorCode::kIo, kCancelled);
    ::poll(nullptr, 0, kWaitMs);
  }
  pid_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (std::string line = last_line(); !line.empty()) return fail(ErrorCode::kIo, std::move(line));
  if (WIFSIGNALED(status)) {
    return fail(ErrorCode::kIo, "ended by signal " + std::to_string(WTERMSIG(status)));
  }
  return fail(ErrorCode::kIo, "ended with exit code " + std::to_string(WEXITSTATUS(status)));
}

std::string EncoderProcess::last_line() const {
  const off_t size = ::lseek(errors_, 0, SEEK_END);
  if (size <= 0) return {};
  std::string text(kMaxErrorBytes, '\0');
  const off_t from =
      size > static_cast<off_t>(kMaxErrorBytes) ? size - static_cast<off_t>(kMaxErrorBytes) : 0;
  const ssize_t count = ::pread(errors_, text.data(), text.size(), from);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text.substr(text.find_last_of("\n\r") + 1);
}

}  // namespace felt
