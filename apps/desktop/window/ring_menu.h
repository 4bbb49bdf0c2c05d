#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <array>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/materials/media_pictures.h"
#include "desktop/window/ring_wells.h"
#include "felt/tools/choice_ring.h"

class QKeyEvent;
class QTouchEvent;
class QToolButton;

namespace felt::desktop {

/// The rings of tools, media and sizes around the pen (ChoiceRing). A ring opens for
/// Canvas::ring_wanted and Canvas::ring_pressed, and for the commands of add_ring_menu().
///
/// While it is open, it handles the input of the canvas, and nothing is drawn. With a force
/// feedback device, the pen feels the wells on the surface (UseRing); other devices
/// get a tick for each new choice (Studio::tick_wanted).
///
/// The direction from the middle chooses. The choice is carried out when the button or key that
/// opened the ring is released or the pen that pressed is lifted, by a click or tap, when the pen
/// of a device is lifted, or by Return; the arrow keys choose, too. A release in the middle leaves
/// the ring open. A click in the middle, a press outside of the canvas, and Escape close it without
/// a choice. A choice does exactly what the tool bar or the media picker does, so that a recording
/// contains their events.
class RingMenu : public QWidget {
  Q_OBJECT

 public:
  /// What opened the ring; its release may choose.
  enum class By : std::uint8_t { kButton, kKey, kPress };

  /// The arguments must outlive this object. `actions` must have the commands of the tools.
  RingMenu(const Actions& actions, Canvas& canvas, const MediaPictures& pictures, QWidget* window);

  /// Opens a ring around a pixel of the canvas, or around the pen if the user holds a device. Does
  /// nothing while a line is drawn, or if a ring is open.
  void open(RingContent content, QPointF px, By by);
  /// Opens a ring at the pen, for a command; closes it if it is open.
  void toggle(RingContent content);
  /// Closes the ring without a choice. If a button is down, the canvas does not get the rest of
  /// this press, which would draw or erase.
  void close_ring();
  /// Returns the ring, or nullopt while it is closed.
  [[nodiscard]] const std::optional<ChoiceRing>& ring() const noexcept { return ring_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void make_buttons();
  void fill();
  void place(QPointF px);
  bool take_pointer(QEvent& event);
  [[nodiscard]] bool is_beside(QPointF px) const;
  void take_touch(const QTouchEvent& event);
  void focus_choice(const QObject* watched, Qt::FocusReason reason);
  bool skip_rest_of_press(const QEvent& event);
  void point(QPointF px, Qt::MouseButtons buttons);
  bool take_key(QKeyEvent& event);
  bool lifts(bool touches);
  bool release_key(const QKeyEvent& event);
  [[nodiscard]] bool holds_device() const;
  void follow_device();
  void move_to(Point pen);
  void choose(std::size_t well);
  void say_choice();
  void run();

  const Actions& actions_;
  Canvas& canvas_;
  Studio& studio_;
  const MediaPictures& pictures_;
  std::array<QToolButton*, ChoiceRing::kWells> buttons_{};
  std::array<RingWell, ChoiceRing::kWells> wells_;
  RingContent content_ = RingContent::kTools;
  std::optional<ChoiceRing> ring_;  // while it is open
  Point pen_;                       // its last position, mm
  QPointF middle_px_;               // in pixels of this widget
  By by_ = By::kButton;
  bool is_held_ = false;     // what opened it has not been released
  QElapsedTimer released_;   // since the release of a key chose
  bool keys_chose_ = false;  // the choice stays until the pen moves
  bool touches_ = false;     // the pen touches since the ring is open, or the left button is down
  bool has_pen_ = false;     // a tablet pen moved since the ring is open
  bool is_pressed_ = false;  // a button of the mouse or tablet is down
  bool skips_ = false;       // the ring was closed during a press that has not ended
};

/// Adds the rings to the canvas, with the commands tool.ring (Q), tool.media_ring (Shift+Q) and
/// tool.size_ring. All arguments must outlive the window.
void add_ring_menu(Actions& actions, Canvas& canvas, const MediaPictures& pictures,
                   QWidget* window);

}  // namespace felt::desktop
