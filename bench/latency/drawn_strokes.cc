#include "drawn_strokes.h"

#include <pthread.h>

#include <QMetaObject>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <variant>

namespace felt::bench {
namespace {

using desktop::Canvas;
using desktop::InjectedPen;
using desktop::Studio;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr double kStepPx = 24.0;
constexpr int kMaxSteps = 24;  // per stroke
constexpr int kLongestMs = 500;
constexpr int kRows = 5;
constexpr double kRowPx = 12.0;
constexpr double kPressure = 0.6;
constexpr double kMarginPx = 40.0;

std::int64_t steady_ns() {
  return nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double ms_between(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-6 * static_cast<double>(to_ns - from_ns);
}

/// Calls `f` on the window's thread and returns when it is done.
template <class F>
void in_window(desktop::MainWindow& window, F f) {
  QMetaObject::invokeMethod(&window, f, Qt::BlockingQueuedConnection);
}

}  // namespace

void SampleWatch::receive(const Event& event) {
  const auto* pen = std::get_if<PenEvent>(&event.what);
  if (!pen) return;
  ++samples_;
  if (passed_ns_ == 0 && pen->position.x > x_mm_) passed_ns_ = event.time_ns;
}

void SampleWatch::arm(double x_mm) {
  x_mm_ = kNowhere;
  passed_ns_ = 0;
  x_mm_ = x_mm;
}

DrawnStrokes::DrawnStrokes(desktop::MainWindow& window, PixelWatch& pixels, SampleWatch& samples)
    : window_(window), pixels_(pixels), samples_(samples) {
  in_window(window, [this] {
    Canvas& canvas = window_.canvas();
    Studio& studio = window_.studio();
    pen_ = std::make_unique<InjectedPen>(canvas);
    view_ = canvas.view();
    canvas_on_screen_ = canvas.mapToGlobal(QPoint(0, 0));
    page_px_ =
        QRectF(view_.to_px({0, 0}), view_.to_px({studio.page().width_mm, studio.page().height_mm}));
    pthread_getcpuclockid(pthread_self(), &window_cpu_);
    studio_start_ns_ = steady_ns() - studio.now_ns();
    const auto widest = studio.session().option("pencil.max_width_mm");
    const double* width_mm = widest ? std::get_if<double>(&*widest) : nullptr;
    ink_radius_px_ = 0.5 * (width_mm ? *width_mm : 0.0) * view_.px_per_mm();
    strokes_before_ = studio.session().document().stroke_count();
  });
}

Latencies DrawnStrokes::measure(int events) {
  Latencies all;
  cpu_ns_ = 0;
  cpu_samples_ = 0;
  while (all.events < events) draw_stroke(all);
  all.cpu_us_per_sample =
      1e-3 * static_cast<double>(cpu_ns_) / static_cast<double>(cpu_samples_ + 1);
  return all;
}

void DrawnStrokes::draw_stroke(Latencies& all) {
  row_ = (row_ + 1) % kRows;  // because the last stroke may still be visible
  const double y = page_px_.center().y() + kRowPx * (row_ - kRows / 2);
  const double start = page_px_.left() + kMarginPx;
  const int steps =
      std::min(kMaxSteps, static_cast<int>((page_px_.width() - 2 * kMarginPx) / kStepPx));
  pen_->point({start, y}, 0.0);
  sleep_ms(60, 0);
  pen_->point({start, y}, kPressure);
  sleep_ms(40, 0);
  const std::int64_t cpu_ns = window_cpu_ns();
  const std::uint64_t samples = samples_.samples();
  for (int i = 1; i <= steps; ++i) {
    sleep_ms(22, 8);
    step(start + kStepPx * (i - 1), start + kStepPx * i, y, all);
  }
  cpu_ns_ += window_cpu_ns() - cpu_ns;
  cpu_samples_ += samples_.samples() - samples;
  pen_->point({start + kStepPx * steps, y}, 0.0);
  take_back();
}

void DrawnStrokes::step(double from_px, double to_px, double y_px, Latencies& all) {
  const double x = std::round(0.5 * (from_px + to_px));
  const QPoint look = canvas_on_screen_ + QPointF(x, y_px).toPoint();
  const bool is_free = find_paper(look.x(), look.y());
  // Waits for the first sample that can have put ink on this pixel. It may be one sample too
  // early, so the measured latency is never too short.
  samples_.arm(view_.to_mm({x - ink_radius_px_, y_px}).x);
  const std::int64_t event_ns = steady_ns();
  pen_->point({to_px, y_px}, kPressure);
  ++all.events;
  if (!is_free) {
    ++all.not_free;
    return;
  }
  while (pixels_.seen_ns() == 0 && ms_between(event_ns, steady_ns()) < kLongestMs) {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  const std::int64_t seen_ns = pixels_.seen_ns(), sample_ns = samples_.passed_ns();
  if (seen_ns == 0) {
    ++all.not_seen;
    return;
  }
  if (sample_ns == 0 || sample_ns + studio_start_ns_ > seen_ns) {
    ++all.seen_early;
    return;
  }
  all.from_event_ms.push_back(ms_between(event_ns, seen_ns));
  all.from_sample_ms.push_back(ms_between(sample_ns + studio_start_ns_, seen_ns));
}

bool DrawnStrokes::find_paper(int x, int y) {
  for (int i = 0; i < 100; ++i) {
    if (pixels_.arm(x, y)) return true;
    sleep_ms(5, 0);
  }
  return false;
}

/// Waits until the stroke is in the document, then undoes it.
void DrawnStrokes::take_back() {
  std::size_t strokes = 0;
  const auto count = [&] { strokes = window_.studio().session().document().stroke_count(); };
  for (int i = 0; i < 100 && strokes <= strokes_before_; ++i) {
    sleep_ms(20, 0);
    in_window(window_, count);
  }
  for (int i = 0; i < 10 && strokes > strokes_before_; ++i) {
    in_window(window_, [&] {
      window_.studio().apply(UndoEvent{});
      count();
    });
  }
  sleep_ms(150, 0);
}

std::int64_t DrawnStrokes::window_cpu_ns() const {
  timespec t{};
  clock_gettime(window_cpu_, &t);
  return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
}

void DrawnStrokes::sleep_ms(int at_least, int random) {
  const auto some_ns = static_cast<std::int64_t>(random_() % 1'000'000) * random;
  std::this_thread::sleep_for(milliseconds(at_least) + nanoseconds(some_ns));
}

}  // namespace felt::bench
