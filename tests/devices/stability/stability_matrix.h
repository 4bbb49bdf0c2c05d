#pragma once

#include <string>
#include <vector>

#include "tests/devices/stability/stability_cell.h"

namespace felt {

/// Every trial of every hand (and of one that lets go) with seven devices, delays of 0, 1 and 2
/// ticks, 1, 4 and 5 kHz, all surfaces, pencil and eraser; all other media at 1 kHz with 1 tick.
std::vector<StabilityCell> all_cells();

/// Those of `cells` that a test can afford: five devices, three hands, the loops 1 kHz with 1 and 2
/// ticks of delay and 5 kHz with 1, paper and blackboard, pencil and eraser. At 1 kHz and 1 tick
/// further every medium: on every surface with a typical hand on the touch, and on those two with a
/// light hand on the worst device.
std::vector<StabilityCell> representative_cells(const std::vector<StabilityCell>& cells);

/// Runs the cells on several threads. The results are in the order of the cells.
std::vector<StabilityResult> run_cells(const std::vector<StabilityCell>& cells, unsigned threads);

/// The report: docs/stability.md.
std::string stability_report(const std::vector<StabilityCell>& cells,
                             const std::vector<StabilityResult>& results);

/// The names of the failing cells that a report lists.
std::vector<std::string> failing_names(const std::string& report);

}  // namespace felt
