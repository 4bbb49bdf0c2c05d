#pragma once

#include <string>

namespace felt {

/// Makes all measurements and returns the text of docs/materials.md. Each run gives the same
/// figures.
std::string materials_report();

}  // namespace felt
