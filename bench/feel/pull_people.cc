#include "pull_people.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/nearest.h"
#include "felt/replay/replay_machine.h"

namespace felt::bench {
namespace {

constexpr int kPulls = 12;              // of each person
constexpr std::int64_t kHoldMs = 1000;  // the pen rests before it is lifted

/// A pull from a point of the line to another point, 5 to 20 mm away.
struct Pull {
  Point from, to;
};

Pull pull_of(int trial) {
  Random random(static_cast<std::uint64_t>(trial) + 1);
  const Point from{random.between(90.0, 150.0), 100.0};
  const double angle = random.between(0.2, 0.8) * kTau / 2.0 * (trial % 2 == 0 ? 1.0 : -1.0);
  const double length = random.between(5.0, 20.0);
  return {from, {from.x + length * std::cos(angle), from.y + length * std::sin(angle)}};
}

Result<VisibleInk> line_to_pull() {
  const Cubic line = straight({60.0, 100.0}, {180.0, 100.0});
  StrokeData data;
  data.points.assign(line.p.begin(), line.p.end());
  data.widths = {{0.0, 0.5}, {1.0, 0.5}};
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke) return tl::unexpected(stroke.error());
  return VisibleInk{{std::make_shared<const Stroke>(*std::move(stroke))}, {}};
}

double distance_from(const Document& document, Point p) {
  double least = 1e9;
  for (const StrokePtr& stroke : visible_strokes(document)) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      least = std::min(least, std::sqrt(felt::nearest(stroke->segment(i), p).distance_squared));
    }
  }
  return least;
}

/// Lets a person pull the line. Without a strength, forces are off.
Result<double> pull_error(const StylusPreset& device, const Person& person,
                          std::optional<double> strength, int trial) {
  const Pull pull = pull_of(trial);
  ReplaySettings settings =
      replay_settings(device, *find_hand("typical"), strength.has_value(), {}, {});
  settings.person = person;
  settings.read_import = [](const std::string&) { return line_to_pull(); };
  ReplayMachine machine(settings, Document(), {});
  if (strength) {
    const Result<void> set = machine.set_option("pull.strength", fmt::format("{}", *strength));
    if (!set) return tl::unexpected(set.error());
  }
  for (const Event& event : {Event{0, ImportEvent{"line"}}, Event{0, SelectTool{"pull"}}}) {
    if (Result<void> added = machine.add(event); !added) return tl::unexpected(added.error());
  }
  RecordedPath plan =
      plan_movement(person, std::vector{pull.from, pull.to}, static_cast<std::uint64_t>(trial));
  const RecordedPoint last = plan.back();
  for (std::int64_t ms = 1; ms <= kHoldMs; ++ms) {
    plan.push_back(last);
    plan.back().time_ns = *last.time_ns + ms * kMs;
  }
  for (const TimedAim& aim : script_hand(std::span(&plan, 1), machine.hand_options())) {
    const Event event{aim.time_ns, HandEvent{aim.target_mm, aim.pressure}};
    if (Result<void> added = machine.add(event); !added) return tl::unexpected(added.error());
  }
  if (Result<void> played = machine.play(); !played) return tl::unexpected(played.error());
  return distance_from(machine.session().document(), pull.to);
}

Result<double> mean_error(const StylusPreset& device, const Person& person,
                          std::optional<double> strength) {
  double sum = 0.0;
  for (int trial = 0; trial < kPulls; ++trial) {
    const Result<double> error = pull_error(device, person, strength, trial);
    if (!error) return error;
    sum += *error;
  }
  return sum / kPulls;
}

}  // namespace

Result<void> compare_pulls(const std::string& device, std::size_t people) {
  using Align = cli::TextTable::Align;
  cli::TextTable table({{"pull.strength", Align::kLeft},
                        {"forces off mm", Align::kRight},
                        {"on mm", Align::kRight},
                        {"change (95 %)", Align::kRight}});
  const StylusPreset& preset = *find_stylus_preset(device);
  for (const double strength : {1.0, 0.7, 0.5, 0.25, 0.0}) {
    std::vector<double> off, on, change;
    for (const Person& person : population(people)) {
      const Result<double> without = mean_error(preset, person, std::nullopt);
      const Result<double> with = mean_error(preset, person, strength);
      if (!without) return tl::unexpected(without.error());
      if (!with) return tl::unexpected(with.error());
      off.push_back(*without);
      on.push_back(*with);
      change.push_back(*with - *without);
    }
    const MeanOverPeople mean = mean_over_people(change);
    table.add_row({fmt::format("{}", strength), fmt::format("{:.3f}", mean_over_people(off).mean),
                   fmt::format("{:.3f}", mean_over_people(on).mean),
                   fmt::format("{:+.3f} ({:+.3f} to {:+.3f})", mean.mean, mean.low, mean.high)});
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people with a simulated {}. mm: distance of the line from the point to which "
      "it\nshould be pulled, after the pen was lifted; mean of {} pulls of 5 to 20 mm.\n",
      people, device, kPulls);
  return {};
}

}  // namespace felt::bench
