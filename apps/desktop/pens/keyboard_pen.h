#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QString>

#include "desktop/pens/pen_hand.h"

namespace felt::desktop {

/// Lets the user draw with keys alone. The arrows move the pen, faster the longer the key is held;
/// Shift makes fine steps. Return, Enter or Insert puts the pen down and lifts it. This works only
/// after an arrow has moved the pen or Tab or F6 has moved the focus here, so that an Enter meant
/// for a text field draws nothing. Escape cancels the gesture. Steps are counted, not timed, so
/// that the same keys make the same line. The view scrolls with the pen. The arguments of the
/// constructor must outlive it.
///
/// If the device cannot sense contact, its pen counts as touching while Return, Enter or Insert is
/// held.
class KeyboardPen : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStepPx = 4.0;
  static constexpr double kFineStepPx = 1.0;
  static constexpr int kStepsPerFactor = 8;  ///< number of key repeats until a step grows by one
                                             ///< unit
  static constexpr int kMaxFactor = 8;

  KeyboardPen(Canvas& canvas, PenHand& hand);

  /// Returns true if it would handle the key in its present state; for ShortcutOverride.
  [[nodiscard]] bool wants(const QKeyEvent& event) const;
  /// Handles a pressed key. Returns false if it does not use the key.
  bool press(const QKeyEvent& event);
  /// Handles a released key. The next press of this key starts with small steps.
  void release(const QKeyEvent& event);
  /// Treats all keys as released, because their release events will not arrive.
  void let_go();
  /// Mouse or pen move the hand now, until an arrow is pressed again.
  void stop_leading() noexcept { is_leading_ = false; }

 Q_SIGNALS:
  /// Reports a message for screen readers.
  void said(const QString& text);

 private:
  [[nodiscard]] bool may_touch() const;
  void step(const QKeyEvent& event);
  void keep_in_view(QPointF px);

  Canvas& canvas_;
  PenHand& hand_;
  int key_ = 0;
  int repeats_ = 0;
  bool is_leading_ = false;  // an arrow was pressed since the mouse last moved
  int held_ = 0;             // the key that holds a device's pen down
};

}  // namespace felt::desktop
