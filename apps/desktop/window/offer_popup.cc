#include "desktop/window/offer_popup.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabletEvent>
#include <QTouchEvent>
#include <algorithm>

namespace felt::desktop {
namespace {

constexpr int kMarginPx = 4;
constexpr QPointF kBesidePenPx{24.0, 24.0};

QString tr_offer(const char* english) {
  return QCoreApplication::translate("OfferPopup", english);
}

/// Returns the meanings that do not apply yet, without the ink.
std::vector<OfferKind> others(const OfferView& offer) {
  std::vector<OfferKind> kinds;
  for (std::size_t i = 0; i < offer.rows.size(); ++i) {
    if (i != offer.chosen && offer.rows[i].kind != OfferKind::kInk) {
      kinds.push_back(offer.rows[i].kind);
    }
  }
  return kinds;
}

/// Returns the command that chooses a meaning, or "" if there is none. `others_before`: number of
/// meanings before it that do not apply yet.
QString command_of(OfferKind kind, bool applies, int others_before) {
  if (kind == OfferKind::kInk) return QStringLiteral("edit.cancel");
  if (applies || others_before > 1) return {};
  return others_before == 0 ? QStringLiteral("edit.take_offer")
                            : QStringLiteral("edit.take_second_offer");
}

}  // namespace

QString offer_text(const OfferRow& row) {
  switch (row.kind) {
    case OfferKind::kDelete:
      if (row.count == 1) return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Delete 1 line"));
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Delete %1 lines")).arg(row.count);
    case OfferKind::kSelect:
      if (row.count == 1) return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Select 1 line"));
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Select %1 lines")).arg(row.count);
    case OfferKind::kLine:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Straight line"));
    case OfferKind::kArc:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Arc"));
    case OfferKind::kCircle:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Circle"));
    case OfferKind::kEllipse:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Ellipse"));
    case OfferKind::kTriangle:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Triangle"));
    case OfferKind::kRectangle:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Rectangle"));
    case OfferKind::kPolygon:
      return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Polygon"));
    case OfferKind::kInk:
      break;
  }
  return tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Keep the ink"));
}

OfferPopup::OfferPopup(const Actions& actions, Canvas& canvas)
    : QFrame(&canvas),
      actions_(actions),
      canvas_(canvas),
      studio_(canvas.studio()),
      row_(new QHBoxLayout(this)),
      hint_(new QLabel(this)) {
  setObjectName(QStringLiteral("offer"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setCursor(Qt::ArrowCursor);
  setAttribute(Qt::WA_AcceptTouchEvents);
  row_->setContentsMargins(kMarginPx, kMarginPx, kMarginPx, kMarginPx);
  row_->setSpacing(kMarginPx);
  row_->addWidget(hint_);
  hide();
  connect(&studio_, &Studio::shown, this, &OfferPopup::follow);
  connect(&studio_, &Studio::edited, this, &OfferPopup::follow);
  connect(&studio_, &Studio::opened, this, &OfferPopup::follow);
  connect(&canvas, &Canvas::view_changed, this, [this] {
    if (shown_) move_to(shown_->at);
  });
}

void OfferPopup::follow() {
  const Session& session = studio_.session();
  std::optional<OfferView> offer = session.offered();
  const bool is_live = session.gesture_in_progress();
  if (offer && shown_ && is_live == is_live_ && offer->rows == shown_->rows &&
      offer->chosen == shown_->chosen) {
    return;
  }
  if (!offer && !shown_) return;
  const bool had_focus = isAncestorOf(QApplication::focusWidget());
  shown_ = std::move(offer);
  is_live_ = is_live;
  if (!shown_) {
    hide();
    canvas_.setAccessibleDescription(Canvas::tr("The area to draw on"));
    if (had_focus) canvas_.setFocus();
    return;
  }
  rebuild(*shown_);
  move_to(shown_->at);
  show();
  raise();
  // Screen readers read a new description of the widget that has the focus. Qt on Linux does not
  // forward alerts.
  canvas_.setAccessibleDescription(accessibleName());
}

void OfferPopup::rebuild(const OfferView& offer) {
  while (row_->count() > 1) {
    QLayoutItem* item = row_->takeAt(1);
    // Not deleted at once, because a click of this button may have led here.
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  const bool waits = is_live_ && offer.rows[offer.chosen].kind == OfferKind::kInk;
  hint_->setText(tr("Press harder, or hold the mouse still:"));
  hint_->setVisible(waits);
  QStringList names;
  int others_shown = 0;
  for (std::size_t i = 0; i < offer.rows.size(); ++i) {
    const OfferKind kind = offer.rows[i].kind;
    auto* button = new QToolButton(this);
    button->setText(offer_text(offer.rows[i]));
    button->setAccessibleName(button->text());
    button->setCheckable(true);
    button->setChecked(i == offer.chosen);
    button->setFocusPolicy(Qt::TabFocus);
    if (const QAction* command = actions_.find(command_of(kind, i == offer.chosen, others_shown))) {
      const QString keys = command->shortcut().toString(QKeySequence::NativeText);
      if (!keys.isEmpty()) button->setToolTip(tr("Key: %1").arg(keys));
    }
    if (kind != OfferKind::kInk && i != offer.chosen) ++others_shown;
    connect(button, &QToolButton::clicked, this,
            [this, kind] { studio_.apply(ChooseOffer{kind}); });
    row_->addWidget(button);
    button->show();  // a layout shows new widgets of a visible popup only later
    names << button->text();
  }
  setAccessibleName(tr("This stroke can be: %1").arg(names.join(QStringLiteral(", "))));
}

/// Shows the popup below and to the right of the pen. Where it does not fit, it is above or to the
/// left, so that it never lies under the pen.
void OfferPopup::move_to(Point at) {
  adjustSize();
  const auto place = [](double pen, double beside, int length, int room) {
    const double after = pen + beside, before = pen - beside - length;
    const double wanted = after + length <= room || before < 0.0 ? after : before;
    return std::clamp(int(wanted), 0, std::max(0, room - length));
  };
  const QPointF pen = canvas_.view().to_px(at);
  move(place(pen.x(), kBesidePenPx.x(), width(), canvas_.width()),
       place(pen.y(), kBesidePenPx.y(), height(), canvas_.height()));
}

QToolButton* OfferPopup::button_at(QPointF global) const {
  return qobject_cast<QToolButton*>(childAt(mapFromGlobal(global).toPoint()));
}

/// Clicks the button under a pen or finger that is lifted, if it was put down on the same one.
void OfferPopup::release_at(QPointF global) {
  QToolButton* button = button_at(global);
  if (button && button == pressed_) button->click();
  pressed_ = nullptr;
}

bool OfferPopup::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::TabletRelease:
      release_at(static_cast<QTabletEvent*>(event)->globalPosition());
      event->accept();
      return true;
    case QEvent::TabletPress:
      pressed_ = button_at(static_cast<QTabletEvent*>(event)->globalPosition());
      [[fallthrough]];
    case QEvent::TabletMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      event->accept();
      return true;
    case QEvent::TouchEnd: {
      const auto& points = static_cast<QTouchEvent*>(event)->points();
      if (points.size() == 1) release_at(points.constFirst().globalPosition());
      event->accept();
      return true;
    }
    case QEvent::TouchBegin:
      pressed_ =
          button_at(static_cast<QTouchEvent*>(event)->points().constFirst().globalPosition());
      [[fallthrough]];
    case QEvent::TouchUpdate:
    case QEvent::TouchCancel:
      event->accept();
      return true;
    default:
      return QFrame::event(event);
  }
}

void add_offer_popup(Actions& actions, Canvas& canvas) {
  Studio& studio = canvas.studio();
  const auto take = [&studio](std::size_t i) {
    const std::optional<OfferView> offer = studio.session().offered();
    if (!offer) return;
    const std::vector<OfferKind> kinds = others(*offer);
    if (i < kinds.size()) studio.apply(ChooseOffer{kinds[i]});
  };
  actions.add(
      QStringLiteral("edit.take_offer"),
      tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Take the &offer at the pen")),
      {QKeySequence(Qt::CTRL | Qt::Key_Return)},
      tr_offer(QT_TRANSLATE_NOOP("OfferPopup",
                                 "Chooses what the last stroke is offered to mean: a gesture or a "
                                 "shape.")),
      [take] { take(0); });
  actions.add(
      QStringLiteral("edit.take_second_offer"),
      tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Take the &second offer at the pen")),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Return)},
      tr_offer(QT_TRANSLATE_NOOP("OfferPopup", "Chooses the second meaning, if two are offered.")),
      [take] { take(1); });
  new OfferPopup(actions, canvas);
}

}  // namespace felt::desktop
