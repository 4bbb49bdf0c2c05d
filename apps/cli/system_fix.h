#pragma once

#include <string>
#include <vector>

#include "doctor_report.h"
#include "felt/base/result.h"

namespace felt::cli {

/// A file that `doctor --fix` would write.
struct PlannedFix {
  enum class State {
    kNew,      ///< no file exists
    kSame,     ///< the file has the right content
    kOurs,     ///< our file, incomplete: it keeps its lines and gets the missing ones
    kForeign,  ///< written by somebody else: not changed unless the user agrees
  };
  std::string path;      ///< with the prefix
  std::string content;   ///< with our mark
  std::string activate;  ///< command that activates it; empty: none
  State state = State::kNew;
};

/// Returns the files that the findings' fixes need, each once, with its current state. A file of
/// ours keeps its lines, because findings are only about devices that are connected now and about
/// this user. Paths begin with `prefix`; if it is not "", nothing is activated. Fails for a fix
/// that we refuse: outside the folders for such files, or with a command of its own. The check is
/// needed because the findings come from a process with a vendor's library, and the fixes run as
/// root.
Result<std::vector<PlannedFix>> plan_fixes(const DoctorReport& report, const SystemView& system,
                                           const std::string& prefix);

/// Returns a description of the planned changes, for the user to decide.
std::string plan_text(const std::vector<PlannedFix>& fixes);

/// Writes the file: directly if `prefix` was given or we are root, otherwise through sudo or
/// pkexec, which ask. Prints each command that it runs on stderr. Fails if a step fails; earlier
/// steps are not undone.
Result<void> write_fix(const PlannedFix& fix, bool has_prefix);
/// Runs the commands that activate files, each once.
Result<void> activate_fixes(const std::vector<PlannedFix>& written);

}  // namespace felt::cli
