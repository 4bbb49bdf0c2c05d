#include "force_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/hand/statistics.h"
#include "erasing.h"
#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/studies/simulated_trial.h"
#include "hand_task.h"
#include "pull_people.h"
#include "traced_study.h"

namespace felt::bench {
namespace {

constexpr int kTrials = 6;          // of each person, in the tasks of this file
constexpr double kSlowPace = 0.25;  // Person::pace of people who draw slowly

/// The studies of the rows, and indices of their conditions.
struct Studies {
  StudyFiles sketching, guided, towed;
};
constexpr std::size_t kAir = 0, kPlane = 1, kDefault = 3;  // improving-sketching
constexpr std::size_t kFree = 0, kGroove = 1;              // langerak-complexity
constexpr std::size_t kFreehand = 0, kDrag = 2;            // keefe-2007

/// A person with a device.
struct Fixture {
  const Studies& studies;
  Person person;
  const StylusPreset& device;
};

/// Returns the measure of one person, without or with the force; smaller is better.
using Measure = std::function<Result<double>(const Fixture&, bool is_on)>;

struct Row {
  const char* force;
  const char* reduces;
  const char* task;  ///< and its measure
  const char* people;
  const char* shipped;
  Measure measure;
};

using Options = std::vector<std::pair<std::string, std::string>>;
const Options kPlaneOnly = {{"surface.plane_only", "true"}};

/// Returns the mean error over the shapes of a study, with the height of the pen if `is_total`.
Result<double> study_error(const Fixture& fixture, const StudyFiles& files, std::size_t condition,
                           bool is_total = false) {
  double sum = 0.0;
  for (std::size_t shape = 0; shape < files.paths.size(); ++shape) {
    const PlannedTrial trial{.condition = condition, .shape = shape, .repetition = 1};
    const auto drawn = simulate_trial(files, trial, fixture.person, fixture.device);
    if (!drawn) return tl::unexpected(drawn.error());
    const TrialMetrics& metrics = drawn->front().metrics;
    const std::optional<double> error = is_total ? metrics.err_total_mm : metrics.err_mean_mm;
    if (!error) return fail(ErrorCode::kInvalidData, "a person did not draw");
    sum += *error;
  }
  return sum / static_cast<double>(files.paths.size());
}

/// Returns the mean of a task over the trials of a person.
Result<double> mean_of(const std::function<Result<double>(int trial)>& task) {
  double sum = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Result<double> one = task(trial);
    if (!one) return one;
    sum += *one;
  }
  return sum / kTrials;
}

/// Draws over ink along each shape. Returns the mean distance from the shape.
Result<double> retrace(const Fixture& fixture, const Options& options) {
  double sum = 0.0;
  const std::vector<StudyPath>& paths = fixture.studies.sketching.paths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    HandTask task{.options = options, .path = via_points(paths[i]), .trial = i};
    task.ink = {ink_along(task.path)};
    const auto done = run_task(task, fixture.person, fixture.device, nullptr);
    if (!done) return tl::unexpected(done.error());
    sum += done->stats.distance.mean_mm();
  }
  return sum / static_cast<double>(paths.size());
}

/// Moves a line to which two others are connected onto a goal. Returns its distance from it.
Result<double> move_line(const Fixture& fixture, const Options& options, int trial) {
  Random random(static_cast<std::uint64_t>(trial) + 1);
  const Point a{90.0, 100.0}, b{120.0, 100.0};
  HandTask task{.tool = "transform", .options = options};
  for (const auto& [from, to] :
       {std::pair(a, b), std::pair(a, Point{70.0, 130.0}), std::pair(b, Point{140.0, 130.0})}) {
    task.ink.push_back(std::make_shared<const Stroke>(testing::polyline_stroke({from, to})));
  }
  const double turn = kTau * random.between(0.55, 0.95), length = random.between(5.0, 20.0);
  const Vec way = length * Vec{std::cos(turn), std::sin(turn)};
  const Point touch = lerp(a, b, 0.5);
  task.path = {touch, touch + way};
  task.trial = static_cast<std::uint64_t>(trial);
  task.hold_s = 0.5;
  const auto done = run_task(task, fixture.person, fixture.device, nullptr);
  if (!done) return tl::unexpected(done.error());
  const StrokePtr moved = visible_strokes(done->page).front();
  return distance(moved->position(0.5 * moved->segment_count()), touch + way);
}

/// Draws a circle whose end misses its begin by up to 2.5 mm. Returns 1 if it stays open.
Result<double> close_circle(const Fixture& fixture, const Options& options, int trial) {
  Random random(static_cast<std::uint64_t>(trial) + 1);
  HandTask task{.options = options, .trial = static_cast<std::uint64_t>(trial)};
  const double miss = random.between(-2.5, 2.5), radius = random.between(6.0, 14.0);
  for (int i = 0; i <= 36; ++i) {
    const double share = i / 36.0, r = radius + miss * share;
    task.path.push_back({100.0 + r * std::cos(kTau * share), 100.0 + r * std::sin(kTau * share)});
  }
  const auto done = run_task(task, fixture.person, fixture.device, nullptr);
  if (!done) return tl::unexpected(done.error());
  const std::vector<StrokePtr> strokes = visible_strokes(done->page);
  return strokes.size() == 1 && strokes.front()->closed() ? 0.0 : 1.0;
}

Result<double> pulled(const Fixture& fixture, bool is_on, double Pulled::*measure) {
  const auto mean =
      pull_lines(fixture.device, {fixture.person}, is_on ? PullOptions{} : plane_only_pull(), 0.5);
  return mean ? Result<double>((*mean).*measure) : tl::unexpected(mean.error());
}

