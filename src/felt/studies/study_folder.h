#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/store/felt_recording.h"
#include "felt/studies/study_files.h"
#include "felt/trial/study_order.h"

namespace felt {

/// One session of one participant.
struct SessionInfo {
  int participant = 1;
  SessionKind session = SessionKind::kTrain;
  std::string device;   ///< shown to the user
  std::string program;  ///< with its version
  /// When the session began, in UTC, as ISO 8601; empty for a simulated person.
  std::string started = {};
  std::optional<std::uint64_t> person_seed = {};  ///< of a simulated person (person_of())
  std::string person_model = {};  ///< of a simulated person (person_model_name()), or empty
  friend bool operator==(const SessionInfo&, const SessionInfo&) = default;
};

/// A finished trial.
struct TrialResult {
  int trial = 1;             ///< PlannedTrial::number
  int attempt = 1;           ///< greater than 1 if the trial was repeated
  std::string invalid = {};  ///< the catch rule that the trial broke, "interrupted", or empty
  std::string recording;     ///< the name of the file in the folder of the session
  /// Of the bytes of this file (fingerprint_of()), so that the recording of another trial is not
  /// taken for it; empty in folders of before there were fingerprints.
  std::string fingerprint = {};
  friend bool operator==(const TrialResult&, const TrialResult&) = default;
};

/// Returns the fingerprint (FNV-1a) of bytes as text: "fnv1a-" and 16 hexadecimal digits.
std::string fingerprint_of(std::string_view bytes);

/// The answers to one questionnaire, in the order of its items.
struct QuestionAnswers {
  int after_trial = 1;
  Questionnaire form = Questionnaire::kNasaTlx;
  std::vector<double> values;
  friend bool operator==(const QuestionAnswers&, const QuestionAnswers&) = default;
};

/// What is known about a session: the trials that were planned, and those that are finished.
struct StudySession {
  SessionInfo info;
  std::vector<PlannedTrial> plan;
  std::vector<TrialResult> results;  ///< in the order in which they were finished
  std::vector<QuestionAnswers> answers;
  friend bool operator==(const StudySession&, const StudySession&) = default;
};

/// TrialResult::invalid of a trial that the participant or the program ended early.
inline constexpr std::string_view kInterrupted = "interrupted";

/// Returns the number of items of a questionnaire.
std::size_t item_count(Questionnaire form) noexcept;
/// The allowed answers to an item: a whole number from `min` to `max`.
struct ItemRange {
  int min = 0;
  int max = 0;
};
/// Returns 0 to 100 for the NASA-TLX. Returns 1 to 7 for the UEQ-S; 1 is the left end of the scale.
ItemRange item_range(Questionnaire form) noexcept;

/// The attempts at one trial of a session.
struct TrialAttempts {
  int last = 0;             ///< the number of the last attempt; 0 if there is none
  int invalid = 0;          ///< how many broke a catch rule
  bool has_valid = false;   ///< one attempt broke no rule and was not interrupted
  std::string broken_rule;  ///< by the last attempt that was not interrupted

  /// Returns true if the trial needs no further attempt.
  [[nodiscard]] bool is_done(const CatchRules& rules) const noexcept;
};
TrialAttempts attempts_of(const StudySession& session, int trial);

/// Returns the number of trials of a session that need no further attempt.
std::size_t done_trials(const StudySession& session, const CatchRules& rules);

/// The folder with the results of a study. Format: docs/formats/study-folder.md. Nothing that was
/// added is changed later: a session that exists is continued, not replaced. Use it from one thread
/// and one program at a time.
class StudyFolder {
 public:
  /// Creates the folder, with copies of the study and of the files that it names. Fails if the
  /// folder exists and is not empty, or if it cannot be written.
  static Result<StudyFolder> create(const std::string& path, StudyFiles files);
  /// Opens a folder that create() made. Fails if it is not the folder of a study.
  static Result<StudyFolder> open(const std::string& path);

  /// Creates the folder if it does not exist or is empty. Otherwise opens it; fails if its study,
  /// or a file that the study names, differs from `files` by one byte. The name of the study's file
  /// may differ.
  static Result<StudyFolder> open_or_create(const std::string& path, StudyFiles files);

  [[nodiscard]] const StudyFiles& files() const noexcept { return files_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

  /// Begins a session, or continues it if it exists: then the device and the program of `info` are
  /// those of the first call. Fails if the participant or the session does not fit the study, or if
  /// the existing session is damaged.
  Result<StudySession> begin_session(const SessionInfo& info);
  /// Saves a finished trial. Sets `result.recording` and `result.fingerprint`. When this returns,
  /// the trial is on the disk. `drawing` has the recording of the trial (add_recording()). Fails if
  /// the session was not begun, or if this attempt exists already.
  Result<void> add_trial(StudySession& session, TrialResult result, const Drawing& drawing);
  /// Saves the answers to a questionnaire, in the same way.
  Result<void> add_answers(StudySession& session, QuestionAnswers answers);

  /// Returns all sessions, ordered by participant and then in the order of Study::sessions. Fails
  /// with the name of the file if one is damaged or does not fit the study.
  [[nodiscard]] Result<std::vector<StudySession>> sessions() const;
  /// Returns the full name of a file in the folder of a session.
  [[nodiscard]] std::string file_of(const SessionInfo& info, const std::string& name) const;
  /// Reads the recording of a trial.  Fails if the file is not a regular file, is damaged, or does
  /// not belong to this trial: its fingerprint differs or, if the session has none, an option or
  /// the guide at its start is not that of the trial's condition. If `bytes` is not null, it
  /// receives the content of the file.
  [[nodiscard]] Result<FeltRecording> recording(const SessionInfo& info, const TrialResult& result,
                                                std::string* bytes = nullptr) const;

 private:
  StudyFolder(std::string path, StudyFiles files);
  [[nodiscard]] Result<StudySession> read_session(const SessionInfo& info) const;
  [[nodiscard]] Result<void> write_session(const StudySession& session) const;
  [[nodiscard]] Result<void> check_begun(const SessionInfo& info) const;

  std::string path_;
  StudyFiles files_;
};

}  // namespace felt
