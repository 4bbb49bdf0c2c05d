// The saver on disks that stall, fail and are full.
#include <gtest/gtest.h>

#include <thread>

#include "felt/autosave/saver.h"
#include "felt/autosave/testing/saver_test_desk.h"
#include "felt/autosave/working_store.h"
#include "felt/store/testing/faulty_vfs.h"

namespace felt {
namespace {

using testing::DiskCall;
using testing::FaultyVfs;
using testing::SaverDesk;
using testing::TestFolder;

class SaverFault : public ::testing::Test {
 protected:
  SaverFault() { FaultyVfs::the().reset(); }
  ~SaverFault() override { FaultyVfs::the().reset(); }

  [[nodiscard]] SaverOptions options() const {
    SaverOptions options{.roots = {folder_.at("first"), folder_.at("second")}};
    options.vfs = FaultyVfs::kName;
    options.retry = options.retry_first = std::chrono::hours(1);
    return options;
  }
  [[nodiscard]] bool is_first(const std::string& path) const {
    return path.starts_with(folder_.at("first"));
  }

  TestFolder folder_;
};

/// While the disk stands still, whatever is told returns at once (this test would stand still,
/// too), samples keep coming, and afterwards all of it is there: 12 s of a hand at 1 kHz.
TEST_F(SaverFault, AStalledDiskHoldsNobodyUp) {
  SaverOptions how = options();
  SaverDesk desk({.roots = {folder_.at("unused")}});
  Saver saver(how);
  desk.feed.emplace(saver);
  desk.feed->begin(*desk.session, desk.drawing(), "n", "", false);
  saver.attach(*desk.ring, SaverDesk::kOffsetNs);
  desk.steps(20);
  saver.flush();
  {
    const std::unique_lock disk(FaultyVfs::the().stall);
    const int before = FaultyVfs::the().calls;
    desk.draw(1);
    while (FaultyVfs::the().calls == before) std::this_thread::yield();
    desk.steps(12'000);
    desk.apply(UndoEvent{});
    saver.modified(true);
    saver.rename("other", "");
    EXPECT_EQ(FaultyVfs::the().calls, before + 1) << "it waits for its first write";
  }
  EXPECT_EQ(desk.ring->dropped(), 0u);
  desk.steps(17);
  saver.flush();
  const Result<RecoveredDrawing> recovered = recover_store(saver.status().folder);
  ASSERT_TRUE(recovered);
  EXPECT_EQ(recovered->name, "other");
  EXPECT_EQ(saver.status().state, SaverStatus::State::kWorking);
  EXPECT_TRUE(recovered->drawing.document == desk.ended());
  EXPECT_GT(recovered->drawing.document.stroke_count(), 190u);
}

/// ... nor does one that stalls while the edit thread hangs lose what the loop made.
TEST_F(SaverFault, AStalledDiskAndAHungEditThreadLoseNothing) {
  SaverDesk desk({.roots = {folder_.at("unused")}});
  Saver saver(options());
  desk.feed.emplace(saver);
  desk.feed->begin(*desk.session, desk.drawing(), "n", "", false);
  saver.attach(*desk.ring, SaverDesk::kOffsetNs);
  desk.steps(20);
  saver.flush();
  desk.hangs = true;
  {
    const std::unique_lock disk(FaultyVfs::the().stall);
    desk.steps(10'000);
  }
  EXPECT_EQ(desk.ring->dropped(), 0u);
  saver.flush();
  const Result<RecoveredDrawing> recovered = recover_store(saver.status().folder);
  ASSERT_TRUE(recovered);
  for (int i = 20; i < 10'020; ++i) {
    PenSample late = SaverDesk::sample(i);
    late.time_ns += SaverDesk::kOffsetNs;
    ASSERT_TRUE(desk.session->sample(late));
  }
  EXPECT_TRUE(recovered->drawing.document == desk.ended());
}

/// Each call of a kind fails once: the store is never touched again, another takes its place, and
/// nothing is lost.
TEST_F(SaverFault, WhateverFailsIsNeverTriedAgainInTheSameFile) {
  for (const DiskCall kind : {DiskCall::kOpen, DiskCall::kWrite, DiskCall::kSync}) {
    for (const int code : {SQLITE_IOERR_WRITE, SQLITE_FULL, SQLITE_IOERR_FSYNC}) {
      bool any = true;
      for (int nth = 1; any && nth < 200; nth += 1 + nth / 12) {
        const TestFolder folder;
        SaverOptions how = options();
        how.roots = {folder.at("first"), folder.at("second")};
        how.longest_log_bytes = 2'000;
        int seen = 0, after = 0;
        FaultyVfs::the().judge = [&](DiskCall call, const std::string& path) {
          if (!path.starts_with(folder.at("first"))) return SQLITE_OK;
          if (seen >= nth) {
            // One that is not made yet holds nothing, and goes.
            if (path.find(kWorkingStoreFile) != std::string::npos) ++after;
            return code;
          }
          if (call == kind) ++seen;
          return seen == nth ? code : SQLITE_OK;
        };
        SaverDesk desk(how);
        for (int i = 0; i < 150; ++i) {
          desk.step();
          if (i % 5 == 0) desk.saver->turn();
          if (i % 40 == 20) desk.draw(static_cast<std::uint64_t>(i));
        }
        desk.saver->turn();
        any = seen >= nth;
        EXPECT_EQ(after, 0) << "the first place was used after its failure";
        EXPECT_EQ(desk.saver->status().state,
                  any ? SaverStatus::State::kElsewhere : SaverStatus::State::kWorking);
        const RecoveredDrawing recovered = desk.crashed();
        EXPECT_TRUE(recovered.problems.empty());
        EXPECT_TRUE(recovered.drawing.document == desk.ended()) << "call " << nth;
      }
    }
  }
}

/// What a store holds that failed in the middle of a commit is what was committed before.
TEST_F(SaverFault, AStoreThatFailedHoldsItsLastCommit) {
  for (int nth = 12; nth < 60; nth += 3) {
    const TestFolder folder;
    SaverOptions how = options();
    how.roots = {folder.at("first")};
    int writes = 0;
    FaultyVfs::the().judge = [&](DiskCall call, const std::string&) {
      return call == DiskCall::kWrite && ++writes >= nth ? SQLITE_FULL : SQLITE_OK;
    };
    SaverDesk desk(how);
    desk.saver->turn();
    std::vector<Document> states{desk.session->document()};
    std::string store = desk.saver->status().folder;
    for (std::uint64_t i = 0; i < 20; ++i) {
      desk.draw(i);
      desk.saver->turn();
      if (desk.saver->status().state != SaverStatus::State::kWorking) break;
      store = desk.saver->status().folder;
      states.push_back(desk.session->document());
    }
    if (store.empty()) continue;
    EXPECT_EQ(desk.saver->status().state, SaverStatus::State::kFailing);
    const Result<RecoveredDrawing> recovered = recover_store(store);
    ASSERT_TRUE(recovered) << recovered.error().message;
    EXPECT_TRUE(recovered->drawing.document == states.back());
  }
}

/// The disk is full, then it is not.
TEST_F(SaverFault, AFullDiskIsSaidAndFoundMended) {
  SaverOptions how = options();
  how.retry = how.retry_first = std::chrono::milliseconds(0);
  std::vector<SaverStatus> told;
  how.on_status = [&told](const SaverStatus& status) { told.push_back(status); };
  bool is_full = false;
  FaultyVfs::the().judge = [&](DiskCall call, const std::string&) {
    return is_full && call == DiskCall::kWrite ? SQLITE_FULL : SQLITE_OK;
  };
  SaverDesk desk(how);
  desk.draw(1);
  desk.saver->turn();
  EXPECT_TRUE(told.empty());
  is_full = true;
  desk.draw(2);
  desk.saver->turn();
  desk.steps(70);
  desk.saver->turn();
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().state, SaverStatus::State::kFailing);
  EXPECT_NE(told.back().why.find("full"), std::string::npos) << told.back().why;
  is_full = false;
  desk.steps(30);
  desk.saver->turn();
  EXPECT_EQ(told.back().state, SaverStatus::State::kWorking);
  EXPECT_TRUE(desk.crashed().drawing.document == desk.ended());
}

}  // namespace
}  // namespace felt
