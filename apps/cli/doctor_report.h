#pragma once

#include <string>
#include <vector>

#include "driver_processes.h"
#include "text_table.h"

namespace felt::cli {

/// The results of `feltline doctor`.
struct DoctorReport {
  std::vector<Finding> machine;  ///< about the computer itself; empty if drivers were named
  std::vector<DriverReport> drivers;
  bool is_named = false;  ///< the user named these drivers, so the report shows all of them
};

/// Returns the number of problems. If there are any, the exit code of `doctor` is 1.
std::size_t count_problems(const DoctorReport& report);

/// Returns the state of the system in one or two sentences.
std::string doctor_summary(const DoctorReport& report);

/// Returns the whole report: the summary, the drivers with problems, the drivers without problems,
/// and last the drivers that have no device on this computer. The findings about the computer
/// itself come after the drivers with problems if they contain a problem, otherwise after the other
/// drivers. Steps are numbered, each command is on a separate line, and messages of libraries and
/// the system are quoted unchanged. `style.width` 0 means 80 columns, because this is a text for
/// people.
std::string doctor_text(const DoctorReport& report, const TextStyle& style);

/// Returns the whole report as one line of JSON.
std::string doctor_json(const DoctorReport& report);

}  // namespace felt::cli
