#pragma once

#include <QListView>
#include <QToolButton>
#include <QWidget>

#include "desktop/engine/studio.h"
#include "desktop/panels/history_model.h"

namespace felt::desktop {

/// Lists the steps of the history, the newest last. A click on a step undoes or redoes all steps up
/// to the clicked step.
class HistoryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(Studio& studio, QWidget* parent = nullptr);

  /// Undoes or redoes until the drawing has the state of this row.
  void go_to(int row);

 private:
  void follow();

  Studio& studio_;
  HistoryModel* model_;
  QListView* list_;
  QToolButton* undo_;
  QToolButton* redo_;
};

}  // namespace felt::desktop
