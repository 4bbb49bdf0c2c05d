// Simulates studies with a known effect, and counts how often the 95 % interval of the difference
// between two conditions (felt/trial/statistics.h) contains this effect.
//   bench_studies [--studies N] [--people N] [--trials N] [--seed N]
//
// In each study, different simulated people draw the same wave in two conditions that are in truth
// the same; the errors of the second condition are then multiplied by 0.8 (an effect of 20 %), or
// not changed (no effect). The difference in mm is compared with the mean over all people of all
// studies, and the ratio with 0.8 or 1. The exit status is 1 if a share is not 93 to 97 %, or if
// the interval excludes no difference in fewer than 3 % or more than 7 % of the studies without
// effect.
#include <fmt/core.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "bench/hand/drawing.h"
#include "felt/trial/statistics.h"
#include "felt/trial/study_shapes.h"

namespace felt::bench {
namespace {

struct StudyOptions {
  std::size_t studies = 1000;
  std::size_t people = 12;
  std::size_t trials = 2;
  std::uint64_t seed = 1;
};

StudyOptions study_options_of(int argc, char** argv) {
  StudyOptions options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
    const auto number = std::strtoull(value.c_str(), nullptr, 10);
    if (name == "--studies") {
      options.studies = number;
    } else if (name == "--people") {
      options.people = number;
    } else if (name == "--trials") {
      options.trials = number;
    } else if (name == "--seed") {
      options.seed = number;
    } else {
      fmt::print(stderr, "bench_studies: unknown option {}\n", name);
      std::exit(2);
    }
  }
  return options;
}

/// The mean error of a person in each of two equal conditions, and the mean of its logarithm.
struct PersonErrors {
  std::array<double, 2> mean_mm{}, mean_log{};
};
using StudyErrors = std::vector<PersonErrors>;

StudyErrors simulate(const StudyOptions& options, std::size_t study) {
  const std::vector<Point> path = shape_path(StudyShapeKind::kWave, 25.0);
  const Condition condition{.friction = 0.2};
  StudyErrors errors;
  for (const Person& person : population(options.people, options.seed * 1'000'003 + study)) {
    PersonErrors& own = errors.emplace_back();
    for (std::size_t trial = 0; trial < 2 * options.trials; ++trial) {
      const double error_mm = draw(person, path, condition, trial).error_mm;
      own.mean_mm[trial % 2] += error_mm / static_cast<double>(options.trials);
      own.mean_log[trial % 2] += std::log(error_mm) / static_cast<double>(options.trials);
    }
  }
  return errors;
}

std::vector<StudyErrors> simulate_all(const StudyOptions& options) {
  std::vector<StudyErrors> all(options.studies);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < all.size(); i = next++) all[i] = simulate(options, i);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    workers.emplace_back(work);
  }
  workers.clear();
  return all;
}

/// How many intervals contain the truth, and how many exclude no difference.
struct Counts {
  std::size_t covered = 0, excluded = 0;
};

void count(const std::vector<double>& differences, double truth, std::uint64_t seed,
           Counts& counts) {
  const auto interval = mean_interval(differences, 0.95, seed);
  if (!interval) return;
  if (interval->low <= truth && truth <= interval->high) ++counts.covered;
  if (interval->low > 0.0 || interval->high < 0.0) ++counts.excluded;
}

bool is_within(std::size_t number, std::size_t of, double low, double high) {
  const double share = static_cast<double>(number) / static_cast<double>(of);
  return share >= low && share <= high;
}

bool check_effect(const std::vector<StudyErrors>& all, double factor) {
  double sum_mm = 0.0, people = 0.0;
  for (const StudyErrors& study : all) {
    for (const PersonErrors& person : study) {
      sum_mm += 0.5 * (person.mean_mm[0] + person.mean_mm[1]);
      people += 1.0;
    }
  }
  const double truth_mm = (factor - 1.0) * sum_mm / people;
  Counts in_mm, as_ratio;
  for (std::size_t study = 0; study < all.size(); ++study) {
    std::vector<double> mm, logs;
    for (const PersonErrors& person : all[study]) {
      mm.push_back(factor * person.mean_mm[1] - person.mean_mm[0]);
      logs.push_back(std::log(factor) + person.mean_log[1] - person.mean_log[0]);
    }
    count(mm, truth_mm, study, in_mm);
    count(logs, std::log(factor), study, as_ratio);
  }
  bool is_good = true;
  for (const auto& [name, counts] : {std::pair{"difference", in_mm}, {"ratio", as_ratio}}) {
    fmt::print("factor {:.1f}, {:10}: {} of {} intervals contain the truth, {} exclude none\n",
               factor, name, counts.covered, all.size(), counts.excluded);
    is_good = is_good && is_within(counts.covered, all.size(), 0.93, 0.97);
    if (factor == 1.0) is_good = is_good && is_within(counts.excluded, all.size(), 0.03, 0.07);
  }
  fmt::print("factor {:.1f}: true difference {:.4f} mm; mean error without effect {:.4f} mm\n",
             factor, truth_mm, sum_mm / people);
  return is_good;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  using namespace felt::bench;
  const StudyOptions options = study_options_of(argc, argv);
  fmt::print("{} studies with {} people and {} trials in each of 2 conditions, seed {}\n",
             options.studies, options.people, options.trials, options.seed);
  const std::vector<StudyErrors> all = simulate_all(options);
  const bool has_effect = check_effect(all, 0.8), has_none = check_effect(all, 1.0);
  return has_effect && has_none ? 0 : 1;
}
