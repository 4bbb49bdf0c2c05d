#include "desktop/pens/pens_page.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"

namespace felt::desktop {
namespace {

constexpr int kSliderSteps = 100;

QString percent(double part) {
  return PensPage::tr("%1 %").arg(std::lround(100.0 * part));
}

void set(const char* key, const QVariant& value) {
  Settings::the().set(QString::fromLatin1(key), value);
}

}  // namespace

PensPage::PensPage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(make_pressure());
  layout->addWidget(make_buttons());
  layout->addStretch();
  connect(&Settings::the(), &Settings::changed, this, [this](const QString& key) {
    if (key.startsWith(QStringLiteral("pens/"))) load();
  });
  load();
}

void PensPage::add_group(QWidget* group) {
  auto* lines = static_cast<QVBoxLayout*>(layout());
  lines->insertWidget(lines->count() - 1, group);
}

QWidget* PensPage::make_pressure() {
  auto* group = new QGroupBox(tr("Pressure"));
  auto* layout = new QGridLayout(group);
  pressure_on_ = new QCheckBox(tr("&Pressing harder draws wider"));
  pressure_on_->setToolTip(tr("If off, every line has the same width, however hard you press."));
  connect(pressure_on_, &QCheckBox::toggled, this,
          [this](bool on) { loads_ ? void() : set(pen_keys::kPressureOn, on); });
  editor_ = new PressureCurveEditor;
  connect(editor_, &PressureCurveEditor::edited, this, &PensPage::set_curve);
  layout->addWidget(pressure_on_, 0, 0, 1, 2);
  layout->addWidget(editor_, 1, 0, 2, 1);
  layout->addWidget(make_sliders(), 1, 1);
  layout->addWidget(make_test(), 2, 1);
  layout->setColumnStretch(1, 1);
  layout->setRowStretch(2, 1);
  return group;
}

QWidget* PensPage::make_sliders() {
  auto* box = new QWidget;
  auto* layout = new QGridLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto row = [&](int y, const QString& text, const QString& name, int smallest) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(smallest, kSliderSteps);
    slider->setAccessibleName(name);
    auto* label = new QLabel(text);
    label->setBuddy(slider);
    layout->addWidget(label, y, 0);
    layout->addWidget(slider, y, 1);
    return slider;
  };
  firmness_ = row(0, tr("&Soft"), tr("Feel, from soft to firm"), -kSliderSteps);
  firmness_->setToolTip(
      tr("Soft: light pressure draws wide. Firm: press harder for the same width."));
  connect(firmness_, &QSlider::valueChanged, this, [this](int value) {
    if (loads_) return;
    set_curve(
        PressureCurve::of_firmness(double(value) / kSliderSteps, editor_->curve().threshold()));
  });
  layout->addWidget(new QLabel(tr("Firm")), 0, 2);
  threshold_ = row(1, tr("Con&tact from"), tr("Pressure at which the pen touches the surface"), 0);
  threshold_->setToolTip(tr("Raise this if the pen draws before you press it."));
  connect(threshold_, &QSlider::valueChanged, this, [this](int value) {
    if (loads_) return;
    const PressureCurve& curve = editor_->curve();
    set_curve({curve.first(), curve.second(), PressureCurve::kMaxThreshold * value / kSliderSteps});
  });
  threshold_text_ = new QLabel;
  layout->addWidget(threshold_text_, 1, 2);
  auto* reset = new QPushButton(tr("Reset cur&ve"));
  reset->setToolTip(tr("Restores the default curve."));
  connect(reset, &QPushButton::clicked, this, [this] { set_curve({}); });
  layout->addWidget(reset, 2, 1, Qt::AlignLeft);
  layout->setColumnStretch(1, 1);
  return box;
}

QWidget* PensPage::make_test() {
  auto* box = new QWidget;
  auto* layout = new QGridLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  area_ = new PenTestArea;
  bar_ = new QProgressBar;
  bar_->setRange(0, kSliderSteps);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Pressure after the curve"));
  numbers_ = new QLabel;
  numbers_->setMinimumWidth(numbers_->fontMetrics().horizontalAdvance(
      tr("pen %1, line %2").arg(percent(1.0), percent(1.0)) + QStringLiteral("  ")));
  tilt_ = new QLabel;
  tilt_->setToolTip(
      tr("Charcoal, chalk and pencils draw broader with a tilted pen, if it reports its tilt."));
  auto* wipe = new QPushButton(tr("&Wipe"));
  wipe->setToolTip(tr("Clears the test area."));
  connect(wipe, &QPushButton::clicked, area_, &PenTestArea::clear);
  connect(area_, &PenTestArea::pressed, this, &PensPage::show_pressure);
  connect(area_, &PenTestArea::tilted, this, &PensPage::show_tilt);
  layout->addWidget(area_, 0, 0, 1, 3);
  layout->addWidget(bar_, 1, 0);
  layout->addWidget(numbers_, 1, 1);
  layout->addWidget(wipe, 1, 2);
  layout->addWidget(tilt_, 2, 0, 1, 3);
  layout->setColumnStretch(0, 1);
  layout->setRowStretch(0, 1);
  show_pressure(0.0, 0.0);
  show_tilt({});
  return box;
}

QComboBox* PensPage::make_choice(const char* key, const QString& name) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  connect(box, &QComboBox::activated, this, [box, key] { set(key, box->currentData()); });
  const auto load = [box, key] {
    const QVariant value = Settings::the().value(QString::fromLatin1(key), box->itemData(0));
    box->setCurrentIndex(std::max(0, box->findData(value)));
  };
  connect(&Settings::the(), &Settings::changed, box, load);
  return box;
}

