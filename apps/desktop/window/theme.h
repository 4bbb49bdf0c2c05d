#pragma once

#include <QPalette>
#include <QString>

namespace felt::desktop {

/// The colour theme of the program.
enum class Theme { kSystem, kLight, kDark };

/// Returns the theme for the name "system", "light" or "dark"; kSystem for any other name.
Theme theme_of(const QString& name);

/// Returns Feltline's palette for a theme. For kSystem, returns the light or the dark palette,
/// depending on the desktop. Enabled text has a contrast of at least 4.5 : 1 to its background
/// (WCAG 2.1, 1.4.3).
QPalette palette_of(Theme theme);

/// Sets style and palette of the whole program, including open windows.
void apply_theme(Theme theme);

/// Applies the theme of the settings, now and whenever the setting changes.
void follow_theme_setting();

}  // namespace felt::desktop
