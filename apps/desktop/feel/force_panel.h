#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "desktop/engine/studio.h"
#include "desktop/feel/force_graph.h"
#include "desktop/feel/force_history.h"

namespace felt::desktop {

/// Shows what the pen feels. A plot shows the terms of the force, their sum and the sent force. A
/// table of the same values serves as the legend. The panel also describes the state of the safety
/// chain and shows the timing of the loop. Repaints at most 30 times a second, and only while it is
/// visible and values change.
class ForcePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ForcePanel(Studio& studio, QWidget* parent = nullptr);

  /// Freezes the plot. The history continues to record.
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const { return pause_->isChecked(); }
  [[nodiscard]] const ForceHistory& history() const noexcept { return history_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void take(const TickReport& tick);
  void use_device();
  void show_bounds();
  void report();
  void report_table();
  void report_state();
  void report_loop();

  Studio& studio_;
  ForceHistory history_;
  ForceHistory held_;  // the copy that a paused plot shows
  QBoxLayout* layout_;
  ForceGraph* graph_;
  QTableWidget* table_;
  QLabel* icon_;
  QLabel* state_;
  QLabel* detail_;
  QLabel* loop_;
  QToolButton* pause_;
  QTimer frame_;  // single-shot timer for the next repaint
  QTimer words_;
  bool has_motors_ = false;
  int reported_tables_ = 0;
};

}  // namespace felt::desktop
