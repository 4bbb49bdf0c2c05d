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

/// The panel "Feel": the large switch of the forces, the master strength, and the surface.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FeelPanel(Studio& studio, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted when the user wants to edit surfaces and media.
  void wants_editor();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_strength();
  QWidget* make_materials();
  void fill_materials();
  void make_reliefs();
  void report_forces();
  void report_strength();
  void report_material();
  void draw_swatches();
  [[nodiscard]] QAbstractButton* button_of(const std::string& id) const;

  Studio& studio_;
  QPushButton* forces_;
  QLabel* words_;
  QSlider* slider_ = nullptr;
  QSpinBox* percent_ = nullptr;
  QButtonGroup* materials_ = nullptr;
  QGridLayout* grid_ = nullptr;
  std::vector<std::string> ids_;  // parallel to the buttons of materials_
  QLabel* material_ = nullptr;
  SafetyState reported_state_ = SafetyState::kOff;
  QThreadPool maker_;  // makes the pictures of the reliefs; the last member, so that its work ends
                       // before the other members are destroyed
};

}  // namespace felt::desktop
