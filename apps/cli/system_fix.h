#pragma once

#include <string>
#include <vector>

#include "doctor_report.h"
#include "felt/base/result.h"

namespace felt::cli {

/// A file that `doctor --fix` would write.
struct PlannedFix {
  enum class State {
    kNew,      ///< nothing is there
    kSame,     ///< it is there, as it should be
    kOurs,     ///< ours, and lacks something: it keeps its lines and gets those
    kForeign,  ///< somebody else's: left alone unless a person says otherwise
  };
  std::string path;      ///< with the prefix
  std::string content;   ///< with our mark
  std::string activate;  ///< command that puts it into effect; empty: none
  State state = State::kNew;
};

/// What the findings' fixes come to, each file once, with how it is now. A file of ours keeps the
/// lines that it has: findings are about what is connected now, and about this user. Paths begin
/// with `prefix`
/// (""; else nothing is activated). Error: a fix that we would not do: outside the folders for such
/// files, or with a command of its own. The findings come from a process that had a vendor's
/// library loaded, and what is decided here runs as root.
Result<std::vector<PlannedFix>> plan_fixes(const DoctorReport& report, const SystemView& system,
                                           const std::string& prefix);

/// What would be done, for the person who decides.
std::string plan_text(const std::vector<PlannedFix>& fixes);

/// Writes it: by itself where `prefix` was given or we are root, else through sudo or pkexec, which
/// ask. Says each command that it runs on stderr. Error: what could not be done; what was done
/// before stays.
Result<void> write_fix(const PlannedFix& fix, bool has_prefix);
/// Runs the commands that put files into effect, each once.
Result<void> activate_fixes(const std::vector<PlannedFix>& written);

}  // namespace felt::cli
