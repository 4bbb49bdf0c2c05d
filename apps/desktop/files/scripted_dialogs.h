#pragma once

#include <QStringList>
#include <utility>

#include "desktop/files/file_dialogs.h"

namespace felt::desktop {

/// A person who answers as a test says, and remembers what was asked.
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
  bool ask_overwrite(QWidget*, const QString& name) override {
    asked.push_back(name);
    return overwrite;
  }
  bool ask_salvage(QWidget*, const QString& name, const QString&, int strokes) override {
    asked.push_back(name);
    salvageable = strokes;
    return salvage;
  }
  void show_error(QWidget*, const QString& what, const QString& why) override {
    errors.push_back(what + QStringLiteral(": ") + why);
  }

  QString next;       ///< the name that is chosen
  QString then;       ///< the name that is chosen to save the next time; "": the same again
  QString suggested;  ///< the last one that save_name was given
  Unsaved unsaved = Unsaved::kCancel;
  bool overwrite = false;
  bool salvage = false;
  int salvageable = 0;  ///< strokes that the last question told of
  QStringList asked;
  QStringList errors;
};

}  // namespace felt::desktop
