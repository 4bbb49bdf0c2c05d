#include "desktop/solid/solid_actions.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <array>
#include <utility>

#include "desktop/engine/text_of.h"
#include "desktop/files/error_words.h"
#include "felt/base/atomic_file.h"

namespace felt::desktop {
namespace {

QString solid_text(const char* text) {
  return QCoreApplication::translate("SolidActions", text);
}

/// A format, with the texts of its action.
struct FormatRow {
  SolidFormat format;
  const char* ending;
  const char* text;
  const char* tip;
  const char* files;
};
constexpr std::array kFormats{
    FormatRow{SolidFormat::kStl, "stl", QT_TRANSLATE_NOOP("SolidActions", "&STL…"),
              QT_TRANSLATE_NOOP("SolidActions", "Writes the solid as triangles, for printing"),
              QT_TRANSLATE_NOOP("SolidActions", "STL file (*.stl)")},
    FormatRow{SolidFormat::k3mf, "3mf", QT_TRANSLATE_NOOP("SolidActions", "&3MF…"),
              QT_TRANSLATE_NOOP("SolidActions",
                                "Writes the solid with its unit and colours, for printing"),
              QT_TRANSLATE_NOOP("SolidActions", "3MF file (*.3mf)")},
    FormatRow{SolidFormat::kObj, "obj", QT_TRANSLATE_NOOP("SolidActions", "&OBJ…"),
              QT_TRANSLATE_NOOP("SolidActions", "Writes the solid for any 3D program"),
              QT_TRANSLATE_NOOP("SolidActions", "Wavefront file (*.obj)")},
    FormatRow{
        SolidFormat::kGlb, "glb", QT_TRANSLATE_NOOP("SolidActions", "&glTF…"),
        QT_TRANSLATE_NOOP(
            "SolidActions",
            "Writes the solid with colours and smooth shading, for 3D programs and web pages"),
        QT_TRANSLATE_NOOP("SolidActions", "Binary glTF file (*.glb)")},
};

/// Asks for a name with this ending. If the ending is appended after the dialog has asked about
/// replacing a file, and a file has that name, asks again.
QString ask_name(FileActions& files, const FormatRow& row, QWidget* window) {
  const QString ending = QLatin1Char('.') + QString::fromLatin1(row.ending);
  QString suggested =
      QDir(files.folder()).filePath(QFileInfo(files.display_name()).completeBaseName() + ending);
  for (;;) {
    QString chosen = files.dialogs().save_name(
        window, solid_text(QT_TRANSLATE_NOOP("SolidActions", "Export the solid")), suggested,
        solid_text(row.files), ending.mid(1));
    if (chosen.isEmpty() || chosen.endsWith(ending, Qt::CaseInsensitive)) return chosen;
    suggested = chosen + ending;
    if (!QFileInfo::exists(suggested)) return suggested;
  }
}

}  // namespace

void export_solid(FileActions& files, const PaintedSolid& painted, SolidFormat format,
                  const QString& path, QWidget* window) {
  files.worker().start([&files, painted, format, path, window]() -> FileWorker::Answer {
    const auto encoded = encode_solid(*painted.solid, format, painted.paint.get());
    const Result<void> done = encoded.and_then([&](const std::string& bytes) {
      return write_file(QFile::encodeName(path).toStdString(), bytes);
    });
    const bool loses = loses_paint(*painted.solid, format, painted.paint.get());
    return [&files, path, done, loses, window] {
      if (done) {
        return Q_EMIT files.exported(
            path, {},
            loses ? solid_text(QT_TRANSLATE_NOOP("SolidActions",
                                                 "The paint on the body was left out, because the "
                                                 "format has none; glTF has it."))
                  : QString());
      }
      files.dialogs().show_error(
          window,
          solid_text(QT_TRANSLATE_NOOP("SolidActions", "“%1” was not exported"))
              .arg(QFileInfo(path).fileName()),
          error_words(done.error()), text_of(done.error()));
    };
  });
}

void add_solid_actions(Actions& actions, FileActions& files, SolidPanel& panel, QWidget* window) {
  QList<QAction*> made;
  for (const FormatRow& row : kFormats) {
    QAction* action =
        actions.add(QStringLiteral("file.export_solid_") + QString::fromLatin1(row.ending),
                    solid_text(row.text), {}, solid_text(row.tip), [&files, &panel, &row, window] {
                      // The dialog's event loop may replace the bodies: those that are seen now are
                      // written.
                      const PaintedSolid painted{panel.solid(), panel.paint()};
                      if (!painted.solid) return;
                      const QString path = ask_name(files, row, window);
                      if (!path.isEmpty()) export_solid(files, painted, row.format, path, window);
                    });
    action->setEnabled(false);
    made.push_back(action);
  }
  panel.set_export_actions(made);
  QObject::connect(&panel, &SolidPanel::solid_changed, &panel, [&panel, made] {
    for (QAction* action : made) action->setEnabled(panel.solid() != nullptr);
  });
}

}  // namespace felt::desktop
