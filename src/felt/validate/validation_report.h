#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

enum class Verdict : std::uint8_t {
  kPassed,
  kFailed,
  kNotPossible,  ///< could not be measured here: no forces, nobody agreed, too much friction
  kNotRun,       ///< the test was ended before
};

/// "pass", "FAIL", "not possible", "not run".
std::string_view name_of(Verdict verdict) noexcept;

struct CheckResult {
  std::string id;  ///< "force_sign"
  int level = 1;
  std::string title;  ///< for people: "pushes the way it is told"
  Verdict verdict = Verdict::kNotRun;
  std::string measured;  ///< figures with their units, one line
  std::string words;     ///< where it did not pass: why, and what to try
};

/// What came of a device test; what people send in.
struct ValidationReport {
  std::string program;      ///< "feltline 0.1.0"
  DeviceDescriptor device;  ///< as it was found
  std::uint64_t seed = 0;
  int level = 10;
  std::string loop;  ///< how time passed: virtual, or as the system allowed it
  bool was_interrupted = false;
  std::vector<CheckResult> checks;

  /// Nothing failed, and it was not interrupted.
  [[nodiscard]] bool passed() const noexcept;
};

/// The report for people: what was tested, a line for each check, why what did not pass did not.
std::string report_text(const ValidationReport& report);

}  // namespace felt
