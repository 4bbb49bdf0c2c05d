#pragma once

#include <QStringList>
#include <utility>

#include "desktop/files/file_dialogs.h"

namespace felt::desktop {

/// Dialogs for tests. They return the answers that the test has set, and record the questions.
class ScriptedDialogs : public FileDialogs {
 public:
  QString open_name(QWidget*, const QString&, const QString&, const QString&) override {
    return next;
  }
  QStringList open_names(QWidget*, const QString&, const QString&, const QString&) override {
    return {next};
  }
  QString save_name(QWidget*, const QString&, const QString& path, const QString&,
                    const QString&) override {
    suggested = path;
    return std::exchange(next, then.isEmpty() ? next : then);
  }
  Unsaved ask_unsaved(QWidget*, const QString& name) override {
    asked.push_back(name);
    return unsaved;
  }
  Overwrite ask_overwrite(QWidget*, const QString& name) override {
    asked.push_back(name);
    return overwrite;
  }
  bool ask_salvage(QWidget*, const QString& name, const QString&, int strokes) override {
    asked.push_back(name);
    salvageable = strokes;
    return salvage;
  }
  int ask_page(QWidget*, const QString& name, int) override {
    asked.push_back(name);
    return page;
  }
  void show_error(QWidget*, const QString& what, const QString& why,
                  const QString& details) override {
    errors.push_back(what + QStringLiteral(": ") + why + QLatin1Char(' ') + details);
  }
  void show_save_error(QWidget* window, const QString& what, const QString& why,
                       const QString& details, std::function<void()> save_as) override {
    show_error(window, what, why, details);
    save_elsewhere = std::move(save_as);
  }

  QString next;       ///< the next name that is chosen
  QString then;       ///< the name chosen at the following save; if "", the same name
  QString suggested;  ///< the name that save_name was last given
  Unsaved unsaved = Unsaved::kCancel;
  Overwrite overwrite = Overwrite::kCancel;
  std::function<void()> save_elsewhere;  ///< the action that the last failed save offered
  bool salvage = false;
  int salvageable = 0;  ///< number of strokes in the last question
  int page = 1;         ///< the next page that is chosen
  QStringList asked;
  QStringList errors;
};

}  // namespace felt::desktop
