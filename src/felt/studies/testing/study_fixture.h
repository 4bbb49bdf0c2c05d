#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "felt/studies/study_folder.h"

/// An empty folder, removed at the end, with a small study.
namespace felt::testing {

/// Two conditions and two shapes, with questions after each condition.
inline constexpr const char* kSmallStudy = R"(id = "small"
catch = { min_length_share = 0.5, action = "repeat", max_repeats = 2 }
questions = { forms = ["nasa-tlx", "ueq-s"] }

[[condition]]
name = "free"
forces = false
settings = { "pencil.snap" = "off" }

[[condition]]
name = "drag"
needs = "force"
settings = { "pencil.snap" = "off", "pencil.stabiliser" = "towed" }

[[shape]]
name = "circle"
kind = "circle"
size_mm = 20

[[shape]]
name = "line"
kind = "line"
size_mm = 30
)";

class StudyFixture : public ::testing::Test {
 protected:
  StudyFixture() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string(test->test_suite_name()) + "." + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~StudyFixture() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  /// Returns the small study, read from a file.
  [[nodiscard]] StudyFiles small_study() const {
    write("small.toml", kSmallStudy);
    return read_study_files(path("small.toml")).value();
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace felt::testing
