#pragma once

#include <QObject>
#include <QPointF>
#include <cstdint>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/pens/button_role.h"

namespace felt::desktop {

/// The one hand over a canvas that mouse, tablet, finger and keys lead, one at a time: who has the
/// pen down keeps it until it is lifted, but for the tablet, which goes before the others.
///
/// Tools that a button borrows go back when the session has seen the pen lifted, so that the end of
/// the line is of the tool that drew it. The canvas must outlive it. Qt's main thread.
class PenHand : public QObject {
  Q_OBJECT

 public:
  enum class Source : std::uint8_t { kMouse, kTablet, kFinger, kKeys };

  explicit PenHand(Canvas& canvas);

  /// The hand is there, in pixels of the canvas or on the sheet. `time_ns`: of the studio's clock.
  /// False: another one has the pen down, and this is ignored.
  bool point(Source source, QPointF px, std::int64_t time_ns, bool touching,
             std::optional<double> pressure, std::optional<double> lean_deg = {});
  bool point_mm(Source source, Point mm, std::int64_t time_ns, bool touching,
                std::optional<double> pressure, std::optional<double> lean_deg = {});
  /// The pen is lifted where it is, whatever keeps it down. Nothing where it is not down.
  void lift();
  /// What it was doing never was; the pen must be lifted before it does anything more.
  void cancel();
  [[nodiscard]] bool is_down() const noexcept { return down_; }
  [[nodiscard]] bool is_down(Source source) const noexcept { return down_ && source_ == source; }
  /// It has been somewhere.
  [[nodiscard]] bool is_known() const noexcept { return is_known_; }
  /// On the sheet; the middle of the view before there was any.
  [[nodiscard]] Point place_mm() const;

  /// A button with this role is pressed or released; kPan is for whoever moves the view.
  void press(ButtonRole role);
  void release(ButtonRole role);
  /// All buttons are released.
  void release_all();
  /// Shift and Ctrl, as the keyboard says.
  void set_keys(Qt::KeyboardModifiers keys);
  /// Modifiers that stay until they are taken away: bits of tool.h.
  void set_locked(std::uint32_t bits);
  [[nodiscard]] std::uint32_t locked() const noexcept { return locked_; }

 Q_SIGNALS:
  /// The pen was put down or lifted.
  void down_changed(bool down);

 private:
  [[nodiscard]] std::uint32_t buttons() const noexcept { return keys_ | held_ | locked_; }
  void send(std::int64_t time_ns);
  void send_buttons(std::uint32_t before);
  void give_back(bool at_once);
  void settle();

  Canvas& canvas_;
  Studio& studio_;
  Source source_ = Source::kMouse;
  bool down_ = false;
  bool is_known_ = false;
  Point place_;
  std::optional<double> pressure_, lean_deg_;
  std::uint32_t keys_ = 0, held_ = 0, locked_ = 0;
  std::uint32_t borrowing_ = 0;  // roles that hold a tool, as bits
  int owed_ = 0;                 // tools that go back when the lift has been seen
  std::int64_t lifted_ns_ = 0;
};

}  // namespace felt::desktop
