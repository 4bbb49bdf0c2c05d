#pragma once

#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The steady hand in the preferences: on or off, what was measured, and a button that measures it
/// (SteadyDialog). It shows and sets the options of the pencil.
class SteadyGroup : public QGroupBox {
  Q_OBJECT

 public:
  explicit SteadyGroup(Studio& studio, QWidget* parent = nullptr);

 private:
  void load();

  Studio& studio_;
  QCheckBox* on_;
  QLabel* words_;
};

}  // namespace felt::desktop
