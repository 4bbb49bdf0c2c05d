// Reads damaged and malicious files. The reader must not crash, hang or use too much memory. It
// must either fail with a reason or return a valid drawing. From a .felt file, every stroke with
// intact database pages must be recoverable.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/recovery.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/testing/random_drawing.h"
#include "felt/store/felt_salvage.h"
#include "felt/store/stroke_blob.h"
#include "tests/reliability/damage/damages.h"

namespace felt::damage::damage_test {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxSeconds = 5.0;  // CPU time for one small file; sanitizers need this much
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

std::string folder_for_test() {
  std::string name = ::testing::TempDir() + "felt-damage-XXXXXX";
  return ::mkdtemp(name.data());
}

struct Counts {
  int all = 0, refused = 0, read = 0, same = 0;
  double slowest_s = 0.0;
};

/// Reads the damaged bytes as a user's file called `name`, and checks the result.
void read_damaged(const Damage& damage, const std::string& name, const Drawing& original,
                  Counts& counts) {
  const double start = cpu_seconds();
  const Result<Imported> opened = parse_drawing(damage.bytes, name);
  const double took = cpu_seconds() - start;
  counts.slowest_s = std::max(counts.slowest_s, took);
  ASSERT_LT(took, kMaxSeconds) << name << ": " << damage.name;
  ++counts.all;
  if (!opened) {
    ++counts.refused;
    ASSERT_GT(opened.error().message.size(), 5u) << name << ": " << damage.name;
    return;
  }
  ++counts.read;
  counts.same += opened->drawing == original;
  // The drawing can be saved and read again, so it violates no invariant.
  Drawing kept = opened->drawing;
  const Result<std::string> again = felt_bytes(kept);
  ASSERT_TRUE(again) << name << ": " << damage.name << ": " << again.error().message;
  const Result<Drawing> back = parse_felt(*again);
  kept.has_page = true;  // because every .felt states a page
  ASSERT_TRUE(back && *back == kept) << name << ": " << damage.name;
}

class Damaged : public ::testing::TestWithParam<FileFormat> {};

TEST_P(Damaged, IsReadOrRefused) {
  const Drawing drawing = felt::testing::random_drawing(3);
  const Result<std::string> whole = drawing_bytes(drawing, GetParam());
  ASSERT_TRUE(whole) << whole.error().message;
  const std::string name = "sample" + std::string(traits_of(GetParam()).endings.front());
  ASSERT_TRUE(parse_drawing(*whole, name));
  Counts counts;
  for_each_damage(*whole, [&](const Damage& damage) {
    if (!HasFatalFailure()) read_damaged(damage, name, drawing, counts);
  });
  EXPECT_LT(peak_bytes(), kMaxBytes);
  if (GetParam() == FileFormat::kFelt) {
    EXPECT_EQ(counts.same, counts.read) << "changed without a word";
  }
  std::printf(
      "%s: %zu bytes, %d damages: %d refused, %d read (%d of them the same drawing); the "
      "slowest took %.3f s, %zu MiB at most\n",
      name.c_str(), whole->size(), counts.all, counts.refused, counts.read, counts.same,
      counts.slowest_s, peak_bytes() >> 20);
}

std::vector<FileFormat> formats_in_both_directions() {
  std::vector<FileFormat> formats;
  for (const FormatTraits& row : format_table()) {
    if (row.reads && row.writes) formats.push_back(row.format);
  }
  return formats;
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, Damaged, ::testing::ValuesIn(formats_in_both_directions()),
                         [](const auto& test) { return std::string(traits_of(test.param).name); });

/// Returns a drawing with strokes on many database pages, each stroke within one page.
Drawing many_strokes() {
  Drawing drawing;
  Edit edit{"Draw", {}};
  const LayerId layer = drawing.document.layers().front().id;
  for (std::uint64_t i = 0; i < 60; ++i) {
    edit.changes.push_back({drawing.document.new_id(i),
                            nullptr,
                            std::make_shared<const Stroke>(felt::testing::random_stroke(i)),
                            {},
                            {layer, i}});
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

TEST(DamagedFelt, GivesBackEveryStrokeOnWholePages) {
  const Drawing drawing = many_strokes();
  const std::string whole = felt_bytes(drawing).value();
  const std::size_t page = static_cast<std::size_t>(static_cast<unsigned char>(whole[16])) << 8 |
                           static_cast<unsigned char>(whole[17]);
  ASSERT_GE(page, 512u);
  // The position of each stroke in the file. Strokes that span several pages are left out.
  std::vector<std::pair<std::size_t, const Stroke*>> places;
  for (const StrokeId id : drawing.document.layers().front().strokes) {
    std::string blob;
    const StrokePtr stroke = drawing.document.find(id);
    ASSERT_TRUE(append_stroke_blob(blob, *stroke));
    const std::size_t at = whole.find(blob);
    if (at != std::string::npos && at / page == (at + blob.size()) / page) {
      places.emplace_back(at / page, stroke.get());
    }
  }
  ASSERT_GT(places.size(), 20u);
  std::size_t wanted = 0, refused = 0;
  for_each_damage(whole, [&](const Damage& damage) {
    std::vector<const Stroke*> intact;
    for (const auto& [number, stroke] : places) {
      const bool before = (number + 1) * page <= damage.first;
      const bool behind = damage.keeps_places && damage.bytes.size() == whole.size() &&
                          number * page >= damage.last;
      if (before || behind) intact.push_back(stroke);
    }
    const Result<Salvaged> salvaged = salvage_felt_bytes(damage.bytes);
    refused += !salvaged;
    if (!salvaged) {
      EXPECT_TRUE(intact.empty()) << damage.name << ": " << salvaged.error().message;
      return;
    }
    std::vector<StrokePtr> found;
    for (const Layer& layer : salvaged->drawing.document.layers()) {
      for (const StrokeId id : layer.strokes) {
        found.push_back(salvaged->drawing.document.find(id));
      }
    }
    for (const Stroke* stroke : intact) {
      const bool is_there = std::any_of(found.begin(), found.end(),
                                        [&](const StrokePtr& one) { return *one == *stroke; });
      EXPECT_TRUE(is_there) << damage.name << ": a stroke on a whole page is missing";
    }
    wanted += intact.size();
  });
  std::printf(
      "%zu bytes, %zu strokes within a page; %zu strokes wanted back, all there; %zu files "
      "held nothing\n",
      whole.size(), places.size(), wanted, refused);
}

TEST(DamagedFelt, SideFilesOfOthersAreIgnoredAndLeftAlone) {
  const std::string folder = folder_for_test(), path = folder + "/a.felt";
  const Drawing first = felt::testing::random_drawing(1);
  const Drawing second = felt::testing::random_drawing(2);
  ASSERT_TRUE(write_felt(path, first));
  const std::string garbage(5000, 'x');
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    ASSERT_TRUE(write_file(path + ending, garbage));
  }
  EXPECT_TRUE(read_felt(path).value() == first);
  ASSERT_TRUE(write_felt(path, second));
  EXPECT_TRUE(read_felt(path).value() == second);
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    EXPECT_EQ(read_file(path + ending, kMaxBytes).value(), garbage) << ending;
  }
  fs::remove_all(folder);
}

/// Creates an autosave as a killed process leaves it. The tests then damage its files.
class DamagedStore : public ::testing::Test {
 protected:
  DamagedStore() : root_(folder_for_test()), drawing_(many_strokes()) {
    Result<AutosaveDatabase> store = AutosaveDatabase::create(root_, "a");
    EXPECT_TRUE(store) << store.error().message;
    EXPECT_TRUE(store->write_base(drawing_));
    AutosaveInfo about{"a drawing", "", true, drawing_};
    about.head.document = Document();
    EXPECT_TRUE(store->put_info(about));
    EXPECT_TRUE(store->commit());
    database_ = store->folder() + '/' + kAutosaveDatabaseFile;
    folder_ = store->folder();
  }
  ~DamagedStore() override { fs::remove_all(root_); }

