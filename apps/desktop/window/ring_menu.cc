#include "desktop/window/ring_menu.h"

#include <QAccessible>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <QToolButton>
#include <QTouchEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "desktop/panels/tool_icons.h"
#include "desktop/pens/pen_input.h"

namespace felt::desktop {
namespace {

constexpr double kLinesPerRadius = 7.0;  // radius of the circle of wells, in heights of a line
constexpr double kButtonShare = 0.75;    // width of a button, as a share of the radius
// The distances at which the hand can feel the wells of a device, whatever the zoom, mm (chosen).
constexpr double kMinRadiusMm = 8.0, kMaxRadiusMm = 24.0;
constexpr int kRingIconPx = 22;
// A choice by keys stays until the pen moves by this share of the radius (a held pen never rests).
constexpr double kStillShare = 0.1;
// If the computer is busy, the repetition of a held key may arrive as a release and a press. Such a
// press must not open the ring again.
constexpr int kRepeatMs = 100;

/// Returns the well that an arrow key chooses: first its own direction, then the neighbour on the
/// side of that direction. Returns none for other keys.
std::optional<std::size_t> well_of_key(int key, std::optional<std::size_t> now) {
  constexpr std::array kKeys{Qt::Key_Up, Qt::Key_Right, Qt::Key_Down, Qt::Key_Left};
  constexpr std::size_t kWells = ChoiceRing::kWells;
  const auto* at = std::find(kKeys.begin(), kKeys.end(), key);
  if (at == kKeys.end()) return std::nullopt;
  const auto target = 2 * static_cast<std::size_t>(at - kKeys.begin());
  const std::size_t turn = now ? (target + kWells - *now) % kWells : kWells / 2;
  if (turn == kWells / 2) return target;
  return turn == 0 ? target : (*now + (turn < kWells / 2 ? 1 : kWells - 1)) % kWells;
}

}  // namespace

RingMenu::RingMenu(const Actions& actions, Canvas& canvas, const MediaPictures& pictures,
                   QWidget* window)
    : QWidget(window),
      actions_(actions),
      canvas_(canvas),
      studio_(canvas.studio()),
      pictures_(pictures) {
  setObjectName(QStringLiteral("ring"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_TransparentForMouseEvents);  // the canvas gets them: eventFilter()
  hide();
  connect(&canvas, &Canvas::ring_wanted, this,
          [this](QPointF px) { open(RingContent::kTools, px, By::kButton); });
  connect(&canvas, &Canvas::ring_pressed, this,
          [this](QPointF px) { open(RingContent::kTools, px, By::kPress); });
  connect(&canvas, &Canvas::view_changed, this, &RingMenu::close_ring);
  connect(&studio_, &Studio::opened, this, &RingMenu::close_ring);
  connect(&studio_, &Studio::tool_changed, this, &RingMenu::close_ring);
  connect(&studio_, &Studio::shown, this, &RingMenu::follow_device);
}

void RingMenu::open(RingContent content, QPointF px, By by) {
  studio_.process();  // a change of tool that is reported later would close the ring
  if (ring_ || studio_.session().gesture_in_progress()) return;
  content_ = content;
  by_ = by;
  is_held_ = true;
  keys_chose_ = skips_ = false;
  touches_ = by == By::kPress;
  has_pen_ = touches_ && canvas_.tablet_in_hand();
  is_pressed_ = by != By::kKey && !holds_device();
  fill();
  place(holds_device() ? canvas_.view().to_px(studio_.pen().hand) : px);
  if (!ring_ || !studio_.session().ring()) {  // a line began meanwhile
    ring_.reset();
    return;
  }
  qApp->installEventFilter(this);  // its events come before those of PenInput
  show();
  raise();
  if (by == By::kKey) setFocus();
  update();
}

void RingMenu::toggle(RingContent content) {
  if (ring_) return close_ring();
  if (released_.isValid() && released_.elapsed() < kRepeatMs) return;
  open(content, canvas_.anchor(), By::kKey);
}

/// Returns true if the pen of a device chooses. Then mouse and tablet only open and confirm.
bool RingMenu::holds_device() const {
  return !studio_.loop().is_pointed() && studio_.pen().is_known;
}

void RingMenu::close_ring() {
  if (!ring_) return;
  ring_.reset();
  skips_ = is_pressed_;
  if (!skips_) qApp->removeEventFilter(this);
  const QWidget* focus = QApplication::focusWidget();
  hide();
  if (focus == this || isAncestorOf(focus)) {
    canvas_.setFocus(by_ == By::kKey ? Qt::ShortcutFocusReason : Qt::OtherFocusReason);
  }
  if (studio_.session().ring()) studio_.apply(UseRing{});
}

/// Called when a ring opens first, to start faster.
void RingMenu::make_buttons() {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    auto* button = buttons_[i] = new QToolButton(this);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setCheckable(true);
    // The mouse never clicks a button, but the keyboard and screen readers do.
    connect(button, &QToolButton::clicked, this, [this, i] {
      choose(i);
      run();
    });
  }
}

/// Gives the buttons their names and pictures.
void RingMenu::fill() {
  if (!buttons_.front()) make_buttons();
  setAccessibleName(ring_name(content_));
  wells_ = ring_wells(content_, actions_, studio_, pictures_, palette());
  const bool is_wide = content_ == RingContent::kMedia;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    QToolButton* button = buttons_[i];
    button->setIcon(wells_[i].icon);
    button->setIconSize(is_wide ? MediaPictures::kSize : QSize(kRingIconPx, kRingIconPx));
    button->setAccessibleName(wells_[i].name);
    button->setText(wells_[i].name);
    button->setChecked(wells_[i].is_current);
  }
}

