#include "erasing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/studies/erased_page.h"
#include "hand_task.h"

namespace felt::bench {
namespace {

constexpr int kTrials = 12;  // of each person
constexpr double kMaxExtraRatio = 0.5, kMaxWrongRatio = 0.2, kMaxTimeChange = 0.05;
constexpr double kLineMm = 90.0;

enum : std::uint8_t { kTarget, kMark, kNeighbour };

/// A line that is to be erased between two marks. Each stroke has its kind as the red of its
/// colour.
struct Page {
  std::vector<StrokePtr> ink;
  Point middle;
  Vec along;  // unit vector of the line
  ErasedPage layout;
  double from_mm, to_mm;  // the marks, from the middle along the line
};

StrokePtr line(Point a, Point b, std::uint8_t kind) {
  StrokeData data = testing::polyline_stroke({a, b}).data();
  data.color = {kind, 0, 0, 255};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

Page page_of(int trial) {
  Random random(static_cast<std::uint64_t>(trial) + 1);
  const double turn = random.between(0.0, kTau);
  Page page{{}, {120.0, 100.0}, {std::cos(turn), std::sin(turn)}, {}, 0.0, 0.0};
  page.layout = erased_page(page.middle, page.along, kLineMm, random);
  page.from_mm = page.layout.from_mm - 0.5 * kLineMm;
  page.to_mm = page.layout.to_mm - 0.5 * kLineMm;
  page.ink.push_back(line(page.layout.line[0], page.layout.line[1], kTarget));
  for (std::size_t i = 0; i < page.layout.others.size(); ++i) {
    const std::vector<Point>& other = page.layout.others[i];
    page.ink.push_back(line(other[0], other[1], i < 2 ? kMark : kNeighbour));
  }
  return page;
}

double length_mm(const Stroke& stroke) {
  double sum = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) sum += arc_length(stroke.segment(i));
  return sum;
}

Erased compare(const Page& before, const Document& after) {
  Erased erased;
  std::array<double, 5> lost{};
  for (std::size_t i = 0; i < before.ink.size(); ++i) lost[i] = length_mm(*before.ink[i]);
  double left_mm = 0.0;
  const double begin = before.from_mm, end = before.to_mm;
  double beyond_mm = kLineMm - (end - begin);
  for (const StrokePtr& stroke : visible_strokes(after)) {
    if (stroke->color().r == kTarget) {
      const double a = dot(stroke->position(0.0) - before.middle, before.along);
      const double b = dot(stroke->position(stroke->segment_count()) - before.middle, before.along);
      const double low = std::min(a, b), high = std::max(a, b);
      const double inside = std::max(0.0, std::min(high, end) - std::max(low, begin));
      left_mm += inside;
      beyond_mm -= high - low - inside;
      continue;
    }
    // Other lines are straight, so the nearest one is the one that this was a part of.
    const Point middle = stroke->position(0.5 * stroke->segment_count());
    std::size_t best = 1;
    double best_mm = 1e9;
    for (std::size_t i = 1; i < before.ink.size(); ++i) {
      if (before.ink[i]->color() != stroke->color()) continue;
      const Cubic c = before.ink[i]->segment(0);
      const double mm = std::fabs(cross(middle - c.p[0], normalized(c.p[3] - c.p[0])));
      if (mm >= best_mm) continue;
      best = i;
      best_mm = mm;
    }
    lost[best] -= length_mm(*stroke);
  }
  erased.left_mm = left_mm;
  erased.extra_mm = std::max(0.0, beyond_mm);
  for (std::size_t i = 1; i < before.ink.size(); ++i) {
    if (lost[i] < 0.01) continue;
    erased.extra_mm += lost[i];
    erased.wrong += 1.0;
  }
  return erased;
}

Result<Erased> erase(const Person& person, const StylusPreset& device, bool is_on, int trial) {
  const Page page = page_of(trial);
  HandTask task{.tool = "eraser", .ink = page.ink, .trial = static_cast<std::uint64_t>(trial)};
  if (!is_on) task.options = {{"eraser.guard_n", "0"}};
  Random random(1000 + static_cast<std::uint64_t>(trial));
  task.path = erasing_path(page.layout, random);
  double sum_n = 0.0, max_n = 0.0, ticks = 0.0;
  const auto watch = [&](const TickReport& report) {
    if (!in_contact(report.sample)) return;
    ++ticks;
    for (const ForceTerms::Term& term : report.terms) {
      if (std::string_view(term.name) != "guide") continue;
      sum_n += norm(term.force);
      max_n = std::max(max_n, norm(term.force));
    }
  };
  const Result<HandTaskResult> done = run_task(task, person, device, watch);
  if (!done) return tl::unexpected(done.error());
  Erased erased = compare(page, done->page);
  erased.seconds = 1e-3 * ticks;
  erased.mean_n = sum_n / std::max(ticks, 1.0);
  erased.max_n = max_n;
  return erased;
}

/// The means over people, without and with the force.
struct Totals {
  std::array<Erased, 2> mean{};

