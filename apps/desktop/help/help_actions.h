#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/help/examples.h"
#include "felt/document/document.h"

namespace felt::desktop {

/// Adds and handles "help.guide", "help.shortcuts", "help.tour", "help.example_cat" etc. and
/// "help.about". `actions` and `window` must outlive this object.
class HelpActions : public QObject {
  Q_OBJECT

 public:
  HelpActions(Actions& actions, QWidget* window);

 Q_SIGNALS:
  /// Emitted when the user chose an example. The receiver shows the drawing in a pristine window or
  /// in a new window.
  void wants_drawing(const felt::Document& drawing, const QString& title);

 private:
  void make_example(const Example& example);
  void show_tour();
  /// Shows the window `dialog`. Makes it with `make` only if it does not exist yet.
  void show_dialog(QPointer<QWidget>& dialog, QWidget* (*make)(const Actions&, QWidget*));

  Actions& actions_;
  QWidget* window_;
  QPointer<QWidget> tour_;
  QPointer<QWidget> shortcuts_;
  QPointer<QWidget> guide_;
  QPointer<QWidget> about_;
};

}  // namespace felt::desktop
