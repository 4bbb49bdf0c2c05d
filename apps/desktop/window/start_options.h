#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

namespace felt::desktop {

/// A picture of a window, for the documents: nobody's settings, no display, a virtual clock.
struct PictureRequest {
  QString path;  ///< "" for none
  QSize size{1280, 800};
  QString theme = QStringLiteral("light");
  QStringList panels;  ///< to be shown
  QString tool;
  QString script;                  ///< an event script that is played first
  std::optional<qint64> until_ms;  ///< stops it there
  QString example;                 ///< opened before the script
  QString dialog;                  ///< "preferences/pen", "shortcuts", "about", "guide", "tour/2"
};

/// What the command line says.
struct StartOptions {
  QStringList files;
  bool new_window = false;
  bool measure_start = false;
  QString language;
  QString record;
  PictureRequest picture;
};

/// Reads the arguments, as QCoreApplication has them. Error: a sentence for stderr; exit code 2.
std::optional<QString> read_arguments(const QStringList& arguments, StartOptions& options);

/// What --help prints.
QString help_text();

}  // namespace felt::desktop
