#pragma once

#include <QObject>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/pens/keyboard_pen.h"
#include "desktop/pens/long_press.h"
#include "desktop/pens/mouse_input.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"
#include "desktop/pens/tablet_input.h"
#include "desktop/pens/touch_input.h"
#include "desktop/pens/view_drag.h"

class QMouseEvent;

namespace felt::desktop {

/// Returns true for a mouse event that the system made from a pen or a finger, for programs that
/// support only mice.
bool is_made_up(const QMouseEvent& event);

/// Handles mouse, tablet, touch and keys over a canvas. This event filter moves the hand (PenHand),
/// or pans, zooms and turns the view. The canvas must outlive this object.
///
/// A drag while Space is held pans the view; if Ctrl is also held, the drag zooms the view, and if
/// Shift is also held, it turns the view. A drag while Ctrl and Alt are held changes the size of
/// the tool. The arrow keys move selected lines by 1 mm, with Shift by 10 mm, with Ctrl by 0.1 mm.
/// A long press opens the ring of tools, if the settings say so (LongPress); its ink vanishes.
/// If the input ends without a release (the window loses the focus, a release event is lost, the
/// pen leaves the range), the pen is lifted.
class PenInput : public QObject {
  Q_OBJECT

 public:
  explicit PenInput(Canvas& canvas);

  bool eventFilter(QObject* watched, QEvent* event) override;

  [[nodiscard]] PenHand& hand() noexcept { return hand_; }
  [[nodiscard]] TabletInput& tablet() noexcept { return tablet_; }

 private:
  bool take_pointer(QEvent* event);
  bool take_keys(QEvent* event);
  bool press_key(QKeyEvent& event);
  bool release_key(QKeyEvent& event);
  [[nodiscard]] std::optional<Vec> nudge_of(const QKeyEvent& event) const;
  bool nudge(const QKeyEvent& event);
  void use_modifiers(Qt::KeyboardModifiers held);
  void offer_drag(Qt::KeyboardModifiers keys);
  void release_all();
  void come(QPointF px);
  void take_focus();
  void load_settings();
  void say_pressure();
  void open_ring(QPointF px);

  Canvas& canvas_;
  PenSettings settings_;
  PenHand hand_;
  ViewDrag drag_;
  TabletInput tablet_;
  TouchInput touch_;
  MouseInput mouse_;
  KeyboardPen keys_;
  LongPress press_;
  bool space_ = false;
};

}  // namespace felt::desktop
