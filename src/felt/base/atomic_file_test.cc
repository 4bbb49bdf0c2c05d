#include "felt/base/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "felt/base/file_steps.h"
#include "felt/base/read_file.h"

namespace felt::atomic_file_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class AtomicFileTest : public ::testing::Test {
 protected:
  AtomicFileTest() {
    std::string name = (fs::temp_directory_path() / "felt-atomic-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~AtomicFileTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, AppearsWholeAtCommit) {
  auto file = AtomicFile::create(path("a")).value();
  ASSERT_TRUE(file.write("header "));
  ASSERT_TRUE(file.write(std::string(200'000, 'x')));
  EXPECT_FALSE(fs::exists(path("a")));
  ASSERT_TRUE(file.overwrite(0, "HEADER"));
  ASSERT_TRUE(file.write(" end"));
  ASSERT_TRUE(file.commit());
  EXPECT_EQ(read(path("a")), "HEADER " + std::string(200'000, 'x') + " end");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, WithoutCommitNothingChanges) {
  ASSERT_TRUE(write_file(path("a"), "old"));
  {
    auto file = AtomicFile::create(path("a")).value();
    ASSERT_TRUE(file.write("new"));
    AtomicFile moved = std::move(file);
    ASSERT_TRUE(moved.write("er"));
  }
  EXPECT_EQ(read(path("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, NothingShowsBeforeCommitThatAKillWouldLeave) {
  const int unnamed = ::open(folder_.c_str(), O_TMPFILE | O_RDWR, 0666);
  if (unnamed < 0) GTEST_SKIP() << "this file system has no files without a name";
  ::close(unnamed);
  auto file = AtomicFile::create(path("a")).value();
  ASSERT_TRUE(file.write(std::string(200'000, 'x')));
  EXPECT_EQ(entries(), 0u);
}

TEST_F(AtomicFileTest, KeepsPermissionsAndFollowsLinks) {
  ASSERT_TRUE(write_file(path("a"), "old"));
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  fs::create_symlink("a", path("link"));
  ASSERT_TRUE(write_file(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read(path("a")), "new");
  EXPECT_EQ(static_cast<unsigned>(fs::status(path("a")).permissions()), 0640u);
}

TEST_F(AtomicFileTest, OtherContentDoesNotRunAsSomebodyElse) {
  for (const bool is_saved : {false, true}) {
    ASSERT_TRUE(write_file(path("a"), "old"));
    ASSERT_EQ(::chmod(path("a").c_str(), 06750), 0);
    ASSERT_TRUE(is_saved ? save_file(path("a"), "new") : write_file(path("a"), "new"));
    EXPECT_EQ(read(path("a")), "new");
    EXPECT_EQ(static_cast<unsigned>(fs::status(path("a")).permissions()), 0750u);
  }
}

TEST_F(AtomicFileTest, PipesGetTheBytes) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int end = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(end, 0);
  ASSERT_TRUE(write_file(path("pipe"), "through"));
  char text[16] = {};
  EXPECT_EQ(::read(end, text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  ::close(end);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(AtomicFileTest, StdoutIsADash) {
  ::testing::internal::CaptureStdout();
  ASSERT_TRUE(write_file("-", "to stdout"));
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "to stdout");
}

TEST_F(AtomicFileTest, ErrorsNameTheFileAndTheReason) {
  const auto missing = AtomicFile::create(path("none/a"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(missing.error().message, HasSubstr("none/a"));
  EXPECT_THAT(missing.error().message, HasSubstr("No such file"));
  const auto folder = AtomicFile::create(folder_.string());
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message, HasSubstr("Is a directory"));
  EXPECT_FALSE(AtomicFile::create(""));
}

TEST_F(AtomicFileTest, AFullDiskIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const auto result = write_file("/dev/full", "too much");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("No space left"));
}

TEST_F(AtomicFileTest, ReadsBackWhatWasWritten) {
  const std::string bytes = std::string(700'000, 'x') + '\0' + "end";
  ASSERT_TRUE(write_file(path("a"), bytes));
  EXPECT_EQ(read_file(path("a"), bytes.size()).value(), bytes);
  EXPECT_THAT(read_file(path("a"), bytes.size() - 1).error().message, HasSubstr("larger than"));
  EXPECT_EQ(read_file(path("b"), 10).error().code, ErrorCode::kNotFound);
  EXPECT_THAT(read_file(folder_.string(), 10).error().message, HasSubstr("directory"));
}

TEST_F(AtomicFileTest, ASavedFileIsVerifiedAndLeavesNothingBeside) {
  const std::string old(300'000, 'o'), fresh = std::string(200'000, 'n') + '\0' + "end";
  ASSERT_TRUE(save_file(path("a"), old));
  EXPECT_EQ(read(path("a")), old);
  ASSERT_TRUE(save_file(path("a"), fresh));
  EXPECT_EQ(read(path("a")), fresh);
  EXPECT_EQ(entries(), 1u);
  const auto file = save_file(path("none/a"), fresh);
  EXPECT_EQ(file.error().code, ErrorCode::kNotFound);
}

TEST_F(AtomicFileTest, WhatWasNotToldIsNotSaved) {
  ASSERT_TRUE(save_file(path("a"), "old"));
  auto file = AtomicFile::create(path("a")).value();
  ASSERT_TRUE(file.write("new"));
  EXPECT_THAT(file.commit_verified("other").error().message, HasSubstr("does not keep"));
  EXPECT_EQ(read(path("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, TheStepsTellSameBytesFromOthers) {
  ASSERT_TRUE(write_file(path("a"), std::string(65'536, 'x')));
  EXPECT_TRUE(file_steps::holds(path("a"), std::string(65'536, 'x')));
  EXPECT_FALSE(file_steps::holds(path("a"), std::string(65'535, 'x')));
  EXPECT_EQ(errno, 0);
  EXPECT_FALSE(file_steps::holds(path("a"), std::string(65'537, 'x')));
  EXPECT_FALSE(file_steps::holds(path("a"), std::string(65'535, 'x') + 'y'));
  EXPECT_FALSE(file_steps::holds(path("b"), ""));
  EXPECT_EQ(errno, ENOENT);
  const std::string kept = file_steps::keep_beside(path("a"));
  ASSERT_TRUE(write_file(path("a"), "other"));
  EXPECT_TRUE(file_steps::holds(kept, std::string(65'536, 'x')));
}

TEST_F(AtomicFileTest, KeepsExtendedAttributes) {
  ASSERT_TRUE(save_file(path("a"), "old"));
  if (::setxattr(path("a").c_str(), "user.felt.note", "mine", 4, 0) != 0) {
    GTEST_SKIP() << "this file system has no extended attributes";
  }
  ASSERT_TRUE(save_file(path("a"), "new"));
  std::array<char, 8> value{};
  EXPECT_EQ(::getxattr(path("a").c_str(), "user.felt.note", value.data(), value.size()), 4);
  EXPECT_STREQ(value.data(), "mine");
}

TEST_F(AtomicFileTest, ALinkToNothingYetIsFollowedToo) {
  fs::create_directory(folder_ / "far");
  fs::create_symlink("far/b", path("a"));
  ASSERT_TRUE(save_file(path("a"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("a")));
  EXPECT_EQ(read(path("far/b")), "new");
}

TEST_F(AtomicFileTest, LitterOfTheDeadIsRemovedAndNobodyElses) {
  const std::string long_name(250, 'n');
  for (const std::string& name : {std::string("a"), long_name}) {
    const std::string hidden = "." + name.substr(0, 200) + ".";
    for (const char* mark : {"123-0.tmp", "99999-12.old"}) {
      std::ofstream(path(hidden + mark)) << "litter";
    }
    std::ofstream(path(hidden + "mine.tmp")) << "a person's";
    std::ofstream(path(hidden + "7-7.tmp")) << "at work";
    const int at_work = ::open(path(hidden + "7-7.tmp").c_str(), O_RDONLY);
    ASSERT_EQ(::flock(at_work, LOCK_EX), 0);
    ASSERT_TRUE(save_file(path(name), "new"));
    EXPECT_FALSE(fs::exists(path(hidden + "123-0.tmp")));
    EXPECT_FALSE(fs::exists(path(hidden + "99999-12.old")));
    EXPECT_TRUE(fs::exists(path(hidden + "mine.tmp")));
    EXPECT_TRUE(fs::exists(path(hidden + "7-7.tmp")));
    ::close(at_work);
  }
}

/// As root, the child becomes an unprivileged user, because permissions do not apply to root.
TEST_F(AtomicFileTest, WhatMayNotBeWrittenIsSaidAndLeftAlone) {
  ASSERT_TRUE(save_file(path("a"), "old"));
  fs::create_directory(folder_ / "closed");
  ASSERT_TRUE(save_file(path("closed/b"), "old"));
  fs::permissions(path("a"), fs::perms(0444));
  fs::permissions(folder_, fs::perms(0777));
  fs::permissions(path("closed"), fs::perms(0555));
  const pid_t child = ::fork();
  if (child == 0) {
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(3);
    const auto file = save_file(path("a"), "new");
    if (file || file.error().message.find("no permission to write") == std::string::npos)
      ::_exit(1);
    const auto folder = save_file(path("closed/b"), "new");
    if (folder || folder.error().message.find("to its folder") == std::string::npos) ::_exit(2);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(read(path("a")), "old");
  EXPECT_EQ(read(path("closed/b")), "old");
  fs::permissions(path("closed"), fs::perms(0755));
}

}  // namespace
}  // namespace felt::atomic_file_test
