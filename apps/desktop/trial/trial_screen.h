#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "desktop/canvas/canvas.h"
#include "desktop/trial/shape_view.h"
#include "felt/studies/study_files.h"
#include "felt/trial/study_order.h"

namespace felt::desktop {

/// Returns what the participant does in a task.
QString task_text(StudyTask task);

/// The screen on which the participant draws: the task in a line at the top, the page with the
/// shape, and at the bottom the number of the trial and the button "Done".
class TrialScreen : public QWidget {
  Q_OBJECT

 public:
  /// The canvas of this screen shows the drawing of the studio.
  explicit TrialScreen(Studio& studio, QWidget* parent = nullptr);

  [[nodiscard]] Canvas& canvas() noexcept { return *canvas_; }
  /// Shows a trial of a session with `count` trials. "Done" cannot be pressed yet.
  void show_trial(const StudyFiles& files, const PlannedTrial& trial, std::size_t count);
  /// Call it when the pen has touched the surface: from now on, "Done" can be pressed.
  void begin_drawing();
  /// Shows a message for the researcher until the next trial.
  void show_problem(const QString& text);

 Q_SIGNALS:
  /// Emitted when the button was pressed.
  void done();

 private:
  QLabel* task_;
  Canvas* canvas_;
  ShapeView* shape_;
  QLabel* number_;
  QLabel* problem_;
  QPushButton* button_;
};

}  // namespace felt::desktop
