#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "felt/base/testing/test_folder.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/testing/random_drawing.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_salvage.h"

namespace felt::huge_files_test {
namespace {

using felt::testing::random_drawing;
using felt::testing::TestFolder;
using ::testing::HasSubstr;

/// Returns the number of bytes that this process has read so far, if the system counts them.
std::optional<std::uint64_t> read_bytes() {
  std::ifstream file("/proc/self/io");
  std::string key;
  std::uint64_t value = 0;
  while (file >> key >> value) {
    if (key == "rchar:") return value;
  }
  return std::nullopt;
}

/// Makes files that are huge but hold no blocks.
class HugeFiles : public ::testing::Test {
 protected:
  /// Returns the path of a file that begins with `head` and continues with zeros.
  [[nodiscard]] std::string huge(const std::string& name, std::string_view head,
                                 std::uint64_t size = 2000U << 20) const {
    const std::string path = folder_.put(name, head);
    std::filesystem::resize_file(path, size);
    return path;
  }

 private:
  TestFolder folder_;
};

/// Calls `read`, which must fail and read less than a mebibyte (if the system counts bytes).
/// Returns its message.
template <class Read>
std::string refused(const Read& read) {
  const std::optional<std::uint64_t> before = read_bytes();
  const auto result = read();
  if (before) {
    EXPECT_LT(*read_bytes() - *before, std::uint64_t{1} << 20);
  }
  EXPECT_FALSE(result);
  return result ? "" : result.error().message;
}

TEST_F(HugeFiles, AFileOfZerosIsRefusedByItsFirstBytes) {
  const std::string path = huge("zeros.felt", "");
  EXPECT_EQ(refused([&] { return read_felt(path); }), path + ": is not a Feltline drawing");
  EXPECT_EQ(refused([&] { return read_drawing(path); }), path + ": is not a Feltline drawing");
  for (const char* name : {"a.svg", "a.ndjson", "a.xopp", "a.inkml", "a.txt", "a"}) {
    const std::string other = huge(name, "");
    refused([&] { return read_drawing(other); });
  }
}

TEST_F(HugeFiles, AHeaderAloneIsNoDrawing) {
  const std::string bytes = felt_bytes(random_drawing(3)).value();
  const std::string path = huge("header.felt", bytes.substr(0, 100));
  EXPECT_THAT(refused([&] { return read_felt(path); }), HasSubstr("is damaged or incomplete"));
  EXPECT_THAT(refused([&] { return read_drawing(path); }), HasSubstr("is damaged or incomplete"));
  const std::string longer = huge("longer.felt", bytes);
  EXPECT_THAT(refused([&] { return read_felt(longer); }), HasSubstr("is 2097152000 bytes long"));
}

TEST_F(HugeFiles, TheNameOfAnotherFormatDoesNotHelp) {
  const std::string bytes = felt_bytes(random_drawing(4)).value();
  const std::string path = huge("drawing.svg", bytes);
  EXPECT_THAT(refused([&] { return read_drawing(path); }), HasSubstr("is 2097152000 bytes long"));
  const std::string picture = huge("picture.felt", "\x89PNG\r\n\x1a\n");
  EXPECT_THAT(refused([&] { return read_drawing(picture); }), HasSubstr("write but not read"));
}

TEST_F(HugeFiles, SalvageHasALimit) {
  const std::string zeros = huge("zeros.felt", "", kMaxSalvageBytes + 1);
  const auto salvage = [&] { return read_drawing(zeros, {.salvage = true}); };
  EXPECT_THAT(refused(salvage), HasSubstr("is larger than 536870912 bytes"));
  EXPECT_THAT(refused([&] { return salvage_felt(zeros); }), HasSubstr("is larger than 536870912"));
}

TEST_F(HugeFiles, AnUnrecognisedFileHasALowLimit) {
  const std::string text = huge("text.ndjson", "words", kMaxUnrecognisedBytes + 1);
  EXPECT_THAT(refused([&] { return read_drawing(text); }), HasSubstr("is larger than 67108864"));
}

TEST_F(HugeFiles, ADamagedFirstPageIsStillSalvaged) {
  const Drawing drawing = random_drawing(5);
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, 200, 200, '\0');
  const std::string path = huge("damaged.felt", bytes, bytes.size());
  const Result<Salvaged> salvaged = salvage_felt(path);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_EQ(salvaged->drawing.document.stroke_count(), drawing.document.stroke_count());
}

}  // namespace
}  // namespace felt::huge_files_test
