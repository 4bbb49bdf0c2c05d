// Runs the program on a real X server and draws with a pen and a mouse of 1 kHz, with the mouse
// also while the program is stopped. Every event must be a pose in the recording, and the recording
// must give the drawing. Exits with 77 if the server cannot run on this machine.
#include <QCoreApplication>
#include <QFile>
#include <QPointF>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <span>
#include <thread>

#include "tests/desktop/inputtest_pen.h"
#include "tests/desktop/recording_check.h"
#include "tests/desktop/x_server.h"

namespace felt::desktop::x_server_test {
namespace {

constexpr int kSkipped = 77;
constexpr int kEvents = 1000;
constexpr int kMousePlaces = 700;
constexpr int kWaitMs = 30'000;
// The pen draws in the middle of the screen, where the page is.
constexpr double kLeft = 600.0 / XServer::kWidth * InputtestPen::kMaxPlace;
constexpr double kRight = 680.0 / XServer::kWidth * InputtestPen::kMaxPlace;
constexpr double kMiddle = 400.0 / XServer::kHeight * InputtestPen::kMaxPlace;
constexpr double kWave = 30.0 / XServer::kHeight * InputtestPen::kMaxPlace;

int failed(const std::string& why) {
  std::fprintf(stderr, "failed: %s\n", why.c_str());
  return 1;
}

/// Waits until `condition` is true; checks it every 50 ms. Returns false after kWaitMs.
template <class Condition>
bool wait_until(Condition condition) {
  for (int waited = 0; waited < kWaitMs; waited += 50) {
    if (condition()) return true;
    QThread::msleep(50);
  }
  return false;
}

/// Hovers at the start of the stroke until the program has recorded it, which means that its window
/// is open.
bool hover_until_seen(InputtestPen& pen, const QString& recording) {
  if (!pen.come(kLeft, kMiddle)) return false;
  double step = 0.0;
  return wait_until([&] {
    step = step == 0.0 ? 0.01 * kWave : 0.0;
    if (!pen.move(kLeft, kMiddle + step, 0.0) || !pen.sync()) return false;
    const auto poses = poses_of(recording);
    // Only a tablet reports a pressure.
    return poses && !poses->empty() && poses->back().pressure.has_value();
  });
}

double pressure_of(int i) {
  return 200.0 + 0.6 * i;  // different for each event
}

/// Draws a stroke of kEvents motions, one per millisecond.
bool draw(InputtestPen& pen) {
  const auto x = [](int i) { return std::lerp(kLeft, kRight, double(i) / kEvents); };
  const auto y = [](int i) { return kMiddle + kWave * std::sin(0.03 * i); };
  bool ok = pen.press(true, x(0), y(0), pressure_of(0));
  auto next = std::chrono::steady_clock::now();
  for (int i = 0; ok && i < kEvents; ++i) {
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    ok = pen.move(x(i), y(i), pressure_of(i));
  }
  QThread::msleep(100);
  return ok && pen.press(false, x(kEvents), y(kEvents), 0.0) && pen.sync();
}

/// Returns how many of the sent pressures occur among the poses, in the same order.
int count_pressures(const std::vector<PenEvent>& poses) {
  auto at = poses.begin();
  int count = 0;
  for (int i = 0; i < kEvents; ++i) {
    const double wanted = pressure_of(i) / InputtestPen::kMaxPressure;
    const auto found = std::find_if(at, poses.end(), [wanted](const PenEvent& pose) {
      return pose.pressure && std::fabs(*pose.pressure - wanted) < 2e-5;
    });
    if (found == poses.end()) continue;
    at = found;
    ++count;
  }
  return count;
}

bool is_lifted(const std::vector<PenEvent>& poses) {
  return poses.empty() || poses.back().pressure.value_or(0.0) == 0.0;
}

/// Returns place `i` of a zigzag that turns at every place.
QPointF zigzag_px(int i) {
  return {XServer::kWidth / 2 + (i % 2 == 0 ? -20.5 : 20.5), XServer::kHeight / 2 + 0.15 * i};
}

/// Draws the zigzag with the mouse, one place per millisecond. The process `id` is stopped three
/// times meanwhile, for 30, 90 and 250 places.
bool draw_by_mouse(InputtestPen& mouse, pid_t id) {
  const auto x = [](int i) { return zigzag_px(i).x() / XServer::kWidth * InputtestPen::kMaxPlace; };
  const auto y = [](int i) {
    return zigzag_px(i).y() / XServer::kHeight * InputtestPen::kMaxPlace;
  };
  bool ok = mouse.move(x(0), y(0), 0.0) && mouse.sync();
  QThread::msleep(300);
  ok = ok && mouse.press(true, x(0), y(0), 0.0);
  const std::pair<int, int> stops[] = {{60, 90}, {150, 240}, {400, 650}};  // first, last place
  auto next = std::chrono::steady_clock::now();
  for (int i = 0; ok && i < kMousePlaces; ++i) {
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    for (const auto& [first, last] : stops) {
      if (i == first) kill(id, SIGSTOP);
      if (i == last) kill(id, SIGCONT);
    }
    ok = mouse.move(x(i), y(i), 0.0);
  }
  QThread::msleep(100);
  return ok && mouse.press(false, x(kMousePlaces - 1), y(kMousePlaces - 1), 0.0) && mouse.sync();
}

/// Returns the number of places of the zigzag among the poses in contact: one more than the turns
/// of x. Poses between two places, which the program interpolates, add no turn, and neither do
/// steps of a pixel by which the server rounds. Each lost place removes two turns.
int count_zigzag(std::span<const PenEvent> poses) {
  std::vector<double> places;
  for (const PenEvent& pose : poses) {
    if (in_contact(sample_of(0, pose))) places.push_back(pose.position.x);
  }
  if (places.empty()) return 0;
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  const double turn_mm = 0.25 * (*high - *low);
  int count = 1;
  double farthest = places.front();  // in the current direction
  int direction = 0;
  for (const double x : places) {
    const bool turns =
        direction == 0 ? std::fabs(x - farthest) > turn_mm : direction * (farthest - x) > turn_mm;
    if (turns) {
      ++count;
      direction = x > farthest ? 1 : -1;
      farthest = x;
    } else if (direction != 0 && direction * (x - farthest) > 0.0) {
      farthest = x;
    }
  }
  return count;
}

/// Draws with the mouse and checks that no place is lost. Returns an error message, or "".
std::string try_mouse(const XServer& server, const QProcess& program, const QString& recording) {
  Result<InputtestPen> mouse = InputtestPen::open(server.mouse_socket());
  if (!mouse) return mouse.error().message;
  const auto before = poses_of(recording);
  if (!before || !draw_by_mouse(*mouse, static_cast<pid_t>(program.processId()))) {
    return "the X server is gone";
  }
  int seen = 0;
  wait_until([&] {
    const auto so_far = poses_of(recording);
    if (!so_far || so_far->size() <= before->size()) return false;
    seen = count_zigzag(std::span(*so_far).subspan(before->size()));
    return seen == kMousePlaces && is_lifted(*so_far);
  });
  std::fprintf(stderr, "%d of %d places of the mouse are poses\n", seen, kMousePlaces);
  return seen == kMousePlaces ? std::string() : "places of the mouse were lost";
}

int run(const QString& desktop, const QString& feltline) {
  Result<std::unique_ptr<XServer>> server = XServer::start();
  if (!server) {
    std::fprintf(stderr, "skipped: %s\n", server.error().message.c_str());
    return kSkipped;
  }
  const QTemporaryDir home;
  const QString recording = home.filePath(QStringLiteral("recording.ndjson"));
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("DISPLAY"), (*server)->display());
  environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
  for (const char* folder : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME",
                             "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
    environment.insert(QString::fromLatin1(folder), home.path());
  }
  program.setProcessEnvironment(environment);
  program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  Result<InputtestPen> pen = InputtestPen::open((*server)->pen_socket());
  if (!pen) return failed(pen.error().message);
  program.start(desktop, {QStringLiteral("--record"), recording});
  if (!wait_until([&] { return QFile(recording).size() > 0; })) {
    return failed("the program does not record");
  }
  if (!hover_until_seen(*pen, recording)) return failed("the program does not see the pen");
  if (!draw(*pen)) return failed("the X server is gone");
  pen->leave(kRight, kMiddle);
  pen->sync();
  // The program may be slower than the pen, but it must not lose an event.
  wait_until([&] {
    const auto so_far = poses_of(recording);
    return so_far && count_pressures(*so_far) == kEvents && is_lifted(*so_far);
  });
  const std::string mouse_error = try_mouse(**server, program, recording);
  program.kill();  // the recording is complete even if the program is killed
  program.waitForFinished(kWaitMs);
  const auto poses = poses_of(recording);
  if (!poses) return failed(poses.error().message);
  const int seen = count_pressures(*poses);
  std::fprintf(stderr, "%d of %d events are poses of the recording (%zu poses)\n", seen, kEvents,
               poses->size());
  if (seen != kEvents) return failed("samples were lost");
  if (!mouse_error.empty()) return failed(mouse_error);
  if (!is_lifted(*poses)) return failed("the pen is stuck");
  const Result<std::string> sketch = replayed(feltline, recording);
  if (!sketch) return failed(sketch.error().message);
  const auto lines = std::count(sketch->begin(), sketch->end(), '\n');
  return lines == 2 ? 0 : failed(std::to_string(lines) + " strokes instead of 2");
}

}  // namespace
}  // namespace felt::desktop::x_server_test

int main(int argc, char** argv) {
  const QCoreApplication app(argc, argv);
  if (argc != 3)
    return felt::desktop::x_server_test::failed("needs the paths of feltline-desktop and feltline");
  return felt::desktop::x_server_test::run(QString::fromLocal8Bit(argv[1]),
                                           QString::fromLocal8Bit(argv[2]));
}
