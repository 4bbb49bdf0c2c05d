#pragma once

#include <string_view>

namespace felt {

/// The scripts of share/studies that analyse trials.csv.
std::string_view analysis_r() noexcept;
std::string_view analysis_python() noexcept;

}  // namespace felt
