#include "desktop/files/journal.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QThread>
#include <cmath>
#include <cstdio>

#include "desktop/files/recovery.h"
#include "desktop/files/test_desk.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kStepNs = 10'000'000;

/// A step of a script that draws loops, lifts, undoes and changes layers; the same for everybody.
void step(TestDesk& desk, int k) {
  const int in_line = k % 60;
  const double t = 0.05 * k;
  const Point at{60.0 + 30.0 * std::cos(t) + 0.1 * k, 60.0 + 30.0 * std::sin(1.7 * t)};
  const bool down = in_line >= 5 && in_line < 50;
  desk.studio.point({desk.studio.now_ns(), at, down, 0.3 + 0.2 * std::sin(t)});
  desk.studio.advance(kStepNs);
  if (in_line == 57 && k % 240 > 180) desk.studio.apply(UndoEvent{});
  if (in_line == 58 && k % 300 > 240) desk.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "L"});
}

/// What is drawn after `steps`, with the line in work ended there.
Document reference(int steps) {
  TestDesk desk;
  for (int k = 0; k < steps; ++k) step(desk, k);
  Document document = desk.document();
  if (desk.studio.session().gesture_in_work()) {
    // A tool that is chosen ends the gesture as if the pen were lifted.
    desk.studio.apply(SelectTool{"pull"});
    document = desk.document();
  }
  return document;
}

Document recovered_from(const QString& root) {
  const std::vector<AbandonedFolder> folders = find_abandoned(root);
  EXPECT_EQ(folders.size(), 1u);
  if (folders.empty()) return {};
  const Result<Recovered> recovered = recover(folders.front().path);
  EXPECT_TRUE(recovered) << recovered.error().message;
  return recovered ? recovered->drawing.document : Document();
}

/// A copy of the folder of a living journal, as a crash would leave it.
QString as_crashed(const Journal& journal, const QString& root) {
  const QString copy = root + QStringLiteral("/crashed");
  QDir().mkpath(copy);
  const QDir from(journal.folder());
  const QStringList names = from.entryList(QDir::Files);
  for (const QString& name : names) {
    if (name != QStringLiteral("lock"))
      QFile::copy(from.filePath(name), copy + QLatin1Char('/') + name);
  }
  return copy;
}

TEST(Journal, WhateverWasDrawnIsRecoveredAtAnyStep) {
  for (const int steps : {1, 20, 49, 55, 130, 239, 240, 270, 299, 333}) {
    TestDesk desk;
    desk.files->keep_journal(desk.at("state"));
    for (int k = 0; k < steps; ++k) step(desk, k);
    desk.files->journal()->flush();
    const Result<Recovered> recovered =
        recover(as_crashed(*desk.files->journal(), desk.folder.path()));
    ASSERT_TRUE(recovered) << recovered.error().message;
    const Document expected = reference(steps);
    EXPECT_EQ(recovered->drawing.document.stroke_count(), expected.stroke_count());
    EXPECT_TRUE(recovered->drawing.document == expected) << steps << " steps";
  }
}

TEST(Journal, TheDrawingThatWasOpenedIsItsBase) {
  TestDesk desk;
  desk.files->keep_journal(desk.at("state"));
  desk.draw(1);
  desk.person->next = desk.at("a.felt");
  desk.files->save();
  desk.files->finish_writing();
  desk.journal_flush();
  EXPECT_FALSE(recover(as_crashed(*desk.files->journal(), desk.at("x"))).value().has_changes);
  ASSERT_TRUE(desk.files->open(desk.at("a.felt")));
  desk.draw(2);
  desk.studio.set_page({100.0, 50.0, {9, 8, 7, 255}});
  desk.journal_flush();
  const Recovered recovered = recover(as_crashed(*desk.files->journal(), desk.at("y"))).value();
  EXPECT_TRUE(recovered.has_changes);
  EXPECT_EQ(recovered.name, QStringLiteral("a.felt"));
  EXPECT_EQ(recovered.path, desk.at("a.felt"));
  EXPECT_TRUE(recovered.drawing.document == desk.document());
  EXPECT_EQ(recovered.drawing.page, desk.studio.page());
}

