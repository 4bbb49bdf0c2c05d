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

/// What a person sets for the device in use, kept in its profile: a name, the hand that holds it,
/// how hard and how stiff it may be, where its drawing plane lies and how large it is on the sheet.
/// Takes effect at once, from no force. Each hand has a plane of its own: the device stands on the
/// other side for the other one. Hand and plane are asked for only where there is a plane to be
/// shown to the device (PenDeviceInfo::has_own_frame).
class DeviceSettings : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceSettings(Studio& studio, QWidget* parent = nullptr);

  /// Shows what is kept for the device in use.
  void tell();
  /// The drawing area's middle on the sheet's middle, and so large that the whole sheet is reached.
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
  void tell_plane(const DeviceProfile& profile);

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
