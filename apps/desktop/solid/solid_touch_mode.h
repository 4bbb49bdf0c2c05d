#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <memory>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/solid/solid_panel.h"

namespace felt::desktop {

/// Lets the pen touch the bodies of the solid view: the action "feel.touch_solid", Shift+F9. While
/// it is on, the bodies stand in front of the device where their outlines are on the page, and the
/// view shows the pen and the point on the surface that stands for it. The pen draws nothing.
///
/// A mouse or a tablet without forces gets the simulated stylus kTouchStylus meanwhile, so that the
/// cursor shows what the hand would feel. Afterwards the device and the tool are those of before.
///
/// It ends when the view has no body any more, when another tool is chosen, when another drawing is
/// opened, or when the device in use cannot push in three directions. After an edit the pen feels
/// the new bodies.
class SolidTouchMode : public QObject {
  Q_OBJECT

 public:
  static constexpr auto kTouchStylus = "simulated:touch";
  /// Room above the bodies that a device must reach, mm. Bodies that are higher are lowered.
  static constexpr double kRoomMm = 8.0;

  /// Adds the action. All arguments must live as long as this.
  SolidTouchMode(Studio& studio, SolidPanel& panel, Actions& actions, QObject* parent);

  [[nodiscard]] bool is_on() const noexcept { return is_on_; }
  [[nodiscard]] QAction* action() const noexcept { return action_; }

 private:
  void set_on(bool on);
  [[nodiscard]] QString tool() const;
  [[nodiscard]] QString why_not() const;
  void follow_device();
  void touch_bodies();
  void follow_bodies();
  void borrow_device();
  void give_back_device();
  void show_pen();

  Studio& studio_;
  SolidPanel& panel_;
  QAction* action_;
  bool is_on_ = false;
  QString tool_;  // when touching began
  bool is_borrowing_device_ = false;
  QString home_device_;  // to use again afterwards; empty: the device stays
  double lowered_mm_ = 0.0;
};

}  // namespace felt::desktop
