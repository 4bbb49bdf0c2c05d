#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTabletEvent>
#include <array>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"
#include "desktop/pens/view_drag.h"

namespace felt::desktop {

/// A pen of a tablet as the hand: pressure by the person's curve, lean as it is, the eraser end and
/// the buttons on its side as borrowed tools, times of the device. What it is given must outlive
/// it.
class TabletInput : public QObject {
  Q_OBJECT

 public:
  /// After this time without the pen, fingers are meant again.
  static constexpr qint64 kPalmMs = 500;

  TabletInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings);

  /// Press, move and release over the canvas.
  void take(const QTabletEvent& event);
  /// The pen went out of reach: what it did ends as if it were lifted.
  void leave();
  /// The window is no longer in use: likewise, and no button is held.
  void let_go();
  /// The pen is over the tablet, or was a moment ago: a touch is a palm.
  [[nodiscard]] bool is_near() const;

  enum class Pressure : std::uint8_t { kNotSeen, kNone, kSeen };
  /// Whether the pen has shown that it senses pressure.
  [[nodiscard]] Pressure pressure_seen() const noexcept { return pressure_seen_; }

 Q_SIGNALS:
  /// The pen comes near.
  void came();
  /// `raw` as the tablet says it.
  void pressed(double raw);
  void pressure_seen_changed();

 private:
  void use_end(bool is_eraser);
  void use_buttons(Qt::MouseButtons now, QPointF px);
  void use_button(std::size_t which, bool down, QPointF px);
  void note_pressure(const QTabletEvent& event, bool touching);

  PenHand& hand_;
  ViewDrag& drag_;
  Studio& studio_;
  const PenSettings& settings_;
  DeviceClock clock_;
  QElapsedTimer since_;  // the last event
  bool erasing_ = false;
  bool drags_ = false;                    // the view
  std::array<ButtonRole, 2> held_roles_;  // of the side buttons, while they are held
  std::array<bool, 2> held_{};
  Pressure pressure_seen_ = Pressure::kNotSeen;
};

}  // namespace felt::desktop
