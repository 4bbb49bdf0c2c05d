#include "desktop/window/start_watch.h"

#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QTimer>
#include <cstdio>
#include <ctime>

#include <unistd.h>

namespace felt::desktop {
namespace {

/// Returns the time since the kernel created the process, which includes the loading of libraries.
/// The resolution is the kernel's, 10 ms.
double seconds_since_start() {
  QFile file(QStringLiteral("/proc/self/stat"));
  if (!file.open(QIODevice::ReadOnly)) return 0.0;
  const QByteArray all = file.readAll();
  // Reads field 22 (proc(5)). Counts from the last bracket, because field 2 is in brackets and may
  // contain any characters.
  const QList<QByteArray> fields = all.mid(all.lastIndexOf(')') + 2).split(' ');
  if (fields.size() < 20) return 0.0;
  const double ticks = double(sysconf(_SC_CLK_TCK));
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - fields[19].toDouble() / ticks;
}

}  // namespace

StartWatch::StartWatch(Canvas& canvas) : QObject(&canvas) {
  canvas.installEventFilter(this);
}

bool StartWatch::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::Paint || is_done_) return false;
  is_done_ = true;
  // The timer fires after the paint, when the picture was passed to the screen.
  QTimer::singleShot(0, this, [] {
    std::printf("first paint %.0f ms after the start, %.0f ms of CPU\n",
                1e3 * seconds_since_start(), 1e3 * double(std::clock()) / CLOCKS_PER_SEC);
    QApplication::exit(0);
  });
  return false;
}

}  // namespace felt::desktop
