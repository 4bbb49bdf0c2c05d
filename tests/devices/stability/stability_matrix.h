#pragma once

#include <string>
#include <vector>

#include "tests/devices/stability/stability_cell.h"

namespace felt {

/// Returns every trial of every hand (and of a hand that releases the pen) with every
/// device,
/// delays of 0, 1 and 2 ticks, 1, 4 and 5 kHz, all surfaces, pencil and eraser. All other media are
/// tried at 1 kHz with a delay of 1 tick. The trials of guides of a drawing use every device,
/// paper and a pencil, 1 kHz with 0, 1 and 2 ticks and 5 kHz with 1 tick.
std::vector<StabilityCell> all_cells();

/// Returns the part of `cells` that a test has time for: five devices, three hands, 1 kHz with a
/// delay of 1 and 2 ticks, 5 kHz with 1 tick, paper and blackboard, pencil and eraser. At 1 kHz
/// with 1 tick it also contains every medium: on every surface for a typical hand with the touch,
/// and on paper and blackboard for a light hand with the worst device. Of guides of a drawing, it
/// contains the same devices, hands and loops.
std::vector<StabilityCell> representative_cells(const std::vector<StabilityCell>& cells);

/// Runs the cells on several threads. The results are in the order of the cells.
std::vector<StabilityResult> run_cells(const std::vector<StabilityCell>& cells, unsigned threads);

/// Returns the text of the report, docs/stability.md.
std::string stability_report(const std::vector<StabilityCell>& cells,
                             const std::vector<StabilityResult>& results);

/// Returns the names of the failing cells that are listed in a report.
std::vector<std::string> failing_names(const std::string& report);

}  // namespace felt
