#pragma once

#include <QAbstractListModel>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The history as a list. Row 0 is the state of the drawing when it was opened, or the oldest state
/// that the history remembers; row n is the state after the n-th step. An edit updates only the
/// rows that it changes, so that the list stays fast with thousands of steps.
class HistoryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { kIsDone = Qt::UserRole, kIsCurrent };

  explicit HistoryModel(Studio& studio, QObject* parent = nullptr);

  /// Returns the row of the present state.
  [[nodiscard]] int current_row() const { return done_; }
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 Q_SIGNALS:
  void current_changed();

 private:
  void follow();
  void start_anew();

  Studio& studio_;
  // The values that were last reported to the views.
  int steps_ = 0;
  int done_ = 0;
  std::size_t forgotten_ = 0;
};

}  // namespace felt::desktop
