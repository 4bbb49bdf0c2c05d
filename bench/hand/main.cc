// Compares simulated people (felt/devices/simulated/person.h) with real people and with published
// findings, and prints the tables. Says which bars are missed (the exit status is 1 then), and
// which findings come out.
//   bench_hand [--people N] [--seed N] [--strokes FILE.ndjson] [--mm-per-unit U] [--limit N]
//              [--every N --from K] [--model NAME]
//   bench_hand --acceptance [--people N] [--seed N]
// --strokes names recordings of real people with times; each simulated person then draws the same
// lines. --every and --from take every N-th stroke from the K-th on, to keep strokes back.
// --acceptance compares with published results that the people must give before any figure about
// forces counts (acceptance.h).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "acceptance.h"
#include "apps/cli/text_table.h"
#include "drawing.h"
#include "felt/base/constants.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/trial/trial_metrics.h"
#include "report.h"
#include "statistics.h"

namespace felt::bench {
namespace {

constexpr double kCareful = 0.25;  // pace of people who draw slowly
constexpr double kHurry = 3.0;     // pace of people who are told to be as fast as possible

struct Options {
  std::size_t people = 20;
  std::uint64_t seed = 1;
  std::string strokes;
  double mm_per_unit = 0.26;
  std::size_t limit = 1'000'000;
  std::size_t every = 1, from = 0;
  bool is_acceptance = false;
  PersonModel model = PersonModel::kProportional;
};

[[noreturn]] void fail_usage() {
  fmt::print(stderr,
             "usage: bench_hand [--people N] [--seed N] [--strokes FILE.ndjson] [--mm-per-unit U]\n"
             "                  [--limit N] [--every N] [--from K] [--model NAME]\n"
             "       bench_hand --acceptance [--people N] [--seed N]\n");
  std::exit(2);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--acceptance") {
      options.is_acceptance = true;
      --i;
      continue;
    }
    if (i + 1 == argc) fail_usage();
    const std::string value = argv[i + 1];
    const auto number = static_cast<std::size_t>(std::strtoull(value.c_str(), nullptr, 10));
    if (name == "--people") {
      options.people = number;
    } else if (name == "--seed") {
      options.seed = number;
    } else if (name == "--strokes") {
      options.strokes = value;
    } else if (name == "--mm-per-unit") {
      options.mm_per_unit = std::strtod(value.c_str(), nullptr);
    } else if (name == "--model" && find_person_model(value)) {
      options.model = *find_person_model(value);
    } else if (name == "--limit") {
      options.limit = number;
    } else if (name == "--every") {
      options.every = number;
    } else if (name == "--from") {
      options.from = number;
    } else {
      fail_usage();
    }
  }
  if (options.people == 0 || options.from >= options.every || !(options.mm_per_unit > 0.0)) {
    fail_usage();
  }
  return options;
}

// --- Shapes ------------------------------------------------------------------------------------

struct Shape {
  std::string name;
  std::vector<Point> via;
};

std::vector<Point> curve(int count, const std::function<Point(double)>& at) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) points.push_back(at(double(i) / count));
  return points;
}

std::vector<Point> circle(double radius) {
  return curve(48, [=](double t) {
    return Point{80.0 + radius * std::sin(kTau * t), 80.0 - radius * std::cos(kTau * t)};
  });
}

// The shapes in the order of their complexity, for the comparison with Langerak.
std::vector<Shape> shapes() {
  std::vector<Point> star;
  for (int i = 0; i <= 10; ++i) {
    const double radius = i % 2 == 0 ? 25.0 : 10.0, angle = kTau * i / 10.0;
    const Point p{80.0 + radius * std::sin(angle), 80.0 - radius * std::cos(angle)};
    star.push_back(p);
    if (i > 0 && i < 10) star.push_back(p);  // a corner
  }
  return {{"line", {{40.0, 80.0}, {120.0, 80.0}}},
          {"circle", circle(20.0)},
          {"wave", curve(60,
                         [](double t) {
                           return Point{30.0 + 132.0 * t, 80.0 + 8.0 * std::sin(2.0 * kTau * t)};
                         })},
          {"spiral", curve(120,
                           [](double t) {
                             const double radius = 12.0 + 25.0 * t;
                             return Point{80.0 + radius * std::cos(3.0 * kTau * t),
                                          80.0 + radius * std::sin(3.0 * kTau * t)};
                           })},
          {"star", star}};
}

