// bench_steady [--strokes FILE] [--tune]: prints how much shaking the steady hand removes, beside
// two other filters, and the time at pen-up (README.md). Exits with 1 if a bar is missed.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/steady/peers.h"
#include "bench/steady/shaky_strokes.h"
#include "felt/stroke/steady/shake_finder.h"
#include "felt/stroke/steady/steady_line.h"

namespace felt::bench {
namespace {

constexpr double kMinAtPenUp = 0.80, kMinPooledAtPenUp = 0.80, kMinLive = 0.60, kMaxLagMs = 10.0,
                 kMaxChangeMm = 0.16;
constexpr auto kSharedStrokes = "../shared/data/pen-strokes-a.ndjson";
constexpr double kSharedMmPerUnit = 0.26;

/// The results of a filter: the newest sample, the sample when it settles, the whole line.
struct Filtered {
  Line live, settled, whole;
};
using Filter = std::function<Filtered(const Line&, const Shake&)>;

Filtered through_steady_hand(const Line& line, const Shake& shake) {
  SteadyLine steady(shake);
  Filtered result{line, {}, {}};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto ready = steady.push(line[i]);
    result.settled.insert(result.settled.end(), ready.begin(), ready.end());
    result.live[i].position = steady.tip();
  }
  const auto rest = steady.held();
  result.settled.insert(result.settled.end(), rest.begin(), rest.end());
  result.whole = steady.smoothed();
  return result;
}

double distance_to_line(Point p, const Line& line) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point a = line[i].position;
    const Vec step = line[i + 1].position - a;
    const double squared = norm_squared(step);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, step) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, distance(p, a + t * step));
  }
  return nearest;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty()
             ? 0.0
             : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// How much of the shaking is removed, over several strokes.
struct Removed {
  std::vector<double> of_strokes, left_of_strokes;
  double before = 0.0, after = 0.0;

  void add(const Line& shaky, const Line& out, const Line& intended) {
    double b = 0.0, a = 0.0;
    for (std::size_t i = 0; i < intended.size(); ++i) {
      b += std::pow(distance_to_line(shaky[i].position, intended), 2.0);
      a += std::pow(distance_to_line(out[i].position, intended), 2.0);
    }
    of_strokes.push_back(1.0 - std::sqrt(a / b));
    left_of_strokes.push_back(a);
    before += b;
    after += a;
  }
  [[nodiscard]] double median() const { return percentile(of_strokes, 0.5); }
  [[nodiscard]] double pooled() const { return 1.0 - std::sqrt(after / before); }
  [[nodiscard]] std::string text() const {
    return fmt::format("{:3.1f} % ({:.1f} %)", 100.0 * median(), 100.0 * pooled());
  }
};

/// Finds the shift in time that fits two lines best.
struct Lag {
  static constexpr std::size_t kMax = 20;
  double squares[kMax] = {};

  void add(const Line& intended, const Line& live) {
    for (std::size_t shift = 0; shift < kMax; ++shift) {
      for (std::size_t i = kMax; i < live.size(); ++i) {
        const double d = distance(live[i].position, intended[i - shift].position);
        squares[shift] += d * d;
      }
    }
  }
  [[nodiscard]] double ms() const {
    return 1e3 / kRateHz * static_cast<double>(std::min_element(squares, squares + kMax) - squares);
  }
};

struct Row {
  Removed live, settled, whole;
  Lag lag;
  std::vector<double> changes, live_changes;
};

struct Test {
  double amplitude_mm = 1.0;
  double hz_error = 0.0;  // of the calibration, added to what it found
};

Row measure(const std::vector<Line>& lines, const Test& test, const Filter& filter) {
  Row row;
  Random random(test.amplitude_mm < 1.0 ? 3 : 21);
  for (const Line& line : lines) {
    const ShakyHand hand = random_hand(test.amplitude_mm, random);
    const Line spiral = shaken(spiral_line(), hand, random);
    Result<Shake> shake = find_shake(spiral);
    if (!shake) throw std::runtime_error("calibration: " + shake.error().message);
    shake->hz += test.hz_error;
    const Line shaky = shaken(line, hand, random);
    const Filtered out = filter(shaky, *shake);
    row.live.add(shaky, out.live, line);
    row.settled.add(shaky, out.settled, line);
    row.whole.add(shaky, out.whole, line);
    const Filtered calm = filter(line, *shake);
    row.lag.add(line, calm.live);
    for (std::size_t i = 0; i < line.size(); ++i) {
      row.changes.push_back(distance_to_line(calm.whole[i].position, line));
      row.live_changes.push_back(distance_to_line(calm.live[i].position, line));
    }
  }
  return row;
}

