#pragma once

#include <QDialog>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// The guide: what the tools do, how the sheet is moved, what is felt, where drawings go, on one
/// page. The tools' part is made from their own tables.
class GuideDialog : public QDialog {
  Q_OBJECT

 public:
  GuideDialog(const Actions& actions, QWidget* parent = nullptr);
};

}  // namespace felt::desktop
