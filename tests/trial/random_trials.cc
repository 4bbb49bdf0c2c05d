// random_trials COUNT SEED: prints random trials and their metrics, for trial_metrics.py.
//   seed N
//   trial N open|closed TUNNEL TARGET       widths in mm, or NA
//   path X Y                                one line for each point
//   sample T_NS X Y CONTACT PRESSURE FX FY HEIGHT  pressure, force and height may be NA
//   width MM                                the required width
//   erase FROM TO                           what is to be erased of the first line of before
//   before N X Y                            a point of line N that was there before
//   ink N X Y WIDTH                         a point of line N of ink after the trial
//   closed N                                line N of ink is closed
//   metric NAME VALUE
//   end
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "felt/geometry/polyline.h"
#include "felt/trial/ink_metrics.h"
#include "felt/trial/trial_columns.h"

namespace felt {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform. Not std::uniform_real_distribution, whose numbers depend on the standard library.
  double between(double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(engine_() >> 11U);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool one_in(int count) { return below(count) == 0; }

 private:
  std::mt19937_64 engine_;
};

struct RandomTrial {
  TrialGeometry geometry;
  std::vector<Point> path;
  std::vector<TrialSample> samples;
  double width_mm = 1.0;
  ErasedPage page;
  std::vector<InkLine> ink;
};

std::vector<Point> random_path(Random& random) {
  std::vector<Point> path;
  const Point middle{random.between(0.0, 200.0), random.between(0.0, 200.0)};
  const double radius = random.one_in(30) ? random.between(30.0, 80.0) : random.between(1.0, 8.0);
  const int kind = random.below(12);
  if (kind == 0) return random.one_in(4) ? path : std::vector<Point>{middle};
  const int corners = kind < 5 ? 2 : 3 + random.below(kind < 9 ? 5 : 30);
  for (int i = 0; i < corners; ++i) {
    if (kind < 9) {
      path.push_back(middle +
                     Vec{random.between(-radius, radius), random.between(-radius, radius)});
    } else {  // a round shape
      const double angle = 2.0 * std::numbers::pi * i / corners;
      path.push_back(middle + radius * Vec{std::cos(angle), std::sin(angle)});
    }
    if (random.one_in(15)) path.push_back(path.back());
    if (random.one_in(60)) path.push_back({std::numeric_limits<double>::quiet_NaN(), 0.0});
  }
  return path;
}

// A sum of sines: smooth, so that movements resemble those of a hand.
class Wobble {
 public:
  Wobble(Random& random, double size) {
    for (Wave& wave : waves_) {
      wave = {random.between(-size, size), random.between(1.0, 40.0), random.between(0.0, 6.0)};
    }
  }
  [[nodiscard]] double at(double t_s) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += wave.size * std::sin(wave.rate * t_s + wave.phase);
    return sum;
  }

 private:
  struct Wave {
    double size, rate, phase;
  };
  Wave waves_[4]{};
};

std::vector<Point> distinct_points(const std::vector<Point>& path) {
  std::vector<Point> out;
  for (const Point p : path) {
    if (is_finite(p) && (out.empty() || out.back() != p)) out.push_back(p);
  }
  return out;
}

void add_samples(Random& random, RandomTrial& trial) {
  const double duration_s = random.one_in(3) ? random.between(0.7, 1.6) : random.between(0.01, 0.6);
  const double size = random.one_in(5) ? 3.0 : random.between(0.0, 0.6);
  const double begin_s = random.between(-0.02, 0.1), lift_s = random.between(0.0, 3.0);
  const double noise = random.one_in(2) ? random.between(0.0, 0.02) : 0.0;
  const int pressure = random.below(3), force = random.below(3), height = random.below(3);
  const bool broken = random.one_in(10), backwards = random.one_in(4), never = random.one_in(40);
  const Wobble x(random, size), y(random, size), speed(random, 0.05), fx(random, 0.4),
      fy(random, 0.4), z(random, 0.5);
  const std::vector<Point> line = distinct_points(trial.path);
  const double length = polyline_length(line);
  std::int64_t time_ns = static_cast<std::int64_t>(random.between(-1e12, 1e12));
  for (double t = 0.0; t < duration_s;) {
    const double share = t / duration_s + speed.at(t) - speed.at(0.0);
    const Point on = point_at_length(line, length * (backwards ? 1.0 - share : share));
    TrialSample sample{.time_ns = time_ns};
    sample.position =
        on + Vec{x.at(t) + random.between(-noise, noise), y.at(t) + random.between(-noise, noise)};
    sample.contact = !never && t >= begin_s && !(t > lift_s && t < lift_s + 0.06);
    if (pressure > 0 && !(pressure == 2 && random.one_in(9)))
      sample.pressure = random.between(0.0, 1.0);
    if (force > 0 && !(force == 2 && random.one_in(9))) sample.force_n = Vec{fx.at(t), fy.at(t)};
    if (height > 0 && !(height == 2 && random.one_in(30))) sample.height_mm = z.at(t) - 1.0;
    if (broken && random.one_in(20)) sample.position.x = std::numeric_limits<double>::quiet_NaN();
    if (broken && random.one_in(20)) sample.pressure = std::numeric_limits<double>::infinity();
    if (broken && random.one_in(20)) sample.time_ns -= 50'000'000;
    if (broken && random.one_in(20) && !trial.samples.empty())
      sample.time_ns = trial.samples.back().time_ns;
    trial.samples.push_back(sample);
    const double step_s = random.between(0.003, 0.014);
    time_ns += std::llround(step_s * 1e9);
    t += step_s;
  }
}

