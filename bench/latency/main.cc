// Measures the time from a pen sample to the pixel that another X client can read, without a camera
// (see DrawnStrokes). It measures an empty drawing and one with many strokes, while the 1 kHz loop
// runs.
#include <QApplication>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>

#include "drawn_strokes.h"
#include "felt/rt/realtime_thread.h"
#include "own_server.h"

namespace felt::bench {
namespace {

using desktop::MainWindow;
using desktop::Studio;

constexpr double kBandMm = 24.0;  // half the height of the free band for the drawn strokes
constexpr int kSettleMs = 1000;
constexpr int kSettleManyMs = 4000;

struct Wanted {
  int events = 1500;
  int strokes = 100'000;
};

/// Returns short strokes all over the page, except in a band in its middle.
Document many_strokes(int count, const Page& page) {
  std::mt19937 random(1);
  const auto any = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<StrokePtr> strokes;
  while (std::ssize(strokes) < count) {
    const Point a{any(0, page.width_mm), any(0, page.height_mm)};
    if (std::fabs(a.y - page.height_mm / 2) < kBandMm) continue;
    const Point b{a.x + any(-6, 6), a.y + any(-2, 2)};
    StrokeData data;
    data.points = {a, {a.x + any(-3, 3), a.y}, {b.x, b.y + any(-2, 2)}, b};
    data.widths = {{0.0, 0.4}, {1.0, 0.6}};
    if (Result<Stroke> stroke = Stroke::create(std::move(data))) {
      strokes.push_back(std::make_shared<const Stroke>(*std::move(stroke)));
    }
  }
  return document_of(strokes);
}

void print_quantiles(const char* name, std::vector<double>& ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&ms](double part) {
    const auto i = static_cast<std::size_t>(part * static_cast<double>(ms.size()));
    return ms[std::min(ms.size() - 1, i)];
  };
  std::printf("  %-44s %7.2f %7.2f %7.2f %7.2f\n", name, at(0.5), at(0.9), at(0.99), ms.back());
}

/// Prints the results. Returns false if no event could be timed.
bool print(Latencies& all) {
  if (all.from_sample_ms.empty()) {
    std::printf("  no event of %d could be timed\n", all.events);
    return false;
  }
  std::printf("  %-44s %7s %7s %7s %7s\n", "ms until the pixel can be read, from", "p50", "p90",
              "p99", "most");
  print_quantiles("the servo's sample (its time stamp)", all.from_sample_ms);
  print_quantiles("the tablet's event (injected)", all.from_event_ms);
  std::printf("  CPU time of the window's thread: %.0f us a sample\n", all.cpu_us_per_sample);
  std::printf(
      "  %d events, %zu timed; missed: %d no ink within 0.5 s, %d ink too early, %d not free\n",
      all.events, all.from_sample_ms.size(), all.not_seen, all.seen_early, all.not_free);
  return true;
}

void print_load() {
  double load = 0.0;
  getloadavg(&load, 1);
  std::printf("load average %.1f on %u CPUs\n", load, std::thread::hardware_concurrency());
  std::fflush(stdout);
}

/// Measures both drawings. Called on a thread other than the window's. Returns false if one of the
/// two could not be measured.
bool measure(MainWindow& window, PixelWatch& pixels, SampleWatch& samples, const Wanted& wanted) {
  bool all_measured = true;
  for (const int strokes : {0, wanted.strokes}) {
    const auto open = [&window, strokes] {
      Studio& studio = window.studio();
      studio.open(strokes > 0 ? many_strokes(strokes, studio.page()) : Document{}, studio.page());
      window.canvas().fit_page();
    };
    QMetaObject::invokeMethod(&window, open, Qt::BlockingQueuedConnection);
    std::this_thread::sleep_for(std::chrono::milliseconds(strokes > 0 ? kSettleManyMs : kSettleMs));
    DrawnStrokes drawn(window, pixels, samples);
    Latencies all = drawn.measure(wanted.events);
    std::printf("%d strokes open:\n", strokes);
    all_measured = print(all) && all_measured;
    print_load();
  }
  std::printf("reading the pixel takes %.0f us; it is read every 50 us\n", 1e-3 * pixels.look_ns());
  return all_measured;
}

int run(QApplication& app, const Wanted& wanted) {
  PixelWatch pixels;
  if (!pixels.works()) {
    std::fprintf(stderr, "bench_latency: the X server (DISPLAY) has no shared memory\n");
    return 1;
  }
  SampleWatch samples;
  MainWindow window(desktop::StudioOptions{});
  window.resize(1280, 800);
  window.show();
  Studio& studio = window.studio();
  QObject::connect(&studio, &Studio::event_applied,
                   [&samples](const Event& event) { samples.receive(event); });
  studio.apply(SetOption{"pencil.snap", std::string("off")});
  std::printf("%s\n", describe(studio.loop().thread()->status()).c_str());
  bool measured = false;
  std::thread beside;
  QTimer::singleShot(1500, &window, [&] {
    beside = std::thread([&] {
      measured = measure(window, pixels, samples, wanted);
      // exit() and not quit(), because quit() would ask whether to save.
      QMetaObject::invokeMethod(
          &app, [] { QCoreApplication::exit(); }, Qt::QueuedConnection);
    });
  });
  print_load();
  QCoreApplication::exec();
  if (beside.joinable()) beside.join();
  studio.set_modified(false);
  return measured ? 0 : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  felt::bench::Wanted wanted;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    if (option == "--events") wanted.events = std::max(1, std::atoi(argv[i + 1]));
    if (option == "--strokes") wanted.strokes = std::max(1, std::atoi(argv[i + 1]));
  }
  std::optional<felt::bench::OwnServer> server;
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    server.emplace();
    if (server->display().empty()) {
      std::fprintf(stderr, "bench_latency: no DISPLAY, and Xvfb did not start (package xvfb)\n");
      return 1;
    }
    qputenv("DISPLAY", server->display().c_str());
  }
  const QTemporaryDir home;  // keeps the user's settings and drawings out of this run
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"}) {
    qputenv(name, home.path().toLocal8Bit());
  }
  qputenv("QT_QPA_PLATFORM", "xcb");
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
  QApplication app(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-bench"));
  return felt::bench::run(app, wanted);
}
