#include "desktop/files/output_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QGraphicsView>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <memory>

#include "desktop/files/error_words.h"
#include "desktop/files/export_dialog.h"
#include "desktop/files/file_actions.h"
#include "desktop/files/format_texts.h"
#include "desktop/files/page_dialog.h"
#include "desktop/files/printed_page.h"
#include "desktop/files/swell_words.h"

namespace felt::desktop {
namespace {

/// About as many dots per inch as a preview shows of a whole page.
constexpr double kPreviewDpi = 100.0;

/// Returns a printer whose paper has the size of the page.
std::unique_ptr<QPrinter> printer_for(const Drawing& drawing, const QString& name) {
  auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
  const Page& page = drawing.page;
  const bool lies = page.width_mm > page.height_mm;
  const QSizeF upright(lies ? page.height_mm : page.width_mm,
                       lies ? page.width_mm : page.height_mm);
  printer->setPageSize(QPageSize(upright, QPageSize::Millimeter, {}, QPageSize::FuzzyMatch));
  printer->setPageOrientation(lies ? QPageLayout::Landscape : QPageLayout::Portrait);
  printer->setFullPage(true);  // the page's corner is the paper's corner
  printer->setDocName(name);
  return printer;
}

}  // namespace

OutputActions::OutputActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window)
    : QObject(window), files_(files), studio_(studio), window_(window) {
  actions.add(QStringLiteral("file.export"), tr("&Export…"),
              {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)},
              tr("Export the drawing as SVG, PDF, PNG or ink for other programs"),
              [this] { ask_export(); });
  actions.add(QStringLiteral("file.page_setup"), tr("Pa&ge setup…"), {},
              tr("Size, orientation and colour of the page"), [this] { ask_page(); });
  actions.add(QStringLiteral("file.print_preview"), tr("Print pre&view…"), {},
              tr("Shows what will be printed"), [this] { preview(); });
  actions.add(QStringLiteral("file.print"), tr("&Print…"), {QKeySequence::Print},
              tr("Prints the page at its true size"), [this] { print(); });
}

void OutputActions::ask_export() {
  ExportDialog dialog(files_.drawing(), studio_.session().selection(), window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const ExportOptions options = dialog.options();
  const QString suffix = suffix_of(options.format);
  const QString base = QFileInfo(files_.display_name()).completeBaseName();
  const QString chosen = files_.dialogs().name_to_write(
      window_, tr("Export"), QDir(files_.folder()).filePath(base + suffix), options.format);
  if (!chosen.isEmpty()) export_to(chosen, options);
}

void OutputActions::export_to(const QString& path, const ExportOptions& options) {
  Drawing drawing = files_.drawing();
  if (options.part == ExportPart::kSelection) {
    drawing = selected_only(std::move(drawing), studio_.session().selection());
  }
  files_.worker().start([this, path, options,
                         drawing = std::move(drawing)]() -> FileWorker::Answer {
    SwellReport swell;
    const Result<void> done = export_drawing(path, drawing, options, &swell);
    const LostObjects lost =
        options.swell ? LostObjects() : lost_objects(drawing, options.format, options.compact);
    return
        [this, path, done, lost, swell] { report_exported(path, done, lost, swell_words(swell)); };
  });
}

void OutputActions::report_exported(const QString& path, const Result<void>& done,
                                    const LostObjects& lost, const QString& changed) {
  const QString name = QFileInfo(path).fileName();
  if (!done) {
    files_.dialogs().show_error(window_, tr("“%1” was not exported").arg(name),
                                error_words(done.error()),
                                QString::fromStdString(done.error().message));
  }
  Q_EMIT exported(path, done.has_value(), lost, changed);
}

void OutputActions::ask_page() {
  PageDialog dialog(studio_.page(), window_);
  if (dialog.exec() == QDialog::Accepted) studio_.set_page(dialog.page());
}

void OutputActions::print() {
  const Drawing drawing = files_.drawing();
  const auto printer = printer_for(drawing, files_.display_name());
  QPrintDialog dialog(printer.get(), window_);
  dialog.setWindowTitle(tr("Print"));
  if (dialog.exec() == QDialog::Accepted) print_to(*printer, drawing);
}

bool OutputActions::print_to(QPrinter& printer, const Drawing& drawing, double max_dpi) {
  const Result<void> done = print_drawing(printer, drawing, max_dpi);
  if (!done) {
    files_.dialogs().show_error(window_, tr("“%1” was not printed").arg(files_.display_name()),
                                error_words(done.error()),
                                QString::fromStdString(done.error().message));
  }
  return done.has_value();
}

void OutputActions::preview() {
  const Drawing drawing = files_.drawing();
  const auto printer = printer_for(drawing, files_.display_name());
  QPrintPreviewDialog dialog(printer.get(), window_);
  dialog.setWindowTitle(tr("Print preview"));
  for (auto* view : dialog.findChildren<QGraphicsView*>()) {
    view->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  }
  bool has_failed = false;
  connect(&dialog, &QPrintPreviewDialog::paintRequested, this, [&](QPrinter* target) {
    if (has_failed || print_to(*target, drawing, kPreviewDpi)) return;
    has_failed = true;  // the message is shown once, instead of an empty preview
    QMetaObject::invokeMethod(&dialog, "reject", Qt::QueuedConnection);
  });
  dialog.exec();
}

}  // namespace felt::desktop
