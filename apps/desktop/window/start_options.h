#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "desktop/trial/trial_request.h"

namespace felt::desktop {

/// A request for a picture of a window, for the documents. To make the picture, the program uses
/// default settings, no display and a virtual clock.
struct PictureRequest {
  QString path;  ///< "" if no picture is requested
  QSize size{1280, 800};
  QString theme = QStringLiteral("light");
  QStringList panels;  ///< names of the panels to show
  QString tool;
  QString script;                  ///< path of an event script that is played first
  std::optional<qint64> until_ms;  ///< script time at which the script stops; nullopt: at its end
  QString example;                 ///< id of an example that is opened before the script
  QString file;                    ///< path of a drawing that is opened before the script
  /// "preferences/pen", "shortcuts", "about", "guide", "tour/2"; or what the window shows itself:
  /// "ring", "touch", "onion"
  QString dialog;
};

/// The options of the command line.
struct StartOptions {
  QStringList files;
  bool new_window = false;
  bool measure_start = false;
  QString language;
  QString record;
  TrialRequest trial;
  PictureRequest picture;
};

/// Sets `options` from the arguments of QCoreApplication. Returns an error message, which the
/// program prints to stderr before it exits with code 2, or nullopt.
std::optional<QString> read_arguments(const QStringList& arguments, StartOptions& options);

/// Returns the text of --help.
QString help_text();

}  // namespace felt::desktop
