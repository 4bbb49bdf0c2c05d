#include "felt/studies/export/export_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "felt/document/drawing.h"
#include "felt/studies/export/testing/made_study.h"
#include "felt/trial/study_shapes.h"

namespace felt::export_study_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder that is removed at the end.
class ExportStudy : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    fs::create_directories(root_);
    std::ofstream(root_ / "made.toml") << testing::MadeStudy::kStudyText;
  }
  void TearDown() override { fs::remove_all(root_); }

  [[nodiscard]] StudyFolder folder_with(int people, int trials) const {
    Result<StudyFiles> files = read_study_files((root_ / "made.toml").string());
    EXPECT_TRUE(files) << files.error().message;
    Result<StudyFolder> folder = StudyFolder::create((root_ / "results").string(), *files);
    EXPECT_TRUE(folder) << folder.error().message;
    for (int person = 1; person <= people; ++person) {
      auto session = folder->begin_session({person, SessionKind::kTrain, "A device", "a program"});
      EXPECT_TRUE(session) << session.error().message;
      for (int trial = 1; trial <= trials; ++trial) {
        const auto& plan = session->plan[static_cast<std::size_t>(trial - 1)];
        const auto added = folder->add_trial(*session, TrialResult{trial, 1, "", ""},
                                             drawing_of(files->paths[plan.shape]));
        EXPECT_TRUE(added) << added.error().message;
      }
    }
    return *folder;
  }

  /// A pen that draws a path exactly, 1 mm each 10 ms.
  static Drawing drawing_of(const StudyPath& path) {
    FeltRecording recording;
    recording.device = "A device";
    recording.period_ns = 10'000'000;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      RecordedSample sample;
      sample.time_ns = 5'000'000 + static_cast<std::int64_t>(i) * recording.period_ns;
      sample.pen.position = {path.points[i].x, path.points[i].y, -0.25};
      if (i % 2 == 0) sample.pen.pressure = 0.5;
      if (i > 0) sample.forces = RecordedForces{{}, {0.5, 0.0, -0.125}};
      recording.samples.push_back(sample);
    }
    Drawing drawing;
    EXPECT_TRUE(add_recording(drawing, recording));
    return drawing;
  }

  static std::string text_of(const fs::path& file) {
    std::stringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  static std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files[entry.path().lexically_relative(folder).generic_string()] = text_of(entry.path());
      }
    }
    return files;
  }

  fs::path root_ = fs::temp_directory_path() / ("felt_export_" + std::to_string(getpid()));
};

