#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  // Tests use no display, and empty settings in a separate folder, regardless of the environment.
  // Therefore tests that run at the same time do not share settings.
  const QTemporaryDir home;
  if (!home.isValid()) return 1;
  qputenv("HOME", home.path().toLocal8Bit());
  qputenv("XDG_DATA_HOME", home.path().toLocal8Bit() + "/data");
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName(QStringLiteral("feltline"));
  QCoreApplication::setApplicationName(QStringLiteral("feltline-test"));
  const QApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
