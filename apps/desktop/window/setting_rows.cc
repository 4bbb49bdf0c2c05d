#include "desktop/window/setting_rows.h"

#include "desktop/engine/settings.h"

namespace felt::desktop {

QCheckBox* setting_switch(const QString& key, bool fallback, const QString& text,
                          const QString& tip, QWidget* parent) {
  auto* box = new QCheckBox(text, parent);
  box->setToolTip(tip);
  const auto show = [box, key, fallback] { box->setChecked(Settings::the().flag(key, fallback)); };
  show();
  QObject::connect(box, &QCheckBox::toggled, box, [key](bool on) { Settings::the().set(key, on); });
  QObject::connect(&Settings::the(), &Settings::changed, box, [key, show](const QString& changed) {
    if (changed == key) show();
  });
  return box;
}

QComboBox* setting_choice(const QString& key, const QString& fallback,
                          const std::vector<std::pair<QString, QString>>& choices,
                          const QString& name, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setAccessibleName(name);
  for (const auto& [kept, shown] : choices) box->addItem(shown, kept);
  const auto show = [box, key, fallback] {
    const int index = box->findData(Settings::the().text(key, fallback));
    box->setCurrentIndex(index < 0 ? 0 : index);
  };
  show();
  QObject::connect(box, &QComboBox::currentIndexChanged, box,
                   [box, key] { Settings::the().set(key, box->currentData().toString()); });
  QObject::connect(&Settings::the(), &Settings::changed, box, [key, show](const QString& changed) {
    if (changed == key) show();
  });
  return box;
}

QSlider* setting_slider(const QString& key, double fallback, const QString& name, QWidget* parent) {
  constexpr int kSteps = 100;
  auto* slider = new QSlider(Qt::Horizontal, parent);
  slider->setRange(0, kSteps);
  slider->setAccessibleName(name);
  const auto show = [slider, key, fallback] {
    slider->setValue(qRound(kSteps * Settings::the().number(key, fallback)));
  };
  show();
  QObject::connect(slider, &QSlider::valueChanged, slider,
                   [key](int value) { Settings::the().set(key, double(value) / kSteps); });
  QObject::connect(&Settings::the(), &Settings::changed, slider,
                   [key, show](const QString& changed) {
                     if (changed == key) show();
                   });
  return slider;
}

}  // namespace felt::desktop