TEST_F(ExportStudy, WritesEverythingAndTheSameTwice) {
  const StudyFolder folder = folder_with(2, 4);
  for (const char* name : {"a", "b"}) {
    const auto done = export_study(folder, (root_ / name).string());
    ASSERT_TRUE(done) << done.error().message;
  }
  const auto files = files_in(root_ / "a");
  EXPECT_EQ(files, files_in(root_ / "b"));
  for (const char* name : {"trials.csv", "trials.json", "answers.csv", "answers.json", "analysis.R",
                           "analysis.py", "report.html", "report.pdf", "study/study.toml",
                           "bids/dataset_description.json", "bids/participants.tsv"}) {
    EXPECT_TRUE(files.contains(name)) << name;
    EXPECT_NE(files.at(name), "") << name;
  }
  const auto copies = std::count_if(files.begin(), files.end(), [](const auto& file) {
    return file.first.starts_with("recordings/") && file.first.ends_with(".felt");
  });
  EXPECT_EQ(copies, 8);
  // The pen draws the path, so there is no error.
  EXPECT_THAT(files.at("trials.csv"), HasSubstr("recordings/"));
  EXPECT_EQ(fs::exists(root_ / "results" / "trials.csv"), false);
  for (const auto& entry : fs::directory_iterator(root_)) {
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST_F(ExportStudy, BidsRunsHaveTheSamplesAndTheirChannels) {
  ASSERT_TRUE(export_study(folder_with(1, 4), (root_ / "out").string()));
  const auto files = files_in(root_ / "out" / "bids");
  std::size_t runs = 0;
  for (const auto& [name, text] : files) {
    if (!name.ends_with("_motion.tsv")) continue;
    ++runs;
    const std::string stem = name.substr(0, name.size() - std::string("motion.tsv").size());
    EXPECT_TRUE(stem.starts_with("sub-0001/ses-train/motion/sub-0001_ses-train_task-t")) << stem;
    const std::string channels = files.at(stem + "channels.tsv");
    const auto channel_count = std::count(channels.begin(), channels.end(), '\n') - 1;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_EQ(std::count(line.begin(), line.end(), '\t') + 1, channel_count);
    }
    EXPECT_THAT(files.at(stem + "motion.json"),
                HasSubstr("\"MotionChannelCount\":" + std::to_string(channel_count)));
    EXPECT_THAT(files.at(stem + "motion.json"), HasSubstr("\"SamplingFrequency\":100,"));
    EXPECT_TRUE(text.starts_with("0.000000\t")) << text.substr(0, 80);
    EXPECT_THAT(text.substr(0, 80), HasSubstr("-0.2500\t1\t0.5000\tn/a\tn/a\tn/a\n0.010000\t"));
    EXPECT_THAT(text, HasSubstr("\t1\tn/a\t0.5000\t0.0000\t-0.1250\n"));
    EXPECT_THAT(files.at(stem + "events.tsv"),
                HasSubstr("onset\tduration\tblock\ttrial\tattempt\ttrial_type"));
  }
  EXPECT_EQ(runs, 4U);
}

TEST_F(ExportStudy, AnEmptyStudyGivesEmptyTables) {
  ASSERT_TRUE(export_study(folder_with(0, 0), (root_ / "out").string()));
  const auto files = files_in(root_ / "out");
  EXPECT_EQ(std::count(files.at("trials.csv").begin(), files.at("trials.csv").end(), '\n'), 1);
  EXPECT_THAT(files.at("report.html"), HasSubstr("There are no trials yet"));
}

TEST_F(ExportStudy, RefusesAFolderWithFilesAndLeavesItAlone) {
  const StudyFolder folder = folder_with(1, 1);
  fs::create_directories(root_ / "out");
  std::ofstream(root_ / "out" / "mine") << "kept";
  const auto refused = export_study(folder, (root_ / "out").string());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("out: exists already"));
  EXPECT_EQ(files_in(root_ / "out").size(), 1U);
  fs::remove(root_ / "out" / "mine");
  EXPECT_TRUE(export_study(folder, (root_ / "out").string())) << "an empty folder is replaced";
}

TEST_F(ExportStudy, LeavesNothingAfterAFailureOrAnInterruption) {
  const StudyFolder folder = folder_with(1, 3);
  const auto interrupted =
      export_study(folder, (root_ / "out").string(), [](double share) { return share < 0.5; });
  EXPECT_FALSE(interrupted);
  fs::path damaged;
  for (const auto& entry : fs::recursive_directory_iterator(root_ / "results")) {
    if (entry.path().extension() == ".felt") damaged = entry.path();
  }
  std::ofstream(damaged) << "not a drawing";
  const auto failed = export_study(folder, (root_ / "out").string());
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr(damaged.filename().string()));
  std::size_t entries = 0;
  for (const auto& entry : fs::directory_iterator(root_)) {
    ++entries;
    EXPECT_NE(entry.path().filename(), "out");
  }
  EXPECT_EQ(entries, 2U);  // the study and its results
}

TEST_F(ExportStudy, TheNextExportRemovesWhatKilledOnesHaveLeft) {
  const StudyFolder folder = folder_with(1, 1);
  for (int kill = 0; kill < 3; ++kill) {
    EXPECT_EXIT(static_cast<void>(export_study(folder, (root_ / "out").string(),
                                               [](double) {
                                                 ::kill(::getpid(), SIGKILL);
                                                 return true;
                                               })),
                ::testing::KilledBySignal(SIGKILL), "");
  }
  // Of another name, or not of an export: they stay.
  const std::set<std::string> others = {".out.1x.export", ".out.export", ".other.99999999.export"};
  for (const std::string& other : others) fs::create_directory(root_ / other);
  ASSERT_TRUE(export_study(folder, (root_ / "out").string()));
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(root_)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.')) left.insert(name);
  }
  EXPECT_EQ(left, others);
}

TEST_F(ExportStudy, NamesTheReasonWhenAFileCannotBeWritten) {
  ::rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const StudyFolder folder = folder_with(1, 1);
  const ::rlimit small{100, old.rlim_max};
  const auto says_why = [&] {
    ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto done = export_study(folder, (root_ / "out").string());
    return !done && done.error().message.ends_with("File too large");
  };
  EXPECT_EXIT(::_exit(says_why() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace felt::export_study_test
