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

/// Returns the whole report: the summary, then the drivers with problems, then the other drivers,
/// and last the drivers without a device on this computer. Steps are numbered, commands have lines
/// of their own, and messages of libraries and the system are quoted unchanged. `style.width` 0
/// means 80 columns, because this is a text for people.
std::string doctor_text(const DoctorReport& report, const TextStyle& style);

/// Returns the whole report as one line of JSON.
std::string doctor_json(const DoctorReport& report);

}  // namespace felt::cli
