#pragma once

#include <QAbstractListModel>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The layers of a studio's drawing as a list, the topmost first. Changing a name or moving a row
/// tells the studio an event; the list follows what the drawing then says. It is read anew when an
/// edit touches a layer, not at any other.
class LayersModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { kVisible = Qt::UserRole, kLocked, kInUse };

  explicit LayersModel(Studio& studio, QObject* parent = nullptr);

  [[nodiscard]] LayerId layer_at(int row) const;
  /// -1 where it is not there.
  [[nodiscard]] int row_of(LayerId id) const;

  [[nodiscard]] static QString shown_name(const Layer& layer);
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  /// The name: a step of undo. Nothing for an empty one.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  bool moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target,
                int before) override;
  bool dropMimeData(const QMimeData*, Qt::DropAction, int, int, const QModelIndex&) override {
    return false;  // moveRows() has done it
  }

 Q_SIGNALS:
  /// Was read anew: a view has lost what was chosen.
  void refreshed();

 private:
  void refresh();
  [[nodiscard]] QString spoken(const Layer& layer) const;

  Studio& studio_;
};

}  // namespace felt::desktop
