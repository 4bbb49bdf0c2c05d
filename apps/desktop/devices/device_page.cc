#include "desktop/devices/device_page.h"

#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "desktop/devices/doctor_dialog.h"
#include "desktop/engine/cue_player.h"
#include "desktop/engine/device_words.h"
#include "desktop/engine/settings.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/feel_setting_keys.h"
#include "felt/driver/cue_device.h"

namespace felt::desktop {
namespace {

constexpr double kLimitStepN = 0.1;  // N
constexpr int kPageIconPx = 20;
constexpr int kRowsShown = 7;
constexpr auto kHelpRow = "help:";

/// Returns a row's icon in the colour of its text, selected or not.
QIcon row_icon(const QWidget& page, FeelLevel level, bool asks) {
  const qreal dpr = page.devicePixelRatioF();
  const auto sign = [&](const QPalette& palette) {
    return level == FeelLevel::kShown ? ring_icon(asks, palette, kPageIconPx, dpr)
                                      : level_icon(level, palette, kPageIconPx, dpr);
  };
  QPalette selected = page.palette();
  selected.setColor(QPalette::WindowText, selected.color(QPalette::HighlightedText));
  QIcon icon(sign(page.palette()));
  icon.addPixmap(sign(selected), QIcon::Selected);
  return icon;
}

}  // namespace

QString capabilities_in_words(const Capabilities& can) {
  if (!can.has_force()) {
    return can.senses_pressure ? DevicePage::tr("Senses pressure if the pen does. No motors.")
                               : DevicePage::tr("No motors.");
  }
  const SafetyLimits limits = limits_for(can);
  return DevicePage::tr("Pushes with up to %L1 N, continuously with %L2 N. Loop of %L3 Hz.")
      .arg(limits.peak_force_n, 0, 'g', 2)
      .arg(limits.continuous_force_n, 0, 'g', 2)
      .arg(1e9 / static_cast<double>(can.period_ns), 0, 'f', 0);
}

DevicePage::DevicePage(Studio& studio, DeviceCare* care, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      care_(care),
      list_(new QListWidget(this)),
      words_(new QLabel(this)),
      use_(new QPushButton(tr("&Use this device"), this)),
      general_(new QWidget(this)),
      limit_(new QDoubleSpinBox(this)),
      settings_(new DeviceSettings(studio, this)),
      cue_row_(new QWidget(this)),
      cue_(new QComboBox(this)),
      pad_(new TestPad(this)) {
  list_->setAccessibleName(tr("Device"));
  list_->setIconSize({kPageIconPx, kPageIconPx});
  list_->setSpacing(1);
  list_->setWordWrap(true);
  list_->setMinimumHeight(2 * kRowsShown * fontMetrics().lineSpacing());
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  make_form();
  auto* use_row = new QHBoxLayout;
  use_row->addWidget(use_);
  use_row->addStretch(1);
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(list_, 2);
  rows->addWidget(words_);
  rows->addLayout(use_row);
  rows->addWidget(settings_);
  rows->addWidget(general_);
  rows->addWidget(cue_row_);
  rows->addWidget(pad_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &DevicePage::take_row);
  connect(list_, &QListWidget::itemClicked, this, [this] {
    if (chosen() == QLatin1String(kHelpRow)) help();
  });
  connect(list_, &QListWidget::itemActivated, this,
          [this] { chosen() == QLatin1String(kHelpRow) ? help() : use(); });
  connect(use_, &QPushButton::clicked, this, &DevicePage::use);
  connect(&studio_.loop(), &HapticLoop::device_changed, this, &DevicePage::refresh);
  connect(&studio_.loop(), &HapticLoop::device_status_changed, this, &DevicePage::report_rows);
  if (care_) connect(care_, &DeviceCare::waiting_changed, this, &DevicePage::refresh);
  if (DriverWatch* watch = DriverWatch::the()) {
    connect(watch, &DriverWatch::changed, this, &DevicePage::refresh);
  }
  refresh();
  choose(studio_.loop().device().info().id);
}

/// Makes the settings that do not belong to one real device.
void DevicePage::make_form() {
  limit_->setRange(0.0, SafetyLimits{}.peak_force_n);
  limit_->setSingleStep(kLimitStepN);
  limit_->setDecimals(1);
  limit_->setSuffix(tr(" N"));
  limit_->setKeyboardTracking(false);
  limit_->setToolTip(tr("The upper limit of all forces of this device"));
  limit_->setAccessibleName(tr("Largest force"));
  connect(limit_, &QDoubleSpinBox::valueChanged, this, &DevicePage::set_limit);
  auto* form = new QFormLayout(general_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Largest force"), limit_);
  cue_->setAccessibleName(tr("Vibrations"));
  cue_->setToolTip(
      tr("A haptic pen, mouse, touchpad or game controller that vibrates while you draw, with any "
         "pen"));
  connect(cue_, &QComboBox::activated, this, [this](int index) {
    Settings::the().set(QString::fromLatin1(kCueDeviceKey), cue_->itemData(index).toString());
  });
  auto* cues = new QFormLayout(cue_row_);
  cues->setContentsMargins(0, 0, 0, 0);
  cues->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  cues->addRow(tr("&Vibrations"), cue_);
}

void DevicePage::refresh() {
  const QString kept = chosen();
  rows_.clear();
  const DriverWatch* watch = DriverWatch::the();
  for (const PenDeviceInfo& info : pen_devices()) {
    rows_.push_back({info, info.moves_hand || info.has_own_frame, true});
  }
  const QString waited = care_ ? care_->waits_for() : QString();
  if (!waited.isEmpty() && !row_of(waited)) {
    PenDeviceInfo info;
    info.id = waited;
    info.label = care_->name_of(waited);
    rows_.push_back({info, true, false});
  }
  std::stable_partition(rows_.begin(), rows_.end(), [](const Row& row) { return row.is_real; });
  const QSignalBlocker quiet(list_);
  list_->clear();
  bool is_helped = false;
  const auto add_help = [&] {
    if (std::exchange(is_helped, true) || !watch) return;
    auto* item = new QListWidgetItem(list_);
    item->setData(Qt::UserRole, QString::fromLatin1(kHelpRow));
  };
  for (const Row& row : rows_) {
    if (!row.is_real) add_help();
    add_row(row);
  }
  add_help();
  report_rows();
  list_cues();
  choose(row_of(kept) ? kept : studio_.loop().device().info().id);
  report();
}

void DevicePage::add_row(const Row& row) {
  auto* item = new QListWidgetItem(list_);
  item->setData(Qt::UserRole, row.info.id);
  item->setToolTip(row.info.note);
}

const DevicePage::Row* DevicePage::row_of(const QString& id) const {
  const auto at =
      std::find_if(rows_.begin(), rows_.end(), [&id](const Row& row) { return row.info.id == id; });
  return at == rows_.end() ? nullptr : &*at;
}

QString DevicePage::state_of(const Row& row, int* sign) const {
  const auto say = [sign](FeelLevel level, const QString& text) {
    *sign = static_cast<int>(level);
    return text;
  };
  if (row.info.id == studio_.loop().device().info().id) {
    const DeviceStatus status = studio_.loop().device_status();
    if (status.fault) {
      return say(FeelLevel::kLimited, tr("In use; %1").arg(words_for(*status.fault)));
    }
    if (row.is_real && !studio_.loop().forces_are_on()) {
      return say(FeelLevel::kOn, tr("In use, forces off"));
    }
    return say(FeelLevel::kOn, tr("In use"));
  }
  if (!row.is_here) return say(FeelLevel::kWaiting, tr("Not connected; used again once it is"));
  if (PenDevice::is_open(row.info.id)) {
    return say(FeelLevel::kWaiting, tr("In use in another window"));
  }
  if (!row.info.is_connected) {
    return say(FeelLevel::kWaiting,
               tr("Its software is installed; whether it is connected shows when you use it"));
  }
  if (!profile_of(row.info.id)) {
    return say(FeelLevel::kLimited, tr("Connected; its settings cannot be read"));
  }
  return say(FeelLevel::kShown, !row.info.has_own_frame || plane_of(row.info.id)
                                    ? tr("Connected")
                                    : tr("Connected; its drawing plane is not set yet"));
}

void DevicePage::report_rows() {
  for (int i = 0; i < list_->count(); ++i) {
    QListWidgetItem* item = list_->item(i);
    const QString id = item->data(Qt::UserRole).toString();
    const auto icon = [this](FeelLevel level) { return row_icon(*this, level, false); };
    if (id == QLatin1String(kHelpRow)) {
      const bool any = !rows_.empty() && rows_.front().is_real;
      item->setText((any ? tr("Another haptic device…") : tr("A haptic device…")) +
                    QLatin1Char('\n') + tr("Not in the list? See what is missing, step by step"));
      item->setIcon(row_icon(*this, FeelLevel::kShown, true));
      continue;
    }
    const Row* row = row_of(id);
    if (!row) continue;
    int sign = 0;
    const QString called = care_ && row->is_real ? care_->name_of(id) : id;
    const QString name = called == id ? row->info.label : called;
    const bool in_use = id == studio_.loop().device().info().id;
    if (!row->is_real) {
      item->setText(name);
      QPixmap nothing(QSize(kPageIconPx, kPageIconPx) *
                      devicePixelRatioF());  // an empty icon, so that all names are aligned
      nothing.fill(Qt::transparent);
      item->setIcon(in_use ? icon(FeelLevel::kOn) : QIcon(nothing));
      continue;
    }
    const QString state = state_of(*row, &sign);
    item->setText(name + QLatin1Char('\n') + state);
    item->setIcon(icon(static_cast<FeelLevel>(sign)));
  }
}

void DevicePage::showEvent(QShowEvent* event) {
  if (!watching_) watching_ = std::make_unique<DriverWatch::Watching>();
  refresh();
  QWidget::showEvent(event);
}

void DevicePage::hideEvent(QHideEvent* event) {
  watching_.reset();
  QWidget::hideEvent(event);
}

void DevicePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) report_rows();
  QWidget::changeEvent(event);
}

QString DevicePage::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item ? item->data(Qt::UserRole).toString() : QString();
}

