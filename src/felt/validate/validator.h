#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "felt/validate/test_loop.h"
#include "felt/validate/test_subject.h"
#include "felt/validate/validation_report.h"

namespace felt {

struct ValidationOptions {
  std::string program;     ///< name and version of the caller, for the report
  int level = 10;          ///< run the checks of levels 1 to `level`
  std::uint64_t seed = 1;  ///< random seed for the order of the axes in the checks that push
  int openings = 100;      ///< how often level 1 opens and closes the device
  double rate_s = 10.0;    ///< duration of measuring the loop's rate
  double soak_s = 60.0;    ///< duration of the soak test (level 10)
  /// Called every few ms; if it returns true, the test ends with zero force, and the report
  /// contains the checks done so far.
  std::function<bool()> is_cancelled = {};
  /// Called before each check.
  std::function<void(const CheckResult&)> on_begin = {};
  /// Called after each check.
  std::function<void(const CheckResult&)> on_end = {};
};

/// Tests a device (docs/design/devices.md#device-test):
///
///   level  checks
///   1      opens and closes repeatedly
///   2      identifies itself; its capabilities are plausible
///   3      rate of the loop, lateness, times of the samples
///   4      positions: finite, within reach, quiet while nobody moves the pen
///   5      a force is felt, and has the right sign on each axis
///   6      how soon and how calmly a step of force moves the pen
///   7      the safety chain's limits hold with this device
///   8      without communication, the force becomes zero; afterwards, forces begin gently
///   9      unplugging is noticed; the device works after it is plugged in again
///   10     a soak test: no fault, no energy gain
///
/// Levels from 5 on need forces. These are at most kTestForceN, pass the servo and its safety
/// chain, and are sent only after the person has agreed. The test is deterministic on a
/// VirtualTestLoop. Call it on the edit thread; it blocks until the test is over.
ValidationReport validate(TestSubject& subject, TestLoop& loop, TestPerson& person,
                          const ValidationOptions& options);

}  // namespace felt
