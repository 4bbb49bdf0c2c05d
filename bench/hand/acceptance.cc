#include "acceptance.h"

#include <fmt/core.h>

#include <cmath>
#include <span>

#include "drawing.h"
#include "felt/base/constants.h"
#include "statistics.h"

namespace felt::bench {
namespace {

constexpr std::uint64_t kTrials = 4;  // of each person and shape

using Path = std::vector<Point>;
using Measure = double Drawing::*;

/// A range in which a published result lies.
struct Range {
  double low, high;
};

Path circle(double radius_mm) {
  Path path;
  for (int i = 0; i <= 48; ++i) {
    const double angle = kTau * i / 48.0;
    path.push_back({100.0 + radius_mm * std::sin(angle), 100.0 - radius_mm * std::cos(angle)});
  }
  return path;
}

/// Returns cursive loops, `height_mm` high.
Path loops(double height_mm) {
  Path path;
  const int count = 6, points = 16;
  for (int i = 0; i <= count * points; ++i) {
    const double turn = static_cast<double>(i) / points;
    path.push_back({80.0 + height_mm * (0.6 * turn + 0.4 * std::sin(kTau * turn)),
                    100.0 - 0.5 * height_mm * std::cos(kTau * turn)});
  }
  return path;
}

/// Returns the measure of each person, averaged over shapes and trials. The conditions that are
/// compared have the same random numbers.
std::vector<double> of_people(const std::vector<Person>& people, std::span<const Path> paths,
                              const Condition& condition, Measure measure) {
  std::vector<double> means;
  const double count = static_cast<double>(paths.size()) * static_cast<double>(kTrials);
  for (const Person& person : people) {
    double sum = 0.0;
    for (const Path& path : paths) {
      for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
        sum += draw(person, path, condition, trial).*measure;
      }
    }
    means.push_back(sum / count);
  }
  return means;
}

/// Returns the ratio of each person's measure with `changed` to that with `usual`.
MeanOverPeople ratio(const std::vector<Person>& people, std::span<const Path> paths,
                     const Condition& changed, const Condition& usual, Measure measure) {
  std::vector<double> ratios = of_people(people, paths, changed, measure);
  const std::vector<double> base = of_people(people, paths, usual, measure);
  for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] /= base[i];
  return mean_over_people(ratios);
}

void check(Report& report, const std::string& what, const MeanOverPeople& value, Range range) {
  report.bar(value.mean >= range.low && value.mean <= range.high,
             fmt::format("{}: {:.3f} ({:.3f} to {:.3f}), {} to {}", what, value.mean, value.low,
                         value.high, range.low, range.high));
}

// Arora and others, CHI 2017, doi 10.1145/3025453.3025474: 12 people, lines and circles of 10 to 60
// cm, in the air and on a surface. The ratios are of the raw data that the authors published.
void check_air(const std::vector<Person>& people, Report& report) {
  const Path paths[] = {{{60.0, 100.0}, {160.0, 100.0}}, circle(50.0)};
  const Condition air{.in_air = true};
  check(report, "V1 total error, air / plane",
        ratio(people, paths, air, {}, &Drawing::total_error_mm), {1.80, 2.34});
  check(report, "V1 error in the plane, air / plane",
        ratio(people, paths, air, {}, &Drawing::plane_error_mm), {1.15, 1.42});
  check(report, "V1 time, air / plane", ratio(people, paths, air, {}, &Drawing::duration_s),
        {0.75, 0.90});
}

// Gerth and others 2016 (PMC5018499): adults write as well on paper as on a smooth tablet, and a
// little slower. A pencil on paper resists with about 0.25 N, a pen on glass with 0.05 N.
void check_writing(const std::vector<Person>& people, Report& report) {
  const Path paths[] = {loops(4.0)};
  const Condition paper{.device_friction_n = 0.25}, glass{.device_friction_n = 0.05};
  check(report, "V2 error of writing of 4 mm, 0.25 N / 0.05 N",
        ratio(people, paths, paper, glass, &Drawing::plane_error_mm), {0.90, 1.10});
  check(report, "V2 time of writing of 4 mm, 0.25 N / 0.05 N",
        ratio(people, paths, paper, glass, &Drawing::duration_s), {1.03, 1.25});
}

// Richard, Cutkosky, ASME IMECE 2000: moderate friction makes targets easier to hit.
void check_targets(const std::vector<Person>& people, Report& report) {
  const Path paths[] = {{{80.0, 100.0}, {100.0, 100.0}}, {{80.0, 80.0}, {110.0, 110.0}}};
  const Condition rubbed{.device_friction_n = 0.13}, free{.device_friction_n = 0.0};
  const MeanOverPeople change = ratio(people, paths, rubbed, free, &Drawing::end_error_mm);
  report.bar(
      change.high < 1.0,
      fmt::format("V3 distance from a target, 0.13 N / 0 N: {:.3f} ({:.3f} to {:.3f}), below 1",
                  change.mean, change.low, change.high));
}

// The lines of people in the data of Arora and others: 1 to 11 % of the variance of the error is
// above 4 Hz.
void check_speed_of_error(const std::vector<Person>& people, Report& report) {
  const Path paths[] = {{{60.0, 100.0}, {160.0, 100.0}}, circle(50.0)};
  check(report, "V4 share of the variance above 4 Hz",
        mean_over_people(of_people(people, paths, {}, &Drawing::fast_share)), {0.01, 0.11});
}

}  // namespace

void check_acceptance(const std::string& model, const std::vector<Person>& people, Report& report) {
  fmt::print("{}, {} people\n", model, people.size());
  check_air(people, report);
  check_writing(people, report);
  check_targets(people, report);
  check_speed_of_error(people, report);
  fmt::print("\n");
}

}  // namespace felt::bench
