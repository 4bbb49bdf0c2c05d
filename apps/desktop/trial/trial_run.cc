#include "desktop/trial/trial_run.h"

#include <utility>

#include "desktop/engine/device_words.h"
#include "desktop/engine/text_of.h"
#include "desktop/trial/unfinished_trials.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/trial_setup.h"

namespace felt::desktop {

TrialRun::TrialRun(StudyFolder folder, StudySession session, Studio& studio)
    : folder_(std::move(folder)), session_(std::move(session)), studio_(studio) {
  studio_.loop().set_forces(false);
  connect(&studio_.loop(), &HapticLoop::device_status_changed, this, &TrialRun::check_device);
}

void TrialRun::begin(const TrialStep& step) {
  step_ = step;
  had_fault_ = false;
  const std::string name = unfinished_name(step.trial.number, step.attempt);
  recorder_ = std::make_unique<TrialRecorder>(
      studio_, QString::fromStdString(folder_.file_of(session_.info, name)));
  connect(recorder_.get(), &TrialRecorder::touched, this, &TrialRun::touched);
  studio_.start_over(Page{});
  const Rgba ink = studio_.session().ink_color();
  for (Event& event : setup_events(files(), step.trial, studio_.session().device(), ink)) {
    studio_.apply(std::move(event.what));
  }
  // A surface of the condition changes the colour of the paper, which would be a second difference
  // between the conditions.
  Page page = studio_.page();
  page.paper = Page{}.paper;
  studio_.set_page(page);
  studio_.loop().set_forces(files().study.conditions[step.trial.condition].forces !=
                            StudyForces::kAir);
}

void TrialRun::check_device(const DeviceStatus& status) {
  if (!recorder_ || !status.fault) return;
  had_fault_ = true;
  const DeviceWords words =
      words_for(*status.fault, studio_.loop().device().info().label, status, false);
  Q_EMIT device_failed(words.what);
}

std::string TrialRun::rule_broken_by(const FeltRecording& recording) const {
  const std::vector<TrialSample> samples = trial_samples(recording);
  const TrialMetrics metrics = measure_recorded_trial(files(), step_.trial, samples);
  return broken_rule(files().study.catch_rules, metrics, metrics.path_length_mm.value_or(0.0),
                     had_fault_);
}

/// Ends the trial in progress. Afterwards result_ and drawing_ have everything to be saved.
void TrialRun::end_trial() {
  studio_.finish_gesture();
  studio_.loop().set_forces(false);
  FeltRecording recording = recorder_->take();
  result_ = {step_.trial.number, step_.attempt, rule_broken_by(recording), {}};
  drawing_ = {};
  drawing_.document = studio_.session().document();
  drawing_.page = studio_.page();
  const Result<void> added = add_recording(drawing_, std::move(recording));
  // The recorder has only numbers that add_recording() accepts.
  if (!added) qFatal("trial %d: %s", result_.trial, added.error().message.c_str());
}

Result<void> TrialRun::finish() {
  end_trial();
  return save();
}

Result<void> TrialRun::interrupt() {
  const bool is_empty = !has_contact();
  end_trial();
  result_.invalid = kInterrupted;
  if (!is_empty) return save();
  recorder_->remove_file();
  recorder_.reset();
  return {};
}

Result<void> TrialRun::save() {
  if (auto saved = folder_.add_trial(session_, result_, drawing_); !saved) return saved;
  recorder_->remove_file();
  recorder_.reset();
  drawing_ = {};
  return {};
}

Result<void> TrialRun::answer(const QuestionStep& step, std::vector<double> values) {
  return folder_.add_answers(session_, {step.after_trial, step.form, std::move(values)});
}

}  // namespace felt::desktop