void print_row(const std::string& name, const Row& row) {
  fmt::print("| {} | {} | {} | {} | {:.0f} ms | {:.3f} mm ({:.3f}) |\n", name, row.live.text(),
             row.settled.text(), row.whole.text(), row.lag.ms(), percentile(row.changes, 0.95),
             percentile(row.live_changes, 0.95));
}

/// Prints the strokes that hold most of what is left at pen-up.
void print_worst(const Row& row, const std::vector<Line>& lines) {
  constexpr std::size_t kWorst = 10;
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<double>& left = row.whole.left_of_strokes;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return left[a] > left[b]; });
  fmt::print("\n| stroke | of all that is left | removed | mean speed |\n|---:|---:|---:|---:|\n");
  for (std::size_t i = 0; i < std::min(kWorst, order.size()); ++i) {
    const Line& line = lines[order[i]];
    double length = 0.0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      length += distance(line[k - 1].position, line[k].position);
    }
    fmt::print("| {} | {:.1f} % | {:.0f} % | {:.0f} mm/s |\n", order[i],
               100.0 * left[order[i]] / row.whole.after, 100.0 * row.whole.of_strokes[order[i]],
               length * kRateHz / static_cast<double>(line.size()));
  }
}

/// Prints the processor time of smoothed() for lines of several lengths: the median of five.
void print_times() {
  fmt::print("\n| samples | at 133 Hz | at 1 kHz |\n|---:|---:|---:|\n");
  for (const int samples : {400, 4000, 40000, 600000}) {
    fmt::print("| {} |", samples);
    for (const double hz : {133.0, 1000.0}) {
      SteadyLine steady({5.5, 1.0, 30.0});
      for (int i = 0; i < samples; ++i) {
        const double s = i / hz, a = kTau * 5.5 * s;
        steady.push({Point{20.0 * std::sin(s) + std::cos(a), 20.0 * std::cos(s)}, 0.5,
                     std::llround(1e9 * s)});
      }
      std::vector<double> ms;
      for (int run = 0; run < 5; ++run) {
        const std::clock_t start = std::clock();
        if (steady.smoothed().size() != static_cast<std::size_t>(samples)) {
          throw std::runtime_error("samples are missing");
        }
        ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      }
      fmt::print(" {:.1f} ms |", percentile(ms, 0.5));
    }
    fmt::print("\n");
  }
}

std::vector<Line> lines_of(const std::string& path) {
  if (std::filesystem::exists(path)) {
    fmt::print("Strokes: {}, {} mm a unit\n", path, kSharedMmPerUnit);
    return read_intended({path}, kSharedMmPerUnit);
  }
  fmt::print("Strokes: share/samples, because there is no {}; the bars are for that file\n", path);
  return read_intended(
      {"share/samples/cat.ndjson", "share/samples/handwriting.ndjson", "share/samples/page.ndjson"},
      1.0);
}

int run(const std::string& path, std::size_t first) {
  const std::vector<Line> all = lines_of(path);
  std::vector<Line> lines;
  for (std::size_t i = first; i < all.size(); i += 2) lines.push_back(all[i]);
  fmt::print("{} strokes that {} the parameters\n\n", lines.size(),
             first == 0 ? "chose" : "did not choose");
  fmt::print(
      "| filter | removed live | after 60 ms | at pen-up | lag | steady line changes by |\n"
      "|---|---|---|---|---|---|\n");
  const auto same = [](Line out) { return Filtered{out, out, out}; };
  print_row("moving average of 20",
            measure(lines, {}, [&](const Line& l, const Shake&) { return same(averaged(l)); }));
  print_row("one-euro filter",
            measure(lines, {}, [&](const Line& l, const Shake&) { return same(one_euro(l)); }));
  const Row row = measure(lines, {}, through_steady_hand);
  print_row("**steady hand**, 1 mm", row);
  print_row("steady hand, calibrated 0.7 Hz too high",
            measure(lines, {1.0, 0.7}, through_steady_hand));
  print_row("steady hand, 0.5 mm", measure(lines, {0.5, 0.0}, through_steady_hand));
  print_row("steady hand, 3 mm", measure(lines, {3.0, 0.0}, through_steady_hand));
  print_worst(row, lines);
  print_times();
  return row.whole.median() >= kMinAtPenUp && row.whole.pooled() >= kMinPooledAtPenUp &&
                 row.live.median() >= kMinLive && row.lag.ms() <= kMaxLagMs &&
                 percentile(row.changes, 0.95) <= kMaxChangeMm
             ? 0
             : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  std::string path = felt::bench::kSharedStrokes;
  std::size_t first = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--strokes" && i + 1 < argc) {
      path = argv[++i];
    } else if (argument == "--tune") {
      first = 0;
    } else {
      fmt::print(stderr, "usage: bench_steady [--strokes FILE] [--tune]\n");
      return 2;
    }
  }
  try {
    return felt::bench::run(path, first);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_steady: {}\n", error.what());
    return 1;
  }
}