QComboBox* PensPage::make_roles(const char* key, const char* fallback, const QString& name) {
  QComboBox* box = make_choice(key, name);
  for (const ButtonRole role : button_roles()) box->addItem(label_of(role), name_of(role));
  const QString chosen =
      Settings::the().text(QString::fromLatin1(key), QString::fromLatin1(fallback));
  box->setCurrentIndex(std::max(0, box->findData(chosen)));
  return box;
}

QCheckBox* PensPage::make_touch_taps() {
  touch_taps_ = new QCheckBox(tr("Tap with two fingers to &undo, with three to redo"));
  touch_taps_->setToolTip(tr("A tap is short, and the fingers do not move."));
  connect(touch_taps_, &QCheckBox::toggled, this,
          [this](bool on) { loads_ ? void() : set(pen_keys::kTouchTaps, on); });
  return touch_taps_;
}

QCheckBox* PensPage::make_long_press() {
  long_press_ = new QCheckBox(tr("&Hold the pen or finger still to open the ring of tools"));
  long_press_->setToolTip(
      tr("Touch and rest for 0.6 seconds, then move in a direction and lift. The dot that you drew "
         "vanishes."));
  connect(long_press_, &QCheckBox::toggled, this,
          [this](bool on) { loads_ ? void() : set(pen_keys::kLongPress, on); });
  return long_press_;
}

QWidget* PensPage::make_buttons() {
  using namespace pen_keys;
  auto* group = new QGroupBox(tr("Buttons, mouse and touch"));
  auto* form = new QFormLayout(group);
  form->addRow(tr("Pen, &lower button:"),
               make_roles(kLowerButton, kLowerButtonDefault, tr("Lower button of the pen")));
  form->addRow(tr("Pen, &upper button:"),
               make_roles(kUpperButton, kUpperButtonDefault, tr("Upper button of the pen")));
  form->addRow(tr("Mouse, &right button:"),
               make_roles(kRightButton, kRightButtonDefault, tr("Right button of the mouse")));
  QComboBox* mouse = make_choice(kMousePressure, tr("Width of lines by mouse"));
  mouse->addItem(tr("Constant"), QStringLiteral("constant"));
  mouse->addItem(tr("Thinner when fast"), QStringLiteral("speed"));
  mouse->setCurrentIndex(std::max(
      0, mouse->findData(Settings::the().text(QString::fromLatin1(kMousePressure),
                                              QString::fromLatin1(kMousePressureDefault)))));
  form->addRow(tr("&Mouse, width of lines:"), mouse);
  QComboBox* touch = make_choice(kTouch, tr("What one finger does"));
  touch->addItem(tr("Moves the view"), name_of(TouchMode::kPan));
  touch->addItem(tr("Draws"), name_of(TouchMode::kDraw));
  touch->addItem(tr("Nothing: touch is off"), name_of(TouchMode::kOff));
  touch->setCurrentIndex(
      std::max(0, touch->findData(Settings::the().text(QString::fromLatin1(kTouch),
                                                       QString::fromLatin1(kTouchDefault)))));
  touch->setToolTip(
      tr("Two fingers move, zoom and turn the view. While the pen is near, touch is ignored."));
  form->addRow(tr("One f&inger:"), touch);
  form->addRow(make_touch_taps());
  form->addRow(make_long_press());
  const auto follow_touch = [this, touch] {
    touch_taps_->setEnabled(touch->currentData() != name_of(TouchMode::kOff));
  };
  connect(touch, &QComboBox::currentIndexChanged, this, follow_touch);
  follow_touch();
  return group;
}

/// The parameter is a copy, because the editor's own curve changes while store() sets the settings
/// one by one.
void PensPage::set_curve(PressureCurve curve) {
  loads_ = true;
  curve.store();
  loads_ = false;
  load();
}

void PensPage::load() {
  if (std::exchange(loads_, true)) return;
  const PenSettings settings = PenSettings::load();
  area_->set_settings(settings);
  pressure_on_->setChecked(settings.pressure_on);
  touch_taps_->setChecked(settings.touch_taps);
  long_press_->setChecked(settings.long_press);
  editor_->set_curve(settings.curve);
  editor_->setEnabled(settings.pressure_on);
  firmness_->setValue(int(std::lround(kSliderSteps * settings.curve.firmness())));
  firmness_->setEnabled(settings.pressure_on);
  threshold_->setValue(
      int(std::lround(kSliderSteps * settings.curve.threshold() / PressureCurve::kMaxThreshold)));
  threshold_text_->setText(percent(settings.curve.threshold()));
  loads_ = false;
}

void PensPage::show_pressure(std::optional<double> raw, double curved) {
  bar_->setValue(int(std::lround(kSliderSteps * curved)));
  editor_->show_raw(raw.value_or(0.0));
  numbers_->setText(raw ? tr("pen %1, line %2").arg(percent(*raw), percent(curved))
                        : tr("mouse, line %1").arg(percent(curved)));
}

void PensPage::show_tilt(std::optional<double> tilt_deg) {
  tilt_->setText(tilt_deg ? tr("The pen is tilted by %L1°").arg(*tilt_deg, 0, 'f', 0)
                          : tr("The tilt of the pen is not known"));
}

}  // namespace felt::desktop
