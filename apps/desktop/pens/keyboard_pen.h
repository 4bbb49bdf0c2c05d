#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QString>

#include "desktop/pens/pen_hand.h"

namespace felt::desktop {

/// Drawing with keys alone. The arrows move the pen, faster the longer one is held; Shift makes
/// fine steps. Return, Enter or Insert puts the pen down and lifts it, but only after an arrow has
/// moved it or Tab or F6 has moved the focus here, so that an Enter meant for a text field draws
/// nothing. Escape cancels the gesture. Steps are counted, not timed: the same keys make the same
/// line. The view scrolls along. The arguments of the constructor must outlive it.
///
/// With a device that cannot sense whether its pen touches, the pen touches while one of these
/// pen-down keys is held.
class KeyboardPen : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStepPx = 4.0;
  static constexpr double kFineStepPx = 1.0;
  static constexpr int kStepsPerFactor = 8;  ///< key repeats until a step is one unit longer
  static constexpr int kMaxFactor = 8;

  KeyboardPen(Canvas& canvas, PenHand& hand);

  /// Returns true if the key belongs to it in the present state; for ShortcutOverride.
  [[nodiscard]] bool wants(const QKeyEvent& event) const;
  /// Handles a pressed key. Returns false if the key is not one of its own.
  bool press(const QKeyEvent& event);
  /// Handles a released key: its next press starts with small steps.
  void release(const QKeyEvent& event);
  /// Treats all keys as released, because their release events will not arrive.
  void let_go();
  /// Mouse or pen lead now, until an arrow is pressed again.
  void stop_leading() noexcept { is_leading_ = false; }

 Q_SIGNALS:
  /// A message for screen readers.
  void said(const QString& text);

 private:
  [[nodiscard]] bool may_touch() const;
  void step(const QKeyEvent& event);
  void keep_in_view(QPointF px);

  Canvas& canvas_;
  PenHand& hand_;
  int key_ = 0;
  int repeats_ = 0;
  bool is_leading_ = false;  // an arrow was pressed since the mouse moved
  int held_ = 0;             // the key that holds a device's pen down
};

}  // namespace felt::desktop
