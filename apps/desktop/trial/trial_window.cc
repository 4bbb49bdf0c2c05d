#include "desktop/trial/trial_window.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QMessageBox>
#include <algorithm>

#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

/// Returns the reason for a repeat, for the participant.
QString repeat_text(const std::string& rule) {
  if (rule == "min_length_share") {
    return TrialWindow::tr(
        "The line was much shorter than the shape. Please draw the whole shape.");
  }
  if (rule == "max_lifts") {
    return TrialWindow::tr("The pen was lifted often. Please keep it on the page.");
  }
  if (rule == "left_tunnel") {
    return TrialWindow::tr("The pen left the tunnel. Please stay between the walls.");
  }
  if (rule == "max_mm_per_s") {
    return TrialWindow::tr("That was very fast. Please draw a little more slowly.");
  }
  return TrialWindow::tr("The device had a problem. It was not your fault.");
}

}  // namespace

TrialWindow::TrialWindow(TrialRun& run, Studio& studio)
    : run_(run),
      stack_(new QStackedLayout(this)),
      message_(new MessageScreen),
      trial_(new TrialScreen(studio)),
      questions_(new QuestionScreen),
      step_(run.next()) {
  setWindowTitle(text_of(run.files().study.label));
  for (QWidget* screen : {static_cast<QWidget*>(message_), static_cast<QWidget*>(trial_),
                          static_cast<QWidget*>(questions_)}) {
    stack_->addWidget(screen);
  }
  connect(message_, &MessageScreen::proceeded, this, &TrialWindow::proceed_from_message);
  connect(trial_, &TrialScreen::done, this, &TrialWindow::finish_trial);
  connect(questions_, &QuestionScreen::answered, this, [this] {
    const auto* step = std::get_if<QuestionStep>(&step_);
    if (step && keep_trying(run_.answer(*step, questions_->answers()))) go_on();
  });
  connect(&run_, &TrialRun::touched, trial_, &TrialScreen::begin_drawing);
  connect(&run_, &TrialRun::device_failed, trial_, &TrialScreen::show_problem);
  connect(&studio, &Studio::refused, trial_, &TrialScreen::show_problem);
  show_welcome(studio.session().device().has_force());
}

void TrialWindow::show_welcome(bool device_has_force) {
  const StudyFiles& files = run_.files();
  std::vector<StudyTask> tasks;
  bool has_forces = false;
  for (const PlannedTrial& trial : run_.session().plan) {
    const StudyTask task = files.study.shapes[trial.shape].task;
    if (std::find(tasks.begin(), tasks.end(), task) == tasks.end()) tasks.push_back(task);
    has_forces = has_forces || files.study.conditions[trial.condition].forces != StudyForces::kAir;
  }
  QStringList lines;
  for (const StudyTask task : tasks) lines.push_back(task_text(task));
  lines.push_back(tr("After each drawing, press Space or the button “Done”."));
  if (has_forces && device_has_force)
    lines.push_back(tr("You may feel forces in the pen. Hold it before you begin."));
  message_->show_message(text_of(files.study.label), lines.join(QStringLiteral("\n\n")),
                         run_.session().results.empty() ? tr("Begin") : tr("Continue"));
  stack_->setCurrentWidget(message_);
}

/// Shows what comes next.
void TrialWindow::go_on() {
  step_ = run_.next();
  if (std::holds_alternative<TrialStep>(step_)) return show_before_trial();
  if (const auto* question = std::get_if<QuestionStep>(&step_)) {
    questions_->show_form(question->form, condition_of(*question));
    stack_->setCurrentWidget(questions_);
    return;
  }
  is_finished_ = true;
  message_->show_message(tr("Thank you!"), tr("You have finished. Please tell the researcher."),
                         tr("Close"));
  stack_->setCurrentWidget(message_);
}

/// Shows a rest, or the reason why a trial is repeated; if there is neither, the trial.
void TrialWindow::show_before_trial() {
  const TrialStep& step = std::get<TrialStep>(step_);
  if (!step.broken_rule.empty()) {
    message_->show_message(tr("Please draw this one again"), repeat_text(step.broken_rule),
                           tr("Again"));
  } else if (step.trial.rest_before_s > 0.0 && step.attempt == 1) {
    message_->show_rest(tr("Please rest a little"), tr("Relax your hand and your arm."),
                        tr("Continue"), step.trial.rest_before_s);
  } else {
    return begin_trial();
  }
  stack_->setCurrentWidget(message_);
}

void TrialWindow::begin_trial() {
  const TrialStep& step = std::get<TrialStep>(step_);
  stack_->setCurrentWidget(trial_);
  trial_->show_trial(run_.files(), step.trial, run_.session().plan.size());
  run_.begin(step);
  trial_->canvas().fit_page();
}

void TrialWindow::finish_trial() {
  if (run_.has_contact() && keep_trying(run_.finish())) go_on();
}

/// Asks the researcher what to do until a result is saved. Returns false if the session ends.
bool TrialWindow::keep_trying(Result<void> saved) {
  while (!saved) {
    const auto pressed = QMessageBox::critical(
        this, windowTitle(), tr("This cannot be saved: %1").arg(text_of(saved.error())),
        QMessageBox::Retry | QMessageBox::Close, QMessageBox::Retry);
    if (pressed == QMessageBox::Close) {
      // The file of the trial in progress stays, so that the next start recovers it.
      has_ended_ = true;
      Q_EMIT ended();
      return false;
    }
    const auto* question = std::get_if<QuestionStep>(&step_);
    saved = question ? run_.answer(*question, questions_->answers()) : run_.save();
  }
  return true;
}

QString TrialWindow::condition_of(const QuestionStep& step) const {
  if (run_.files().study.question_time == QuestionTime::kSession) return {};
  const auto& plan = run_.session().plan;
  const auto at = std::find_if(plan.begin(), plan.end(), [&](const PlannedTrial& trial) {
    return trial.number == step.after_trial;
  });
  return at == plan.end() ? QString() : text_of(at->shown_condition);
}

void TrialWindow::proceed_from_message() {
  if (is_finished_) {
    has_ended_ = true;
    Q_EMIT ended();
  } else if (!has_begun_) {
    has_begun_ = true;
    go_on();
  } else {
    begin_trial();
  }
}

/// Does what the button of the screen does.
void TrialWindow::proceed() {
  if (shown_screen() == message_) return message_->proceed();
  if (shown_screen() == questions_) return questions_->proceed();
  finish_trial();
}

void TrialWindow::stop() {
  if (has_ended_) return;
  if (run_.is_trial_in_progress() && !keep_trying(run_.interrupt())) return;
  has_ended_ = true;
  Q_EMIT ended();
}

void TrialWindow::ask_to_stop() {
  if (is_finished_) return stop();
  QMessageBox box(QMessageBox::Question, windowTitle(),
                  tr("Stop the session? Finished trials are saved."), QMessageBox::NoButton, this);
  QPushButton* stop_button = box.addButton(tr("Stop"), QMessageBox::AcceptRole);
  QPushButton* stay = box.addButton(tr("Go on"), QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  activateWindow();
  if (box.clickedButton() == stop_button) stop();
}

void TrialWindow::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  switch (event->key()) {
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return proceed();
    case Qt::Key_Escape:
      return ask_to_stop();
    default:
      QWidget::keyPressEvent(event);
  }
}

void TrialWindow::closeEvent(QCloseEvent* event) {
  if (has_ended_) return event->accept();
  event->ignore();
  ask_to_stop();
}

}  // namespace felt::desktop
