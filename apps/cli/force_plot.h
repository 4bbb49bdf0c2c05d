#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/render/plot.h"
#include "felt/rt/servo.h"

namespace felt::cli {

/// Collects the data for a plot of a replay in bounded memory: pose, width, every force term, and
/// the requested and sent forces.
class ForcePlot {
 public:
  /// `period_s` is the time between ticks. The plot starts at the first tick.
  ForcePlot(double period_s, const SafetyLimits& limits);

  /// Adds one tick. `width_mm` is the width of the line that the pen draws in this tick, or nullopt
  /// if the pen draws no line.
  void add(const TickReport& tick, std::optional<double> width_mm);

  /// Sets the texts above the plot.
  void set_title(std::string title, std::string note);
  /// Makes the plot show only this time interval, and adds a strip that shows the sent force of the
  /// whole recording. If this function is not called, the plot shows the whole recording without a
  /// strip.
  void set_span(const PlotSpan& span) { span_ = span; }
  /// Returns the interval of the whole recording.
  [[nodiscard]] PlotSpan whole() const noexcept;

  [[nodiscard]] double rate_hz() const noexcept { return 1.0 / period_s_; }

  /// Draws the picture. Fails if no tick was added.
  [[nodiscard]] Result<Image> draw(const PlotOptions& options = {}) const;

 private:
  struct Term {
    std::string name;
    PlotTrace strength;
  };
  [[nodiscard]] PlotTrace new_trace() const { return {start_s_, period_s_, kStretches}; }
  void begin(double start_s);
  PlotTrace& term_trace(const std::string& name);
  [[nodiscard]] PlotPanel force_panel() const;

  static constexpr std::size_t kStretches = 1u << 15;
  double start_s_ = 0.0;
  double period_s_;
  SafetyLimits limits_;
  std::string title_, note_;
  std::optional<PlotSpan> span_;
  std::size_t ticks_ = 0;
  PlotTrace contact_, x_, y_, z_, width_, asked_, sent_;
  std::vector<Term> terms_;
};

}  // namespace felt::cli
