#pragma once

/// The file session.json of a session (docs/formats/study-folder.md). Internal: StudyFolder reads
/// and writes it.

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/studies/study_folder.h"

namespace felt {

/// The largest size of the file.
inline constexpr std::size_t kMaxSessionBytes = std::size_t{16} << 20;
inline constexpr int kSessionVersion = 1;
/// The largest TrialResult::attempt. Interrupted trials may exceed CatchRules::max_repeats.
inline constexpr int kMaxAttempts = 999;

constexpr std::string_view session_name(SessionKind session) noexcept {
  return kSessionKinds[static_cast<std::size_t>(session)];
}

/// Returns the name of the file with a trial: "trial-0001.felt", or "trial-0001-2.felt" for the
/// second attempt.
std::string recording_name(const TrialResult& result);

/// Checks a session against its study. Fails if a text is not one line of at most 200 bytes, a
/// trial was not planned or occurs twice, an attempt is missing, the reason of an invalid trial is
/// unknown, or answers do not fit a questionnaire of the study. Requires that the plan is that of
/// plan_trials().
Result<void> check_session(const StudySession& session, const Study& study);

/// Returns the text of the file. Requires a session that check_session() accepts.
std::string session_to_json(const StudySession& session, const Study& study);

/// Reads a session and makes its plan. `expected` has the participant and the session that the file
/// must be about. Fails if the text is not JSON, has an unknown version or key, lacks a key, or if
/// check_session() refuses the session. Messages do not have the name of the file.
Result<StudySession> session_from_json(std::string_view text, const Study& study,
                                       const SessionInfo& expected);

}  // namespace felt
