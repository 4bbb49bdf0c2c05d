#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Applies the user's stored strength, force limit and surface to a studio. Adds the actions
/// feel.forces, feel.forces_off, feel.stronger, feel.weaker, a switch for each built-in surface
/// (feel.surface_paper ...), feel.surface_own with a menu of the other surfaces, and feel.sound if
/// the program has sound. Two presses of Escape switch the forces off, and so does a fault that
/// only the user can clear. Only feel.forces (and its button in the panel) switches forces on
/// again.
void add_feel_actions(Actions& actions, Studio& studio, QWidget* window);

/// Chooses the surface and stores the choice.
void choose_material(Studio& studio, const QString& id);
/// Sets the master strength, 0..1, and stores it.
void choose_strength(Studio& studio, double share);

/// Detects two presses of Escape within 0.6 s, in any widget of this program. Escape still has its
/// other effects. Holding the key down counts as one press.
class DoubleEscape : public QObject {
  Q_OBJECT

 public:
  static constexpr int kWithinMs = 600;

  explicit DoubleEscape(QObject* parent);

 Q_SIGNALS:
  void pressed_twice();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void press();

  QElapsedTimer since_;  // time since the last press that counted
  bool is_down_ = false;
};

}  // namespace felt::desktop
