#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The user's settings of the device in use, stored in its profile: a name, the hand with which the
/// user holds the pen, the limits of force and stiffness, and the position and scale of the
/// device's drawing plane. Changes take effect immediately, and the force starts again from zero.
/// Each hand has its own drawing plane, because the device stands to the left or to the right of
/// the user. Hand and plane are shown only if the device needs a calibrated plane
/// (PenDeviceInfo::has_own_frame).
class DeviceSettings : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceSettings(Studio& studio, QWidget* parent = nullptr);

  /// Shows the profile of the device in use.
  void report();
  /// Centres the drawing area on the page, with a scale at which the device reaches the whole
  /// page.
  void fit();

 private:
  void make_form();
  [[nodiscard]] std::optional<DeviceProfile> profile();
  void keep(const DeviceProfile& profile);
  void set_name();
  void set_hand(int index);
  void set_limit(double limit);
  void set_stiffest(int n_per_m);
  void set_scale(std::optional<double> scale);
  void calibrate();
  void report_plane(const DeviceProfile& profile);

  Studio& studio_;
  QFormLayout* form_;
  QLineEdit* name_;
  QComboBox* hand_;
  QDoubleSpinBox* limit_;
  QSpinBox* stiffest_;
  QLabel* plane_;
  QPushButton* calibrate_;
  QSpinBox* scale_;
  QPushButton* fit_;
  QWidget* size_ = nullptr;
};

}  // namespace felt::desktop
