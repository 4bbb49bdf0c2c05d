#pragma once

#include <QObject>
#include <QWidget>
#include <optional>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/export_file.h"
#include "felt/render/grain.h"

class QPainter;
class QPrinter;

namespace felt::desktop {

class FileActions;

/// The sheet on paper, in lines and not in pixels: `painter` draws it at its true size where a unit
/// of its device is 1/dpi of an inch, from the corner of the page on. With grain, strokes that show
/// it are pictures, of 300 dots per inch or as fine as all of them can be.
void paint_sheet(QPainter& painter, const Drawing& drawing, double dpi,
                 const std::optional<Grain>& grain = {});

/// Sets the paper that the sheet asks for, and prints it there, with grain where the screen shows
/// it.
void print_drawing(QPrinter& printer, const Drawing& drawing);

/// "file.export", "file.page_setup", "file.print", "file.print_preview".
class OutputActions : public QObject {
  Q_OBJECT

 public:
  OutputActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window);

  /// Begins to write; what went wrong is told.
  void export_to(const QString& path, const ExportOptions& options);

 Q_SIGNALS:
  void exported(const QString& path, bool done);

 private:
  void tell_exported(const QString& path, const Result<void>& done);
  void ask_export();
  void ask_page();
  void print();
  void preview();

  FileActions& files_;
  Studio& studio_;
  QWidget* window_;
};

}  // namespace felt::desktop
