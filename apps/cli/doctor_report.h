#pragma once

#include <string>
#include <vector>

#include "driver_look.h"
#include "text_table.h"

namespace felt::cli {

/// All that the doctor saw.
struct DoctorReport {
  std::vector<Finding> machine;  ///< of the computer itself; none where drivers were named
  std::vector<DriverLook> drivers;
  bool is_named = false;  ///< asked about these drivers by name: nothing is left out
};

/// Things that hinder: the exit code is 1 with any.
std::size_t count_problems(const DoctorReport& report);

/// How things are, in one or two sentences.
std::string doctor_summary(const DoctorReport& report);

/// The whole report: the summary, then families with something to mend, then the others, in the end
/// what is not here. Steps are numbered, commands stand alone on their lines, what a library or the
/// system said is verbatim. `style.width` 0 is 80 columns: it is text for people.
std::string doctor_text(const DoctorReport& report, const TextStyle& style);

/// One line of JSON with all of it.
std::string doctor_json(const DoctorReport& report);

}  // namespace felt::cli
