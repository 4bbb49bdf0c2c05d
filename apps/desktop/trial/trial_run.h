#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/trial/session_steps.h"
#include "desktop/trial/trial_recorder.h"
#include "felt/studies/study_folder.h"

namespace felt::desktop {

/// A session of a study: prepares the studio for each trial, records the trial, and saves it.
///
///   while (!std::holds_alternative<SessionEnd>(run.next())) {
///     run.begin(trial_step);    // then the participant draws
///     run.finish();             // or run.interrupt()
///   }
///
/// Shows nothing. The studio must outlive it.
class TrialRun : public QObject {
  Q_OBJECT

 public:
  /// The session was begun in this folder (StudyFolder::begin_session). The studio has
  /// StudioOptions::reads_forces.
  TrialRun(StudyFolder folder, StudySession session, Studio& studio);

  [[nodiscard]] const StudyFiles& files() const noexcept { return folder_.files(); }
  [[nodiscard]] const StudySession& session() const noexcept { return session_; }
  [[nodiscard]] SessionStep next() const { return next_step(files().study, session_); }

  /// Starts a trial: an empty page with the options of its condition, and its forces on or off.
  /// Requires that no trial is in progress.
  void begin(const TrialStep& step);
  [[nodiscard]] bool is_trial_in_progress() const noexcept { return recorder_ != nullptr; }
  /// Returns true if the pen has touched the surface in the trial in progress.
  [[nodiscard]] bool has_contact() const noexcept { return recorder_ && recorder_->has_contact(); }
  /// Ends the trial in progress, switches the forces off, and saves the trial with the catch rule
  /// that it broke. If this fails, nothing is lost: call save() to try again.
  Result<void> finish();
  /// Does the same for a trial that the participant did not finish. A trial in which the pen has
  /// not touched the surface is not saved.
  Result<void> interrupt();
  /// Saves the trial that finish() or interrupt() could not save.
  Result<void> save();
  /// Saves the answers to a questionnaire.
  Result<void> answer(const QuestionStep& step, std::vector<double> values);

 Q_SIGNALS:
  /// Emitted when the pen touches the surface for the first time in a trial.
  void touched();
  /// Emitted when the device fails during a trial, with a text for the researcher.
  void device_failed(const QString& text);

 private:
  void end_trial();
  [[nodiscard]] std::string rule_broken_by(const FeltRecording& recording) const;
  void check_device(const DeviceStatus& status);

  StudyFolder folder_;
  StudySession session_;
  Studio& studio_;
  TrialStep step_;
  std::unique_ptr<TrialRecorder> recorder_;  // null if no trial is in progress
  TrialResult result_;                       // of the trial to be saved
  Drawing drawing_;
  bool had_fault_ = false;
};

}  // namespace felt::desktop