// --- Tables ------------------------------------------------------------------------------------

// Prints whether a published finding comes out. Nothing fails if it does not, because the model was
// not built to show it.
void finding(bool comes_out, const std::string& what) {
  fmt::print("{}: {}\n", comes_out ? "comes out" : "does NOT come out", what);
}

// Returns the error of each person, mm.
std::vector<double> errors_of(const std::vector<Person>& people, std::span<const Point> via,
                              const Condition& condition) {
  std::vector<double> errors;
  for (const Person& person : people) errors.push_back(draw(person, via, condition).error_mm);
  return errors;
}

std::vector<Person> at_pace(std::vector<Person> people, double pace) {
  for (Person& person : people) person.pace *= pace;
  return people;
}

// --- Comparison with real people -----------------------------------------------------------------

double seconds(const TrialSample& from, const TrialSample& to) {
  return 1e-9 * static_cast<double>(to.time_ns - from.time_ns);
}

struct Real {
  std::vector<TrialSample> samples;
  TrialMetrics metrics;
};

constexpr double kShortestS = 0.6;

// Returns the metrics of a stroke, or nullopt if it is too short for the measures to compare.
std::optional<TrialMetrics> measure(const std::vector<TrialSample>& stroke) {
  if (stroke.empty() || seconds(stroke.front(), stroke.back()) < kShortestS) return std::nullopt;
  TrialMetrics metrics = measure_trial(stroke, {});
  if (!metrics.power_law_r2 || !metrics.log_dimensionless_jerk) return std::nullopt;
  return metrics;
}

std::vector<Real> read_strokes(const Options& options) {
  std::ifstream file(options.strokes);
  if (!file) {
    fmt::print(stderr, "bench_hand: {}: cannot open\n", options.strokes);
    std::exit(1);
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  LineReader reader(read_text(text));
  LineBatch batch;
  NdjsonParser parser;
  RawStroke raw;
  std::vector<Real> all;
  std::size_t number = 0;
  while (reader.fill(batch, 1'000'000).value()) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!parser.raw_stroke(batch.line(i), raw)) continue;
      Real real;
      for (const InkSample& s : raw.samples) {
        if (!s.time_ns) break;
        const Point p{options.mm_per_unit * s.position.x, options.mm_per_unit * s.position.y};
        if (!real.samples.empty() && *s.time_ns <= real.samples.back().time_ns) continue;
        real.samples.push_back({.time_ns = *s.time_ns, .position = p, .contact = true});
      }
      const std::optional<TrialMetrics> metrics = measure(real.samples);
      if (!metrics || number++ % options.every != options.from) continue;
      real.metrics = *metrics;
      if (all.size() < options.limit) all.push_back(std::move(real));
    }
  }
  return all;
}

// The line that a real person drew, without sensor steps and tremor, as a path to draw.
std::vector<Point> line_of(const Real& real) {
  std::vector<Point> via;
  const double apart_mm = 1.0;
  for (std::size_t i = 0; i < real.samples.size(); ++i) {
    const std::size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, real.samples.size() - 1);
    Vec sum;
    for (std::size_t k = from; k <= to; ++k) sum += real.samples[k].position - Point{};
    const Point p = Point{} + sum / static_cast<double>(to - from + 1);
    if (via.empty() || distance(via.back(), p) >= apart_mm) via.push_back(p);
  }
  for (Point& p : via) p = p + Vec{40.0, 40.0};
  return via;
}

// The tablet or mouse of a recording, as its samples show it.
Tablet tablet_of(const Real& real) {
  Tablet tablet{.interval_s = 0.0, .step_mm = 1e9};
  std::vector<double> intervals;
  for (std::size_t i = 1; i < real.samples.size(); ++i) {
    intervals.push_back(seconds(real.samples[i - 1], real.samples[i]));
    const Vec step = real.samples[i].position - real.samples[i - 1].position;
    for (const double d : {std::abs(step.x), std::abs(step.y)}) {
      if (d > 1e-6) tablet.step_mm = std::min(tablet.step_mm, d);
    }
  }
  tablet.interval_s = quantile(intervals, 0.5);
  return tablet;
}