/// Places the ring around a pixel of the canvas, and its wells on the page.
void RingMenu::place(QPointF px) {
  const double radius_px = kLinesPerRadius * fontMetrics().height();
  const int width = qRound(kButtonShare * radius_px);
  int height = 0;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setText(fontMetrics().elidedText(wells_[i].name, Qt::ElideRight, width - 4));
    height = std::max(height, buttons_[i]->sizeHint().height());
  }
  resize(QSize(1, 1) * qRound(2.0 * radius_px + 1.2 * width));
  middle_px_ = QRectF(rect()).center();
  move((window()->mapFromGlobal(canvas_.mapToGlobal(px)) - middle_px_).toPoint());
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * double(i) / double(buttons_.size());
    const QPointF at = middle_px_ + radius_px * QPointF(std::sin(angle), -std::cos(angle));
    buttons_[i]->setGeometry(qRound(at.x()) - width / 2, qRound(at.y()) - height / 2, width,
                             height);
  }
  const CanvasView& view = canvas_.view();
  pen_ = view.to_mm(px);
  Vec up = view.to_mm(px - QPointF(0.0, radius_px)) - pen_;
  Vec right = view.to_mm(px + QPointF(radius_px, 0.0)) - pen_;
  if (!studio_.loop().is_pointed()) {
    const double length = std::max(norm(up), 1e-9);
    const double share = std::clamp(length, kMinRadiusMm, kMaxRadiusMm) / length;
    up = share * up;
    right = share * right;
  }
  ring_.emplace(pen_, up, right);
  studio_.apply(UseRing{true, pen_, pen_ + up, pen_ + right});
}

/// Returns true for events of a press during which the ring was closed.
bool RingMenu::skip_rest_of_press(const QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove:
      skips_ = static_cast<const QSinglePointEvent&>(event).buttons() != Qt::NoButton;
      break;
    case QEvent::WindowDeactivate:
      skips_ = false;
      break;
    default:
      return false;
  }
  if (!skips_) qApp->removeEventFilter(this);
  return event.type() != QEvent::WindowDeactivate;
}

bool RingMenu::eventFilter(QObject* watched, QEvent* event) {
  if (!ring_) return skips_ && watched == &canvas_ && skip_rest_of_press(*event);
  const bool is_ours = watched == &canvas_ || watched == this || watched->parent() == this;
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return is_ours && take_key(static_cast<QKeyEvent&>(*event));
    case QEvent::WindowDeactivate:
      if (watched == &canvas_) close_ring();
      return false;
    case QEvent::MouseButtonPress:
      if (watched->isWidgetType() && !is_ours) close_ring();
      break;
    case QEvent::FocusIn:
      focus_choice(watched, static_cast<const QFocusEvent&>(*event).reason());
      return false;
    default:
      break;
  }
  return watched == &canvas_ && ring_ && take_pointer(*event);
}

/// Chooses the button to which Tab moved the focus, so that Return carries it out.
void RingMenu::focus_choice(const QObject* watched, Qt::FocusReason reason) {
  if (reason != Qt::TabFocusReason && reason != Qt::BacktabFocusReason) return;
  const auto button = std::find(buttons_.begin(), buttons_.end(), watched);
  if (button != buttons_.end()) choose(static_cast<std::size_t>(button - buttons_.begin()));
}

/// Returns true if a press at this pixel of the canvas begins something else: it is outside of the
/// ring, no button is held that chooses by its direction, and no device chooses.
bool RingMenu::is_beside(QPointF px) const {
  if (is_pressed_ || holds_device()) return false;
  const QPointF off = px - canvas_.view().to_px(ring_->middle());
  return std::hypot(off.x(), off.y()) > middle_px_.x();
}

