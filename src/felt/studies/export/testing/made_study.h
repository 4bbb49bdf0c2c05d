#pragma once

#include <string>

#include "felt/studies/export/study_results.h"

namespace felt::testing {

/// Results of a study that nobody took part in: errors are random numbers, and the second condition
/// has 0.8 times the error of the first one.
struct MadeStudy {
  std::string text = kStudyText;  ///< of the study file
  int people = 12;
  bool is_simulated = true;
  int invalid_every = 0;  ///< every so many trials one is invalid; 0: none; 1: all

  static const char* const kStudyText;
};
StudyResults made_results(const MadeStudy& made = {});

}  // namespace felt::testing
