#pragma once

#include <QDialog>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// The guide on one page: what the tools do, how to move the page, what the forces mean, where
/// drawings are saved. The section about the tools is generated from the tools' own texts
/// (ToolInfo).
class GuideDialog : public QDialog {
  Q_OBJECT

 public:
  GuideDialog(const Actions& actions, QWidget* parent = nullptr);
};

}  // namespace felt::desktop
