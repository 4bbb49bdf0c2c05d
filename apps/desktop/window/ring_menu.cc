#include "desktop/window/ring_menu.h"

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

#include "desktop/engine/text_of.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

/// The wells, clockwise from the top. They do not depend on the drawing or on earlier choices,
/// because a hand learns directions. The pencil and the eraser lie opposite each other. An empty
/// name opens the ring of media.
constexpr std::array<const char*, ChoiceRing::kWells> kTools{
    "pencil", "shape", "pull", "smooth", "eraser", "transform", "lasso", ""};
constexpr std::array<const char*, ChoiceRing::kWells> kMedia{
    "pencil", "pencil-soft", "ink-pen", "brush-pen", "felt-tip", "crayon", "charcoal", "chalk"};

constexpr double kLinesPerRadius = 7.0;  // radius of the circle of wells, in heights of a line
constexpr double kButtonShare = 0.75;   // width of a button, as a share of the radius
// The distances at which the hand can feel the wells of a device, whatever the zoom, mm (chosen).
constexpr double kMinRadiusMm = 8.0, kMaxRadiusMm = 24.0;
constexpr int kRingIconPx = 22;

QString ring_text(const char* english) {
  return QCoreApplication::translate("RingMenu", english);
}

QString action_of(RingMenu::Content content) {
  return content == RingMenu::Content::kTools ? QStringLiteral("tool.ring")
                                              : QStringLiteral("tool.media_ring");
}

/// Returns the well that an arrow key chooses: first its own direction, then the neighbour on the
/// side of that direction. Returns none for other keys.
std::optional<std::size_t> well_of_key(int key, std::optional<std::size_t> now) {
  constexpr std::array kKeys{Qt::Key_Up, Qt::Key_Right, Qt::Key_Down, Qt::Key_Left};
  const auto at = std::find(kKeys.begin(), kKeys.end(), key);
  if (at == kKeys.end()) return std::nullopt;
  const auto target = 2 * static_cast<std::size_t>(at - kKeys.begin());
  constexpr std::size_t n = ChoiceRing::kWells;
  const std::size_t turn = now ? (target + n - *now) % n : n / 2;
  if (turn == n / 2) return target;
  return turn == 0 ? target : (*now + (turn < n / 2 ? 1 : n - 1)) % n;
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
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    auto* button = buttons_[i] = new QToolButton(this);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setCheckable(true);
    connect(button, &QToolButton::clicked, this, [this, i] {
      choose(i);
      run();
    });
  }
  hide();
  connect(&canvas, &Canvas::ring_wanted, this,
          [this](QPointF px) { open(Content::kTools, px, By::kButton); });
  connect(&canvas, &Canvas::view_changed, this, &RingMenu::close_ring);
  connect(&studio_, &Studio::opened, this, &RingMenu::close_ring);
  connect(&studio_, &Studio::shown, this, &RingMenu::follow_device);
}

void RingMenu::open(Content content, QPointF px, By by) {
  if (ring_ || studio_.session().gesture_in_progress()) return;
  content_ = content;
  by_ = by;
  is_held_ = true;
  touches_ = false;
  fill(content);
  place(px);
  qApp->installEventFilter(this);  // before the filter of PenInput
  show();
  raise();
  if (by == By::kKey) setFocus();
  show_choice();
}

void RingMenu::close_ring() {
  if (!ring_) return;
  ring_.reset();
  qApp->removeEventFilter(this);
  const bool had_focus = hasFocus() || isAncestorOf(focusWidget());
  hide();
  if (had_focus) canvas_.setFocus();
  studio_.set_menu_force({});
}

