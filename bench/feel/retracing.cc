#include "retracing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <optional>
#include <string_view>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/replay/script_run.h"
#include "felt/studies/study_files.h"
#include "hand_task.h"
#include "tests/drawing/snapping/snap_count.h"
#include "tests/drawing/snapping/snap_scenes.h"
#include "traced_study.h"

namespace felt::bench {
namespace {

constexpr const char* kStudy = "share/studies/improving-sketching.toml";
constexpr double kMaxRatio = 0.65, kMaxMeanN = 0.05, kMaxN = 0.1, kMaxHoldMj = 0.2;
// The pace of people who draw slowly: Person::pace.
constexpr double kSlowPace = 0.25;
constexpr double kMaxFalseShare = 1e-3, kMaxFirstChange = 0.01;

/// The holds of a play, as the haptic loop feels them.
class Holds {
 public:
  void add(const TickReport& report) {
    const Point pen = on_page(report.sample.position);
    const Vec moved = pen - last_;
    last_ = pen;
    Vec force;
    bool holds = false;
    for (const ForceTerms::Term& term : report.terms) {
      if (std::string_view(term.name) != "guide") continue;
      holds = true;
      force = {term.force.x, term.force.y};
    }
    if (holds && !holds_) work_mj_ = 0.0;
    count_ += holds && !holds_ ? 1 : 0;
    holds_ = holds;
    work_mj_ += dot(force, moved);
    most_mj_ = std::max(most_mj_, work_mj_);
    if (!in_contact(report.sample)) return;
    sum_n_ += norm(force);
    max_n_ = std::max(max_n_, norm(force));
    ++ticks_;
  }
  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] double max_n() const noexcept { return max_n_; }
  [[nodiscard]] double mean_n() const noexcept { return sum_n_ / std::max(ticks_, 1); }
  /// Returns the largest work of one hold on the hand.
  [[nodiscard]] double most_mj() const noexcept { return most_mj_; }

 private:
  Point last_;
  bool holds_ = false;
  double sum_n_ = 0.0, max_n_ = 0.0, work_mj_ = 0.0, most_mj_ = 0.0;
  int count_ = 0, ticks_ = 0;
};

/// What one person did.
struct Drawn {
  double error_mm = 0.0;
  int strokes = 0, holds = 0;
  double mean_n = 0.0, max_n = 0.0, most_mj = 0.0;
};

/// A person with a device and a force.
struct Setup {
  const Person& person;
  const StylusPreset& device;
  bool is_on = true;
};

Drawn drawn_of(const ReplayStats& stats, const Holds& holds) {
  return {stats.distance.mean_mm(),
          static_cast<int>(stats.strokes_meant),
          holds.count(),
          holds.mean_n(),
          holds.max_n(),
          holds.most_mj()};
}

/// Lets the person draw once over the ink of a path.
Result<Drawn> retrace(const Setup& setup, const std::vector<Point>& path, std::uint64_t trial) {
  HandTask task{.ink = {ink_along(path)}, .path = path, .trial = trial};
  if (!setup.is_on) task.options = {{"pencil.retrace_n", "0"}};
  Holds holds;
  const Result<HandTaskResult> done = run_task(
      task, setup.person, setup.device, [&holds](const TickReport& tick) { holds.add(tick); });
  if (!done) return tl::unexpected(done.error());
  return drawn_of(done->stats, holds);
}

/// Lets the person draw the lines of a text on an empty page.
Result<Drawn> first_lines(const Setup& setup, const std::string& text) {
  ReplaySettings settings = replay_settings(setup.device, setup.person.grip(), true, {}, {});
  settings.person = setup.person;
  Holds holds;
  ReplayMachine::Observer observer;
  observer.tick = [&holds](const ReplayTick& tick) -> Result<void> {
    holds.add(tick.report);
    return {};
  };
  ReplayMachine machine(settings, Document(), observer);
  if (!setup.is_on) {
    if (Result<void> set = machine.set_option("pencil.retrace_n", "0"); !set) {
      return tl::unexpected(set.error());
    }
  }
  ScriptRun run(machine, 1.0, 0);
  if (Result<void> read = run.script("page", "", read_text(text)); !read) {
    return tl::unexpected(read.error());
  }
  if (Result<void> played = run.play(); !played) return tl::unexpected(played.error());
  return drawn_of(machine.take_stats(), holds);
}

/// Adds up what people did: their errors without and with the force, and the largest forces.
struct Totals {
  std::vector<double> off_mm, on_mm, changes;
  double mean_n = 0.0, max_n = 0.0, most_mj = 0.0;
  int strokes = 0, holds = 0;

