#include "desktop/feel/device_page.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "desktop/engine/settings.h"
#include "desktop/feel/calibration_dialog.h"
#include "desktop/feel/settings_keys.h"

namespace felt::desktop {
namespace {

constexpr double kLimitStep = 0.1;  // N

}  // namespace

QString capabilities_in_words(const Capabilities& can) {
  if (!can.has_force()) {
    return can.senses_pressure ? DevicePage::tr("Feels pressure, if the pen does. No motors.")
                               : DevicePage::tr("No motors.");
  }
  const SafetyLimits limits = limits_for(can);
  return DevicePage::tr("Pushes with up to %L1 N, for long with %L2 N. Loop of %L3 Hz.")
      .arg(limits.peak_force_n, 0, 'g', 2)
      .arg(limits.continuous_force_n, 0, 'g', 2)
      .arg(1e9 / static_cast<double>(can.period_ns), 0, 'f', 0);
}

DevicePage::DevicePage(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      list_(new QListWidget(this)),
      words_(new QLabel(this)),
      limit_(new QDoubleSpinBox(this)),
      calibrate_(new QPushButton(tr("Set the drawing plane…"), this)),
      plane_(new QLabel(this)),
      pad_(new TestPad(this)) {
  list_->setAccessibleName(tr("Device"));
  list_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  words_->setWordWrap(true);
  words_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  limit_->setRange(0.0, SafetyLimits{}.peak_force_n);
  limit_->setSingleStep(kLimitStep);
  limit_->setDecimals(1);
  limit_->setSuffix(tr(" N"));
  limit_->setKeyboardTracking(false);
  limit_->setToolTip(tr("No force is ever larger than this, whatever a tool asks for"));
  limit_->setAccessibleName(tr("Largest force"));
  plane_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Largest force"), limit_);
  form->addRow(plane_, calibrate_);
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(list_, 2);
  rows->addWidget(words_);
  rows->addLayout(form);
  rows->addWidget(pad_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &DevicePage::choose);
  connect(limit_, &QDoubleSpinBox::valueChanged, this, &DevicePage::set_limit);
  connect(calibrate_, &QPushButton::clicked, this, &DevicePage::calibrate);
  connect(&studio_, &Studio::device_changed, this, &DevicePage::tell);
  refresh();
}

void DevicePage::refresh() {
  const QSignalBlocker quiet(list_);
  devices_ = pen_devices();
  list_->clear();
  for (const PenDeviceInfo& info : devices_) {
    auto* item = new QListWidgetItem(info.label, list_);
    item->setToolTip(info.note);
  }
  tell();
}

void DevicePage::showEvent(QShowEvent* event) {
  refresh();
  QWidget::showEvent(event);
}

void DevicePage::choose(int row) {
  if (row < 0 || row >= static_cast<int>(devices_.size())) return;
  const QString id = devices_[static_cast<std::size_t>(row)].id;
  if (id == studio_.device().info().id) return;
  if (studio_.use_device(id)) Settings::the().set(QString::fromLatin1(kPenDeviceKey), id);
  tell();
}

void DevicePage::tell() {
  const PenDeviceInfo& now = studio_.device().info();
  const bool is_led = studio_.device().hand() != nullptr;
  const QSignalBlocker quiet(list_), quiet_limit(limit_);
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    if (devices_[i].id == now.id) list_->setCurrentRow(static_cast<int>(i));
  }
  QStringList words{now.note, capabilities_in_words(studio_.device().device().capabilities())};
  if (now.moves_hand) words << tr("Forces stay off until you switch them on.");
  words_->setText(words.join(QLatin1Char(' ')));
  limit_->setValue(studio_.force_limit());
  limit_->setEnabled(studio_.device().device().capabilities().has_force());
  calibrate_->setVisible(now.has_own_frame);
  plane_->setVisible(now.has_own_frame);
  plane_->setText(plane_of(now.id) ? tr("The drawing plane is set.")
                                   : tr("The drawing plane has not been set yet."));
  pad_->use(is_led ? now.id : QString(), studio_.strength(), studio_.force_limit());
}

void DevicePage::set_limit(double newton) {
  studio_.set_force_limit(newton);
  Settings::the().set(QString::fromLatin1(feel_keys::kForceLimit), studio_.force_limit());
  tell();
}

void DevicePage::calibrate() {
  CalibrationDialog::run(studio_, this);
  tell();
}

}  // namespace felt::desktop
