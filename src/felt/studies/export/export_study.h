#pragma once

#include <functional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/studies/study_folder.h"

namespace felt {

/// Writes everything that is known about a study into a new folder (docs/formats/study-export.md):
/// tables with their dictionaries, reports, scripts for the analysis, a BIDS data set, and copies
/// of the recordings. The same folder of a study gives the same files.
///
/// Writes into a hidden folder beside `out` first, and renames it at the end: so `out` is complete
/// or does not exist. Fails if `out` exists and is not an empty folder, if the study or a recording
/// is damaged, or if a file cannot be written; the message names the file. Unfinished sessions are
/// exported as they are, named in the report, and returned: "participant 3, train: 12 of 40
/// trials". `progress` receives the
/// finished share, 0..1, after each trial; if it returns false, nothing is written, and the result
/// is an error.
Result<std::vector<std::string>> export_study(const StudyFolder& folder, const std::string& out,
                                              const std::function<bool(double)>& progress = {});

}  // namespace felt