/// Handles an event of the canvas. Returns false if the ring does not handle it.
bool RingMenu::take_pointer(QEvent& event) {
  const bool presses =
      event.type() == QEvent::MouseButtonPress || event.type() == QEvent::TabletPress;
  if (presses && is_beside(static_cast<const QSinglePointEvent&>(event).position())) {
    close_ring();
    return false;
  }
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove: {
      const auto& mouse = static_cast<const QMouseEvent&>(event);
      if (!is_made_up(mouse)) point(mouse.position(), mouse.buttons());
      break;
    }
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove: {
      const auto& pen = static_cast<const QTabletEvent&>(event);
      has_pen_ = true;
      point(pen.position(), pen.buttons());
      break;
    }
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      take_touch(static_cast<const QTouchEvent&>(event));
      break;
    case QEvent::Wheel:
    case QEvent::NativeGesture:
    case QEvent::ContextMenu:
      break;
    default:
      return false;
  }
  event.accept();
  return true;
}

/// Follows a finger on a screen, but not if a pen or button is used, because then it may be the
/// palm.
void RingMenu::take_touch(const QTouchEvent& event) {
  const bool is_finger = event.deviceType() == QInputDevice::DeviceType::TouchScreen;
  if (event.type() == QEvent::TouchCancel) touches_ = is_pressed_ = false;
  if (event.type() == QEvent::TouchCancel || event.points().isEmpty()) return;
  if (!is_finger || has_pen_ || by_ == By::kButton) return;
  const bool lifts = event.type() == QEvent::TouchEnd;
  point(event.points().constFirst().position(), lifts ? Qt::NoButton : Qt::LeftButton);
}

void RingMenu::point(QPointF px, Qt::MouseButtons buttons) {
  is_pressed_ = buttons != Qt::NoButton;
  const Point pen = canvas_.view().to_mm(px);
  const bool touches = buttons.testFlag(Qt::LeftButton);
  const bool others = (buttons & ~Qt::MouseButtons(Qt::LeftButton)) != 0;
  if (!holds_device()) {
    // Only a simulated device needs the touch: its pen feels the wells on the surface.
    const bool feels = touches && studio_.session().device().has_force();
    studio_.point({studio_.now_ns(), pen, feels, std::nullopt, 0, std::nullopt});
    if (!ring_) return;
    move_to(pen);
  }
  const bool released = by_ == By::kButton && is_held_ && !others && !touches;
  if (released) is_held_ = false;
  const bool lifted = lifts(touches);
  if (lifted || (released && ring_->chosen())) run();
}

/// Follows the pen of a device.
void RingMenu::follow_device() {
  const PenState& pen = studio_.pen();
  if (!ring_ || !holds_device()) return;
  move_to(pen.hand);
  if (lifts(in_contact(pen.sample))) run();
}

/// Returns true if the pen was lifted to choose. The lift of a long press leaves the ring open if
/// nothing is chosen.
bool RingMenu::lifts(bool touches) {
  const bool lifted = std::exchange(touches_, touches) && !touches;
  const bool of_press = lifted && by_ == By::kPress && std::exchange(is_held_, false);
  return lifted && (!of_press || ring_->chosen());
}

/// Updates the choice for a position of the pen.
void RingMenu::move_to(Point pen) {
  if (keys_chose_ && distance(pen, pen_) < kStillShare * ring_->radius_mm()) return;
  keys_chose_ = false;
  pen_ = pen;
  const std::optional<std::size_t> before = ring_->chosen();
  const ChoiceRing* felt = holds_device() ? studio_.session().ring() : nullptr;
  if (felt) {
    ring_->choose(felt->chosen());  // what the pen feels
  } else {
    ring_->move(pen);
  }
  if (ring_->chosen() == before) return;
  update();
  if (!ring_->chosen()) return;
  say_choice();
  Q_EMIT studio_.tick_wanted();
}

bool RingMenu::take_key(QKeyEvent& event) {
  if (event.type() == QEvent::KeyRelease) return release_key(event);
  const int key = event.key();
  const std::optional<std::size_t> well = well_of_key(key, ring_->chosen());
  const bool enters = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
  if (!well && !enters && key != Qt::Key_Escape) return false;
  event.accept();
  // An override that is accepted here keeps the shortcut of the window away.
  if (event.type() == QEvent::ShortcutOverride) return true;
  if (key == Qt::Key_Escape) {
    close_ring();
    return false;  // so that Escape twice still stops all forces (DoubleEscape)
  }
  if (enters) {
    run();
  } else {
    choose(*well);
    buttons_[*well]->setFocus();  // so that a screen reader says its name
  }
  return true;
}

