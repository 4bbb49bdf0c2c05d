#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "desktop/trial/answer_scale.h"
#include "felt/trial/study.h"

namespace felt::desktop {

/// Shows a questionnaire: the NASA Task Load Index (NASA TLX 1.0, 1986) without weights, or the
/// short User Experience Questionnaire (doi:10.9781/ijimai.2017.09.001), both with their original
/// questions and end labels.
class QuestionScreen : public QWidget {
  Q_OBJECT

 public:
  explicit QuestionScreen(QWidget* parent = nullptr);

  /// Shows a questionnaire without answers. `condition` is the name of the condition to which the
  /// questions refer, as the user may see it, or "" if they refer to the whole session.
  void show_form(Questionnaire form, const QString& condition);
  /// Returns the answers in the order of the items: 0 to 100 for NASA TLX; 1 (left) to 7 (right)
  /// for the UEQ-S. Requires that all items are answered.
  [[nodiscard]] std::vector<double> answers() const;
  /// Ends the questionnaire, if all items are answered.
  void proceed();

 Q_SIGNALS:
  void answered();

 private:
  void add_items();

  Questionnaire form_ = Questionnaire::kNasaTlx;
  QLabel* title_;
  QLabel* text_;
  QWidget* items_ = nullptr;
  QPushButton* button_;
  std::vector<AnswerScale*> scales_;
};

}  // namespace felt::desktop
