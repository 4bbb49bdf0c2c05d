#include <QApplication>

#include "desktop/window/main_window.h"

int main(int argc, char** argv) {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-desktop"));
  QCoreApplication::setApplicationVersion(QStringLiteral(FELT_VERSION));
  const QApplication app(argc, argv);
  felt::desktop::MainWindow window({});
  window.resize(1280, 800);
  window.show();
  return QApplication::exec();
}
