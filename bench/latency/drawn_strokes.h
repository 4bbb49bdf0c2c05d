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

/// When the session was told the first sample beyond a line across the sheet: hears all its events.
class SampleWatch {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// The window's thread.
  void hear(const Event& event);
  /// Samples farther right than this from now on, mm.
  void arm(double x_mm);
  /// That sample's time stamp, on the studio's clock; 0: not yet.
  [[nodiscard]] std::int64_t passed_ns() const noexcept { return passed_ns_; }
  [[nodiscard]] std::uint64_t samples() const noexcept { return samples_; }

 private:
  std::atomic<double> x_mm_{kNowhere};
  std::atomic<std::int64_t> passed_ns_{0};
  std::atomic<std::uint64_t> samples_{0};
};

/// What was measured. Every event that was injected is in `events` once.
struct Latencies {
  int events = 0;
  std::vector<double> from_event_ms;   ///< injected
  std::vector<double> from_sample_ms;  ///< the sample's time stamp
  int not_seen = 0;                    ///< no ink within half a second
  int seen_early = 0;                  ///< ink, and no sample that had come so far: not ours
  int not_free = 0;                    ///< there was ink before
  double cpu_us_per_sample = 0.0;      ///< of the window's thread, while the pen is down
};

/// Strokes of a pen that is injected into a real window, from a thread of its own: one place every
/// 30 ms or so at random phase, each 24 px from the last, and the place half way there is watched.
/// Each stroke is undone. Not the window's thread, whose event loop must run.
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
  // Asked on the window's thread once: nothing of it changes while strokes are drawn.
  std::unique_ptr<desktop::InjectedPen> pen_;
  desktop::CanvasView view_;
  QPoint canvas_on_screen_;
  QRectF page_px_;
  clockid_t window_cpu_{};
  std::int64_t studio_start_ns_ = 0;  // steady clock when the studio's said 0
  double ink_radius_px_ = 0.0;
  std::size_t strokes_before_ = 0;
  int row_ = 0;
  std::mt19937 random_{7};
  std::int64_t cpu_ns_ = 0;
  std::uint64_t cpu_samples_ = 0;
};

}  // namespace felt::bench
