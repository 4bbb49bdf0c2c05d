#pragma once

#include <QObject>
#include <QWidget>
#include <optional>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/export_file.h"
#include "felt/formats/lost_objects.h"
#include "felt/render/grain.h"

class QPainter;
class QPrinter;

namespace felt::desktop {

class FileActions;

/// Paints the page as vector lines. One unit of the painter must be 1/dpi inch; the page then has
/// its true size. The corner of the page is at the origin. If `grain` is given, strokes that show
/// grain are painted as pictures with 300 dots per inch, or with a lower resolution if all pictures
/// together would be too large.
void paint_page(QPainter& painter, const Drawing& drawing, double dpi,
                const std::optional<Grain>& grain = {});

/// Sets the printer's paper to the size of the page and prints. Prints the grain if the screen
/// shows it.
void print_drawing(QPrinter& printer, const Drawing& drawing);

/// Handles "file.export", "file.page_setup", "file.print" and "file.print_preview".
class OutputActions : public QObject {
  Q_OBJECT

 public:
  OutputActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window);

  /// Starts an export. Errors are shown to the user.
  void export_to(const QString& path, const ExportOptions& options);

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
