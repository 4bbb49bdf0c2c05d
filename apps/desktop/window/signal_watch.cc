#include "desktop/window/signal_watch.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <initializer_list>

namespace felt::desktop {
namespace {

std::atomic<int> listener{-1};  // the end of the pipe to which the handler writes
static_assert(std::atomic<int>::is_always_lock_free);

void set(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaction(signal, &action, nullptr);
}

extern "C" void note_signal(int signal) {
  const int kept_errno = errno;
  const int fd = listener.exchange(-1);
  if (fd < 0 || write(fd, "!", 1) != 1) {  // the second signal, or the pipe failed
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  errno = kept_errno;
}

}  // namespace

SignalWatch::SignalWatch(QObject* parent) : QObject(parent) {
  if (pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    return;  // without a pipe, signals end the process as usual
  notifier_ = std::make_unique<QSocketNotifier>(pipe_[0], QSocketNotifier::Read);
  connect(notifier_.get(), &QSocketNotifier::activated, this, [this] {
    notifier_->setEnabled(false);
    Q_EMIT asked();
  });
  listener = pipe_[1];
  set(note_signal);
}

SignalWatch::~SignalWatch() {
  if (!notifier_) return;
  set(SIG_DFL);
  listener = -1;
  notifier_.reset();  // before its file descriptor is closed
  for (const int fd : pipe_) close(fd);
}

}  // namespace felt::desktop
