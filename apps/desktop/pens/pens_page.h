#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QSlider>
#include <QWidget>
#include <functional>
#include <optional>

#include "desktop/pens/pen_test_area.h"
#include "desktop/pens/pressure_curve_editor.h"

namespace felt::desktop {

/// The page "Pens" of the preferences: pressure with its curve and an area to try it, the roles of
/// the buttons, and the action of fingers. Every change applies immediately.
class PensPage : public QWidget {
  Q_OBJECT

 public:
  explicit PensPage(QWidget* parent = nullptr);

  /// Adds a group of settings below the others.
  void add_group(QWidget* group);

 private:
  QWidget* make_pressure();
  QWidget* make_sliders();
  QWidget* make_test();
  QWidget* make_buttons();
  QCheckBox* make_touch_taps();
  QCheckBox* make_long_press();
  QComboBox* make_roles(const char* key, const char* fallback, const QString& name);
  QComboBox* make_choice(const char* key, const QString& name);
  void set_curve(PressureCurve curve);
  void show_pressure(std::optional<double> raw, double curved);
  void show_tilt(std::optional<double> tilt_deg);
  void load();

  QCheckBox* pressure_on_;
  QCheckBox* touch_taps_;
  QCheckBox* long_press_;
  PressureCurveEditor* editor_;
  QSlider* firmness_;
  QSlider* threshold_;
  QLabel* threshold_text_;
  PenTestArea* area_;
  QProgressBar* bar_;
  QLabel* numbers_;
  QLabel* tilt_;
  bool loads_ = false;
};

}  // namespace felt::desktop