/// Gives the buttons their names and pictures.
void RingMenu::fill(Content content) {
  const bool tools = content == Content::kTools;
  setAccessibleName(tools ? tr("Ring of tools") : tr("Ring of media"));
  const std::string medium = drawing_medium(studio_.session());
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    QToolButton* button = buttons_[i];
    const std::string id = tools ? kTools[i] : kMedia[i];
    QString name = tr("Media");
    QIcon icon = icon_of("palette");
    bool is_current = false;
    if (!tools) {
      const Medium* known = studio_.materials().find_medium(id);
      name = known ? medium_label(*known) : QString();
      icon = swatch_icon(QPixmap::fromImage(pictures_.of(id)), palette());
      is_current = id == medium;
    } else if (const QAction* tool = actions_.find(QStringLiteral("tool.") + text_of(id))) {
      name = tool->text().remove(QLatin1Char('&'));
      icon = tool->icon();
      is_current = tool->isChecked();
    }
    button->setIcon(icon);
    button->setIconSize(tools ? QSize(kRingIconPx, kRingIconPx) : MediaPictures::kSize);
    button->setAccessibleName(name);
    button->setText(name);
    button->setChecked(is_current);
  }
}

/// Places the ring around a pixel of the canvas, and its wells on the page.
void RingMenu::place(QPointF px) {
  const double radius_px = kLinesPerRadius * fontMetrics().height();
  const int width = qRound(kButtonShare * radius_px);
  int height = 0;
  for (QToolButton* button : buttons_) {
    button->setText(fontMetrics().elidedText(button->accessibleName(), Qt::ElideRight, width - 4));
    height = std::max(height, button->sizeHint().height());
  }
  const double half = radius_px + 0.6 * width;
  resize(QSize(1, 1) * qRound(2.0 * half));
  middle_px_ = QRectF(rect()).center();
  move_to(px);
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * double(i) / double(buttons_.size());
    const QPointF at = middle_px_ + radius_px * QPointF(std::sin(angle), -std::cos(angle));
    buttons_[i]->setGeometry(qRound(at.x()) - width / 2, qRound(at.y()) - height / 2, width,
                             height);
  }
  const CanvasView& view = canvas_.view();
  const Point middle = view.to_mm(px);
  Vec up = view.to_mm(px - QPointF(0.0, radius_px)) - middle;
  Vec right = view.to_mm(px + QPointF(radius_px, 0.0)) - middle;
  if (!studio_.loop().is_pointed()) {
    const double length = std::max(norm(up), 1e-9);
    const double share = std::clamp(length, kMinRadiusMm, kMaxRadiusMm) / length;
    up = share * up;
    right = share * right;
  }
  ring_.emplace(middle, up, right);
}

void RingMenu::move_to(QPointF px) {
  const QPointF at = window()->mapFromGlobal(canvas_.mapToGlobal(px));
  move((at - middle_px_).toPoint());
}

bool RingMenu::eventFilter(QObject* watched, QEvent* event) {
  if (!ring_ || (watched != &canvas_ && watched != this && watched->parent() != this)) return false;
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return take_key(static_cast<QKeyEvent&>(*event));
    case QEvent::WindowDeactivate:
      close_ring();
      return false;
    default:
      return watched == &canvas_ && take_pointer(*event);
  }
}