TEST(Journal, ADrawingThatOthersOpenIsABaseToo) {
  TestDesk desk;
  desk.files->keep_journal(desk.at("state"));
  desk.draw(1);
  Document example = desk.document();
  desk.draw(2);
  desk.studio.open(example, {120.0, 90.0, {255, 255, 255, 255}});
  desk.draw(3);
  desk.journal_flush();
  const Recovered recovered = recover(as_crashed(*desk.files->journal(), desk.at("x"))).value();
  EXPECT_TRUE(recovered.drawing.document == desk.document());
  EXPECT_EQ(recovered.drawing.page, desk.studio.page());
}

TEST(Journal, DamageCostsTheEndAndNoMore) {
  TestDesk desk;
  desk.files->keep_journal(desk.at("state"));
  std::vector<Document> after{desk.document()};
  for (std::uint64_t i = 0; i < 12; ++i) {
    desk.draw(i, 1);
    after.push_back(desk.document());
  }
  desk.journal_flush();
  const QString folder = as_crashed(*desk.files->journal(), desk.folder.path());
  QFile log(folder + QStringLiteral("/edits-1"));
  ASSERT_TRUE(log.open(QIODevice::ReadWrite));
  std::size_t most = after.size();
  for (qint64 size = log.size(); size >= 0; size -= 61) {
    ASSERT_TRUE(log.resize(size));
    const Document document = recover(folder).value().drawing.document;
    const std::size_t count = document.stroke_count();
    ASSERT_LT(count, after.size());
    EXPECT_LE(count, most);
    EXPECT_TRUE(document == after[count]);
    most = count;
  }
  EXPECT_EQ(most, 0u);
}

