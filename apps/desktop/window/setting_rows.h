#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSlider>
#include <QString>
#include <utility>
#include <vector>

namespace felt::desktop {

/// Returns a control that shows and changes a setting, and follows changes that come from
/// elsewhere.
QCheckBox* setting_switch(const QString& key, bool fallback, const QString& text,
                          const QString& tip, QWidget* parent);
/// `choices` are the stored values and the texts that the user sees.
QComboBox* setting_choice(const QString& key, const QString& fallback,
                          const std::vector<std::pair<QString, QString>>& choices,
                          const QString& name, QWidget* parent);

/// Returns a slider for a share, 0..1, in steps of 0.01.
QSlider* setting_slider(const QString& key, double fallback, const QString& name, QWidget* parent);

}  // namespace felt::desktop
