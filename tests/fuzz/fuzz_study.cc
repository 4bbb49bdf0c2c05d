/// Reads any bytes as the text of a study. The reader must not crash, and every session of an
/// accepted study must have a plan with the announced number of trials.

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/trial/study_file.h"
#include "felt/trial/study_order.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Study> study = read_study(text);
  const std::vector<Error> problems = study_problems(text);
  FELT_CHECK(study.has_value() == problems.empty());
  FELT_CHECK(problems.size() <= kMaxStudyProblems);
  for (const Error& error : problems) FELT_CHECK(error.message.starts_with("study:"));
  if (!study) return 0;
  FELT_CHECK(study->conditions.size() <= kMaxStudyConditions);
  FELT_CHECK(study->shapes.size() <= kMaxStudyShapes);
  for (const SessionKind session : study->sessions) {
    const auto trials = plan_trials(*study, 1, session);
    FELT_CHECK(trials.has_value());
    FELT_CHECK(trials->size() == trial_count(*study, session));
    FELT_CHECK(trials->size() <= kMaxSessionTrials);
  }
  return 0;
}