Result<double> erased(const Fixture& fixture, bool is_on, double Erased::*measure) {
  const auto mean = erase_all(fixture.person, fixture.device, is_on);
  return mean ? Result<double>((*mean).*measure) : tl::unexpected(mean.error());
}

Fixture slow(Fixture fixture) {
  fixture.person.pace = kSlowPace;
  return fixture;
}

std::vector<Row> rows() {
  return {
      {"plane", "errors of depth, and in the plane",
       "trace in the air or on the plane; total error",
       "-51 % (n = 12, doi 10.1145/3025453.3025474)", "on",
       [](const Fixture& f, bool on) {
         return study_error(f, f.studies.sketching, on ? kPlane : kAir, true);
       }},
      {"friction and viscosity of media", "skating", "trace on the plane; error in the plane",
       "fewer errors at targets (Richard and Cutkosky 2000)", "on",
       [](const Fixture& f, bool on) {
         return study_error(f, f.studies.sketching, on ? kDefault : kPlane);
       }},
      {"pull", "pulling too far", "pull to a mark, rest 0.5 s; overshoot", "none", "on",
       [](const Fixture& f, bool on) { return pulled(f, on, &Pulled::overshoot_mm); }},
      {"pull", "", "the same; distance after the lift", "none", "on",
       [](const Fixture& f, bool on) { return pulled(f, on, &Pulled::final_mm); }},
      {"transform", "moving too far", "move a line with two connections onto a goal; distance",
       "rotation more precise (doi 10.1115/1.4048618)", "on",
       [](const Fixture& f, bool on) {
         return mean_of([&](int i) { return move_line(f, on ? Options{} : kPlaneOnly, i); });
       }},
      {"eraser, guard", "erasing too much", "erase between two lines; ink that was not meant",
       "none", "on", [](const Fixture& f, bool on) { return erased(f, on, &Erased::extra_mm); }},
      {"connect", "open shapes", "close a circle that misses by up to 2.5 mm; share left open",
       "errors down (Oakley and others 2000)", "on",
       [](const Fixture& f, bool on) {
         const Options off = {{"pencil.attraction_n", "0"}};
         return mean_of([&](int i) { return close_circle(f, on ? Options{} : off, i); });
       }},
      {"guides", "distance from a known path", "trace along a groove; error",
       "accuracy up (arxiv 1906.11753)", "when chosen",
       [](const Fixture& f, bool on) {
         return study_error(f, f.studies.guided, on ? kGroove : kFree);
       }},
      {"tow", "wobble of slow curves", "trace slowly behind a rope; error",
       "better than freehand (Keefe and others 2007)", "off",
       [](const Fixture& f, bool on) {
         return study_error(slow(f), f.studies.towed, on ? kDrag : kFreehand);
       }},
      {"retrace", "distance from a line drawn over", "draw over a line slowly; error", "none", "on",
       [](const Fixture& f, bool on) {
         const Options off = {{"pencil.retrace_n", "0"}};
         return retrace(slow(f), on ? Options{} : off);
       }},
  };
}

/// Returns the change of a row for each model, as text.
Result<std::string> change_text(const Row& row, const Studies& studies, const StylusPreset& device,
                                const std::vector<Person>& people) {
  std::vector<double> off, on;
  for (const Person& person : people) {
    const Fixture fixture{studies, person, device};
    auto running = std::async(std::launch::async, [&] { return row.measure(fixture, false); });
    const Result<double> with = row.measure(fixture, true);
    const Result<double> without = running.get();
    if (!with) return tl::unexpected(with.error());
    if (!without) return tl::unexpected(without.error());
    off.push_back(*without);
    on.push_back(*with);
  }
  const double before = mean_over_people(off).mean, after = mean_over_people(on).mean;
  if (before <= 0.0) return fmt::format("{:.2f} to {:.2f}", before, after);
  return fmt::format("{:+.0f} % ({:.2f} to {:.2f})", 100.0 * (after / before - 1.0), before, after);
}

}  // namespace

Result<void> print_force_table(const std::string& device, std::size_t people) {
  Studies studies;
  for (auto& [files, name] : {std::pair(&studies.sketching, "improving-sketching"),
                              std::pair(&studies.guided, "langerak-complexity"),
                              std::pair(&studies.towed, "keefe-2007")}) {
    const std::string path = fmt::format("share/studies/{}.toml", name);
    const bool is_sketching = files == &studies.sketching;
    Result<StudyFiles> read = is_sketching ? read_traced_study(path) : read_study_files(path);
    if (!read) return tl::unexpected(read.error());
    *files = *std::move(read);
  }
  const StylusPreset& preset = *find_stylus_preset(device);
  fmt::print("| force | should reduce | task; measure | in people |");
  for (const PersonModel model : kPersonModels) fmt::print(" {} |", person_model_name(model));
  fmt::print(" default |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows()) {
    fmt::print("| {} | {} | {} | {} |", row.force, row.reduces, row.task, row.people);
    for (const PersonModel model : kPersonModels) {
      const auto text = change_text(row, studies, preset, population(people, 1, model));
      if (!text) return tl::unexpected(text.error());
      fmt::print(" {} |", *text);
    }
    fmt::print(" {} |\n", row.shipped);
  }
  fmt::print(
      "\n{} simulated people with a simulated {}, default options without and with the force.\n",
      people, device);
  return {};
}

}  // namespace felt::bench
