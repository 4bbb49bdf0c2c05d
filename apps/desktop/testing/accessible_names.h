#pragma once

#include <QStringList>
#include <QWidget>

namespace felt::desktop {

/// Returns the controls under `root` without an accessible name, each as "QToolButton \"zoom\" in
/// FeelPanel". Includes hidden ones, because they may be shown later. Skips parts that Qt makes
/// itself (the editor of a spin box, scroll bars).
QStringList nameless_controls(QWidget& root);

}  // namespace felt::desktop
