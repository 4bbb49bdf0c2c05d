#include "desktop/devices/device_settings.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "desktop/devices/calibration_dialog.h"
#include "desktop/engine/driver_watch.h"
#include "desktop/engine/settings.h"
#include "desktop/feel/feel_setting_keys.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt::desktop {
namespace {

constexpr double kLimitStep = 0.1;  // N
constexpr int kStiffnessStep = 50;  // N/m
constexpr int kPercentStep = 5;

/// Returns the largest force that the device's own table allows, regardless of the user's limits.
double most_of(const Capabilities& device) {
  return limits_for(device).peak_force_n;
}

QWidget* beside(QWidget* first, QWidget* second, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(first);
  row->addWidget(second);
  row->addStretch(1);
  return box;
}

}  // namespace

DeviceSettings::DeviceSettings(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      form_(new QFormLayout(this)),
      name_(new QLineEdit(this)),
      hand_(new QComboBox(this)),
      limit_(new QDoubleSpinBox(this)),
      stiffest_(new QSpinBox(this)),
      plane_(new QLabel(this)),
      calibrate_(new QPushButton(tr("&Set the drawing plane…"), this)),
      scale_(new QSpinBox(this)),
      fit_(new QPushButton(tr("Fit to the p&age"), this)) {
  name_->setMaxLength(60);
  name_->setAccessibleName(tr("Name of the device"));
  hand_->addItems({tr("Right hand"), tr("Left hand")});
  hand_->setAccessibleName(tr("The hand that holds it"));
  hand_->setToolTip(
      tr("Each hand has its own drawing plane, because the device stands on that side"));
  limit_->setRange(kMinForceLimitN, SafetyLimits{}.peak_force_n);
  limit_->setSingleStep(kLimitStep);
  limit_->setDecimals(1);
  limit_->setSuffix(tr(" N"));
  limit_->setKeyboardTracking(false);
  limit_->setToolTip(tr("The upper limit of all forces of this device"));
  limit_->setAccessibleName(tr("Largest force"));
  stiffest_->setRange(int(kMinStiffnessCap) - kStiffnessStep, 2000);
  stiffest_->setSingleStep(kStiffnessStep);
  stiffest_->setSpecialValueText(tr("device limit"));
  stiffest_->setSuffix(tr(" N/m"));
  stiffest_->setKeyboardTracking(false);
  stiffest_->setToolTip(tr("Lower this if the surface hums or trembles under the pen"));
  stiffest_->setAccessibleName(tr("Stiffest surface"));
  plane_->setTextFormat(Qt::PlainText);
  scale_->setRange(qRound(100 * kMinPageScale), qRound(100 * kMaxPageScale));
  scale_->setSingleStep(kPercentStep);
  scale_->setSuffix(tr(" %"));
  scale_->setKeyboardTracking(false);
  scale_->setToolTip(tr(
      "At 100 %, one millimetre of the hand is one millimetre of the page. At 200 % it is two."));
  scale_->setAccessibleName(tr("Size of a movement on the page"));
  fit_->setToolTip(tr(
      "Centres the drawing area on the page and scales it so that the whole page can be reached"));
  make_form();
}

void DeviceSettings::make_form() {
  size_ = beside(scale_, fit_, this);
  QFormLayout* form = form_;
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Hand"), hand_);
  form->addRow(tr("&Largest force"), limit_);
  form->addRow(tr("S&tiffest surface"), stiffest_);
  form->addRow(tr("Drawing plane"), plane_);
  form->addRow(QString(), calibrate_);
  form->addRow(tr("S&ize on the page"), size_);
  connect(name_, &QLineEdit::editingFinished, this, &DeviceSettings::set_name);
  connect(hand_, &QComboBox::activated, this, &DeviceSettings::set_hand);
  connect(limit_, &QDoubleSpinBox::valueChanged, this, &DeviceSettings::set_limit);
  connect(stiffest_, &QSpinBox::valueChanged, this, &DeviceSettings::set_stiffest);
  connect(calibrate_, &QPushButton::clicked, this, &DeviceSettings::calibrate);
  connect(scale_, &QSpinBox::valueChanged, this,
          [this](int percent) { set_scale(0.01 * percent); });
  connect(fit_, &QPushButton::clicked, this, &DeviceSettings::fit);
}

/// Returns the stored profile if it can be read; otherwise reports the error.
std::optional<DeviceProfile> DeviceSettings::profile() {
  Result<DeviceProfile> profile = profile_of(studio_.loop().device().info().id);
  if (profile) return *std::move(profile);
  Q_EMIT studio_.refused(QString::fromStdString(profile.error().message));
  return std::nullopt;
}

void DeviceSettings::keep(const DeviceProfile& profile) {
  if (const Result<void> kept = keep_profile(profile); !kept) {
    Q_EMIT studio_.refused(QString::fromStdString(kept.error().message));
    return report();
  }
  studio_.loop().set_profile(profile);
}

void DeviceSettings::report() {
  const PenDeviceInfo& info = studio_.loop().device().info();
  const Result<DeviceProfile> kept = profile_of(info.id);
  const DeviceProfile profile = kept.value_or(DeviceProfile{});
  const QSignalBlocker quiet_limit(limit_), quiet_stiffest(stiffest_), quiet_scale(scale_);
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(profile.name));
  const DriverWatch* watch = DriverWatch::the();
  const PenDeviceInfo* seen = watch ? watch->find(info.id) : nullptr;
  name_->setPlaceholderText(seen ? seen->label : info.label);
  hand_->setCurrentIndex(profile.left_handed ? 1 : 0);
  // Uses the device's own limits, because the user's present limit must not reduce the range.
  const double largest = most_of(info.capabilities);
  limit_->setMaximum(std::max(largest, kMinForceLimitN));
  limit_->setValue(std::min(profile.force_limit_n.value_or(largest), studio_.loop().force_limit()));
  limit_->setEnabled(info.capabilities.has_force());
  const double stiffest = info.capabilities.max_stiffness_n_per_m;
  if (stiffest > 0.0) stiffest_->setMaximum(std::max(int(stiffest), stiffest_->minimum()));
  stiffest_->setValue(profile.stiffness_cap_n_per_m ? qRound(*profile.stiffness_cap_n_per_m)
                                                    : stiffest_->minimum());
  stiffest_->setEnabled(info.capabilities.has_force());
  for (QWidget* row : {static_cast<QWidget*>(hand_), static_cast<QWidget*>(plane_),
                       static_cast<QWidget*>(calibrate_), size_}) {
    form_->setRowVisible(row, info.has_own_frame);
  }
  report_plane(profile);
}

