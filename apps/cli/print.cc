#include "print.h"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>

namespace felt::cli {
namespace {

/// Blocks SIGPIPE for this thread during its lifetime, and discards a SIGPIPE that a write caused.
/// A closed stdout ends the program by that signal, but a closed stderr must not.
class WithoutSigpipe {
 public:
  WithoutSigpipe() noexcept {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  WithoutSigpipe(const WithoutSigpipe&) = delete;
  WithoutSigpipe& operator=(const WithoutSigpipe&) = delete;
  ~WithoutSigpipe() {
    const timespec at_once{};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_{}, before_{};
  bool was_pending_ = false;
};

}  // namespace

void print_text(std::string_view text) noexcept {
  // An error is not handled here, because stdout_is_whole() reports it.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stdout));
}

void say_text(std::string_view text) noexcept {
  const WithoutSigpipe quiet;
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool stdout_is_whole() noexcept {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

bool somebody_is_there() {
  return isatty(STDIN_FILENO) != 0;
}

bool ask(const std::string& question) {
  if (!somebody_is_there()) return false;
  say("{} [y/N] ", question);
  std::fflush(stderr);
  std::string answer;
  for (char c = 0; read(STDIN_FILENO, &c, 1) == 1 && c != '\n' && answer.size() < 16;) answer += c;
  return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes";
}

bool enter_pressed() {
  if (!somebody_is_there()) return false;
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  if (poll(&keys, 1, 0) <= 0 || (keys.revents & POLLIN) == 0) return false;
  char line[256];
  return read(STDIN_FILENO, line, sizeof line) > 0;
}

}  // namespace felt::cli
