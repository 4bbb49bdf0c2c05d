#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/studies/study_files.h"

namespace felt {

/// Returns the text of a preregistration in Markdown, made from the study: what is asked, the
/// design, the number of people and what they can show, the measures, the exclusions, the model and
/// the fingerprints of the study and of the program. Its headings follow the fields of the
/// preregistration of the Open Science Framework (https://osf.io/prereg). The same arguments give
/// the same text. Lines in brackets are left for the researcher.
///
/// `people` is the planned number of participants, 2 to kMaxParticipants. The fingerprint is that
/// of trials.csv (study_hash()), so that readers can see that the study was not changed. Fails if
/// the study has no hypothesis.
Result<std::string> preregistration_text(const StudyFiles& files, int people,
                                         const std::string& program);

}  // namespace felt