void compare_with_people(const Options& options, const std::vector<Person>& people,
                         Report& report) {
  if (options.strokes.empty()) {
    fmt::print("No comparison with real people: no --strokes.\n\n");
    return;
  }
  std::vector<TrialMetrics> real, simulated;
  double simulated_s = 0.0, cpu_s = 0.0;  // CPU time, because other programs may run
  std::size_t number = 0;
  for (const Real& stroke : read_strokes(options)) {
    const std::vector<Point> via = line_of(stroke);
    if (via.size() < 2) continue;
    const Person& person = people[number % people.size()];
    const std::clock_t start = std::clock();
    const Drawing drawing = draw(person, via, {}, ++number, tablet_of(stroke));
    cpu_s += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    simulated_s += drawing.simulated_s;
    real.push_back(stroke.metrics);
    if (const std::optional<TrialMetrics> m = measure(drawing.ink)) simulated.push_back(*m);
  }
  if (real.empty() || simulated.empty()) {
    report.bar(false, options.strokes + ": no strokes with times that last 0.6 s or more\n");
    return;
  }
  fmt::print("{} strokes of real people, {} of {} simulated people on the same lines\n",
             real.size(), simulated.size(), people.size());
  cli::TextTable rows =
      table({"measure", "people 5 %", "50 %", "95 %", "simulated 5 %", "50 %", "95 %", "KS"});
  double largest = 0.0;
  const auto add = [&](const char* name, TrialMetrics::Value TrialMetrics::*member) {
    std::vector<double> a, b;
    for (const TrialMetrics& m : real) a.push_back(*(m.*member));
    for (const TrialMetrics& m : simulated) b.push_back(*(m.*member));
    const double ks = ks_distance(a, b);
    largest = std::max(largest, ks);
    std::vector<std::string> cells{name};
    for (const auto& values : {a, b}) {
      for (const double share : {0.05, 0.5, 0.95}) {
        cells.push_back(fmt::format("{:.2f}", quantile(values, share)));
      }
    }
    cells.push_back(fmt::format("{:.2f}", ks));
    rows.add_row(cells);
  };
  add("exponent of the power law", &TrialMetrics::power_law_exponent);
  add("R2 of the power law", &TrialMetrics::power_law_r2);
  add("peaks of the speed per s", &TrialMetrics::velocity_peaks_per_s);
  add("log dimensionless jerk", &TrialMetrics::log_dimensionless_jerk);
  print(rows);
  report.bar(largest <= 0.30, fmt::format("KS distance to people at most 0.30 ({:.2f})", largest));
  report.bar(simulated_s / cpu_s >= 100.0,
             fmt::format("at least 100 times real time ({:.0f})\n", simulated_s / cpu_s));
}

// --- Laws and findings ---------------------------------------------------------------------------

void check_steering(const std::vector<Person>& people, Report& report) {
  cli::TextTable rows = table({"tunnel", "width mm", "ID", "time s", "error mm"});
  for (const Shape& shape : {shapes()[0], shapes()[1]}) {
    std::vector<Point> law;
    bool falls = true;
    double before = 1e9;
    for (const double width : {12.0, 8.0, 5.0, 3.0, 2.0}) {
      double time = 0.0, error = 0.0;
      for (const Person& person : at_pace(people, kHurry)) {
        const Drawing drawing = draw(person, shape.via, {.tunnel_mm = width});
        time += drawing.duration_s / static_cast<double>(people.size());
        error += drawing.error_mm / static_cast<double>(people.size());
      }
      const double length = shape.name == "line" ? 80.0 : 20.0 * kTau;
      law.push_back({length / width, time});
      falls = falls && error < before;
      before = error;
      rows.add_row({shape.name, fmt::format("{:.0f}", width), fmt::format("{:.1f}", length / width),
                    fmt::format("{:.2f}", time), fmt::format("{:.3f}", error)});
    }
    report.bar(correlation(law) >= 0.98, fmt::format("steering law, {}: r at least 0.98 ({:.4f})",
                                                     shape.name, correlation(law)));
    report.bar(falls, shape.name + ": the error falls with the width of the tunnel");
  }
  print(rows);
}

void check_speed(const std::vector<Person>& people, Report& report) {
  cli::TextTable rows = table({"pace", "error mm"});
  double before = 0.0;
  bool rises = true;
  for (const double pace : {0.5, 1.0, 2.0, 4.0}) {
    const double error =
        mean_over_people(errors_of(at_pace(people, pace), shapes()[2].via, {})).mean;
    rises = rises && error > before;
    before = error;
    rows.add_row({fmt::format("{:.1f}", pace), fmt::format("{:.3f}", error)});
  }
  report.bar(rises, "wave: the error rises with the speed");
  print(rows);
}

