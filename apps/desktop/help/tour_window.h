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

/// The guided tour: two minutes in which the program draws by itself, tool by tool, with a sentence
/// to each. It has a studio of its own, so that nobody's drawing is touched. Left and Right go to
/// the act before and after, Space pauses, Esc closes.
class TourWindow : public QWidget {
  Q_OBJECT

 public:
  explicit TourWindow(QWidget* parent = nullptr);

  [[nodiscard]] int act_count() const noexcept;
  /// 0 and on; act_count() is the last page, where there is nothing to play.
  [[nodiscard]] int act() const noexcept { return act_; }
  void go_to(int act);
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const noexcept { return is_paused_; }
  /// The time that passes between two frames: plays on. For the timer, tests and pictures.
  void play(std::int64_t ns);
  [[nodiscard]] Studio& studio() noexcept { return *studio_; }

 Q_SIGNALS:
  /// "Try it yourself": a window is wanted with what the tour has drawn.
  void wants_sheet(const felt::Document& drawing);

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
  std::vector<Document> before_;  // what was there when each act began
  int act_ = 0;
  int wanted_ = 0;  // acts before it are played as fast as they can be
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
