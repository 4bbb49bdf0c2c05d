#pragma once

#include <QObject>
#include <QTabletEvent>
#include <array>
#include <cstdint>
#include <optional>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"
#include "desktop/pens/view_drag.h"

namespace felt::desktop {

/// Moves the hand with the pen of a tablet. The user's curve is applied to the pressure; the tilt
/// is unchanged. The eraser end and the side buttons borrow tools. Times are computed from the
/// device's own time stamps. The arguments of the constructor must outlive this object.
class TabletInput : public QObject {
  Q_OBJECT

 public:
  /// A touch within kPalmNs after the pen's last event counts as a palm.
  static constexpr std::int64_t kPalmNs = 500'000'000;

  TabletInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings);

  /// Handles press, move and release over the canvas.
  void take(const QTabletEvent& event);
  /// Handles a pen that left the range: its gesture ends as if the pen had been lifted.
  void leave();
  /// Discards the gesture in progress, and ignores the pen until it is lifted.
  void cancel();
  /// Treats all side buttons as released and ends a drag of the view. Called when the window is no
  /// longer active.
  void release_all();
  /// Returns true if the pen is over the tablet, or was there a moment ago. A touch then counts as
  /// a palm.
  [[nodiscard]] bool is_near() const;

  enum class Pressure : std::uint8_t { kNotSeen, kNone, kSeen };
  /// Returns whether the pen has shown that it senses pressure.
  [[nodiscard]] Pressure pressure_seen() const noexcept { return pressure_seen_; }

 Q_SIGNALS:
  /// Emitted when the pen comes into range.
  void came();
  /// Emitted for each event of the pen. `raw` is the tablet's pressure before the curve, or 0 if
  /// the pen does not touch.
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
  std::optional<std::int64_t> last_ns_;  // time of the last event
  bool erasing_ = false;
  bool drags_ = false;                    // true while a side button drags the view
  std::array<ButtonRole, 2> held_roles_;  // roles of the side buttons while they are held
  std::array<bool, 2> held_{};
  bool ignores_ = false;  // this touch was cancelled
  Pressure pressure_seen_ = Pressure::kNotSeen;
};

}  // namespace felt::desktop
