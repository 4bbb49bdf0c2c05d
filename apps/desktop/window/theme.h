#pragma once

#include <QPalette>
#include <QString>

namespace felt::desktop {

/// The colour theme of the program.
enum class Theme { kSystem, kLight, kDark };

/// Returns the theme of "system", "light" or "dark"; kSystem for any other name.
Theme theme_of(const QString& name);

/// Returns our palette; for kSystem light or dark as on the desktop. Enabled text has a contrast of
/// at least 4.5 : 1 to its background (WCAG 2.1, 1.4.3).
QPalette palette_of(Theme theme);

/// Sets style and palette of the whole program, including open windows.
void apply_theme(Theme theme);

/// Applies the theme of the settings, and follows the setting.
void follow_theme_setting();

}  // namespace felt::desktop
