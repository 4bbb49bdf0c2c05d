#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/studies/study_files.h"

namespace felt::bench {

/// Reads a study and leaves out the shapes that are not traced, so that all trials have errors of
/// the same kind. The traced shapes keep their random numbers if they come first in the study.
Result<StudyFiles> read_traced_study(const std::string& path);

}  // namespace felt::bench