  void add(const Drawn& off, const Drawn& on) {
    off_mm.push_back(off.error_mm);
    on_mm.push_back(on.error_mm);
    changes.push_back(on.error_mm / off.error_mm - 1.0);
    const double n = static_cast<double>(changes.size());
    mean_n += (on.mean_n - mean_n) / n;
    max_n = std::max(max_n, on.max_n);
    most_mj = std::max(most_mj, on.most_mj);
    strokes += on.strokes;
    holds += on.holds;
  }
};

void add_to(Drawn& sum, const Drawn& one, double share) {
  sum.error_mm += share * one.error_mm;
  sum.mean_n += share * one.mean_n;
  sum.max_n = std::max(sum.max_n, one.max_n);
  sum.most_mj = std::max(sum.most_mj, one.most_mj);
  sum.strokes += one.strokes;
  sum.holds += one.holds;
}

Result<Drawn> retrace_all(const Setup& setup, const std::vector<std::vector<Point>>& paths) {
  Drawn sum;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Result<Drawn> one = retrace(setup, paths[i], i);
    if (!one) return one;
    add_to(sum, *one, 1.0 / static_cast<double>(paths.size()));
  }
  return sum;
}

Result<Drawn> draw_first(const Setup& setup, const std::vector<std::string>& pages) {
  Drawn sum;
  for (const std::string& page : pages) {
    const Result<Drawn> one = first_lines(setup, page);
    if (!one) return one;
    add_to(sum, *one, 1.0 / static_cast<double>(pages.size()));
  }
  return sum;
}

template <class Task>
Result<Totals> totals_of(const std::vector<Person>& people, const StylusPreset& device,
                         const Task& task) {
  Totals totals;
  for (const Person& person : people) {
    auto off = std::async(std::launch::async, [&] { return task(Setup{person, device, false}); });
    const Result<Drawn> on = task(Setup{person, device, true});
    const Result<Drawn> without = off.get();
    if (!on) return tl::unexpected(on.error());
    if (!without) return tl::unexpected(without.error());
    totals.add(*without, *on);
  }
  return totals;
}

std::string change_text(const Totals& totals) {
  const MeanOverPeople mean = mean_over_people(totals.changes);
  return fmt::format("{:+.1f} % ({:+.1f} to {:+.1f})", 100.0 * mean.mean, 100.0 * mean.low,
                     100.0 * mean.high);
}

}  // namespace

Result<bool> compare_retracing(const std::vector<std::string>& devices, std::size_t people) {
  const Result<StudyFiles> files = read_traced_study(kStudy);
  if (!files) return tl::unexpected(files.error());
  std::vector<std::vector<Point>> paths;
  for (const StudyPath& path : files->paths) paths.push_back(via_points(path));
  std::vector<std::string> pages;
  for (const snap_test::SnapScene& scene : snap_test::scenes_to_leave_alone()) {
    pages.push_back(lines_of(scene));
  }
  using Align = cli::TextTable::Align;
  std::vector<cli::TextTable::Column> columns = {{"device", Align::kLeft}, {"model", Align::kLeft}};
  for (const char* name : {"off mm", "on mm", "retraced", "mean N", "max N", "mJ a hold",
                           "first lines", "held", "of"}) {
    columns.push_back({name, Align::kRight});
  }
  cli::TextTable table(columns);
  bool is_met = true;
  for (const std::string& name : devices) {
    for (const PersonModel model : kPersonModels) {
      const StylusPreset& device = *find_stylus_preset(name);
      std::vector<Person> drawers = population(people, 1, model);
      for (Person& person : drawers) person.pace = kSlowPace;
      const auto over =
          totals_of(drawers, device, [&](const Setup& setup) { return retrace_all(setup, paths); });
      if (!over) return tl::unexpected(over.error());
      const auto first =
          totals_of(drawers, device, [&](const Setup& setup) { return draw_first(setup, pages); });
      if (!first) return tl::unexpected(first.error());
      const double off = mean_over_people(over->off_mm).mean,
                   on = mean_over_people(over->on_mm).mean;
      is_met = is_met && on <= kMaxRatio * off && over->mean_n <= kMaxMeanN &&
               over->max_n <= kMaxN + 1e-9 &&
               std::max(over->most_mj, first->most_mj) <= kMaxHoldMj &&
               first->holds <= kMaxFalseShare * first->strokes &&
               std::fabs(mean_over_people(first->changes).mean) <= kMaxFirstChange;
      table.add_row({name, std::string(person_model_name(model)), fmt::format("{:.3f}", off),
                     fmt::format("{:.3f}", on), change_text(*over),
                     fmt::format("{:.3f}", over->mean_n), fmt::format("{:.3f}", over->max_n),
                     fmt::format("{:.3f}", std::max(over->most_mj, first->most_mj)),
                     change_text(*first), std::to_string(first->holds),
                     std::to_string(first->strokes)});
    }
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people who draw slowly, default options without and with pencil.retrace_n. "
      "Changes of the "
      "mean "
      "error, per\nperson, with the 95 % interval over people. retraced: over a line along the "
      "shapes "
      "of {}.\nfirst lines: hatching, shading, grass and words; a line that is held there is a "
      "mistake.\nBars: {:.2f} times the error, {} N on average, {} N at most, {} mJ a hold, 1 held "
      "line in 1,000, first lines within 1 %: {}\n",
      people, kStudy, kMaxRatio, kMaxMeanN, kMaxN, kMaxHoldMj, is_met ? "met" : "MISSED");
  return is_met;
}

}  // namespace felt::bench
