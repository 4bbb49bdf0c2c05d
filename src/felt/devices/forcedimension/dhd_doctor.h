#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt::dhd {

/// Checks the devices of Force Dimension and Novint on USB, the permission to use them, and the
/// library. Returns the findings with the next step for the user. `named` is the same as in
/// library_names(). `last_refusal` is the library's message if this program could not open a
/// device; otherwise it is empty. `library_refusal` is the reason why the driver rejected a library
/// that can be loaded (functions are missing); it is empty if the driver rejected none.
std::vector<Finding> diagnose(const SystemView& system, const std::string& named,
                              const std::string& last_refusal,
                              const std::string& library_refusal = {});

}  // namespace felt::dhd
