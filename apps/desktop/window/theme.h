#pragma once

#include <QPalette>
#include <QString>

namespace felt::desktop {

/// How the program looks.
enum class Theme { kSystem, kLight, kDark };

/// "system", "light", "dark"; anything else is kSystem.
Theme theme_of(const QString& name);

/// Our own colours. Of kSystem: light or dark as the desktop is. Text has a contrast of 4.5 : 1 at
/// least to what it stands on (WCAG 2.1, 1.4.3), wherever it is enabled.
QPalette palette_of(Theme theme);

/// Style and palette of the whole program, at once, windows that are open included.
void apply_theme(Theme theme);

/// The one that the settings name; follows them from now on.
void follow_theme_setting();

}  // namespace felt::desktop
