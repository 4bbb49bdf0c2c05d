#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/materials/media_pictures.h"
#include "felt/tools/choice_ring.h"

class QKeyEvent;
class QToolButton;

namespace felt::desktop {

/// The ring of tools, and the ring of media, around the pen (ChoiceRing). It opens for
/// Canvas::ring_wanted, and for the commands of add_ring_menu().
///
/// While it is open, it handles the input of the canvas, and a device that has force lets the pen
/// feel the wells on the surface (Studio::set_menu_force); nothing is drawn. A choice is made by
/// releasing the button or key that opened it away from the middle, by a click or tap, by lifting
/// the pen of a device, or with the arrow keys and Enter; in the middle, a release leaves the ring
/// open, and a click or Escape closes it. A choice runs the same commands as the tool bar and the
/// media picker, so that a recording contains their events.
class RingMenu : public QWidget {
  Q_OBJECT

 public:
  enum class Content : std::uint8_t { kTools, kMedia };
  /// What opened the ring; its release may choose.
  enum class By : std::uint8_t { kButton, kKey };

  /// The arguments must outlive this object. `actions` must have the commands of the tools.
  RingMenu(const Actions& actions, Canvas& canvas, const MediaPictures& pictures, QWidget* window);

  /// Opens the ring around a pixel of the canvas. Does nothing while a line is drawn.
  void open(Content content, QPointF px, By by);
  void close_ring();
  [[nodiscard]] const std::optional<ChoiceRing>& ring() const noexcept { return ring_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void fill(Content content);
  void place(QPointF px);
  void move_to(QPointF px);
  bool take_pointer(QEvent& event);
  void point(QPointF px, Qt::MouseButtons buttons);
  bool take_key(QKeyEvent& event);
  void choose(std::optional<std::size_t> well);
  void follow_device();
  void show_choice();
  void run();

  const Actions& actions_;
  Canvas& canvas_;
  Studio& studio_;
  const MediaPictures& pictures_;
  std::array<QToolButton*, ChoiceRing::kWells> buttons_{};
  Content content_ = Content::kTools;
  std::optional<ChoiceRing> ring_;  // while it is open
  QPointF middle_px_;               // in pixels of this widget
  By by_ = By::kButton;
  bool is_held_ = false;  // the button or key that opened it has not been released
  bool touches_ = false;  // the pen touches since the ring is open, or the left button is down
};

/// Adds the rings to the canvas, with the commands tool.ring (Q) and tool.media_ring (Shift+Q). All
/// arguments must outlive the window.
void add_ring_menu(Actions& actions, Canvas& canvas, const MediaPictures& pictures,
                   QWidget* window);

}  // namespace felt::desktop
