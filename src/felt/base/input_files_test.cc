#include "felt/base/input_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <functional>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "tests/support/scratch_path.h"

namespace felt::input_files_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 1000;

/// A folder with the file "in". Each check runs in a process of its own, because the list of inputs
/// belongs to the process.
class InputFiles : public ::testing::Test {
 protected:
  InputFiles() {
    fs::create_directory(folder_);
    EXPECT_TRUE(write_file(path("in"), "input"));
  }
  ~InputFiles() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  /// Returns true if `output` may be created and committed after "in" was read under `input`.
  [[nodiscard]] static bool may_write(const std::string& output) {
    Result<AtomicFile> file = AtomicFile::create(output);
    return file && file->write("output") && file->commit();
  }
  void expect(const std::function<bool()>& check, const char* what) const {
    EXPECT_EXIT(::_exit(check() ? 0 : 1), ::testing::ExitedWithCode(0), "") << what;
  }

  fs::path folder_ = scratch_path("inputs");
};

TEST_F(InputFiles, NoOutputReplacesAFileThatWasReadUnderAnyName) {
  fs::create_symlink(path("in"), path("link"));
  fs::create_symlink("link", path("link to link"));
  fs::create_hard_link(path("in"), path("hard"));
  fs::create_directory(path("folder"));
  for (const char* input : {"in", "link", "hard", "folder/../in"}) {
    for (const char* output : {"in", "link", "link to link", "hard", "folder/../in", "./in"}) {
      expect(
          [&] {
            protect_input_files();
            return read_file(path(input), kMaxBytes) && !may_write(path(output)) &&
                   may_write(path("other"));
          },
          output);
      EXPECT_EQ(read_file(path("in"), kMaxBytes).value(), "input") << input << ' ' << output;
      fs::remove(path("other"));
    }
  }
}

TEST_F(InputFiles, AFileThatIsReadAfterTheOutputWasCreatedStays) {
  expect(
      [this] {
        protect_input_files();
        Result<AtomicFile> file = AtomicFile::create(path("in"));
        return file && read_regular_file(path("in"), kMaxBytes) && file->write("output") &&
               !file->commit();
      },
      "commit");
  expect(
      [this] {
        protect_input_files();
        Result<AtomicFile> file = AtomicFile::create(path("in"));
        return file && read_regular_file(path("in"), kMaxBytes) && file->write("output") &&
               !file->commit_verified("output");
      },
      "commit_verified");
  EXPECT_EQ(read_file(path("in"), kMaxBytes).value(), "input");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(InputFiles, FilesThatTheProgramKeepsMayBeSavedAgain) {
  expect(
      [this] {
        protect_input_files();
        return read_file(path("in"), kMaxBytes) && !write_file(path("in"), "written") &&
               save_file(path("in"), "saved");
      },
      "save_file");
  EXPECT_EQ(read_file(path("in"), kMaxBytes).value(), "saved");
}

TEST_F(InputFiles, NothingIsProtectedUnlessAsked) {
  expect([this] { return read_file(path("in"), kMaxBytes) && may_write(path("in")); }, "off");
  EXPECT_EQ(read_file(path("in"), kMaxBytes).value(), "output");
}

}  // namespace
}  // namespace felt::input_files_test
