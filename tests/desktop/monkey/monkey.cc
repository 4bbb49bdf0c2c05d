#include "monkey.h"

#include <QApplication>
#include <QThread>
#include <array>
#include <cstdio>
#include <ctime>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {
namespace {

/// Returns the CPU time of this thread, in ms. It does not grow while other programs keep the
/// machine busy, so these cannot look like a hang.
double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

constexpr std::uint64_t kDeepEvery = 997;

}  // namespace

Monkey::Monkey(MainWindow& window, const MonkeyOptions& options)
    : window_(window),
      options_(options),
      dice_(options.seed),
      witness_(window.studio()),
      pen_(QStringLiteral("monkey pen"), 7001, QInputDevice::DeviceType::Stylus,
           QPointingDevice::PointerType::Pen,
           QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3),
      eraser_(QStringLiteral("monkey eraser"), 7002, QInputDevice::DeviceType::Stylus,
              QPointingDevice::PointerType::Eraser,
              QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3) {}

void Monkey::start() {
  QTimer::singleShot(0, this, &Monkey::step);
}

const Monkey::Choice& Monkey::choose() {
  static constexpr std::array<Choice, 13> kChoices = {{
      {20, &Monkey::stroke, "stroke"},
      {8, &Monkey::pen_event, "pen event"},
      {10, &Monkey::tablet_stroke, "tablet stroke"},
      {14, &Monkey::press_key, "key"},
      {12, &Monkey::trigger_action, "action"},
      {8, &Monkey::click_widget, "click"},
      {4, &Monkey::wheel, "wheel"},
      {8, &Monkey::choose_tool, "tool"},
      {5, &Monkey::set_option, "option"},
      {1, &Monkey::resize, "resize"},
      {0.3, &Monkey::switch_device, "device"},
      {2, &Monkey::leave_and_enter, "leave"},
      {5, &Monkey::wait, "wait"},
  }};
  double total = 0.0;
  for (const Choice& choice : kChoices) total += choice.weight;
  double at = dice_.between(0.0, total);
  for (const Choice& choice : kChoices) {
    if ((at -= choice.weight) < 0.0) return choice;
  }
  return kChoices.back();
}

void Monkey::step() {
  // An event may open a dialog, and the event loop of the dialog calls step() again. Such a call is
  // a separate event.
  if (!failure_.empty() || done_ >= options_.events) {
    if (QWidget* modal = QApplication::activeModalWidget()) {
      modal->close();
      QTimer::singleShot(0, this, &Monkey::step);
      return;
    }
    if (failure_.empty()) check_deeply();
    Q_EMIT finished();
    return;
  }
  ++done_;
  // The next step is scheduled before this act, because the act may open a dialog and the next step
  // must then run in the loop of the dialog. A repeating timer does not fire while its own event is
  // being handled.
  QTimer::singleShot(0, this, &Monkey::step);
  const Choice& chosen = choose();
  doing_ = chosen.name;
  if (options_.verbose)
    std::fprintf(stderr, "%llu %s\n", static_cast<unsigned long long>(done_), chosen.name);
  const double start_ms = cpu_ms();
  const std::uint64_t start = done_;
  if (QApplication::activeModalWidget() && ++steps_in_dialog_ > 25) {
    doing_ = "close dialog";
    close_dialog();
  } else {
    (this->*chosen.act)();
  }
  ++counts_[doing_];
  // If other steps ran in the loop of a dialog, they were measured separately.
  const double took_ms = cpu_ms() - start_ms;
  if (start == done_ && took_ms > worst_ms_) {
    worst_ms_ = took_ms;
    worst_ = doing_;
  }
  if (start == done_ && took_ms > options_.hang_ms) {
    fail(doing_ + " took " + std::to_string(took_ms) + " ms of CPU time");
  }
  check();
}

void Monkey::check() {
  if (done_ % kDeepEvery == 0 && !QApplication::activeModalWidget()) check_deeply();
}

void Monkey::check_deeply() {
  Studio& studio = window_.studio();
  // The last samples of a pen are played some milliseconds later (AimTrack). If this made a line
  // between undo and redo, the line would correctly discard the steps to redo.
  for (int i = 0; i < 20; ++i) {
    QThread::msleep(2);
    studio.process();
  }
  std::string wrong = witness_.complaint();
  if (wrong.empty()) wrong = witness_.undo_and_redo();
  if (wrong.empty()) {
    const QString path = folder_.filePath(QStringLiteral("drawing.felt"));
    Drawing drawing;
    drawing.document = studio.session().document();
    drawing.page = studio.page();
    if (const Result<void> written = write_drawing(path, drawing); !written) {
      wrong = written.error().message;
    } else if (const Result<Drawing> read = read_drawing(path); !read) {
      wrong = read.error().message;
    } else if (!(read->document == drawing.document)) {
      wrong = "saved and read again, the document is another";
    }
  }
  if (!wrong.empty()) fail(wrong);
}

void Monkey::fail(const std::string& why) {
  if (!failure_.empty()) return;
  failure_ = "event " + std::to_string(done_) + " (" + doing_ + "): " + why;
}

std::string Monkey::report() const {
  std::string text = std::to_string(done_) + " events:";
  for (const auto& [name, count] : counts_) text += " " + name + " " + std::to_string(count);
  text += "; slowest: " + worst_ + ", " + std::to_string(worst_ms_) + " ms of CPU time; " +
          std::to_string(window_.studio().session().document().stroke_count()) + " strokes";
  return text;
}

}  // namespace felt::desktop
