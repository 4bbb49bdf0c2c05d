#include "desktop/files/instance.h"

#include <gtest/gtest.h>

#include <QLocalServer>
#include <QSignalSpy>
#include <QUuid>
#include <thread>

namespace felt::desktop::instance_test {
namespace {

QString fresh_key() {
  return QUuid::createUuid().toString();
}

TEST(Instance, TheSecondHandsItsFilesToTheFirst) {
  const QString key = fresh_key();
  Instance first(key);
  EXPECT_FALSE(first.hand_over({QStringLiteral("a.felt")}));
  EXPECT_TRUE(first.is_first());
  QSignalSpy wanted(&first, &Instance::wanted);
  bool taken = false;
  // A thread acts as another process: it waits while the loop of the first process runs.
  std::thread other([&] {
    Instance second(key);
    taken = second.hand_over({QStringLiteral("/tmp/ä b.felt"), QStringLiteral("c.felt")});
  });
  EXPECT_TRUE(wanted.wait(10'000));
  other.join();
  EXPECT_TRUE(taken);
  const QStringList files = wanted[0][0].toStringList();
  ASSERT_EQ(files.size(), 2);
  EXPECT_EQ(files[0], QStringLiteral("/tmp/ä b.felt"));
  EXPECT_TRUE(files[1].startsWith(QLatin1Char('/'))) << "paths are absolute";
}

TEST(Instance, AnEmptySocketOfTheDeadIsTakenOver) {
  const QString key = fresh_key();
  {
    Instance first(key);
    EXPECT_FALSE(first.hand_over({}));
  }
  Instance second(key);
  EXPECT_FALSE(second.hand_over({}));
  EXPECT_TRUE(second.is_first());
}

TEST(Instance, OthersAreLeftAlone) {
  Instance a(fresh_key()), b(fresh_key());
  EXPECT_FALSE(a.hand_over({}));
  EXPECT_FALSE(b.hand_over({}));
  EXPECT_TRUE(a.is_first() && b.is_first());
}

}  // namespace
}  // namespace felt::desktop::instance_test
