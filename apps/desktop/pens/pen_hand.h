#pragma once

#include <QObject>
#include <QPointF>
#include <cstdint>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/pens/button_role.h"

namespace felt::desktop {

/// The hand over a canvas. Mouse, tablet, finger or keys move the hand, one source at a time. While
/// the tablet has the pen down, no other source can move the hand. While another source has the pen
/// down, the tablet can take over the hand, and so can a source that also puts the pen down; the
/// first gesture then ends.
///
/// When a button is released, the former tool is selected again only after the session has handled
/// the sample with the lifted pen, so that the borrowed tool draws its line to the end. The canvas
/// must outlive this object. Use it in Qt's main thread.
class PenHand : public QObject {
  Q_OBJECT

 public:
  enum class Source : std::uint8_t { kMouse, kTablet, kFinger, kKeys };

  explicit PenHand(Canvas& canvas);

  /// Moves the hand to a position, in pixels of the canvas or in mm on the page. `time_ns` is on
  /// the studio's clock. Returns false and does nothing if another source has the pen down and this
  /// source cannot take over the hand.
  bool point(Source source, QPointF px, std::int64_t time_ns, bool touching,
             std::optional<double> pressure, std::optional<double> tilt_deg = {});
  bool point_mm(Source source, Point mm, std::int64_t time_ns, bool touching,
                std::optional<double> pressure, std::optional<double> tilt_deg = {});
  /// Lifts the pen at its present position, whichever source has put it down. Does nothing if the
  /// pen is not down.
  void lift();
  /// Discards the gesture in progress and lifts the pen.
  void cancel();
  [[nodiscard]] bool is_down() const noexcept { return down_; }
  [[nodiscard]] bool is_down(Source source) const noexcept { return down_ && source_ == source; }
  /// Returns true if the hand has had a position.
  [[nodiscard]] bool is_known() const noexcept { return is_known_; }
  /// Returns the hand's position on the page, or the middle of the view if it has had no position.
  [[nodiscard]] Point place_mm() const;

  /// Handles the press of a button with this role; release() handles its release. kPan is handled
  /// by the code that moves the view.
  void press(ButtonRole role);
  void release(ButtonRole role);
  /// Releases all buttons.
  void release_all();
  /// Sets Shift, Ctrl and Alt as the keyboard reports them.
  void set_keys(Qt::KeyboardModifiers keys);
  /// Sets modifiers that stay until they are removed: the bits defined in tool.h.
  void set_locked(std::uint32_t bits);
  [[nodiscard]] std::uint32_t locked() const noexcept { return locked_; }

 Q_SIGNALS:
  /// Emitted when the pen was put down or lifted.
  void down_changed(bool down);

 private:
  [[nodiscard]] std::uint32_t buttons() const noexcept { return keys_ | held_ | locked_; }
  void send(std::int64_t time_ns);
  void send_buttons(std::uint32_t before);
  void on_sample(const PenSample& sample);
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
  std::uint32_t borrowing_ = 0;    // roles that borrow a tool, one bit each
  int owed_ = 0;                   // number of borrowed tools to give back when the session has
                                   // handled the lifted pen
  int touches_owed_ = 0;           // number of touches that the session has not handled
  bool session_touches_ = false;   // in the sample that the session handled last
  std::int64_t lifted_ns_ = 0;     // when the hand lifted the pen
  std::int64_t seen_lift_ns_ = 0;  // time of the first sample after the last contact
};

}  // namespace felt::desktop
