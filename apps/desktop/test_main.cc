#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // No display, and nobody's settings, whatever the environment says.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-test"));
  const QApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
