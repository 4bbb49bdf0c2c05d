#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSlider>
#include <QString>
#include <utility>
#include <vector>

namespace felt::desktop {

/// Controls that show a setting and change it, and follow it wherever else it is changed.
QCheckBox* setting_switch(const QString& key, bool fallback, const QString& text,
                          const QString& tip, QWidget* parent);
/// `choices`: what is kept, and what is shown for it.
QComboBox* setting_choice(const QString& key, const QString& fallback,
                          const std::vector<std::pair<QString, QString>>& choices,
                          const QString& name, QWidget* parent);

/// A share, 0..1, in steps of a hundredth.
QSlider* setting_slider(const QString& key, double fallback, const QString& name, QWidget* parent);

}  // namespace felt::desktop
