#pragma once

#include <string>

namespace felt {

/// Returns true if both paths name the same regular file, also through symbolic or hard links, or
/// will name the same file once that file is written. Returns false for pipes and devices, because
/// several writers may share them.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace felt
