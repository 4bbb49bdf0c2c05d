#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/geometry/polyline.h"
#include "felt/replay/replay_machine.h"

namespace felt::testing {

/// How a simulated person drew a path with a guide.
struct GuidedDrawing {
  double mean_mm = 0.0, rms_mm = 0.0;  ///< distance of the pen from the path, in contact
  double mean_n = 0.0, max_n = 0.0;    ///< size of the guide's force, in contact
  double seconds = 0.0;                ///< in contact
  double energy_mj = 0.0;              ///< work of the guide on the hand
  int faults = 0;                      ///< of the safety chain
};

/// Lets a person draw along `line.points` with a simulated Phantom Premium, the haptic loop and the
/// pencil, while `line` guides the pen. `page` is what has been drawn before, and `retrace_n` the
/// value of that option of the pencil; "" for its default.
inline GuidedDrawing draw_guided(const Person& person, const GuideLine& line,
                                 std::uint64_t trial = 0, Document page = {},
                                 const std::string& retrace_n = "") {
  std::vector<Point> path = line.points;
  if (line.is_closed) path.push_back(path.front());
  GuidedDrawing drawing;
  double squares = 0.0, ticks = 0.0;
  PenSample last;
  const auto watch = [&](const ReplayTick& tick) -> Result<void> {
    const PenSample& sample = tick.report.sample;
    const Vec way = on_page(sample.position) - on_page(last.position);
    last = sample;
    if (!in_contact(sample)) return {};
    const double squared = nearest_on_polyline(path, on_page(sample.position)).distance_squared;
    squares += squared;
    drawing.mean_mm += std::sqrt(squared);
    for (const ForceTerms::Term& term : tick.report.terms) {
      if (std::string_view(term.name) != "guide") continue;
      drawing.mean_n += norm(term.force);
      drawing.max_n = std::max(drawing.max_n, norm(term.force));
      drawing.energy_mj += term.force.x * way.x + term.force.y * way.y;
    }
    ++ticks;
    return {};
  };
  ReplaySettings settings =
      replay_settings(*find_stylus_preset("premium"), typical_hand(), true, {}, {});
  settings.person = person;
  ReplayMachine machine(settings, std::move(page), {.tick = watch});
  const auto must = [](const Result<void>& done) {
    EXPECT_TRUE(done) << (done ? "" : done.error().message);
  };
  must(machine.add({0, line.kind == GuideKind::kNone ? UseGuide{} : UseGuide{line}}));
  if (!retrace_n.empty()) must(machine.set_option("pencil.retrace_n", retrace_n));
  const RecordedPath plan = plan_movement(person, path, trial);
  for (const TimedAim& aim : script_hand(std::span(&plan, 1), machine.hand_options())) {
    must(machine.add({aim.time_ns, HandEvent{.target = aim.target_mm, .pressure = aim.pressure}}));
  }
  must(machine.play());
  const ReplayStats stats = machine.take_stats();
  drawing.faults = static_cast<int>(stats.soft_faults + stats.hard_faults);
  drawing.seconds = 0.001 * ticks;
  drawing.mean_mm /= ticks;
  drawing.rms_mm = std::sqrt(squares / ticks);
  drawing.mean_n /= ticks;
  return drawing;
}

}  // namespace felt::testing
