#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt::bench {

/// Simulated people of each model (PersonModel) take part in share/studies/improving-sketching.toml
/// with each device, and draw the same shapes with a tablet. Prints how the default forces change
/// their errors, compared with a pen in the air, with the plane alone and with the tablet.
Result<void> compare_baselines(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
