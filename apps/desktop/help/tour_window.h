#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/studio.h"
#include "desktop/help/script_player.h"

namespace felt::desktop {

/// The guided tour of two minutes: the program draws by itself, tool by tool, with a sentence about
/// each tool. The tour has its own studio, so that it does not change the user's drawing. Left and
/// Right go to the previous and next act, Space pauses, Esc closes.
class TourWindow : public QWidget {
  Q_OBJECT

 public:
  explicit TourWindow(QWidget* parent = nullptr);

  [[nodiscard]] int act_count() const noexcept;
  /// Returns the number of the act, from 0. The number act_count() stands for the last page, which
  /// plays nothing.
  [[nodiscard]] int act() const noexcept { return act_; }
  void go_to(int act);
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const noexcept { return is_paused_; }
  /// Plays the next `ns` nanoseconds of the tour. Called by the timer, by tests and for pictures.
  void play(std::int64_t ns);
  [[nodiscard]] Studio& studio() noexcept { return *studio_; }

 Q_SIGNALS:
  /// Emitted when the user chose "Try it yourself". The receiver shows `drawing`, the drawing of
  /// the tour, in a normal window.
  void drawing_requested(const felt::Document& drawing);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_controls();
  void tick();
  void start_act();
  void show_state();

  Studio* studio_;
  Canvas* canvas_;
  ScriptPlayer player_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::vector<Document> before_;  // the drawing at the start of each act
  int act_ = 0;
  int wanted_ = 0;  // acts before this one are played as fast as possible
  double speed_ = 1.0;
  bool is_paused_ = false;
  QLabel* title_ = nullptr;
  QLabel* caption_ = nullptr;
  QLabel* step_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* pause_ = nullptr;
  QPushButton* next_ = nullptr;
};

}  // namespace felt::desktop
