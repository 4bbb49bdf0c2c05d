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
  int level = 10;          ///< checks of levels 1 to this one
  std::uint64_t seed = 1;  ///< orders what needs no order of its own
  int openings = 100;
  double rate_s = 10.0;  ///< how long the loop's rate is measured
  double soak_s = 60.0;  ///< level 10
  /// Asked every few ms; true ends the test with no force: the report says what was done.
  std::function<bool()> is_cancelled = {};
  /// Told before each check.
  std::function<void(const CheckResult&)> on_begin = {};
  /// And after it.
  std::function<void(const CheckResult&)> on_end = {};
};

/// Tests a device (reliability.md 6.3 for devices):
///
///   level  checks
///   1      opens and closes, again and again
///   2      says who it is; what it says it can do makes sense
///   3      rate of the loop, lateness, times of the samples
///   4      places: finite, within reach, quiet while nobody moves
///   5      a force is felt; it pushes the way it is told, on each axis
///   6      how soon and how calmly a step of force moves the pen
///   7      the safety chain's limits hold at this device
///   8      nobody speaks to it: it goes limp; and after that, forces begin gently
///   9      unplugged: noticed; plugged in again: works
///   10     a soak: no fault, no energy out of nowhere
///
/// Levels from 5 on need forces: kTestForceN at most, through servo and safety chain, and only
/// after the person agreed. Deterministic on a virtual loop. Edit thread; blocks until it is over.
ValidationReport validate(TestSubject& subject, TestLoop& loop, TestPerson& person,
                          const ValidationOptions& options);

}  // namespace felt
