#pragma once

#include <QAbstractListModel>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// What was done, as a list: row 0 is the drawing as it was opened (or as far back as is
/// remembered), row n is what the n-th step made of it. Follows each edit by the rows that change,
/// so that thousands of steps cost nothing.
class HistoryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { kIsDone = Qt::UserRole, kIsCurrent };

  explicit HistoryModel(Studio& studio, QObject* parent = nullptr);

  /// The row of the drawing as it is now.
  [[nodiscard]] int current_row() const { return done_; }
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 Q_SIGNALS:
  void current_changed();

 private:
  void follow();
  void start_anew();

  Studio& studio_;
  // What views have been told.
  int steps_ = 0;
  int done_ = 0;
  std::size_t forgotten_ = 0;
};

}  // namespace felt::desktop
