#include <QApplication>
#include <QCommandLineParser>
#include <cstdio>
#include <memory>

#include "desktop/engine/recording_file.h"
#include "desktop/window/main_window.h"

int main(int argc, char** argv) {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-desktop"));
  QCoreApplication::setApplicationVersion(QStringLiteral(FELT_VERSION));
  const QApplication app(argc, argv);
  QCommandLineParser parser;
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption record(
      QStringLiteral("record"),
      QCoreApplication::translate(
          "main", "Record all that happens to the drawing, for feltline replay --as-recorded."),
      QCoreApplication::translate("main", "FILE"));
  parser.addOption(record);
  parser.process(app);
  felt::desktop::StudioOptions options;
  const std::unique_ptr<felt::desktop::RecordingFile> recording =
      felt::desktop::record_into(parser.value(record), options);
  felt::desktop::MainWindow window(std::move(options));
  if (recording && !recording->error().isEmpty()) {
    std::fprintf(stderr, "feltline-desktop: %s\n", qPrintable(recording->error()));
    return 1;
  }
  window.resize(1280, 800);
  window.show();
  return QApplication::exec();
}
