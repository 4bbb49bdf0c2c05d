#include "felt/store/felt_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sys/mman.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/document/testing/random_document.h"
#include "felt/store/felt_tables.h"

namespace felt::felt_file_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Drawing random_drawing(std::uint64_t seed) {
  Drawing drawing;
  felt::testing::RandomEdits edits(seed);
  std::mt19937_64 random(seed);
  for (std::uint64_t i = random() % 12; i > 0; --i) {
    EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  }
  drawing.page = {10.0 + static_cast<double>(random() % 499'000) / 100.0,
                  5000.0,
                  {1, static_cast<std::uint8_t>(random()), 3, static_cast<std::uint8_t>(random())}};
  drawing.page.surface = random() % 2 == 0 ? "" : "Bütten";
  for (std::uint64_t i = random() % 3; i > 0; --i) {
    drawing.materials.push_back("id = \"m" + std::to_string(i) + "\"\n");
  }
  drawing.color = {static_cast<std::uint8_t>(random()), 0, 255, 128};
  const auto layers = drawing.document.layers();
  if (random() % 3 > 0) drawing.layer = layers[random() % layers.size()].id;
  for (std::uint64_t i = random() % 4; i > 0; --i) {
    drawing.palette.colors.push_back(
        {{static_cast<std::uint8_t>(random()), 2, 3, 200}, i % 2 == 0 ? "" : "Grün"});
    drawing.palette.name = "mine";
    drawing.palette.columns = random() % 64;
  }
  if (random() % 2 == 0) {
    drawing.view = Viewport{{148.5, -1.0 / static_cast<double>(1 + random() % 9)},
                            3.0,
                            static_cast<double>(random() % 360) - 180.0,
                            random() % 2 == 0};
  }
  return drawing;
}

class FeltFileTest : public ::testing::Test {
 protected:
  FeltFileTest() {
    std::string name = (fs::temp_directory_path() / "felt-file-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FeltFileTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(FeltFileTest, EveryDrawingReadsBackAsItWas) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Drawing drawing = random_drawing(seed);
    const std::string bytes = felt_bytes(drawing).value();
    const Result<Drawing> back = parse_felt(bytes);
    ASSERT_TRUE(back) << "seed " << seed << ": " << back.error().message;
    EXPECT_TRUE(*back == drawing) << "seed " << seed;
    // The next ids are the same, too, so that an id is never reused.
    EXPECT_EQ(back->document.new_id(), drawing.document.new_id()) << "seed " << seed;
    EXPECT_EQ(back->document.new_layer_id(), drawing.document.new_layer_id()) << "seed " << seed;
    EXPECT_EQ(felt_bytes(*back).value(), bytes) << "seed " << seed;
  }
}

TEST_F(FeltFileTest, AFileIsOnePlainFileWithOurNumbers) {
  ASSERT_TRUE(write_felt(path("a.felt"), random_drawing(3)));
  ASSERT_TRUE(read_felt(path("a.felt")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  const std::string bytes = read_file(path("a.felt"), kMaxFeltBytes).value();
  EXPECT_EQ(bytes.substr(0, 16), (std::string("SQLite format 3\0", 16)));
  EXPECT_EQ(bytes.substr(68, 4), "Felt");
  EXPECT_EQ(bytes.substr(60, 4), (std::string("\0\0\0\1", 4)));
  EXPECT_EQ(bytes.substr(18, 2), "\1\1");  // no WAL
}

TEST_F(FeltFileTest, ErrorsNameTheFileAndTheReason) {
  const auto message = [this](std::string_view bytes) {
    EXPECT_TRUE(write_file(path("x.felt"), bytes));
    return read_felt(path("x.felt")).error().message;
  };
  EXPECT_THAT(read_felt(path("none")).error().message, StartsWith(path("none") + ": "));
  EXPECT_THAT(message(""), StartsWith(path("x.felt") + ": is empty"));
  EXPECT_THAT(message("<svg/>"), HasSubstr("is not a Feltline drawing"));
  std::string bytes = felt_bytes(random_drawing(5)).value();
  EXPECT_THAT(message(bytes.substr(0, 50)), HasSubstr("incomplete"));
  bytes[63] = 2;
  EXPECT_THAT(message(bytes), HasSubstr("newer Feltline (format 2; this version reads 1)"));
  bytes[63] = 1;
  bytes[70] = 'x';
  EXPECT_THAT(message(bytes), HasSubstr("another program"));
  bytes[70] = 'l';
  bytes[18] = bytes[19] = 2;
  EXPECT_THAT(message(bytes), HasSubstr("did not close it"));
}

/// This is the purpose of the checksums: damage is an error, unless it is in unused bytes.
TEST_F(FeltFileTest, NoDamagePassesForADrawing) {
  const Drawing drawing = random_drawing(11);
  const std::string bytes = felt_bytes(drawing).value();
  std::mt19937 random(4);
  for (int run = 0; run < 3000; ++run) {
    std::string changed = bytes;
    for (auto k = 1 + random() % 3; k > 0; --k) {
      changed[random() % changed.size()] ^= static_cast<char>(1 + random() % 255);
    }
    const Result<Drawing> read = parse_felt(changed);
    EXPECT_TRUE(read ? *read == drawing : !read.error().message.empty()) << "run " << run;
  }
  for (std::size_t size = 0; size < bytes.size(); size += 1 + random() % 97) {
    EXPECT_FALSE(parse_felt(std::string_view(bytes).substr(0, size))) << size;
  }
  for (int run = 0; run < 200; ++run) {  // a page of zeros, or of other bytes
    std::string changed = bytes;
    const std::size_t page = random() % (bytes.size() / 4096) * 4096;
    changed.replace(page, 4096,
                    run % 2 == 0 ? std::string(4096, '\0')
                                 : bytes.substr(random() % (bytes.size() - 4096), 4096));
    const Result<Drawing> read = parse_felt(changed);
    EXPECT_TRUE(!read || *read == drawing) << "run " << run;
  }
}

TEST_F(FeltFileTest, ZerosAfterADrawingAreNotLookedAt) {
  const Drawing drawing = random_drawing(11);
  std::string bytes = felt_bytes(drawing).value();
  bytes.resize(4 * bytes.size());
  const Result<Drawing> read = parse_felt(bytes);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("bytes long, but contains a drawing of"));
}

TEST_F(FeltFileTest, WhatNoFileMayHoldIsNotWritten) {
  ASSERT_TRUE(write_felt(path("a.felt"), random_drawing(1)));
  Drawing drawing = random_drawing(2);
  drawing.page.width_mm = 0.0;
  EXPECT_THAT(write_felt(path("a.felt"), drawing).error().message,
              StartsWith(path("a.felt") + ": the sides of the page"));
  drawing = random_drawing(2);
  drawing.view = Viewport{{0.0, std::nan("")}};
  EXPECT_FALSE(felt_bytes(drawing));
  drawing.view->center.y = Viewport::kMaxMm;
  EXPECT_TRUE(felt_bytes(drawing));
  drawing.palette.name = std::string(PaletteLimits::kMaxNameBytes + 1, 'n');
  EXPECT_FALSE(felt_bytes(drawing));
  EXPECT_TRUE(read_felt(path("a.felt")).value() == random_drawing(1));
}

/// A drawing at a limit is written and read. A drawing above the limit is an error.
TEST_F(FeltFileTest, LimitsAreKeptExactly) {
  Drawing drawing;
  drawing.palette.colors.assign(PaletteLimits::kMaxColors, {{1, 2, 3, 255}, "c"});
  EXPECT_TRUE(parse_felt(felt_bytes(drawing).value()).value() == drawing);
  drawing.palette.colors.push_back({});
  EXPECT_EQ(felt_bytes(drawing).error().code, ErrorCode::kLimitExceeded);
  drawing.palette.colors.clear();
  Edit edit;
  for (std::uint64_t i = 1; i < kMaxLayers; ++i) {
    edit.layers.push_back({{i + 1}, std::nullopt, LayerState{"l", true, false}, 0, i});
  }
  edit.layers.front().after->name = std::string(kMaxLayerNameBytes, 'n');
  ASSERT_TRUE(drawing.document.apply(edit));
  EXPECT_TRUE(parse_felt(felt_bytes(drawing).value()).value() == drawing);
  const Edit more{
      "", {}, {{{kMaxLayers + 1}, std::nullopt, LayerState{"m", true, false}, 0, kMaxLayers}}};
  ASSERT_TRUE(drawing.document.apply(more));
  EXPECT_EQ(felt_bytes(drawing).error().code, ErrorCode::kLimitExceeded);
  Drawing named;
  named.page.surface = std::string(kMaxLayerNameBytes + 1, 'n');
  EXPECT_FALSE(felt_bytes(named));
}

/// The pages are reserved but never accessed, because a test does not have so much memory.
TEST_F(FeltFileTest, AFileThatIsTooLargeIsNotLookedAt) {
  const std::size_t size = kMaxFeltBytes + 1;
  void* pages =
      ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (pages == MAP_FAILED) GTEST_SKIP() << "this system does not promise 2 GiB of addresses";
  const std::string_view bytes(static_cast<const char*>(pages), size);
  EXPECT_EQ(parse_felt(bytes).error().code, ErrorCode::kLimitExceeded);
  EXPECT_THAT(parse_felt(bytes.substr(1)).error().message, HasSubstr("is not a Feltline drawing"));
  ::munmap(pages, size);
}

/// Kills a saving process at random moments: the old drawing or the new one remains, and no other
/// file.
TEST_F(FeltFileTest, AKilledSaveLeavesTheOldFileOrTheNew) {
  const Drawing a = random_drawing(21), b = random_drawing(22);
  ASSERT_TRUE(write_felt(path("a.felt"), a));
  std::mt19937 random(5);
  for (int run = 0; run < 40; ++run) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) {
        if (!write_felt(path("a.felt"), b) || !write_felt(path("a.felt"), a)) ::_exit(1);
      }
    }
    ::usleep(static_cast<useconds_t>(500 + random() % 8000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child could not save";
    const Result<Drawing> read = read_felt(path("a.felt"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(*read == a || *read == b) << "run " << run;
  }
}

TEST_F(FeltFileTest, WhatCouldNotBeReadAgainIsNotWritten) {
  Drawing drawing;
  drawing.document.reserve_ids({(std::uint64_t{1} << 53) + 1}, {1});
  const auto bytes = felt_bytes(drawing);
  ASSERT_FALSE(bytes);
  EXPECT_THAT(bytes.error().message, ::testing::HasSubstr("no free numbers"));
}

}  // namespace
}  // namespace felt::felt_file_test
