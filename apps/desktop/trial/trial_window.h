#pragma once

#include <QStackedLayout>
#include <QWidget>

#include "desktop/trial/message_screen.h"
#include "desktop/trial/question_screen.h"
#include "desktop/trial/trial_run.h"
#include "desktop/trial/trial_screen.h"

namespace felt::desktop {

/// The window in which a participant takes part in a session: welcome, rests, trials,
/// questionnaires and the end. Space and Enter do what the button of the screen does. Esc, and
/// closing the window, ask whether to stop the session. It has no other controls.
class TrialWindow : public QWidget {
  Q_OBJECT

 public:
  /// Shows the welcome. `run` must outlive the window.
  TrialWindow(TrialRun& run, Studio& studio);

  /// Returns true when all trials are saved and all questions are answered.
  [[nodiscard]] bool is_finished() const noexcept { return is_finished_; }
  [[nodiscard]] TrialScreen& trial_screen() noexcept { return *trial_; }
  [[nodiscard]] QuestionScreen& question_screen() noexcept { return *questions_; }
  [[nodiscard]] MessageScreen& message_screen() noexcept { return *message_; }
  /// Returns the screen that is shown.
  [[nodiscard]] QWidget* shown_screen() const { return stack_->currentWidget(); }
  /// Ends the session. A trial in progress is saved as an interrupted one. Emits `ended`.
  void stop();

 Q_SIGNALS:
  /// Emitted when the session has ended or was stopped.
  void ended();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void show_welcome(bool device_has_force);
  void go_on();
  void show_before_trial();
  void begin_trial();
  void finish_trial();
  void proceed();
  void proceed_from_message();
  void ask_to_stop();
  bool keep_trying(Result<void> saved);
  [[nodiscard]] QString condition_of(const QuestionStep& step) const;

  TrialRun& run_;
  QStackedLayout* stack_;
  MessageScreen* message_;
  TrialScreen* trial_;
  QuestionScreen* questions_;
  SessionStep step_;
  bool has_begun_ = false;
  bool is_finished_ = false;
  bool has_ended_ = false;
};

}  // namespace felt::desktop
