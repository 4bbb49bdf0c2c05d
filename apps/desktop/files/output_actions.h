#pragma once

#include <QObject>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/export_file.h"
#include "felt/formats/lost_objects.h"

class QPrinter;

namespace felt::desktop {

class FileActions;

/// Handles "file.export", "file.page_setup", "file.print" and "file.print_preview".
class OutputActions : public QObject {
  Q_OBJECT

 public:
  OutputActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window);

  /// Starts an export. Errors are shown to the user.
  void export_to(const QString& path, const ExportOptions& options);
  /// Prints a drawing. Returns false if nothing was printed because of an error, which is shown to
  /// the user.
  bool print_to(QPrinter& printer, const Drawing& drawing, double max_dpi = 1e9);

 Q_SIGNALS:
  /// The export to `path` has ended. `lost` counts what the format cannot hold; `changed` says what
  /// was changed for swell paper.
  void exported(const QString& path, bool done, const felt::LostObjects& lost,
                const QString& changed);

 private:
  void report_exported(const QString& path, const Result<void>& done, const LostObjects& lost,
                       const QString& changed);
  void ask_export();
  void ask_page();
  void print();
  void preview();

  FileActions& files_;
  Studio& studio_;
  QWidget* window_;
};

}  // namespace felt::desktop
