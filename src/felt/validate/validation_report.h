#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

enum class Verdict : std::uint8_t {
  kPassed,
  kFailed,
  kNotPossible,  ///< could not be measured: no forces, nobody agreed, too much friction
  kNotRun,       ///< the test ended before this check
};

/// Returns "pass", "FAIL", "not possible" or "not run".
std::string_view name_of(Verdict verdict) noexcept;

struct CheckResult {
  std::string id;  ///< "force_sign"
  int level = 1;
  std::string title;  ///< for the user: "pushes in the right direction"
  Verdict verdict = Verdict::kNotRun;
  std::string measured;  ///< measured values with their units, one line
  std::string words;     ///< if the check did not pass: the reason, and what to try
};

/// The result of a device test. Users can send it to the project.
struct ValidationReport {
  std::string program;      ///< "feltline 0.1.0"
  DeviceDescriptor device;  ///< as found at the start of the test
  std::uint64_t seed = 0;
  int level = 10;
  std::string loop;  ///< how time passed: "virtual", or the scheduling that the system granted
  bool was_interrupted = false;
  std::vector<CheckResult> checks;

  /// Returns true if nothing failed and the test was not interrupted.
  [[nodiscard]] bool passed() const noexcept;
};

/// Returns the report as text: the device, a line for each check, and the reasons why checks did
/// not pass.
std::string report_text(const ValidationReport& report);

}  // namespace felt
