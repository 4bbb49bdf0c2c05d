#include "desktop/panels/swatch_view.h"

#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <utility>

#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr int kCellPx = 24;
constexpr double kSwatchRoundPx = 4.0;

/// Draws a swatch: a rounded square, chequered if transparent, with a tick on the current colour,
/// and with a ring for the keyboard focus.
class SwatchDelegate : public QStyledItemDelegate {
 public:
  explicit SwatchDelegate(SwatchView* view) : QStyledItemDelegate(view), view_(view) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const Rgba color = view_->colors()[static_cast<std::size_t>(index.row())].color;
    const QRectF cell = QRectF(option.rect).adjusted(2.5, 2.5, -2.5, -2.5);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    if (color.a < 255) {
      painter->setBrush(Qt::white);
      painter->drawRoundedRect(cell, kSwatchRoundPx, kSwatchRoundPx);
      painter->setBrush(QBrush(Qt::lightGray, Qt::Dense4Pattern));
      painter->drawRoundedRect(cell, kSwatchRoundPx, kSwatchRoundPx);
    }
    painter->setBrush(qcolor(color));
    const bool has_keys = option.state.testFlag(QStyle::State_HasFocus);
    painter->setPen(QPen(option.palette.color(has_keys ? QPalette::Highlight : QPalette::Mid),
                         has_keys ? 2.5 : 1));
    painter->drawRoundedRect(cell, kSwatchRoundPx, kSwatchRoundPx);
    if (color == view_->marked()) {
      const bool is_dark = qGray(color.r, color.g, color.b) < 140 && color.a > 100;
      painter->setPen(
          QPen(is_dark ? Qt::white : Qt::black, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      const QPointF c = cell.center();
      const QPointF tick[] = {c + QPointF(-4, 0), c + QPointF(-1, 3), c + QPointF(4.5, -3.5)};
      painter->drawPolyline(tick, 3);
    }
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {kCellPx, kCellPx};
  }

 private:
  SwatchView* view_;
};

}  // namespace

QColor qcolor(Rgba color) {
  return {color.r, color.g, color.b, color.a};
}

Rgba rgba(const QColor& color) {
  const auto part = [](int value) { return static_cast<std::uint8_t>(value); };
  return {part(color.red()), part(color.green()), part(color.blue()), part(color.alpha())};
}

void SwatchModel::set_colors(std::vector<NamedColor> colors) {
  if (colors == colors_) return;
  beginResetModel();
  colors_ = std::move(colors);
  endResetModel();
}

int SwatchModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(colors_.size());
}

QVariant SwatchModel::data(const QModelIndex& index, int role) const {
  if (index.row() < 0 || index.row() >= rowCount()) return {};
  const NamedColor& entry = colors_[static_cast<std::size_t>(index.row())];
  if (role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
  const QString number = QString::fromStdString(color_to_text(entry.color));
  if (entry.name.empty()) return number;
  return QStringLiteral("%1 (%2)").arg(QString::fromStdString(entry.name), number);
}

SwatchView::SwatchView(const QString& name, bool one_row, QWidget* parent)
    : QListView(parent), model_(new SwatchModel(this)), one_row_(one_row) {
  setModel(model_);
  setItemDelegate(new SwatchDelegate(this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setGridSize({kCellPx, kCellPx});
  setSpacing(0);
  setFrameShape(QFrame::NoFrame);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  if (one_row) setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, one_row ? QSizePolicy::Fixed : QSizePolicy::Expanding);
  viewport()->setAutoFillBackground(false);
  setAccessibleName(name);
  const auto choose = [this](const QModelIndex& index) {
    Q_EMIT chosen(colors()[static_cast<std::size_t>(index.row())].color);
  };
  connect(this, &QListView::clicked, this, choose);
  connect(this, &QListView::activated, this, [this, choose](const QModelIndex& index) {
    if (colors()[static_cast<std::size_t>(index.row())].color != marked_) choose(index);
  });
}

void SwatchView::mark(Rgba color) {
  if (std::exchange(marked_, color) != color) viewport()->update();
}

QSize SwatchView::sizeHint() const {
  return {8 * kCellPx, one_row_ ? kCellPx + 2 : 3 * kCellPx + 2};
}

QSize SwatchView::minimumSizeHint() const {
  return {3 * kCellPx, one_row_ ? kCellPx + 2 : kCellPx + 2};
}

}  // namespace felt::desktop
