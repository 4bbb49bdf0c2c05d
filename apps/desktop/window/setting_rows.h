#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSlider>
#include <QString>
#include <utility>
#include <vector>

namespace felt::desktop {

/// Returns a check box that shows and changes a setting. The check box is also updated when other
/// code changes the setting.
QCheckBox* setting_switch(const QString& key, bool fallback, const QString& text,
                          const QString& tip, QWidget* parent);
/// Does the same with a list. `choices` are pairs of the stored value and the text that the user
/// sees.
QComboBox* setting_choice(const QString& key, const QString& fallback,
                          const std::vector<std::pair<QString, QString>>& choices,
                          const QString& name, QWidget* parent);

/// Does the same with a slider for a number from 0 to 1, in steps of 0.01.
QSlider* setting_slider(const QString& key, double fallback, const QString& name, QWidget* parent);

}  // namespace felt::desktop
