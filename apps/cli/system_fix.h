#pragma once

#include <string>
#include <vector>

#include "doctor_report.h"
#include "felt/base/result.h"

namespace felt::cli {

/// A file that `doctor --fix` would write.
struct PlannedFix {
  enum class State {
    kNew,   ///< the file does not exist
    kSame,  ///< the file has the right content
    kOurs,  ///< written by Feltline, but lines are missing; the fix adds these and keeps the other
            ///< lines
    kForeign,  ///< not written by Feltline; changed only if the user agrees
  };
  std::string path;      ///< with the prefix
  std::string content;   ///< begins with the line that marks the file as Feltline's
  std::string activate;  ///< command that activates it; empty if not needed
  State state = State::kNew;
};

/// Returns the files that the fixes of the findings would write, with their current states. Each
/// file is returned once. A file that Feltline wrote earlier keeps its lines, because the findings
/// are only about the devices that are connected now and about this user. Paths begin with
/// `prefix`. If `prefix` is not empty, `activate` is empty in all results. Fails if a fix is not
/// allowed, because its file is outside the folders for such files or because its command is not
/// one that Feltline runs as root. The check is needed because the findings come from a process
/// with a vendor's library, and the fixes run as root.
Result<std::vector<PlannedFix>> plan_fixes(const DoctorReport& report, const SystemView& system,
                                           const std::string& prefix);

/// Returns a description of the planned changes, so that the user can decide.
std::string plan_text(const std::vector<PlannedFix>& fixes);

/// Writes the file directly if `has_prefix` is true or the user is root; otherwise runs sudo or
/// pkexec, which ask for a password. Prints to stderr each command that it runs. Fails if a step
/// fails; earlier steps are not undone.
Result<void> write_fix(const PlannedFix& fix, bool has_prefix);
/// Runs the commands that activate the files. Runs each command once.
Result<void> activate_fixes(const std::vector<PlannedFix>& written);

}  // namespace felt::cli
