#include "desktop/panels/history_panel.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr int kRailPx = 22;  // width of the time line left of the names, with a dot for each step
constexpr int kRowRoomPx = 8;
constexpr float kUndoneOpacity = 0.62F;

/// Draws steps as dots on a line: filled if done, a ring for the present state, empty if undone.
class StepDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyleOptionViewItem look = option;
    initStyleOption(&look, index);
    const bool is_done = index.data(HistoryModel::kIsDone).toBool();
    const bool is_current = index.data(HistoryModel::kIsCurrent).toBool();
    look.state &= ~QStyle::State_Selected;
    const QString text = std::exchange(look.text, {});
    look.widget->style()->drawControl(QStyle::CE_ItemViewItem, &look, painter, look.widget);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    QColor ink = look.palette.color(QPalette::Text);
    if (!is_done) ink.setAlphaF(kUndoneOpacity);
    const QRectF row = option.rect;
    const double x = row.left() + 0.5 * kRailPx + 2.0, y = row.center().y();
    painter->setPen(QPen(ink, 1.2, is_done ? Qt::SolidLine : Qt::DotLine, Qt::FlatCap));
    if (index.row() > 0) painter->drawLine(QPointF(x, row.top()), QPointF(x, y - 4));
    if (index.row() + 1 < index.model()->rowCount()) {
      painter->drawLine(QPointF(x, y + 4), QPointF(x, row.bottom()));
    }
    const QColor accent = accent_on(look.palette.color(QPalette::Base));
    painter->setPen(QPen(is_current ? accent : ink, is_current ? 2.0 : 1.2));
    painter->setBrush(is_current || !is_done ? Qt::NoBrush : QBrush(ink));
    const double radius = is_current ? 4.5 : 2.5;
    painter->drawEllipse(QPointF(x, y), radius, radius);
    painter->setPen(ink);
    painter->setFont(look.font);
    const QRect name = option.rect.adjusted(kRailPx + 6, 0, -6, 0);
    painter->drawText(name, Qt::AlignVCenter | Qt::AlignLeft,
                      QFontMetrics(look.font).elidedText(text, Qt::ElideRight, name.width()));
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex&) const override {
    return {4 * kRailPx, option.fontMetrics.height() + kRowRoomPx};
  }
};

QToolButton* tool_button(const char* icon, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon_of(icon));
  button->setIconSize({18, 18});
  button->setAutoRaise(true);
  button->setObjectName(QString::fromLatin1(icon));
  button->setAccessibleName(name);
  button->setToolTip(name);
  return button;
}

}  // namespace

HistoryPanel::HistoryPanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      model_(new HistoryModel(studio, this)),
      list_(new QListView(this)),
      undo_(tool_button("undo", tr("One step back"), this)),
      redo_(tool_button("redo", tr("One step forward"), this)) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(0);
  list_->setModel(model_);
  list_->setItemDelegate(new StepDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setAccessibleName(tr("Steps"));
  lines->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(6, 4, 6, 4);
  row->setSpacing(2);
  row->addStretch(1);
  row->addWidget(undo_);
  row->addWidget(redo_);
  lines->addLayout(row);
  connect(undo_, &QToolButton::clicked, this, [this] { studio_.apply(UndoEvent{}); });
  connect(redo_, &QToolButton::clicked, this, [this] { studio_.apply(RedoEvent{}); });
  const auto go = [this](const QModelIndex& index) { go_to(index.row()); };
  connect(list_, &QListView::clicked, this, go);
  connect(list_, &QListView::activated, this, go);
  connect(model_, &HistoryModel::current_changed, this, &HistoryPanel::follow);
  follow();
}

void HistoryPanel::go_to(int row) {
  // The number of steps may shrink meanwhile, because a gesture in progress is cancelled first.
  // Therefore the loop ends only after two calls without a change.
  for (int idle = 0; idle < 2;) {
    const int here = model_->current_row();
    if (here == row) break;
    if (here > row) {
      studio_.apply(UndoEvent{});
    } else {
      studio_.apply(RedoEvent{});
    }
    idle = model_->current_row() == here ? idle + 1 : 0;
  }
  follow();
}

void HistoryPanel::follow() {
  const QModelIndex here = model_->index(model_->current_row());
  list_->setCurrentIndex(here);
  list_->scrollTo(here);
  const History& history = studio_.session().history();
  undo_->setEnabled(history.can_undo());
  redo_->setEnabled(history.can_redo());
}

}  // namespace felt::desktop
