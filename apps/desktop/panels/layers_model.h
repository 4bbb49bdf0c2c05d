#pragma once

#include <QAbstractListModel>
#include <set>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/panels/layer_thumbnails.h"

namespace felt::desktop {

/// The layers of a studio's drawing as a list, the topmost first. Above the layers of a group is a
/// row for the group; if the group is collapsed, the rows of its layers are left out. Renaming or
/// moving a row applies an event to the studio, and the resulting edit updates the list. The list
/// is rebuilt only if an edit changes the layers themselves.
class LayersModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    kVisible = Qt::UserRole,  ///< of the row itself
    kLocked,
    kInUse,
    kThumbnail,   ///< a QPixmap, or nothing
    kHasPicture,  ///< the layer has a picture to draw over
    kShown,       ///< false also if the group of the layer is hidden
    kIsGroup,
    kCollapsed,
    kIndented,  ///< the layer is in a group
  };

  explicit LayersModel(Studio& studio, QObject* parent = nullptr);

  /// Returns the layer of a row; an empty id if the row is that of a group.
  [[nodiscard]] LayerId layer_at(int row) const;
  /// Returns the group of a row; an empty id if the row is that of a layer.
  [[nodiscard]] GroupId group_at(int row) const;
  /// Returns the row of a layer, or of its group if that is collapsed; -1 if there is none.
  [[nodiscard]] int row_of(LayerId id) const;
  [[nodiscard]] int row_of_group(GroupId id) const;
  /// Leaves out the rows of the layers of a group, or shows them. Not a step of undo.
  void set_collapsed(GroupId group, bool on);
  [[nodiscard]] bool is_collapsed(GroupId group) const { return collapsed_.contains(group); }

  [[nodiscard]] static QString shown_name(const Layer& layer);
  [[nodiscard]] static QString shown_name(const LayerGroup& group);
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  /// Renames a layer or a group as a step of undo. Ignores an empty name.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  /// Moves a layer or a group. A layer that is dropped between the rows of a group joins it.
  bool moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target,
                int before) override;
  bool dropMimeData(const QMimeData*, Qt::DropAction, int, int, const QModelIndex&) override {
    return false;  // moveRows() has already moved it
  }

 Q_SIGNALS:
  /// Emitted when the list was rebuilt. Views must then restore their selection.
  void refreshed();

 private:
  struct Row {
    GroupId group;  // set if the row is that of a group
    LayerId layer;
  };

  void refresh();
  void list_rows();
  [[nodiscard]] std::size_t layers_below(int before, const Row& moved) const;
  [[nodiscard]] GroupId group_between(int before, const Layer& moved) const;
  bool move_group(int row, int before);
  [[nodiscard]] QVariant layer_data(const Layer& layer, int role) const;
  [[nodiscard]] QVariant group_data(const LayerGroup& group, int role) const;
  [[nodiscard]] QString spoken(const Layer& layer) const;
  [[nodiscard]] QString spoken(const LayerGroup& group) const;

  Studio& studio_;
  LayerThumbnails* thumbnails_;
  std::vector<Row> rows_;
  std::set<GroupId> collapsed_;
};

}  // namespace felt::desktop
