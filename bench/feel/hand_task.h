#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/document/document.h"
#include "felt/geometry/point.h"
#include "felt/replay/replay_machine.h"

namespace felt::bench {

/// A gesture of a simulated person with a simulated device, on a page with ink.
struct HandTask {
  std::string_view tool = "pencil";
  std::vector<std::pair<std::string, std::string>> options{};  ///< ids and values
  std::vector<StrokePtr> ink{};                                ///< on the page at the start
  std::vector<Point> path{};                                   ///< of plan_movement()
  std::uint64_t trial = 0;                                     ///< chooses the noise of the plan
  UseEdges edges{};                                            ///< what is felt at the start
  double hold_s = 0.0;                                         ///< rest at the end, before the lift
};

/// What became of the page, and the counts of the play.
struct HandTaskResult {
  Document page;
  ReplayStats stats;
};

/// Lets the person carry out the task. Calls `tick` for each tick of the loop, unless it is null.
Result<HandTaskResult> run_task(const HandTask& task, const Person& person,
                                const StylusPreset& device,
                                const std::function<void(const TickReport&)>& tick);

/// Returns a line of ink along a path, 1 mm wide.
StrokePtr ink_along(std::vector<Point> path);

/// Returns a page with one layer that holds these strokes.
Result<Document> page_with(const std::vector<StrokePtr>& ink);

}  // namespace felt::bench
