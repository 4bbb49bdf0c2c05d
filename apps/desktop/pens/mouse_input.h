#pragma once

#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QObject>
#include <QTimer>
#include <QWheelEvent>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"
#include "desktop/pens/view_drag.h"

namespace felt::desktop {

/// Moves the hand with the mouse. The left button puts the pen down, the middle button moves the
/// view, and the right button may draw with a borrowed tool; the wheel zooms at the pointer. A
/// click of the right button, without a motion of more than kClickPx, opens the palette at the
/// pointer, unless the button acts when it is pressed (undo, modifiers, ring). If the button is
/// held still for kHoldMs, the ring of tools opens instead. The arguments of the constructor must
/// outlive this object.
///
///   wheel                  zoom           Shift + wheel          move sideways
///   Ctrl + wheel           zoom, finely   Ctrl + Shift + wheel   turn
///   touchpad, two fingers  move           pinch, turn            zoom, turn
class MouseInput : public QObject {
  Q_OBJECT

 public:
  static constexpr double kClickPx = 4.0;
  static constexpr int kHoldMs = 400;

  MouseInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings);

  /// Handles press, double click, move and release.
  void take(const QMouseEvent& event);
  void take(const QWheelEvent& event);
  /// Handles a touchpad gesture. Returns false if it is not one of the gestures in the table above.
  bool take(const QNativeGestureEvent& event);
  /// Treats all buttons as released, because the window is no longer active.
  void release_all();

 private:
  [[nodiscard]] bool drags(const QMouseEvent& event);
  void hold_right(std::int64_t time_ns);

  Canvas& canvas_;
  PenHand& hand_;
  ViewDrag& drag_;
  const PenSettings& settings_;
  DeviceClock clock_;
  Qt::MouseButton dragging_ = Qt::NoButton;    // the button that moves the view
  ButtonRole right_held_ = ButtonRole::kNone;  // the role of the right button while it is held
  std::optional<QPointF> click_;  // position of a press of the right button that may be a click
  // Time of the press that opened a ring; PenInput reports a press twice.
  std::optional<quint64> ring_press_;
  QTimer hold_;  // while that button may be held still
};

}  // namespace felt::desktop