bool DevicePage::choose(const QString& id) {
  for (int i = 0; i < list_->count(); ++i) {
    if (list_->item(i)->data(Qt::UserRole).toString() != id) continue;
    list_->setCurrentRow(i);
    return true;
  }
  return false;
}

void DevicePage::take_row() {
  const Row* row = row_of(chosen());
  if (row && !row->is_real) use();
  report();
}

void DevicePage::use() {
  const QString id = chosen();
  const Row* row = row_of(id);
  if (!row || !row->is_here) return;
  if (care_) {
    care_->use(id, this);
  } else if (id != studio_.loop().device().info().id && studio_.use_device(id)) {
    Settings::the().set(QString::fromLatin1(kPenDeviceKey), id);
  }
  // A device that mouse and tablet move is used when its row is selected. If it did not open,
  // selects the row of the device in use.
  const Row* now = row_of(id);
  if (now && !now->is_real) choose(studio_.loop().device().info().id);
  report_rows();
  report();
}

void DevicePage::help() {
  DoctorDialog(this).exec();
  choose(studio_.loop().device().info().id);
}

void DevicePage::report() {
  const PenDeviceInfo& now = studio_.loop().device().info();
  const Row* row = row_of(chosen());
  const bool in_use = row && row->info.id == now.id;
  const bool is_led = in_use && studio_.loop().device().hand() != nullptr;
  const bool is_real = row && row->is_real;
  const Capabilities& can = in_use ? studio_.loop().device().device().capabilities()
                            : row  ? row->info.capabilities
                                   : now.capabilities;
  QStringList words;
  if (row) {
    if (!row->info.note.isEmpty()) words << row->info.note;
    if (row->is_here && (in_use || can.has_force())) words << capabilities_in_words(can);
    if (is_real && row->is_here) words << tr("Forces stay off until you switch them on.");
    if (is_real && !in_use && row->is_here) {
      if (const auto profile = profile_of(row->info.id); !profile) {
        words << QString::fromStdString(profile.error().message) + QLatin1Char('.')
              << tr("Correct that line, or remove the file.");
      }
    }
    if (!row->is_here) words << tr("Check its cable and power.");
  }
  words_->setText(words.join(QLatin1Char(' ')));
  use_->setVisible(is_real && !in_use);
  use_->setEnabled(is_real && row->is_here && !PenDevice::is_open(row->info.id));
  const QSignalBlocker quiet(limit_);
  limit_->setValue(studio_.loop().force_limit());
  general_->setVisible(!is_real);
  limit_->setEnabled(studio_.loop().device().device().capabilities().has_force());
  settings_->setVisible(is_real && in_use);
  if (is_real && in_use) settings_->report();
  pad_->setVisible(!is_real);
  pad_->use(is_led ? now.id : QString(), studio_.loop().strength(), studio_.loop().force_limit());
}

/// Lists the cue devices that were found, and the chosen device even if it is missing.
void DevicePage::list_cues() {
  const QString chosen = Settings::the().text(QString::fromLatin1(kCueDeviceKey));
  cue_->clear();
  cue_->addItem(tr("None"), QString());
  bool is_there = chosen.isEmpty();
  if (const DriverWatch* watch = DriverWatch::the()) {
    for (const auto& [id, label] : watch->found_cues()) {
      cue_->addItem(label, id);
      is_there = is_there || id == chosen;
    }
  }
  if (!is_there) cue_->addItem(tr("%1 (not connected)").arg(chosen), chosen);
  cue_->setCurrentIndex(std::max(0, cue_->findData(chosen)));
  cue_row_->setVisible(cue_->count() > 1);
}

void DevicePage::set_limit(double newton) {
  studio_.loop().set_force_limit(newton);
  Settings::the().set(QString::fromLatin1(feel_keys::kForceLimit), studio_.loop().force_limit());
  report();
}

}  // namespace felt::desktop
