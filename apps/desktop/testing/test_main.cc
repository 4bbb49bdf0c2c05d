#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace {

/// Ends the process if one test takes longer than any test needs, so that the last line of the
/// output names the test that waits for ever.
class TestTimeLimit : public ::testing::EmptyTestEventListener {
 public:
  void OnTestStart(const ::testing::TestInfo&) override { ::alarm(kSeconds); }
  void OnTestEnd(const ::testing::TestInfo&) override { ::alarm(0); }

 private:
  static constexpr unsigned kSeconds = 300;
};

}  // namespace

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
  ::testing::UnitTest::GetInstance()->listeners().Append(new TestTimeLimit);
  return RUN_ALL_TESTS();
}