  std::string root_, folder_, database_;
  Drawing drawing_;
};

TEST_F(DamagedStore, GarbageBesideItIsNoHarm) {
  ASSERT_TRUE(write_file(database_ + "-shm", std::string(40'000, 'x')));
  ASSERT_TRUE(write_file(folder_ + "/new.db", "x"));
  ASSERT_TRUE(write_file(database_ + "-journal", std::string(3'000, 'x')));
  const auto recovered = recover_autosave(folder_);
  ASSERT_TRUE(recovered) << recovered.error().message;
  EXPECT_TRUE(recovered->drawing == drawing_);
  EXPECT_TRUE(recovered->problems.empty());
}

/// An unreadable autosave must not be deleted, because the disk may fail only for a moment.
TEST_F(DamagedStore, WhatCannotBeLookedAtIsNotCleared) {
  fs::rename(database_, database_ + ".away");
  fs::create_symlink(database_, database_);  // links to itself, so it cannot be opened
  EXPECT_TRUE(find_abandoned_autosaves({root_}).empty());
  EXPECT_TRUE(fs::exists(database_ + "-wal"));
  fs::remove(database_);
  fs::rename(database_ + ".away", database_);
  EXPECT_EQ(find_abandoned_autosaves({root_}).size(), 1u);
}

TEST_F(DamagedStore, ADatabaseThatCannotBeRemovedKeepsItsJournal) {
  fs::rename(database_, database_ + ".away");
  fs::create_directory(database_);
  auto found = find_abandoned_autosaves({root_});
  ASSERT_EQ(found.size(), 1u);
  const auto removed = std::move(found.front()).remove();
  ASSERT_FALSE(removed);
  EXPECT_EQ(removed.error().message.find(database_ + ": cannot remove"), 0u);
  EXPECT_TRUE(fs::exists(database_ + "-wal"));
}

TEST(DamagedFelt, ANameThatLeadsNowhereIsNotReplaced) {
  const std::string folder = folder_for_test(), path = folder + "/a.felt";
  fs::create_symlink(path, path);
  const auto saved = write_felt(path, felt::testing::random_drawing(1));
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().message.find(path + ": "), 0u) << saved.error().message;
  EXPECT_TRUE(fs::is_symlink(path));
  fs::remove_all(folder);
}

/// The recovery must never crash, and must never return a part of the drawing without a problem.
TEST_F(DamagedStore, GivesAllOrSaysWhatIsMissing) {
  const std::string wal = read_file(database_ + "-wal", kMaxBytes).value();
  int damages = 0, whole = 0, reported = 0, refused = 0;
  const auto look = [&](const Damage& damage) {
    ++damages;
    const auto recovered = recover_autosave(folder_);
    if (!recovered) {
      ++refused;
      EXPECT_EQ(recovered.error().message.find(folder_), 0u) << recovered.error().message;
      return;
    }
    const bool is_whole = recovered->drawing == drawing_;
    whole += is_whole;
    reported += !recovered->problems.empty();
    EXPECT_TRUE(is_whole || !recovered->problems.empty()) << damage.name << ": lost without a word";
  };
  int number = 0;
  for_each_damage(wal, [&](const Damage& damage) {
    if (number++ % 8 != 0) return;  // because each damage costs a copy on disk and a recovery
    ASSERT_TRUE(write_file(database_ + "-wal", damage.bytes));
    look(damage);
  });
  std::printf("%d damages of the journal: %d whole, %d told of, %d refused\n", damages, whole,
              reported, refused);
}

// --- bombs --------------------------------------------------------------------------------------

/// Returns a gzip stream of `head`, then `part` repeated up to `size` bytes, then `tail`.
std::string gzip_of(const std::string& head, const std::string& part, std::size_t size,
                    const std::string& tail) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 1, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out;
  const auto put = [&](const std::string& text, int flush) {
    std::string buffer(1 << 16, '\0');
    std::string in = text;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      deflate(&stream, flush);
      out.append(buffer, 0, buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  };
  put(head, Z_NO_FLUSH);
  std::string block;
  while (block.size() < (1u << 20)) block += part;
  for (std::size_t done = 0; done < size; done += block.size()) put(block, Z_NO_FLUSH);
  put(tail, Z_FINISH);
  deflateEnd(&stream);
  return out;
}

std::string repeated(const std::string& part, std::size_t count) {
  std::string text;
  text.reserve(part.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}

/// Checks that `bytes` are refused or read in bounded time and memory. The memory limit is 20 times
/// the size of the unpacked file plus 64 MiB (docs/design/limits.md#foreign-files). The unpacked
/// file is at most 100 times as large as the file.
void expect_bounded(const std::string& what, const std::string& bytes, const std::string& name,
                    bool is_refused) {
  const double start = cpu_seconds();
  const Result<Imported> opened = parse_drawing(bytes, name);
  const double took = cpu_seconds() - start;
  EXPECT_LT(took, 20.0) << what;  // sanitizers need this much
  EXPECT_LT(peak_bytes(), std::size_t{3} << 30) << what;
  if (is_refused) {
    EXPECT_FALSE(opened) << what;
  }
  std::printf("%-34s %9zu bytes: %-7s %.3f s, %zu MiB; %s\n", what.c_str(), bytes.size(),
              opened ? "read" : "refused", took, peak_bytes() >> 20,
              opened ? "" : opened.error().message.c_str());
}

TEST(Bombs, GzipOfZeros) {
  expect_bounded("gzip of 300 MiB of zeros",
                 gzip_of("", std::string(4096, '\0'), std::size_t{300} << 20, ""), "a.xopp", true);
}

TEST(Bombs, GzipOfAnEndlessDrawing) {
  const std::string head = "<?xml version=\"1.0\"?><xournal><page width=\"9\" height=\"9\"><layer>";
  const std::string stroke = "<stroke tool=\"pen\" color=\"black\" width=\"1\">1 1 2 2</stroke>";
  expect_bounded("gzip of 300 MiB of strokes",
                 gzip_of(head, stroke, std::size_t{300} << 20, "</layer></page></xournal>"),
                 "a.xopp", true);
}

TEST(Bombs, EntitiesThatMultiply) {
  std::string entities = "<!ENTITY a0 \"aaaaaaaaaa\">";
  for (int i = 1; i < 30; ++i) {
    entities += "<!ENTITY a" + std::to_string(i) + " \"" +
                repeated("&a" + std::to_string(i - 1) + ";", 10) + "\">";
  }
  for (const char* root : {"svg", "ink", "xournal"}) {
    const std::string name = std::string(root) == "ink"   ? "a.inkml"
                             : std::string(root) == "svg" ? "a.svg"
                                                          : "a.xopp";
    const std::string text = "<?xml version=\"1.0\"?><!DOCTYPE " + std::string(root) + " [" +
                             entities + "]><" + root + ">&a29;</" + root + ">";
    // Some programs define SVG namespaces with entities, so the reader must accept entities in SVG.
    expect_bounded("entities in " + name, text, name, name != "a.svg");
  }
  expect_bounded("entities in a path, .svg",
                 "<?xml version=\"1.0\"?><!DOCTYPE svg [" + entities +
                     "]><svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0 &a29;\"/></svg>",
                 "a.svg", false);
}

TEST(Bombs, NestingWithoutEnd) {
  expect_bounded("groups in groups, .svg",
                 "<svg xmlns=\"http://www.w3.org/2000/svg\">" + repeated("<g>", 2'000'000), "a.svg",
                 true);
  expect_bounded("traceGroups, .inkml",
                 "<ink xmlns=\"http://www.w3.org/2003/InkML\">" + repeated("<traceGroup>", 500'000),
                 "a.inkml", true);
  expect_bounded("brackets, .ndjson", "{\"id\":" + repeated("[", 5'000'000), "a.ndjson", false);
}

TEST(Bombs, UsesOfUses) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\"><defs>"
      "<path id=\"u0\" d=\"M0 0L9 9\" stroke=\"red\"/>";
  for (int i = 1; i < 12; ++i) {
    text += "<g id=\"u" + std::to_string(i) + "\">" +
            repeated("<use xlink:href=\"#u" + std::to_string(i - 1) + "\"/>", 10) + "</g>";
  }
  expect_bounded("use of use of use, .svg", text + "</defs><use xlink:href=\"#u11\"/></svg>",
                 "a.svg", false);
}

}  // namespace
}  // namespace felt::damage::damage_test
