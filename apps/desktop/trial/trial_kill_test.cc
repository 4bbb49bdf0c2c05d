// A process in which a participant draws is killed in the middle of a trial. The next start of the
// session must find this trial, with all samples that are older than 50 ms.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

#include "desktop/trial/testing/test_participant.h"
#include "desktop/trial/trial_start.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::desktop::trial_kill_test {
namespace {

constexpr const char* kFolderVariable = "FELT_TRIAL_KILL_FOLDER";
constexpr int kKills = 5;
/// Each kill costs at most 1 s, because a busy machine writes later than every 50 ms; the best of
/// all kills at most 100 ms.
constexpr std::int64_t kLargestLossNs = 1'000'000'000;
constexpr std::int64_t kUsualLossNs = 100'000'000;

/// What the process that draws tells the process that kills it, in shared memory.
struct Drawn {
  std::atomic<std::int64_t> first_ns{-1};  // time of the first sample of the trial
  std::atomic<std::int64_t> last_ns{-1};   // time of the newest sample that the session handled
};

Drawn* map_drawn(const std::string& folder) {
  const int file = ::open((folder + "/drawn").c_str(), O_RDWR | O_CREAT, 0600);
  if (file < 0 || ::ftruncate(file, sizeof(Drawn)) != 0) return nullptr;
  void* memory = ::mmap(nullptr, sizeof(Drawn), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<Drawn*>(memory);
}

Result<TrialSetup> prepare(const std::string& folder) {
  const QString path = QString::fromStdString(folder);
  return prepare_trials(
      {path + QStringLiteral("/study.toml"), path + QStringLiteral("/results"), 1},
      QStringLiteral("test pen"), find_stylus_preset("tablet")->capabilities);
}

/// Not a test of its own: the process that is killed. It draws until then.
TEST(TrialKill, DISABLED_Draws) {
  const char* folder = std::getenv(kFolderVariable);
  ASSERT_TRUE(folder);
  Drawn* drawn = map_drawn(folder);
  ASSERT_TRUE(drawn);
  Result<TrialSetup> setup = prepare(folder);
  ASSERT_TRUE(setup) << setup.error().message;
  Studio studio({.reads_forces = true});
  TrialRun run(setup->folder, setup->session, studio);
  TrialWindow window(run, studio);
  window.resize(900, 700);
  window.show();
  TestParticipant person(window, [](int ms) { QTest::qWait(ms); });
  QTest::qWait(50);
  person.press(Qt::Key_Space);
  QObject::connect(&studio, &Studio::sampled, &window, [drawn](const PenSample& sample) {
    if (drawn->first_ns < 0) drawn->first_ns = sample.time_ns;
    drawn->last_ns = sample.time_ns;
  });
  for (;;) person.draw(run.files().paths[0]);
}

/// Starts the process that draws, and kills it when the trial has lasted so long. Returns the
/// duration of the trial up to then, in ns; -1 if the process did not draw.
std::int64_t draw_and_kill(const std::string& folder, std::int64_t duration_ns) {
  Drawn* drawn = new (map_drawn(folder)) Drawn;
  ::setenv(kFolderVariable, folder.c_str(), 1);
  const pid_t process = ::fork();
  if (process == 0) {
    // Otherwise the test that draws belongs to another shard and does not run.
    ::unsetenv("GTEST_TOTAL_SHARDS");
    ::unsetenv("GTEST_SHARD_INDEX");
    ::execl("/proc/self/exe", "trial", "--gtest_also_run_disabled_tests",
            "--gtest_filter=TrialKill.DISABLED_Draws", nullptr);
    ::_exit(127);
  }
  QElapsedTimer since;
  since.start();
  while (drawn->last_ns - drawn->first_ns < duration_ns && since.elapsed() < 30'000) {
    ::usleep(500);
  }
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
  const std::int64_t last_ns = drawn->last_ns - drawn->first_ns;
  ::munmap(drawn, sizeof(Drawn));
  return since.elapsed() < 30'000 ? last_ns : -1;
}

TEST(TrialKill, AKillCostsLittleOfTheTrial) {
  const QTemporaryDir temporary;
  const std::string folder = temporary.path().toStdString();
  std::ofstream(folder + "/study.toml")
      << "id = \"kill\"\n[[condition]]\nname = \"free\"\n[[shape]]\nname = \"line\"\nkind = "
         "\"line\"\n";
  std::int64_t least_ns = kLargestLossNs;
  for (int attempt = 1; attempt <= kKills; ++attempt) {
    const std::int64_t duration_ns = draw_and_kill(folder, 300'000'000 + 137'000'000 * attempt);
    ASSERT_GT(duration_ns, 0);
    const Result<TrialSetup> setup = prepare(folder);
    ASSERT_TRUE(setup) << setup.error().message;
    const auto& results = setup->session.results;
    ASSERT_EQ(results.size(), std::size_t(attempt));
    EXPECT_EQ(results.back().attempt, attempt);
    EXPECT_EQ(results.back().invalid, "interrupted");
    const auto recording = setup->folder.recording(setup->session.info, results.back());
    ASSERT_TRUE(recording) << recording.error().message;
    ASSERT_FALSE(recording->samples.empty());
    const std::int64_t kept_ns =
        recording->samples.back().time_ns - recording->samples.front().time_ns;
    EXPECT_LE(duration_ns - kept_ns, kLargestLossNs);
    least_ns = std::min(least_ns, duration_ns - kept_ns);
    RecordProperty("lost_ms_" + std::to_string(attempt), int((duration_ns - kept_ns) / 1'000'000));
    std::printf("attempt %d: lost %.1f of %.1f ms\n", attempt,
                1e-6 * static_cast<double>(duration_ns - kept_ns),
                1e-6 * static_cast<double>(duration_ns));
  }
  EXPECT_LE(least_ns, kUsualLossNs);
}

}  // namespace
}  // namespace felt::desktop::trial_kill_test
