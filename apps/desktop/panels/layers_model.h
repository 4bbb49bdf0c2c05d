#pragma once

#include <QAbstractListModel>

#include "desktop/engine/studio.h"
#include "desktop/panels/layer_thumbnails.h"

namespace felt::desktop {

/// The layers of a studio's drawing as a list, the topmost first. Renaming or moving a row applies
/// an event to the studio, and the resulting edit updates the list. The list is rebuilt only if an
/// edit changes the layers themselves.
class LayersModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    kVisible = Qt::UserRole,
    kLocked,
    kInUse,
    kThumbnail,   ///< a QPixmap, or nothing
    kHasPicture,  ///< the layer has a picture to draw over
  };

  explicit LayersModel(Studio& studio, QObject* parent = nullptr);

  [[nodiscard]] LayerId layer_at(int row) const;
  /// Returns the row of a layer, or -1 if the list does not contain it.
  [[nodiscard]] int row_of(LayerId id) const;

  [[nodiscard]] static QString shown_name(const Layer& layer);
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  /// Renames a layer as a step of undo. Ignores an empty name.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  bool moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target,
                int before) override;
  bool dropMimeData(const QMimeData*, Qt::DropAction, int, int, const QModelIndex&) override {
    return false;  // moveRows() has already moved it
  }

 Q_SIGNALS:
  /// Emitted when the list was rebuilt. Views must then restore their selection.
  void refreshed();

 private:
  void refresh();
  [[nodiscard]] QString spoken(const Layer& layer) const;

  Studio& studio_;
  LayerThumbnails* thumbnails_;
};

}  // namespace felt::desktop