void DeviceSettings::report_plane(const DeviceProfile& profile) {
  const PlaneCalibration plane = studio_.loop().device().device().plane();
  if (!profile.plane) {
    plane_->setText(tr("Not set yet: the usual position of such a device is assumed."));
  } else if (profile.area) {
    plane_->setText(tr("Set: %L1 × %L2 mm.")
                        .arg(profile.area->width_mm, 0, 'f', 0)
                        .arg(profile.area->height_mm, 0, 'f', 0));
  } else {
    plane_->setText(tr("Set."));
  }
  scale_->setValue(qRound(100.0 * plane.scale()));
}

void DeviceSettings::set_name() {
  std::optional<DeviceProfile> kept = profile();
  const std::string name = name_->text().simplified().toStdString();
  if (!kept || kept->name == name) return;
  kept->name = name;
  keep(*kept);
}

void DeviceSettings::set_hand(int index) {
  std::optional<DeviceProfile> kept = profile();
  if (!kept || kept->left_handed == (index == 1)) return;
  forget_planes_of_another(*kept, studio_.loop().device().info().serial.toStdString());
  switch_hand(*kept);
  keep(*kept);
}

void DeviceSettings::set_limit(double limit) {
  std::optional<DeviceProfile> kept = profile();
  if (!kept) return;
  const double largest = most_of(studio_.loop().device().info().capabilities);
  kept->force_limit_n = limit < largest - 0.5 * kLimitStep ? std::optional(limit) : std::nullopt;
  // The user expects a limit that is set here to apply, so a lower general limit is raised.
  if (limit > studio_.loop().force_limit()) {
    studio_.loop().set_force_limit(limit);
    Settings::the().set(QString::fromLatin1(feel_keys::kForceLimit), studio_.loop().force_limit());
  }
  keep(*kept);
}

void DeviceSettings::set_stiffest(int n_per_m) {
  std::optional<DeviceProfile> kept = profile();
  if (!kept) return;
  kept->stiffness_cap_n_per_m =
      n_per_m > stiffest_->minimum() ? std::optional<double>(n_per_m) : std::nullopt;
  keep(*kept);
}

void DeviceSettings::fit() {
  set_scale(std::nullopt);
}

void DeviceSettings::set_scale(std::optional<double> scale) {
  std::optional<DeviceProfile> kept = profile();
  if (!kept) return;
  const PlaneCalibration plane = studio_.loop().device().device().plane();
  forget_planes_of_another(*kept, studio_.loop().device().info().serial.toStdString());
  const DrawingArea area =
      kept->area.value_or(reach_of(plane, studio_.loop().device().info().capabilities));
  kept->plane = fit_to_page(plane, area, studio_.page().area(), scale);
  keep(*kept);
}

void DeviceSettings::calibrate() {
  CalibrationDialog::run(studio_, this);
}

}  // namespace felt::desktop
