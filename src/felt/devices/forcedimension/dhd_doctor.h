#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt::dhd {

/// Returns what is present of Force Dimension and Novint, what is missing, and the next step: the
/// devices on USB, the permission to use them, the library. `named` as in library_names();
/// `last_refusal` is the library's message when this program could not open a device, or empty;
/// `library_refusal` is the reason why the driver rejected a library that loads (it lacks
/// functions), or empty.
std::vector<Finding> diagnose(const SystemView& system, const std::string& named,
                              const std::string& last_refusal,
                              const std::string& library_refusal = {});

}  // namespace felt::dhd
