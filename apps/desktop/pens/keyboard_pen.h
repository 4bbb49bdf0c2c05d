#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QString>

#include "desktop/pens/pen_hand.h"

namespace felt::desktop {

/// Lets the user draw with keys alone. The arrow keys move the pen, with steps that grow while the
/// key is held; Shift makes fine steps. Return, Enter or Insert puts the pen down; a second press
/// lifts the pen. These three keys work only after an arrow key has moved the pen, or after Tab or
/// F6 has moved the focus to the canvas, so that an Enter that was meant for a text field draws
/// nothing. Escape cancels the gesture. The length of a step depends on the number of key repeats
/// and not on time, so that the same keys draw the same line. The view scrolls with the pen. The
/// arguments of the constructor must outlive this object.
///
/// If the user holds a device, the three keys always work. If this device cannot sense contact, its
/// pen counts as touching while one of the three keys is held.
class KeyboardPen : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStepPx = 4.0;
  static constexpr double kFineStepPx = 1.0;
  static constexpr int kStepsPerFactor = 8;  ///< number of key repeats until a step grows by one
                                             ///< unit
  static constexpr int kMaxFactor = 8;

  KeyboardPen(Canvas& canvas, PenHand& hand);

  /// Returns true if press() would use the key now. Called for ShortcutOverride events.
  [[nodiscard]] bool wants(const QKeyEvent& event) const;
  /// Handles a pressed key. Returns false if the key has no meaning for the pen.
  bool press(const QKeyEvent& event);
  /// Handles a released key. The next press of this key starts with small steps.
  void release(const QKeyEvent& event);
  /// Treats all keys as released, because their release events will not arrive.
  void release_all();
  /// Must be called when the mouse or a pen moves the hand. An arrow key that was pressed before
  /// that no longer enables Return, Enter and Insert.
  void stop_leading() noexcept { is_leading_ = false; }

  /// Returns true if an arrow key has moved the pen since the mouse or a pen moved the hand.
  [[nodiscard]] bool is_leading() const noexcept { return is_leading_; }

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
  int held_ = 0;             // the key that is held to make a device's pen touch; 0: none
};

}  // namespace felt::desktop
