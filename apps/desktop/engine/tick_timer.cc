#include "desktop/engine/tick_timer.h"

#include <sys/timerfd.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <algorithm>

#include "felt/base/constants.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

}  // namespace

TickTimer::TickTimer(QObject* parent)
    : QObject(parent), fd_(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)) {
  coarse_.setSingleShot(true);
  coarse_.setTimerType(Qt::PreciseTimer);
  connect(&coarse_, &QTimer::timeout, this, &TickTimer::due);
  if (fd_ < 0) return;
  notifier_ = new QSocketNotifier(fd_, QSocketNotifier::Read, this);
  connect(notifier_, &QSocketNotifier::activated, this, &TickTimer::take);
}

TickTimer::~TickTimer() {
  delete notifier_;  // before its file descriptor is closed
  if (fd_ >= 0) close(fd_);
}

void TickTimer::start(std::int64_t in_ns) {
  in_ns = std::max<std::int64_t>(in_ns, 1);  // 0 would stop the timer
  itimerspec shot{};
  shot.it_value.tv_sec = in_ns / kSecond;
  shot.it_value.tv_nsec = in_ns % kSecond;
  if (fd_ < 0 || timerfd_settime(fd_, 0, &shot, nullptr) != 0) {
    coarse_.start(static_cast<int>((in_ns + kMs - 1) / kMs));
  }
}

void TickTimer::stop() {
  coarse_.stop();
  const itimerspec never{};
  if (fd_ >= 0) static_cast<void>(timerfd_settime(fd_, 0, &never, nullptr));
}

void TickTimer::take() {
  std::uint64_t shots = 0;
  // A failed read means that the timer had fired but was then restarted.
  if (read(fd_, &shots, sizeof shots) == sizeof shots) Q_EMIT due();
}

}  // namespace felt::desktop
