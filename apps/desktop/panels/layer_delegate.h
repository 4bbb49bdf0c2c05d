#pragma once

#include <QStyledItemDelegate>

namespace felt::desktop {

/// Paints a row of the layers panel: an eye, a pencil if the row is the current layer, a thumbnail,
/// the layer's name, a mark if it has a picture, and a lock. The row of a group has an arrow and a
/// folder instead of the pencil and the thumbnail; the rows of its layers are indented. The user
/// can click the eye, the lock and the arrow.
class LayerDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

  /// Returns the areas of the eye, the lock and the arrow in a row.
  [[nodiscard]] static QRect eye_of(const QRect& row);
  [[nodiscard]] static QRect lock_of(const QRect& row);
  [[nodiscard]] static QRect arrow_of(const QRect& row);

 Q_SIGNALS:
  void eye_clicked(const QModelIndex& index);
  void lock_clicked(const QModelIndex& index);
  void arrow_clicked(const QModelIndex& index);
};

}  // namespace felt::desktop
