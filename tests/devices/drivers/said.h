#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// Returns the text of a doctor's findings, one line for each finding and each step, for tests that
/// search for words.
inline std::string said(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) {
    text += std::to_string(static_cast<int>(f.level)) + " " + f.what + " | " + f.details + "\n";
    for (const std::string& step : f.steps) text += "  - " + step + "\n";
  }
  return text;
}

}  // namespace felt
