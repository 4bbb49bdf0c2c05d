#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// All that a doctor's findings say, a line each and one a step, for tests that look for words.
inline std::string said(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) {
    text += std::to_string(static_cast<int>(f.level)) + " " + f.what + " | " + f.details + "\n";
    for (const std::string& step : f.steps) text += "  - " + step + "\n";
  }
  return text;
}

}  // namespace felt
