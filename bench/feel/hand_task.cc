#include "hand_task.h"

#include <algorithm>
#include <span>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::bench {

StrokePtr ink_along(std::vector<Point> path) {
  const auto is_near = [](Point a, Point b) { return distance(a, b) < 2.0 * kMinSegmentMm; };
  path.erase(std::unique(path.begin(), path.end(), is_near), path.end());
  return std::make_shared<const Stroke>(testing::polyline_stroke(path));
}

Result<Document> page_with(const std::vector<StrokePtr>& ink) {
  Document document;
  EditBuilder edit(document);
  for (const StrokePtr& stroke : ink) edit.add(document.layers().front().id, stroke);
  if (Result<void> done = document.apply(std::move(edit).build("Draw")); !done) {
    return tl::unexpected(done.error());
  }
  return document;
}

Result<HandTaskResult> run_task(const HandTask& task, const Person& person,
                                const StylusPreset& device,
                                const std::function<void(const TickReport&)>& tick) {
  ReplaySettings settings = replay_settings(device, person.grip(), true, {}, {});
  settings.person = person;
  Result<Document> page = page_with(task.ink);
  if (!page) return tl::unexpected(page.error());
  ReplayMachine::Observer observer;
  observer.tick = [&tick](const ReplayTick& now) -> Result<void> {
    if (tick) tick(now.report);
    return {};
  };
  ReplayMachine machine(settings, *std::move(page), observer);
  for (const auto& [id, value] : task.options) {
    if (Result<void> set = machine.set_option(id, value); !set) return tl::unexpected(set.error());
  }
  if (Result<void> chosen = machine.add({0, SelectTool{std::string(task.tool)}}); !chosen) {
    return tl::unexpected(chosen.error());
  }
  if (Result<void> felt = machine.add({0, task.edges}); !felt) return tl::unexpected(felt.error());
  const Person drawer = on_a_plane(person, machine.expected_friction_n());
  RecordedPath plan = plan_movement(drawer, task.path, task.trial);
  const RecordedPoint last = plan.back();
  for (std::int64_t ms = 1; static_cast<double>(ms) <= 1e3 * task.hold_s; ++ms) {
    plan.push_back(last);
    plan.back().time_ns = *last.time_ns + ms * kMs;
  }
  machine.begin_stroke();
  for (const TimedAim& aim : script_hand(std::span(&plan, 1), machine.hand_options())) {
    const Event event{aim.time_ns, HandEvent{aim.target_mm, aim.pressure}};
    if (Result<void> added = machine.add(event); !added) return tl::unexpected(added.error());
  }
  machine.stroke_drawn(task.path);
  if (Result<void> played = machine.play(); !played) return tl::unexpected(played.error());
  return HandTaskResult{machine.session().document(), machine.take_stats()};
}

}  // namespace felt::bench
