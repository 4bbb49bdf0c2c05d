#include "desktop/panels/history_model.h"

#include <QFont>
#include <algorithm>

#include "desktop/engine/tool_texts.h"

namespace felt::desktop {

HistoryModel::HistoryModel(Studio& studio, QObject* parent)
    : QAbstractListModel(parent), studio_(studio) {
  connect(&studio, &Studio::edited, this, [this] { follow(); });
  connect(&studio, &Studio::opened, this, &HistoryModel::start_anew);
  start_anew();
}

void HistoryModel::start_anew() {
  beginResetModel();
  const History& history = studio_.session().history();
  steps_ = static_cast<int>(history.step_count());
  done_ = static_cast<int>(history.undo_count());
  forgotten_ = history.forgotten_count();
  endResetModel();
  Q_EMIT current_changed();
}

/// Updates the rows, of which rows 1..steps_ are the steps. Since the last call, the history may
/// have forgotten steps at the front, and new steps may have replaced undone steps at the end.
void HistoryModel::follow() {
  const History& history = studio_.session().history();
  const int steps = static_cast<int>(history.step_count());
  const int done = static_cast<int>(history.undo_count());
  const auto lost = static_cast<int>(
      std::min<std::size_t>(history.forgotten_count() - forgotten_, std::size_t(steps_)));
  forgotten_ = history.forgotten_count();
  if (lost > 0) {
    beginRemoveRows({}, 1, lost);
    steps_ -= lost;
    done_ = std::max(done_ - lost, 0);
    endRemoveRows();
  }
  const int before = done_;
  done_ = done;
  if (steps < steps_) {
    beginRemoveRows({}, steps + 1, steps_);
    steps_ = steps;
    endRemoveRows();
  } else if (steps > steps_) {
    beginInsertRows({}, steps_ + 1, steps);
    steps_ = steps;
    endInsertRows();
  }
  const int first = std::clamp(std::min(before, done), 0, steps_);
  const int last = std::clamp(std::max(before, done) + 1, 0, steps_);
  Q_EMIT dataChanged(index(first), index(last));
  Q_EMIT current_changed();
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : steps_ + 1;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  const History& history = studio_.session().history();
  const int row = index.row();
  if (row < 0 || row > static_cast<int>(history.step_count())) return {};
  const QString label = row > 0 ? edit_text(history.label(static_cast<std::size_t>(row) - 1))
                        : forgotten_ > 0 ? tr("Earlier steps are no longer available")
                                         : tr("As opened");
  switch (role) {
    case Qt::DisplayRole:
      return label;
    case Qt::AccessibleTextRole:
      return row == done_  ? tr("%1, current").arg(label)
             : row > done_ ? tr("%1, undone").arg(label)
                           : label;
    case Qt::FontRole: {
      QFont font;
      font.setBold(row == done_);
      font.setItalic(row > done_ || row == 0);
      return font;
    }
    case kIsDone:
      return row <= done_;
    case kIsCurrent:
      return row == done_;
    default:
      return {};
  }
}

}  // namespace felt::desktop
