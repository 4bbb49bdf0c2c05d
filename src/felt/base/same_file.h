#pragma once

#include <string>

namespace felt {

/// True if two paths name one regular file, through links of both kinds too, or will name one once
/// it is written. Pipes and devices are never the same: several may write to them.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace felt