// Returns the change of each person's error, relative to drawing freely.
std::vector<double> changes(std::span<const double> free, std::span<const double> with) {
  std::vector<double> relative;
  for (std::size_t i = 0; i < free.size(); ++i) relative.push_back(with[i] / free[i] - 1.0);
  return relative;
}

std::string percent(const MeanOverPeople& change) {
  return fmt::format("{:+.0f} % ({:+.0f} to {:+.0f})", 100.0 * change.mean, 100.0 * change.low,
                     100.0 * change.high);
}

void show_findings(const std::vector<Person>& usual) {
  const std::vector<Person> people = at_pace(usual, kCareful);
  const Condition conditions[] = {{.friction = 0.4}, {.towed = true}, {.guide_n_per_m = 100.0}};
  cli::TextTable rows =
      table({"shape, drawn slowly", "free mm", "friction 0.4", "towed", "groove"});
  // The changes of each person with friction and with a rope, averaged over the curves.
  std::array<std::vector<double>, 2> on_curves{std::vector<double>(people.size()),
                                               std::vector<double>(people.size())};
  std::vector<double> gain;
  for (const Shape& shape : shapes()) {
    const bool is_curve = shape.name != "line" && shape.name != "star";
    const std::vector<double> free = errors_of(people, shape.via, {});
    std::vector<std::string> cells{shape.name, fmt::format("{:.3f}", mean_over_people(free).mean)};
    for (std::size_t k = 0; k < std::size(conditions); ++k) {
      const std::vector<double> change = changes(free, errors_of(people, shape.via, conditions[k]));
      cells.push_back(percent(mean_over_people(change)));
      if (k == 2) gain.push_back(-mean_over_people(change).mean);
      if (k == 2 || !is_curve) continue;
      for (std::size_t i = 0; i < change.size(); ++i) on_curves[k][i] += change[i] / 3.0;
    }
    rows.add_row(cells);
  }
  print(rows);
  const MeanOverPeople rubbed = mean_over_people(on_curves[0]);
  const MeanOverPeople pulled = mean_over_people(on_curves[1]);
  finding(pulled.high < 0.0 && pulled.mean < rubbed.mean,
          "Keefe 2007: towing beats drawing freely on slow curves: " + percent(pulled));
  finding(rubbed.high >= 0.0, "Keefe 2007: friction alone does not: " + percent(rubbed));
  finding(*std::min_element(gain.begin(), gain.end()) > 0.0, "guidance lowers the error");
  finding(gain.front() < gain[1] && gain[1] < gain.back(),
          "Langerak 2019: guidance gains less for simple shapes\n");
}

void show_pulse(const std::vector<Person>& people) {
  std::vector<double> peak, at_50, late;
  for (const Person& person : people) {
    const std::vector<double> moved = pulse_response(person, 1.0, 0.05);
    peak.push_back(*std::max_element(moved.begin(), moved.end()));
    at_50.push_back(moved[50]);
    late.push_back(moved[400]);
  }
  cli::TextTable rows = table({"pulse of 1 N for 50 ms", "5 %", "50 %", "95 %"});
  const auto add = [&](const char* name, const std::vector<double>& values) {
    rows.add_row({name, fmt::format("{:.2f}", quantile(values, 0.05)),
                  fmt::format("{:.2f}", quantile(values, 0.5)),
                  fmt::format("{:.2f}", quantile(values, 0.95))});
  };
  add("moved at the end of the pulse, mm", at_50);
  add("moved furthest, mm", peak);
  add("moved after 400 ms, mm", late);
  print(rows);
}

int run(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  Report report;
  if (options.is_acceptance) {
    for (const PersonModel model : kPersonModels) {
      check_acceptance(std::string(person_model_name(model)),
                       population(options.people, options.seed, model), report);
    }
    return report.missed() == 0 ? 0 : 1;
  }
  const std::vector<Person> people = population(options.people, options.seed, options.model);
  compare_with_people(options, people, report);
  check_steering(people, report);
  check_speed(people, report);
  show_findings(people);
  show_pulse(people);
  return report.missed() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  return felt::bench::run(argc, argv);
}
