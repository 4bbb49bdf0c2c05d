#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/help/examples.h"
#include "felt/document/document.h"

namespace felt::desktop {

/// Adds "help.guide", "help.shortcuts", "help.tour", "help.example_cat" and on, "help.about", and
/// shows what they promise. `actions` and `window` must outlive it.
class HelpActions : public QObject {
  Q_OBJECT

 public:
  HelpActions(Actions& actions, QWidget* window);

 Q_SIGNALS:
  /// An example is wanted, in place of an empty drawing or in a window of its own.
  void wants_drawing(const felt::Document& drawing, const QString& title);

 private:
  void make_example(const Example& example);
  void show_tour();
  /// One window of each kind, made when it is first asked for.
  void show_dialog(QPointer<QWidget>& dialog, QWidget* (*make)(const Actions&, QWidget*));

  Actions& actions_;
  QWidget* window_;
  QPointer<QWidget> tour_;
  QPointer<QWidget> shortcuts_;
  QPointer<QWidget> guide_;
  QPointer<QWidget> about_;
};

}  // namespace felt::desktop