/// Handles an event of the canvas. Returns false if the ring does not handle it.
bool RingMenu::take_pointer(QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove: {
      const auto& pointer = static_cast<const QSinglePointEvent&>(event);
      point(pointer.position(), pointer.buttons());
      break;
    }
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd: {
      const auto& fingers = static_cast<const QTouchEvent&>(event).points();
      const bool lifts = event.type() == QEvent::TouchEnd;
      point(fingers.constFirst().position(), lifts ? Qt::NoButton : Qt::LeftButton);
      break;
    }
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

void RingMenu::point(QPointF px, Qt::MouseButtons buttons) {
  const Point pen = canvas_.view().to_mm(px);
  const bool touches = buttons.testFlag(Qt::LeftButton);
  const bool others = (buttons & ~Qt::MouseButtons(Qt::LeftButton)) != 0;
  studio_.point({studio_.now_ns(), pen, touches, std::nullopt, 0, std::nullopt});
  if (!ring_) return;
  ring_->move(pen);
  show_choice();
  const bool released = by_ == By::kButton && is_held_ && !others && !touches;
  if (released) is_held_ = false;
  const bool lifted = std::exchange(touches_, touches) && !touches;
  if (lifted || (released && ring_->chosen())) run();
}

/// Follows the pen of a device.
void RingMenu::follow_device() {
  const PenState& pen = studio_.pen();
  if (!ring_ || studio_.loop().is_pointed() || !pen.is_known) return;
  ring_->move(pen.hand);
  show_choice();
  const bool touches = in_contact(pen.sample);
  if (std::exchange(touches_, touches) && !touches) run();
}

bool RingMenu::take_key(QKeyEvent& event) {
  const int key = event.key();
  const std::optional<std::size_t> well = well_of_key(key, ring_->chosen());
  const bool enters = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
  const bool is_ours = well || enters || key == Qt::Key_Escape;
  if (event.type() == QEvent::KeyRelease) {
    const auto keys = actions_.find(action_of(content_))->shortcuts();
    const bool opened_it = std::any_of(keys.begin(), keys.end(), [&](const QKeySequence& of) {
      return of.count() == 1 && of[0].key() == key;
    });
    if (by_ != By::kKey || !opened_it || event.isAutoRepeat() || !is_held_) return is_ours;
    is_held_ = false;
    if (ring_->chosen()) run();
    return true;
  }
  if (!is_ours) return false;
  event.accept();
  if (event.type() == QEvent::ShortcutOverride) return true;
  if (key == Qt::Key_Escape) {
    close_ring();
  } else if (enters) {
    run();
  } else {
    choose(well);
    buttons_[*well]->setFocus();  // so that a screen reader says its name
  }
  return true;
}

void RingMenu::choose(std::optional<std::size_t> well) {
  if (!ring_) return;
  ring_->choose(well);
  show_choice();
}

/// Shows the present choice, and lets a device feel it.
void RingMenu::show_choice() {
  const Session& session = studio_.session();
  studio_.set_menu_force(ring_force(*ring_, session.surface(), session.device()));
  update();
}

/// Closes the ring and carries out the choice, if there is one.
void RingMenu::run() {
  if (!ring_) return;
  const std::optional<std::size_t> well = ring_->chosen();
  const QPointF px = canvas_.view().to_px(ring_->middle());
  close_ring();
  if (!well) return;
  if (content_ == Content::kMedia) {
    choose_medium(studio_, kMedia[*well]);
  } else if (QAction* tool = actions_.find(QStringLiteral("tool.") + text_of(kTools[*well]))) {
    tool->trigger();
  } else {
    open(Content::kMedia, px, by_);
    is_held_ = false;
  }
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
  const auto add = [&](RingMenu::Content content, const QString& text, const QKeySequence& key,
                       const QString& tip) {
    QAction* action = actions.add(action_of(content), text, {key}, tip, [menu, &canvas, content] {
      if (menu->ring()) return menu->close_ring();
      menu->open(content, canvas.anchor(), RingMenu::By::kKey);
    });
    action->setAutoRepeat(false);
    action->setIcon(icon_of("palette"));
  };
  add(RingMenu::Content::kTools,
      ring_text(QT_TRANSLATE_NOOP("RingMenu", "&Ring of tools at the pen")), Qt::Key_Q,
      ring_text(QT_TRANSLATE_NOOP(
          "RingMenu", "Eight tools around the pen, each in its own direction. Hold the key, move "
                      "in the direction, and release.")));
  add(RingMenu::Content::kMedia,
      ring_text(QT_TRANSLATE_NOOP("RingMenu", "Ring of &media at the pen")),
      Qt::SHIFT | Qt::Key_Q,
      ring_text(QT_TRANSLATE_NOOP("RingMenu", "Eight media around the pen.")));
}

}  // namespace felt::desktop
