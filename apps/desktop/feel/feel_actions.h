#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Brings what a person chose last time into a studio: strength, limit, material. Also adds to the
/// window: feel.forces, feel.forces_off, feel.stronger, feel.weaker, a switch for each material
/// (feel.sheet_paper ...), feel.sheet_own with a menu of the others, feel.sound where there is
/// sound; Escape pressed twice switches the forces off, and so does a fault that needs a person.
/// Nothing but feel.forces (and its button in the panel) switches them on again.
void add_feel_actions(Actions& actions, Studio& studio, QWidget* window);

/// Chooses a material for hand and eye, and keeps the choice.
void choose_material(Studio& studio, const QString& id);
/// Master strength, 0..1, and keeps it.
void choose_strength(Studio& studio, double share);

/// Tells when Escape is pressed twice within 0.6 s, whatever has the focus in this program, and
/// whatever else the key does. Holding it down is one press.
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

  QElapsedTimer since_;  // the last press that counted
  bool is_down_ = false;
};

}  // namespace felt::desktop
