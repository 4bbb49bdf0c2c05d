#include <QApplication>

#include "desktop/window/main_window.h"
#include "desktop/window/theme.h"

int main(int argc, char** argv) {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-desktop"));
  QCoreApplication::setApplicationVersion(QStringLiteral(FELT_VERSION));
  const QApplication app(argc, argv);
  felt::desktop::follow_theme_setting();
  felt::desktop::MainWindow window({});
  window.show();
  return QApplication::exec();
}
