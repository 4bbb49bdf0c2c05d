#include "desktop/trial/trial_screen.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "desktop/engine/text_of.h"
#include "desktop/trial/message_screen.h"
#include "desktop/trial/plain_pen.h"

namespace felt::desktop {

QString task_text(StudyTask task) {
  switch (task) {
    case StudyTask::kTrace:
      return TrialScreen::tr(
          "Draw along the line. Begin at the dot and go in the direction of the arrow.");
    case StudyTask::kTunnel:
      return TrialScreen::tr(
          "Draw between the walls without touching them. Begin at the dot and go in the direction "
          "of the arrow.");
    case StudyTask::kCopy:
      return TrialScreen::tr("Draw the same shape in the empty half on the right.");
    case StudyTask::kConnect:
      return TrialScreen::tr("Draw from target to target in the order of the numbers.");
    case StudyTask::kFind:
      return TrialScreen::tr(
          "Move the pen over the page until you feel a line in it, and follow this line.");
    case StudyTask::kRetrace:
      return TrialScreen::tr(
          "Draw over the line. Begin at the dot and go in the direction of the arrow.");
    case StudyTask::kClose:
      return TrialScreen::tr(
          "Draw along the line, once around, so that the end of your line meets its start.");
    case StudyTask::kWidth:
      return TrialScreen::tr(
          "Draw along the band with one line that is as broad as the band everywhere. Begin at the "
          "dot.");
    case StudyTask::kErase:
      return TrialScreen::tr(
          "Erase the marked part of the line, up to the two lines that cross it. Leave all other "
          "lines as they are.");
  }
  return {};
}

TrialScreen::TrialScreen(Studio& studio, QWidget* parent)
    : QWidget(parent),
      task_(new QLabel),
      canvas_(new Canvas(studio)),
      shape_(new ShapeView(*canvas_)),
      number_(new QLabel),
      problem_(new QLabel),
      button_(new QPushButton(tr("Done"))) {
  new PlainPen(*canvas_);
  canvas_->hide_first_hints();
  task_->setFont(larger_font(*this, 1.3));
  task_->setAlignment(Qt::AlignHCenter);
  button_->setFont(larger_font(*this, 1.3));
  button_->setMinimumSize(180, 52);
  button_->setFocusPolicy(Qt::NoFocus);
  for (QLabel* label : {task_, number_, problem_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(label != number_);
  }
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(16, 8, 16, 8);
  bottom->addWidget(number_);
  bottom->addSpacing(24);
  bottom->addWidget(problem_, 1);
  bottom->addWidget(button_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 10, 0, 0);
  layout->addWidget(task_);
  layout->addWidget(canvas_, 1);
  layout->addLayout(bottom);
  connect(button_, &QPushButton::clicked, this, &TrialScreen::done);
}

void TrialScreen::show_trial(const StudyFiles& files, const PlannedTrial& trial,
                             std::size_t count) {
  QString task = task_text(files.study.shapes[trial.shape].task);
  if (!files.study.conditions[trial.condition].has_vision) {
    task += QLatin1Char(' ') + tr("You will not see what you draw.");
  }
  task_->setText(task);
  QString number = tr("Trial %1 of %2").arg(trial.number).arg(count);
  if (trial.is_practice) number += QStringLiteral(" · ") + tr("practice");
  number_->setText(number + QStringLiteral(" · ") + text_of(trial.shown_condition));
  problem_->clear();
  button_->setEnabled(false);
  shape_->set_trial(files, trial);
  canvas_->fit_page();
  canvas_->setFocus();
}

void TrialScreen::begin_drawing() {
  shape_->begin_drawing();
  button_->setEnabled(true);
}

void TrialScreen::show_problem(const QString& text) {
  problem_->setText(text);
}

}  // namespace felt::desktop
