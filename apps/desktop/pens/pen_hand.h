#pragma once

#include <QObject>
#include <QPointF>
#include <cstdint>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/pens/button_role.h"

namespace felt::desktop {

/// The hand over a canvas, led by mouse, tablet, finger or keys, one at a time: the one that has
/// the pen down keeps it until it is lifted, except that the tablet takes precedence.
///
/// Borrowed tools are given back after the session has seen the pen lifted, so that the end of the
/// line belongs to the tool that drew it. The canvas must outlive it. Qt's main thread.
class PenHand : public QObject {
  Q_OBJECT

 public:
  enum class Source : std::uint8_t { kMouse, kTablet, kFinger, kKeys };

  explicit PenHand(Canvas& canvas);

  /// Moves the hand to a position, in pixels of the canvas or in mm on the page. `time_ns`: on the
  /// studio's clock. Returns false if another source has the pen down; the call is then ignored.
  bool point(Source source, QPointF px, std::int64_t time_ns, bool touching,
             std::optional<double> pressure, std::optional<double> tilt_deg = {});
  bool point_mm(Source source, Point mm, std::int64_t time_ns, bool touching,
                std::optional<double> pressure, std::optional<double> tilt_deg = {});
  /// Lifts the pen where it is, for any source. Does nothing if it is not down.
  void lift();
  /// Discards the gesture; the pen must be lifted before it does anything more.
  void cancel();
  [[nodiscard]] bool is_down() const noexcept { return down_; }
  [[nodiscard]] bool is_down(Source source) const noexcept { return down_ && source_ == source; }
  /// Returns true if it has had a position.
  [[nodiscard]] bool is_known() const noexcept { return is_known_; }
  /// Returns its position on the page; the middle of the view if there was none yet.
  [[nodiscard]] Point place_mm() const;

  /// Handles a button with this role that is pressed or released. kPan is handled by the code that
  /// moves the view.
  void press(ButtonRole role);
  void release(ButtonRole role);
  /// Releases all buttons.
  void release_all();
  /// Sets Shift and Ctrl, as the keyboard reports them.
  void set_keys(Qt::KeyboardModifiers keys);
  /// Sets modifiers that stay until they are removed: bits of tool.h.
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
  std::optional<double> pressure_, tilt_deg_;
  std::uint32_t keys_ = 0, held_ = 0, locked_ = 0;
  std::uint32_t borrowing_ = 0;  // roles that borrow a tool, as bits
  int owed_ = 0;                 // tools to give back after the lift was seen
  std::int64_t lifted_ns_ = 0;
};

}  // namespace felt::desktop
