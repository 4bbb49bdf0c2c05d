#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "desktop/window/main_window.h"
#include "felt/session/event.h"
#include "pixel_watch.h"
#include "tests/desktop/injected_pen.h"

namespace felt::bench {

/// Records the first pen sample to the right of a given x. `hear` gets all events of the session.
class SampleWatch {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// Handles one event. Called on the window's thread.
  void receive(const Event& event);
  /// Starts to wait for a sample to the right of `x_mm`.
  void arm(double x_mm);
  /// Returns the time stamp of that sample on the studio's clock, or 0 if it has not come yet.
  [[nodiscard]] std::int64_t passed_ns() const noexcept { return passed_ns_; }
  [[nodiscard]] std::uint64_t samples() const noexcept { return samples_; }

 private:
  std::atomic<double> x_mm_{kNowhere};
  std::atomic<std::int64_t> passed_ns_{0};
  std::atomic<std::uint64_t> samples_{0};
};

/// The measurements. `events` is the number of injected events.
struct Latencies {
  int events = 0;
  std::vector<double> from_event_ms;   ///< from the injection of the event to the pixel
  std::vector<double> from_sample_ms;  ///< from the time stamp of the sample to the pixel
  int not_seen = 0;                    ///< no ink within half a second
  int seen_early = 0;                  ///< ink that appeared before a sample could draw it
  int not_free = 0;                    ///< the pixel had ink before
  double cpu_us_per_sample = 0.0;      ///< of the window's thread, while the pen is down
};

/// Draws strokes by injecting pen events into a real window: one event about every 30 ms with
/// random jitter, each 24 px from the last. Watches the pixel half way between two events, and
/// undoes each stroke. Runs on a thread of its own, because the window's event loop must run.
class DrawnStrokes {
 public:
  DrawnStrokes(desktop::MainWindow& window, PixelWatch& pixels, SampleWatch& samples);

  [[nodiscard]] Latencies measure(int events);

 private:
  void draw_stroke(Latencies& all);
  void step(double from_px, double to_px, double y_px, Latencies& all);
  bool find_paper(int x, int y);
  void take_back();
  [[nodiscard]] std::int64_t window_cpu_ns() const;
  void sleep_ms(int at_least, int random);

  desktop::MainWindow& window_;
  PixelWatch& pixels_;
  SampleWatch& samples_;
  // Read once on the window's thread, because these do not change while strokes are drawn.
  std::unique_ptr<desktop::InjectedPen> pen_;
  desktop::CanvasView view_;
  QPoint canvas_on_screen_;
  QRectF page_px_;
  clockid_t window_cpu_{};
  std::int64_t studio_start_ns_ = 0;  // the steady clock at time 0 of the studio's clock
  double ink_radius_px_ = 0.0;
  std::size_t strokes_before_ = 0;
  int row_ = 0;
  std::mt19937 random_{7};
  std::int64_t cpu_ns_ = 0;
  std::uint64_t cpu_samples_ = 0;
};

}  // namespace felt::bench
