#pragma once

#include <string>

namespace felt {

/// The report docs/materials.md, measured here and now; the same figures on each run.
std::string materials_report();

}  // namespace felt
