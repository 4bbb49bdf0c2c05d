#pragma once

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QThreadPool>
#include <QWidget>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// How it shall feel: the large switch of the forces, master strength, the sheet's material.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FeelPanel(Studio& studio, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// A person wants to change what sheets and media are like.
  void wants_editor();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_strength();
  QWidget* make_materials();
  void fill_materials();
  void make_reliefs();
  void tell_forces();
  void tell_strength();
  void tell_material();
  void draw_swatches();
  [[nodiscard]] QAbstractButton* button_of(const std::string& id) const;

  Studio& studio_;
  QPushButton* forces_;
  QLabel* words_;
  QSlider* slider_ = nullptr;
  QSpinBox* percent_ = nullptr;
  QButtonGroup* materials_ = nullptr;
  QGridLayout* grid_ = nullptr;
  std::vector<std::string> ids_;  // of materials_, in their order
  QLabel* material_ = nullptr;
  SafetyState told_state_ = SafetyState::kOff;
  QThreadPool maker_;  // of the reliefs; last, so that it has ended before the rest goes
};

}  // namespace felt::desktop
