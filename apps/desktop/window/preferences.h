#pragma once

#include <QDialog>
#include <QListWidget>
#include <QStackedWidget>
#include <functional>
#include <vector>

#include "desktop/window/main_window.h"

namespace felt::desktop {

/// The dialog in which the user changes the settings, with several pages. Every change takes effect
/// immediately and is stored; the dialog has no button to confirm. A page is made when it is first
/// shown.
class Preferences : public QDialog {
  Q_OBJECT

 public:
  explicit Preferences(MainWindow& window);

  /// Shows the page "general", "pen", "device", "canvas" or "shortcuts". Returns false if no page
  /// has that name.
  bool show_page(const QString& name);
  [[nodiscard]] QStringList page_names() const;
  [[nodiscard]] QWidget* page(const QString& name);

 private:
  struct Page {
    QString name;
    std::function<QWidget*()> make;
    QWidget* made = nullptr;
  };
  void add(const QString& name, const char* icon, const QString& title,
           std::function<QWidget*()> make);
  void show_row(int row);

  std::vector<Page> pages_;
  QListWidget* list_;
  QStackedWidget* stack_;
};

}  // namespace felt::desktop