/// Handles the release of the key that opened the ring.
bool RingMenu::release_key(const QKeyEvent& event) {
  const QAction* command = actions_.find(ring_command(content_));
  const auto keys = command ? command->shortcuts() : QList<QKeySequence>();
  const bool opened_it = std::any_of(keys.begin(), keys.end(), [&](const QKeySequence& of) {
    return of.count() == 1 && of[0].key() == event.key();
  });
  if (by_ != By::kKey || !opened_it || event.isAutoRepeat() || !is_held_) return false;
  is_held_ = false;
  if (!ring_->chosen()) return true;
  released_.start();
  run();
  return true;
}

/// Chooses a well without the pen. Screen readers say the button that gets the focus.
void RingMenu::choose(std::size_t well) {
  if (!ring_) return;
  keys_chose_ = true;
  if (ring_->chosen() == well) return;
  ring_->choose(well);
  update();
  Q_EMIT studio_.tick_wanted();
}

/// Tells screen readers the present choice (see ReadingSpeech).
void RingMenu::say_choice() {
  setAccessibleName(tr("%1: %2").arg(ring_name(content_), wells_[*ring_->chosen()].name));
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

/// Closes the ring and carries out the choice, if there is one.
void RingMenu::run() {
  if (!ring_) return;
  const std::optional<std::size_t> well = ring_->chosen();
  const QPointF px = canvas_.view().to_px(pen_);
  close_ring();
  if (!well) return;
  // A copy, because the choice may open a ring, which replaces the wells.
  if (const auto choose = wells_[*well].choose) return choose();
  open(wells_[*well].opens, px, by_);
  is_held_ = is_pressed_ = touches_ = false;
}

void RingMenu::paintEvent(QPaintEvent* /*event*/) {
  if (!ring_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double outer = middle_px_.x() - 1.0;
  const double inner = ChoiceRing::kMiddle * kLinesPerRadius * fontMetrics().height();
  const auto circle = [&](double radius) {
    return QRectF(middle_px_ - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
  };
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
  painter.setBrush(palette().color(QPalette::Window));
  painter.drawEllipse(circle(outer));
  constexpr int kSixteenths = 360 * 16 / int(ChoiceRing::kWells);
  if (const auto well = ring_->chosen()) {
    QColor light = palette().color(QPalette::Highlight);
    painter.setPen(QPen(light, 2.0));
    light.setAlphaF(0.3F);
    painter.setBrush(light);
    painter.drawPie(circle(outer), 90 * 16 - kSixteenths * int(*well) - kSixteenths / 2,
                    kSixteenths);
  }
  painter.setPen(QPen(palette().color(QPalette::Mid), 2.0));
  for (std::size_t i = 0; i < ChoiceRing::kWells; ++i) {
    const double angle = std::numbers::pi * (2.0 * double(i) + 1.0) / double(ChoiceRing::kWells);
    const QPointF out(std::sin(angle), -std::cos(angle));
    painter.drawLine(middle_px_ + inner * out, middle_px_ + outer * out);
  }
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawEllipse(circle(inner));
}

void add_ring_menu(Actions& actions, Canvas& canvas, const MediaPictures& pictures,
                   QWidget* window) {
  auto* menu = new RingMenu(actions, canvas, pictures, window);
  const auto add = [&](RingContent content, const QString& text, const QList<QKeySequence>& keys,
                       const QString& tip) {
    QAction* action = actions.add(ring_command(content), text, keys, tip,
                                  [menu, content] { menu->toggle(content); });
    action->setAutoRepeat(false);
    return action;
  };
  add(RingContent::kTools, RingMenu::tr("&Ring of tools at the pen"), {Qt::Key_Q},
      RingMenu::tr("Eight tools around the pen, each in its own direction. Hold the key, move in "
                   "the direction, and release the key."))
      ->setIcon(icon_of("more"));
  QAction* media = add(RingContent::kMedia, RingMenu::tr("Ring of &media at the pen"),
                       {Qt::SHIFT | Qt::Key_Q}, RingMenu::tr("Eight media around the pen."));
  media->setIcon(icon_of("palette"));
  media->setIconText(RingMenu::tr("Media"));
  QAction* sizes = add(RingContent::kSizes, RingMenu::tr("Ring of si&zes at the pen"), {},
                       RingMenu::tr("Eight sizes around the pen: widths of new lines, or sizes of "
                                    "the current tool. They grow clockwise."));
  sizes->setIcon(icon_of("size-up"));
  sizes->setIconText(RingMenu::tr("Size"));
}

}  // namespace felt::desktop
