#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTextBrowser>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Shows all current shortcuts on one page; the user can search and print them.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  ShortcutSheet(const Actions& actions, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void print();

  const Actions& actions_;
  QLineEdit* search_;
  QTextBrowser* page_;
};

}  // namespace felt::desktop
