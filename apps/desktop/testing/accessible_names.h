#pragma once

#include <QStringList>
#include <QWidget>

namespace felt::desktop {

/// The controls under `root` that a screen reader has no name for, each as "QToolButton \"zoom\" in
/// FeelPanel". Hidden ones count: somebody will see them. What Qt makes for itself (the editor of a
/// spin box, scroll bars) is left out.
QStringList nameless_controls(QWidget& root);

}  // namespace felt::desktop
