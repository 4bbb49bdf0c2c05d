#include "own_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace felt::bench {
namespace {

constexpr int kStartMs = 10'000;

[[noreturn]] void become_server(int display_fd) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string fd = std::to_string(display_fd);
  execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1280x800x24", "-nolisten",
         "tcp", static_cast<char*>(nullptr));
  _exit(127);
}

/// Returns the display number that the server writes to `fd` when it is ready. Returns "" if none
/// comes in time.
std::string number_from(int fd) {
  std::string text;
  std::array<char, 16> part{};
  pollfd ready{fd, POLLIN, 0};
  while (poll(&ready, 1, kStartMs) > 0) {
    const ssize_t n = read(fd, part.data(), part.size());
    if (n <= 0) return {};
    text.append(part.data(), static_cast<std::size_t>(n));
    if (const std::size_t end = text.find('\n'); end != std::string::npos) {
      return text.substr(0, end);
    }
  }
  return {};
}

}  // namespace

OwnServer::OwnServer() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return;
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    become_server(ends[1]);
  }
  close(ends[1]);
  const std::string number = process_ > 0 ? number_from(ends[0]) : std::string();
  close(ends[0]);
  if (!number.empty()) display_ = ":" + number;
}

OwnServer::~OwnServer() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

}  // namespace felt::bench
