#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/person.h"
#include "report.h"

namespace felt::bench {

/// Compares simulated people with published results, and prints a bar for each
/// (docs/design/simulation.md#acceptance):
///   V1  drawing in the air and on a plane;
///   V2  small writing on a smooth and on a rough surface;
///   V3  stopping at a target with and without friction;
///   V4  how fast the error of a line changes.
void check_acceptance(const std::string& model, const std::vector<Person>& people, Report& report);

}  // namespace felt::bench
