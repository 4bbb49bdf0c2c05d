#include "pull_people.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "hand_task.h"

namespace felt::bench {
namespace {

constexpr int kPulls = 12;  // of each person
constexpr double kMaxFinalRatio = 1.5, kMaxOvershootRatio = 0.5;
constexpr double kBarRestS = 0.5;                // the bars are for this rest before the lift
constexpr std::array kRestS = {kBarRestS, 1.0};  // of the rows

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

double distance_from(const Document& document, Point p) {
  double least = 1e9;
  for (const StrokePtr& stroke : visible_strokes(document)) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      least = std::min(least, std::sqrt(felt::nearest(stroke->segment(i), p).distance_squared));
    }
  }
  return least;
}

Result<Pulled> pull_line(const StylusPreset& device, const Person& person,
                         const PullOptions& options, double rest_s, int trial) {
  const Pull pull = pull_of(trial);
  const Stroke line = testing::straight_stroke({60.0, 100.0}, {180.0, 100.0}, 0.5, 0.5);
  HandTask task{.tool = "pull",
                .options = options,
                .ink = {std::make_shared<const Stroke>(line)},
                .path = {pull.from, pull.to},
                .trial = static_cast<std::uint64_t>(trial),
                .hold_s = rest_s};
  const Vec along = normalized(pull.to - pull.from);
  Pulled pulled;
  const auto watch = [&](const TickReport& report) {
    if (!in_contact(report.sample)) return;
    const double beyond = dot(on_page(report.sample.position) - pull.to, along);
    pulled.overshoot_mm = std::max(pulled.overshoot_mm, beyond);
  };
  const Result<HandTaskResult> done = run_task(task, person, device, watch);
  if (!done) return tl::unexpected(done.error());
  pulled.final_mm = distance_from(done->page, pull.to);
  return pulled;
}

}  // namespace

PullOptions plane_only_pull() {
  return {{"surface.plane_only", "true"}};
}

Result<Pulled> pull_lines(const StylusPreset& device, const std::vector<Person>& people,
                          const PullOptions& options, double rest_s) {
  Pulled mean;
  for (const Person& person : people) {
    for (int trial = 0; trial < kPulls; ++trial) {
      Result<Pulled> one = pull_line(device, person, options, rest_s, trial);
      if (!one) return one;
      const double share = 1.0 / (kPulls * static_cast<double>(people.size()));
      mean.final_mm += share * one->final_mm;
      mean.overshoot_mm += share * one->overshoot_mm;
    }
  }
  return mean;
}

/// Adds what people did under each condition. Returns whether the last one meets the bars.
Result<bool> add_cells(const StylusPreset& device, const std::vector<Person>& people, double rest_s,
                       const PullOptions& options, std::vector<std::string>& cells) {
  std::vector<Pulled> means;
  for (const PullOptions& condition :
       {plane_only_pull(), PullOptions{{"pull.yield_s", "0"}}, options}) {
    const auto mean = pull_lines(device, people, condition, rest_s);
    if (!mean) return tl::unexpected(mean.error());
    means.push_back(*mean);
    cells.push_back(fmt::format("{:.2f}, {:.2f}", mean->final_mm, mean->overshoot_mm));
  }
  const Pulled &off = means.front(), &on = means.back();
  const bool meets =
      rest_s != kBarRestS || (on.final_mm <= kMaxFinalRatio * off.final_mm &&
                              on.overshoot_mm <= kMaxOvershootRatio * off.overshoot_mm);
  cells.push_back(fmt::format("{:.2f}, {:.2f}{}", on.final_mm / off.final_mm,
                              on.overshoot_mm / off.overshoot_mm, meets ? "" : " missed"));
  return meets;
}

Result<bool> compare_pulls(const std::vector<std::string>& devices, std::size_t people,
                           const PullOptions& options) {
  using Align = cli::TextTable::Align;
  cli::TextTable table({{"device", Align::kLeft},
                        {"model", Align::kLeft},
                        {"rest s", Align::kRight},
                        {"plane only mm", Align::kRight},
                        {"paper", Align::kRight},
                        {"default", Align::kRight},
                        {"ratios", Align::kRight}});
  bool is_met = true;
  for (const std::string& name : devices) {
    for (const PersonModel model : kPersonModels) {
      const std::vector<Person> pullers = population(people, 1, model);
      for (const double rest_s : kRestS) {
        std::vector<std::string> cells = {name, std::string(person_model_name(model)),
                                          fmt::format("{}", rest_s)};
        Result<bool> meets = add_cells(*find_stylus_preset(name), pullers, rest_s, options, cells);
        if (!meets) return meets;
        is_met = is_met && *meets;
        table.add_row(cells);
      }
    }
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people, {} pulls of 5 to 20 mm each: with the plane only, with the "
      "counter-force of the paper (pull.yield_s = 0), and with the default options.\nmm: distance "
      "of the line from its goal after the lift, and how far the pen went beyond the goal.\nBars, "
      "at the default after {} s: {} times the distance and {} times the overshoot: {}\n",
      people, kPulls, kBarRestS, kMaxFinalRatio, kMaxOvershootRatio, is_met ? "met" : "MISSED");
  return is_met;
}

}  // namespace felt::bench