  void add(const Erased& one, bool is_on, double share) {
    Erased& sum = mean[is_on ? 1 : 0];
    sum.extra_mm += share * one.extra_mm;
    sum.wrong += share * one.wrong;
    sum.left_mm += share * one.left_mm;
    sum.seconds += share * one.seconds;
    sum.mean_n += share * one.mean_n;
    sum.max_n = std::max(sum.max_n, one.max_n);
  }
  [[nodiscard]] bool meets_bars() const noexcept {
    return mean[1].extra_mm <= kMaxExtraRatio * mean[0].extra_mm &&
           mean[1].wrong <= kMaxWrongRatio * mean[0].wrong &&
           mean[1].seconds <= (1.0 + kMaxTimeChange) * mean[0].seconds;
  }
};

Result<Totals> totals_of(const std::vector<Person>& people, const StylusPreset& device) {
  Totals totals;
  const double share = 1.0 / static_cast<double>(people.size());
  for (const Person& person : people) {
    auto off = std::async(std::launch::async, [&] { return erase_all(person, device, false); });
    const Result<Erased> on = erase_all(person, device, true);
    const Result<Erased> without = off.get();
    if (!on) return tl::unexpected(on.error());
    if (!without) return tl::unexpected(without.error());
    totals.add(*without, false, share);
    totals.add(*on, true, share);
  }
  return totals;
}

std::string pair_text(double off, double on) {
  return fmt::format("{:.2f} -> {:.2f}", off, on);
}

}  // namespace

Result<Erased> erase_all(const Person& person, const StylusPreset& device, bool is_on) {
  Erased sum;
  constexpr double kShare = 1.0 / kTrials;
  for (int trial = 0; trial < kTrials; ++trial) {
    Result<Erased> one = erase(person, device, is_on, trial);
    if (!one) return one;
    sum.extra_mm += kShare * one->extra_mm;
    sum.wrong += kShare * one->wrong;
    sum.left_mm += kShare * one->left_mm;
    sum.seconds += kShare * one->seconds;
    sum.mean_n += kShare * one->mean_n;
    sum.max_n = std::max(sum.max_n, one->max_n);
  }
  return sum;
}

Result<bool> compare_erasing(const std::vector<std::string>& devices, std::size_t people) {
  using Align = cli::TextTable::Align;
  std::vector<cli::TextTable::Column> columns = {{"device", Align::kLeft}, {"model", Align::kLeft}};
  for (const char* name : {"extra mm", "wrong lines", "left mm", "s", "mean N", "max N", ""}) {
    columns.push_back({name, Align::kRight});
  }
  cli::TextTable table(columns);
  bool is_met = true;
  for (const std::string& name : devices) {
    for (const PersonModel model : kPersonModels) {
      const auto totals = totals_of(population(people, 1, model), *find_stylus_preset(name));
      if (!totals) return tl::unexpected(totals.error());
      const auto& [off, on] = totals->mean;
      is_met = is_met && totals->meets_bars();
      table.add_row({name, std::string(person_model_name(model)),
                     pair_text(off.extra_mm, on.extra_mm), pair_text(off.wrong, on.wrong),
                     pair_text(off.left_mm, on.left_mm), pair_text(off.seconds, on.seconds),
                     fmt::format("{:.3f}", on.mean_n), fmt::format("{:.3f}", on.max_n),
                     totals->meets_bars() ? "met" : "missed"});
    }
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people, default options without and with eraser.guard_n; means per trial. A "
      "line of {} mm of ink is\nerased between two lines that cross it, with a neighbour 0.3 to "
      "1.2 mm beside the eraser on each side. extra: ink that was\nnot meant. wrong lines: lines "
      "that were not meant and have lost ink. left: ink that was meant.\nBars: {} times the extra "
      "ink, {} times the wrong lines, {:+.0f} % time: {}\n",
      people, kErasedInkMm, kMaxExtraRatio, kMaxWrongRatio, 100.0 * kMaxTimeChange,
      is_met ? "met" : "MISSED");
  return is_met;
}

}  // namespace felt::bench
