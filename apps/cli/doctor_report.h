#pragma once

#include <string>
#include <vector>

#include "driver_look.h"
#include "text_table.h"

namespace felt::cli {

/// Everything that the doctor found.
struct DoctorReport {
  std::vector<Finding> machine;  ///< about the computer itself; empty if drivers were named
  std::vector<DriverLook> drivers;
  bool is_named = false;  ///< the user named these drivers: nothing is left out
};

/// Returns the number of problems. The exit code is 1 if there are any.
std::size_t count_problems(const DoctorReport& report);

/// Returns the state of the system in one or two sentences.
std::string doctor_summary(const DoctorReport& report);

/// Returns the whole report: the summary, then the drivers with problems, then the others, finally
/// those whose devices are not on this computer. Steps are numbered, commands have lines of their
/// own, messages of libraries and the system are verbatim. `style.width` 0 means 80 columns,
/// because it is text for people.
std::string doctor_text(const DoctorReport& report, const TextStyle& style);

/// Returns all of it as one line of JSON.
std::string doctor_json(const DoctorReport& report);

}  // namespace felt::cli