Point random_point(Random& random) {
  return {random.between(0.0, 60.0), random.between(0.0, 60.0)};
}

/// Lines of which parts were erased, and lines that may meet at their ends.
void add_ink(Random& random, RandomTrial& trial) {
  trial.width_mm = random.between(0.3, 6.0);
  trial.page.line = {random_point(random), random_point(random), random_point(random)};
  const double length = polyline_length(trial.page.line);
  trial.page.from_mm = random.between(0.0, 0.5) * length;
  trial.page.to_mm = trial.page.from_mm + random.between(0.0, 0.5) * length;
  for (int i = random.below(4); i > 0; --i) {
    trial.page.others.push_back({random_point(random), random_point(random)});
  }
  if (random.one_in(8)) return;
  std::vector<std::vector<Point>> lines = trial.page.others;
  lines.push_back(trial.page.line);
  for (const std::vector<Point>& line : lines) {
    const Point first = line[0], last = line[1];
    const double from = random.between(0.0, 0.5), to = random.between(0.5, 1.0);
    trial.ink.push_back({{first, lerp(first, last, from)}, {}, false});
    if (!random.one_in(4)) trial.ink.push_back({{lerp(first, last, to), last}, {}, false});
    if (random.one_in(5)) {
      trial.ink.push_back({{first, random_point(random), first}, {}, random.one_in(2)});
    }
  }
  if (random.one_in(4)) trial.ink = {{{{1.0, 1.0}, {30.0, 2.0}}, {}, false}};
  if (random.one_in(4)) trial.ink = {{trial.page.line, {}, false}};
  if (random.one_in(4)) {
    const Point a = trial.ink.front().points.front(), b = trial.ink.front().points.back();
    trial.ink = {trial.ink.front(), {{b, random_point(random), a}, {}, false}};
  }
  for (InkLine& line : trial.ink) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      line.widths_mm.push_back(random.between(0.1, 6.0));
    }
  }
}

RandomTrial random_trial(Random& random) {
  RandomTrial trial;
  if (random.one_in(2)) trial.geometry.tunnel_width_mm = random.between(0.2, 6.0);
  if (random.one_in(2)) trial.geometry.target_width_mm = random.between(0.2, 6.0);
  trial.path = random_path(random);
  // A closed path of two points has no sides, so that the sign of an error depends on rounding.
  if (distinct_points(trial.path).size() > 2 && random.one_in(2))
    trial.geometry.ends = TrialPathEnds::kClosed;
  if (!random.one_in(50)) add_samples(random, trial);
  add_ink(random, trial);
  return trial;
}

std::string exact_text(const std::optional<double>& value) {
  if (!value) return "NA";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", *value);
  return text;
}

void print_ink(const RandomTrial& trial) {
  std::printf("width %.17g\nerase %.17g %.17g\n", trial.width_mm, trial.page.from_mm,
              trial.page.to_mm);
  for (const Point p : trial.page.line) std::printf("before 0 %.17g %.17g\n", p.x, p.y);
  for (std::size_t i = 0; i < trial.page.others.size(); ++i) {
    for (const Point p : trial.page.others[i]) {
      std::printf("before %zu %.17g %.17g\n", i + 1, p.x, p.y);
    }
  }
  for (std::size_t i = 0; i < trial.ink.size(); ++i) {
    const InkLine& line = trial.ink[i];
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      std::printf("ink %zu %.17g %.17g %.17g\n", i, line.points[k].x, line.points[k].y,
                  line.widths_mm[k]);
    }
    if (line.is_closed) std::printf("closed %zu\n", i);
  }
}

void print_trial(int number, const RandomTrial& trial) {
  const TrialGeometry& geometry = trial.geometry;
  std::printf(
      "trial %d %s %s %s\n", number, geometry.ends == TrialPathEnds::kClosed ? "closed" : "open",
      exact_text(geometry.tunnel_width_mm).c_str(), exact_text(geometry.target_width_mm).c_str());
  for (const Point p : trial.path) std::printf("path %.17g %.17g\n", p.x, p.y);
  for (const TrialSample& s : trial.samples) {
    std::optional<double> fx, fy;
    if (s.force_n) fx = s.force_n->x, fy = s.force_n->y;
    std::printf("sample %lld %.17g %.17g %d %s %s %s %s\n", static_cast<long long>(s.time_ns),
                s.position.x, s.position.y, s.contact ? 1 : 0, exact_text(s.pressure).c_str(),
                exact_text(fx).c_str(), exact_text(fy).c_str(), exact_text(s.height_mm).c_str());
  }
  print_ink(trial);
  TrialMetrics metrics = measure_trial(trial.samples, trial.path, geometry);
  measure_closing(trial.ink, metrics);
  measure_width(trial.ink, trial.width_mm, metrics);
  measure_erasing(trial.page, trial.ink, metrics);
  for (const TrialColumn& column : trial_metric_columns()) {
    std::printf("metric %s %s\n", std::string(column.name).c_str(),
                exact_text(metrics.*column.value).c_str());
  }
  std::printf("end\n");
}

}  // namespace
}  // namespace felt

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: random_trials COUNT SEED\n");
    return 2;
  }
  const int count = std::atoi(argv[1]);
  const std::uint64_t seed = std::strtoull(argv[2], nullptr, 10);
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  felt::Random random(seed);
  for (int i = 0; i < count; ++i) felt::print_trial(i, felt::random_trial(random));
  return 0;
}
