#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QString>

#include "desktop/pens/pen_hand.h"

namespace felt::desktop {

/// Drawing with keys alone: the arrows move the pen, faster the longer one is held, Shift finely;
/// Return, Enter or Insert put it down and lift it, once an arrow has moved it or Tab or F6 has
/// brought the focus here: an Enter that was meant for a text field draws nothing. Escape cancels
/// what it draws. Steps are counted, not timed: the same keys make the same line. The view follows.
/// What it is given must outlive it.
///
/// A person who holds a device that cannot tell whether its pen touches draws while one of the keys
/// is held that put the pen down.
class KeyboardPen : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStepPx = 4.0;
  static constexpr double kFineStepPx = 1.0;
  static constexpr int kStepsPerFactor = 8;  ///< repeats until a step is one more step long
  static constexpr int kMostFactor = 8;

  KeyboardPen(Canvas& canvas, PenHand& hand);

  /// Whether the key is ours as things are; for ShortcutOverride.
  [[nodiscard]] bool wants(const QKeyEvent& event) const;
  /// Does what a pressed key does. False: it is not ours.
  bool press(const QKeyEvent& event);
  /// The key is up: its next press begins with small steps.
  void release(const QKeyEvent& event);
  /// No key is held any more, as far as anybody will be told.
  void let_go();
  /// Mouse or pen lead now, until an arrow is pressed again.
  void stop_leading() noexcept { is_leading_ = false; }

 Q_SIGNALS:
  /// What happened, for who cannot see it.
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
