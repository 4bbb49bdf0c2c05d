#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QThreadPool>
#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// How it shall feel: the large switch of the forces, master strength, the sheet's material.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FeelPanel(Studio& studio, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_strength();
  QWidget* make_materials();
  void tell_forces();
  void tell_strength();
  void tell_material();
  void draw_swatches();

  Studio& studio_;
  QPushButton* forces_;
  QLabel* words_;
  QSlider* slider_ = nullptr;
  QSpinBox* percent_ = nullptr;
  QButtonGroup* materials_ = nullptr;
  QLabel* material_ = nullptr;
  SafetyState told_state_ = SafetyState::kOff;
  QThreadPool maker_;  // of the reliefs; last, so that it has ended before the rest goes
};

}  // namespace felt::desktop
