#include "desktop/panels/layer_delegate.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QPolygonF>
#include <QTransform>
#include <algorithm>

#include "desktop/panels/layers_model.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr int kIconPx = 18;
constexpr int kGapPx = 6;
constexpr int kMinRowPx = 30;
constexpr int kIndentPx = 12;            // of the layers of a group
constexpr double kHiddenOpacity = 0.65;  // still easy to read
constexpr double kIdleOpacity = 0.4;     // opacity of an open lock, which most layers have

QRect slot(const QRect& row, int x) {
  return {x, row.center().y() - kIconPx / 2, kIconPx, kIconPx};
}

QRect mark_of(const QRect& row) {
  return slot(row, LayerDelegate::eye_of(row).right() + kGapPx);
}

QRect thumbnail_of(const QRect& row, int indent) {
  const QSize size = LayerThumbnails::kSize;
  return {mark_of(row).right() + kGapPx + indent, row.center().y() - size.height() / 2,
          size.width(), size.height()};
}

QRect picture_of(const QRect& row) {
  return slot(row, LayerDelegate::lock_of(row).left() - kGapPx - kIconPx);
}

int indent_of(const QModelIndex& index) {
  return index.data(LayersModel::kIndented).toBool() ? kIndentPx : 0;
}

QRect folder_of(const QRect& row) {
  return slot(row, thumbnail_of(row, 0).left());
}

QRect name_of(const QRect& row, const QModelIndex& index) {
  const bool has_picture = index.data(LayersModel::kHasPicture).toBool();
  const bool is_group = index.data(LayersModel::kIsGroup).toBool();
  QRect rect = row;
  rect.setLeft((is_group ? folder_of(row) : thumbnail_of(row, indent_of(index))).right() + kGapPx);
  rect.setRight((has_picture ? picture_of(row) : LayerDelegate::lock_of(row)).left() - kGapPx);
  return rect;
}

/// Paints the arrow that expands or collapses a group.
void paint_arrow(QPainter& painter, const QRect& place, bool is_collapsed, const QColor& color) {
  const QPointF middle = QRectF(place).center();
  QPolygonF arrow;
  arrow << QPointF(-3.0, -4.5) << QPointF(3.5, 0.0) << QPointF(-3.0, 4.5);
  if (!is_collapsed) arrow = QTransform().rotate(90.0).map(arrow);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(arrow.translated(middle));
  painter.restore();
}

}  // namespace

QRect LayerDelegate::eye_of(const QRect& row) {
  return slot(row, row.left() + kGapPx);
}

QRect LayerDelegate::lock_of(const QRect& row) {
  return slot(row, row.right() - kGapPx - kIconPx);
}

QRect LayerDelegate::arrow_of(const QRect& row) {
  return mark_of(row);
}

void LayerDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  QStyleOptionViewItem look = option;
  initStyleOption(&look, index);
  look.text.clear();
  const QStyle* style = look.widget ? look.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &look, painter, look.widget);
  const bool visible = index.data(LayersModel::kVisible).toBool();
  const bool locked = index.data(LayersModel::kLocked).toBool();
  const bool in_use = index.data(LayersModel::kInUse).toBool();
  const bool shown = index.data(LayersModel::kShown).toBool();
  const bool is_group = index.data(LayersModel::kIsGroup).toBool();
  const bool selected = look.state.testFlag(QStyle::State_Selected);
  const QRect& row = option.rect;
  const auto draw = [&](const char* icon, const QRect& place, double opacity) {
    painter->setOpacity(opacity);
    icon_of(icon).paint(painter, place, Qt::AlignCenter,
                        selected ? QIcon::Selected : QIcon::Normal);
    painter->setOpacity(1.0);
  };
  draw(visible ? "eye" : "eye-off", eye_of(row), visible ? 1.0 : kHiddenOpacity);
  draw(locked ? "lock" : "unlock", lock_of(row), locked ? 1.0 : kIdleOpacity);
  const QColor text = look.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
  if (is_group) {
    paint_arrow(*painter, arrow_of(row), index.data(LayersModel::kCollapsed).toBool(), text);
    draw("group", folder_of(row), 1.0);
  } else if (in_use) {
    draw("in-use", mark_of(row), 1.0);
  }
  const bool has_picture = index.data(LayersModel::kHasPicture).toBool();
  if (has_picture) draw("picture", picture_of(row), 1.0);
  const auto thumbnail = index.data(LayersModel::kThumbnail).value<QPixmap>();
  if (!thumbnail.isNull()) {
    QRectF place({0.0, 0.0}, thumbnail.deviceIndependentSize());
    place.moveCenter(QRectF(thumbnail_of(row, indent_of(index))).center());
    painter->drawPixmap(place.topLeft(), thumbnail);
    painter->setPen(look.palette.color(QPalette::Mid));
    painter->drawRect(place);
  }
  QFont font = look.font;
  font.setBold(in_use);
  font.setItalic(!shown);
  painter->save();
  painter->setFont(font);
  painter->setOpacity(shown ? 1.0 : kHiddenOpacity);
  painter->setPen(text);
  const QRect name = name_of(row, index);
  painter->drawText(
      name, Qt::AlignVCenter | Qt::AlignLeft,
      QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, name.width()));
  painter->restore();
}

QSize LayerDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {6 * kIconPx, std::max(kMinRowPx, option.fontMetrics.height() + 2 * kGapPx)};
}

void LayerDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
  editor->setGeometry(name_of(option.rect, index).adjusted(-3, 2, 3, -2));
}

bool LayerDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                const QStyleOptionViewItem& option, const QModelIndex& index) {
  const bool is_press = event->type() == QEvent::MouseButtonPress;
  const bool is_release = event->type() == QEvent::MouseButtonRelease;
  if (is_press || is_release || event->type() == QEvent::MouseButtonDblClick) {
    const QPoint at = static_cast<QMouseEvent*>(event)->pos();
    const QMargins room(4, 8, 4, 8);
    const bool on_eye = (eye_of(option.rect) + room).contains(at);
    const bool on_lock = (lock_of(option.rect) + room).contains(at);
    if (is_release && on_eye) Q_EMIT eye_clicked(index);
    const bool on_arrow =
        index.data(LayersModel::kIsGroup).toBool() && (arrow_of(option.rect) + room).contains(at);
    if (is_release && on_lock) Q_EMIT lock_clicked(index);
    if (is_release && on_arrow && !on_eye) Q_EMIT arrow_clicked(index);
    if (on_eye || on_lock || on_arrow) return true;
  }
  return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace felt::desktop
