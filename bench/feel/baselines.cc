#include "baselines.h"

#include <fmt/core.h>

#include <array>
#include <future>
#include <optional>
#include <span>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/studies/simulated_trial.h"
#include "traced_study.h"

namespace felt::bench {
namespace {

constexpr const char* kStudy = "share/studies/improving-sketching.toml";
constexpr int kRepetitions = 2;
constexpr std::size_t kDefaultRetrace = 3;  // of the study: the options as they ship
enum Column : std::size_t { kAir, kPlane, kDefault, kTablet, kColumns };

/// The means of one person over shapes and repetitions.
struct Means {
  double plane_mm = 0.0;  ///< error in the plane of drawing
  double total_mm = 0.0;  ///< with the height of the pen, if the device measures it
  double time_s = 0.0;
};
using OfPeople = std::array<std::vector<Means>, kColumns>;

Result<Means> means_of(const StudyFiles& files, std::size_t condition, const Person& person,
                       const StylusPreset& device) {
  Means means;
  const double share = 1.0 / (kRepetitions * static_cast<double>(files.paths.size()));
  for (std::size_t shape = 0; shape < files.paths.size(); ++shape) {
    for (int repetition = 1; repetition <= kRepetitions; ++repetition) {
      const PlannedTrial trial{.condition = condition, .shape = shape, .repetition = repetition};
      const auto drawn = simulate_trial(files, trial, person, device);
      if (!drawn) return tl::unexpected(drawn.error());
      const TrialMetrics& metrics = drawn->front().metrics;
      if (!metrics.err_mean_mm || !metrics.movement_s) {
        return fail(ErrorCode::kInvalidData, "a person did not draw");
      }
      means.plane_mm += share * *metrics.err_mean_mm;
      means.total_mm += share * metrics.err_total_mm.value_or(*metrics.err_mean_mm);
      means.time_s += share * *metrics.movement_s;
    }
  }
  return means;
}

Result<std::vector<Means>> column_of(const StudyFiles& files, Column column,
                                     const std::vector<Person>& people,
                                     const StylusPreset& device) {
  const bool is_default = column == kDefault || column == kTablet;
  const std::size_t condition = is_default ? kDefaultRetrace : std::size_t{column};
  const StylusPreset& used = column == kTablet ? *find_stylus_preset("tablet") : device;
  std::vector<Means> all;
  for (const Person& person : people) {
    const Result<Means> means = means_of(files, condition, person, used);
    if (!means) return tl::unexpected(means.error());
    all.push_back(*means);
  }
  return all;
}

/// Returns the columns of one model and device, which are computed side by side.
Result<OfPeople> columns_of(const StudyFiles& files, const std::vector<Person>& people,
                            const StylusPreset& device) {
  std::array<std::future<Result<std::vector<Means>>>, kColumns> running;
  for (std::size_t i = 0; i < kColumns; ++i) {
    running[i] = std::async(std::launch::async, [&, i] {
      return column_of(files, static_cast<Column>(i), people, device);
    });
  }
  OfPeople columns;
  std::optional<Error> error;
  for (std::size_t i = 0; i < kColumns; ++i) {
    Result<std::vector<Means>> means = running[i].get();
    if (!means) {
      error = means.error();
      continue;
    }
    columns[i] = *std::move(means);
  }
  if (error) return tl::unexpected(*error);
  return columns;
}

/// Returns how much greater a measure is in per cent, with its 95 % interval over people.
std::string change(const OfPeople& all, Column from, double Means::*measure) {
  std::vector<double> changes;
  for (std::size_t i = 0; i < all[from].size(); ++i) {
    changes.push_back(all[kDefault][i].*measure / all[from][i].*measure - 1.0);
  }
  const MeanOverPeople mean = mean_over_people(changes);
  return fmt::format("{:+.0f} % ({:+.0f} to {:+.0f})", 100.0 * mean.mean, 100.0 * mean.low,
                     100.0 * mean.high);
}

std::string mean_mm(const std::vector<Means>& people, double Means::*measure) {
  std::vector<double> values;
  values.reserve(people.size());
  for (const Means& means : people) values.push_back(means.*measure);
  return fmt::format("{:.3f}", mean_over_people(values).mean);
}

}  // namespace

Result<void> compare_baselines(const std::vector<std::string>& devices, std::size_t people) {
  const Result<StudyFiles> files = read_traced_study(kStudy);
  if (!files) return tl::unexpected(files.error());
  using Align = cli::TextTable::Align;
  std::vector<cli::TextTable::Column> columns = {{"device", Align::kLeft}, {"model", Align::kLeft}};
  for (const char* name : {"default mm", "from air, total", "from air, in plane", "time",
                           "from plane only", "time", "from tablet"}) {
    columns.push_back({name, Align::kRight});
  }
  cli::TextTable table(columns);
  for (const std::string& device : devices) {
    for (const PersonModel model : kPersonModels) {
      const Result<OfPeople> all =
          columns_of(*files, population(people, 1, model), *find_stylus_preset(device));
      if (!all) return tl::unexpected(all.error());
      table.add_row({device, std::string(person_model_name(model)),
                     mean_mm((*all)[kDefault], &Means::plane_mm),
                     change(*all, kAir, &Means::total_mm), change(*all, kAir, &Means::plane_mm),
                     change(*all, kAir, &Means::time_s), change(*all, kPlane, &Means::plane_mm),
                     change(*all, kPlane, &Means::time_s),
                     change(*all, kTablet, &Means::plane_mm)});
    }
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people, the shapes of {}, default options. Changes of\nthe mean error from a "
      "baseline to the default forces, per person, with the 95 % interval over people.\ntotal: "
      "with the height of the pen. The simulated tablet has neither mass nor friction.\n",
      people, kStudy);
  return {};
}

}  // namespace felt::bench