TEST(Journal, ACleanCloseLeavesNothingAndACrashLeavesAFolder) {
  QTemporaryDir root;
  {
    TestDesk desk;
    desk.files->keep_journal(root.path());
    desk.draw(1);
    EXPECT_TRUE(find_abandoned(root.path()).empty()) << "its owner lives";
    desk.person->unsaved = FileDialogs::Unsaved::kDiscard;
    EXPECT_TRUE(desk.files->may_close());
  }
  EXPECT_EQ(QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
  {
    TestDesk desk;
    desk.files->keep_journal(root.path());
    desk.draw(1);  // and the window goes without a question
  }
  std::vector<AbandonedFolder> left = find_abandoned(root.path());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(recover(left[0].path).value().drawing.document.stroke_count(), 3u);
  left[0].remove();
  EXPECT_TRUE(find_abandoned(root.path()).empty());
}

/// In a container every start has the same process number: the folder of the one that died has the
/// name that the next one would take, and its lock names a process that lives.
TEST(Journal, AFolderOfADeadProcessWithOurNumberIsLeftAloneAndOffered) {
  QTemporaryDir root;
  QString name;
  QByteArray lock;
  {
    TestDesk desk;
    desk.files->keep_journal(root.path());
    desk.draw(1);
    name = desk.files->journal()->folder();
    QFile file(name + QStringLiteral("/lock"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    lock = file.readAll();
  }
  const qsizetype dash = name.lastIndexOf(QLatin1Char('-'));
  const QString next = name.left(dash + 1) + QString::number(name.mid(dash + 1).toInt() + 1);
  ASSERT_TRUE(QDir().rename(name, next));
  QFile file(next + QStringLiteral("/lock"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(lock);
  file.close();

  TestDesk desk;
  desk.files->keep_journal(root.path());
  EXPECT_NE(desk.files->journal()->folder(), next);
  desk.draw(2, 1);
  const std::vector<AbandonedFolder> left = find_abandoned(root.path());
  ASSERT_EQ(left.size(), 1u) << "the dead one's, not the one in use";
  EXPECT_EQ(left[0].path, next);
  EXPECT_EQ(recover(next).value().drawing.document.stroke_count(), 3u);
  desk.studio.set_modified(false);
}

TEST(Journal, AFailureIsSaidAndNothingElseHappens) {
  TestDesk desk;
  QFile file(desk.at("state"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));  // a file where the folder should be
  desk.files->keep_journal(desk.at("state"));
  QSignalSpy failed(desk.files->journal(), &Journal::failed);
  desk.draw(1);
  EXPECT_TRUE(failed.count() > 0 || failed.wait(5000));
  EXPECT_EQ(desk.document().stroke_count(), 3u);
}

TEST(Journal, ALongLogBeginsAnewAndLosesNothing) {
  QTemporaryDir root;
  TestDesk desk;
  desk.draw(1, 20);
  JournalWriter writer(root.path().toStdString(), [](const std::string&) {});
  writer.begin(std::make_shared<const Drawing>(desk.files->drawing()));
  desk.studio.listen({{}, [&](const Edit& edit) { writer.edit(edit); }});
  for (std::uint64_t i = 0; i < 40; ++i) {
    desk.draw(i, 1);
    if (i % 7 == 3) writer.renew(std::make_shared<const Drawing>(desk.files->drawing()));
    if (i % 5 == 2) writer.flush();
  }
  desk.studio.listen({});
  writer.flush();
  EXPECT_TRUE(recover(root.path()).value().drawing.document == desk.document());
  EXPECT_EQ(QDir(root.path()).entryList({QStringLiteral("base-*")}).size(), 1);
}

/// Draws until the test below kills it; by itself a few lines, which must be there at its end.
TEST(JournalChild, Draws) {
  const QTemporaryDir own;
  const QString given = qEnvironmentVariable("FELT_TEST_JOURNAL");
  const int steps = given.isEmpty() ? 70 : 2000;
  TestDesk desk;
  desk.files->keep_journal(given.isEmpty() ? own.path() : given);
  for (int k = 0; k < steps; ++k) {
    step(desk, k);
    if (k % 20 == 7) {
      desk.files->journal()->flush();
      std::printf("kept %d\n", k + 1);
    }
    std::printf("drawn %d\n", k + 1);
    std::fflush(stdout);
    QThread::msleep(10);
  }
  desk.files->journal()->flush();
  const Result<Recovered> recovered =
      recover(as_crashed(*desk.files->journal(), desk.folder.path()));
  ASSERT_TRUE(recovered) << recovered.error().message;
  EXPECT_TRUE(recovered->drawing.document == reference(steps));
}

TEST(Journal, AKilledProgramLosesNextToNothing) {
  for (const int kill_at : {15, 47, 95, 163}) {
    QTemporaryDir root;
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("FELT_TEST_JOURNAL"), root.path());
    child.setProcessEnvironment(environment);
    child.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("--gtest_filter=JournalChild.*")});
    int drawn = 0, kept = 0;
    while (drawn < kill_at && (child.canReadLine() || child.waitForReadyRead(20'000))) {
      while (child.canReadLine()) {
        const QList<QByteArray> words = child.readLine().trimmed().split(' ');
        if (words[0] == "drawn") drawn = words[1].toInt();
        if (words[0] == "kept") kept = words[1].toInt();
      }
    }
    child.kill();  // SIGKILL
    ASSERT_TRUE(child.waitForFinished());
    ASSERT_GE(drawn, kill_at);
    const QList<QByteArray> rest = child.readAll().split('\n');
    for (const QByteArray& line : rest) {
      if (line.startsWith("drawn ")) drawn = line.mid(6).toInt();
      if (line.startsWith("kept ")) kept = line.mid(5).toInt();
    }
    const Document document = recovered_from(root.path());
    int found = -1;
    for (int k = drawn + 2; k >= kept && found < 0; --k) {
      if (document == reference(k)) found = k;
    }
    EXPECT_GE(found, kept) << "killed after " << drawn << " steps";
    std::printf("killed after %d steps of 10 ms: the last %d are lost\n", drawn, drawn - found);
  }
}

}  // namespace
}  // namespace felt::desktop
