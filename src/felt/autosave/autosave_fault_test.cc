// The autosave on disks that stall, fail and are full.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "felt/autosave/autosave.h"
#include "felt/autosave/autosave_database.h"
#include "felt/autosave/testing/autosave_fixture.h"
#include "felt/store/testing/faulty_vfs.h"

namespace felt::autosave_fault_test {
namespace {

using testing::AutosaveFixture;
using testing::DiskCall;
using testing::FaultyVfs;
using testing::TestFolder;

class AutosaveFault : public ::testing::Test {
 protected:
  AutosaveFault() { FaultyVfs::the().reset(); }
  ~AutosaveFault() override { FaultyVfs::the().reset(); }

  [[nodiscard]] AutosaveOptions options() const {
    AutosaveOptions options{.roots = {folder_.at("first"), folder_.at("second")}};
    options.vfs = FaultyVfs::kName;
    options.retry = options.retry_first = std::chrono::hours(1);
    return options;
  }
  [[nodiscard]] bool is_first(const std::string& path) const {
    return path.starts_with(folder_.at("first"));
  }

  TestFolder folder_;
};

/// While the disk stalls, every call returns immediately (otherwise this test would stall, too) and
/// samples keep arriving. Afterwards all of them are saved: 12 s at 1 kHz.
TEST_F(AutosaveFault, AStalledDiskHoldsNobodyUp) {
  AutosaveOptions how = options();
  AutosaveFixture fixture({.roots = {folder_.at("unused")}});
  Autosave autosave(how);
  fixture.listener = &autosave;
  fixture.listener->session_began(*fixture.session, fixture.drawing(), "n", "", false);
  autosave.attach(*fixture.ring, AutosaveFixture::kOffsetNs);
  fixture.steps(20);
  autosave.flush();
  {
    const std::unique_lock disk(FaultyVfs::the().stall);
    const int before = FaultyVfs::the().calls;
    fixture.draw(1);
    while (FaultyVfs::the().calls == before) std::this_thread::yield();
    fixture.steps(12'000);
    fixture.apply(UndoEvent{});
    autosave.post({.modified = true});
    autosave.post({.name = "other", .path = ""});
    EXPECT_EQ(FaultyVfs::the().calls, before + 1) << "it waits for its first write";
  }
  EXPECT_EQ(fixture.ring->dropped(), 0u);
  fixture.steps(17);
  autosave.flush();
  const Result<Recovered> recovered = recover_autosave(autosave.status().folder);
  ASSERT_TRUE(recovered);
  EXPECT_EQ(recovered->name, "other");
  EXPECT_EQ(autosave.status().state, AutosaveStatus::State::kWorking);
  EXPECT_TRUE(recovered->drawing.document == fixture.ended());
  EXPECT_GT(recovered->drawing.document.stroke_count(), 190u);
}

/// If a disk stalls while the edit thread hangs, the samples of the loop are not lost either.
TEST_F(AutosaveFault, AStalledDiskAndAHungEditThreadLoseNothing) {
  AutosaveFixture fixture({.roots = {folder_.at("unused")}});
  Autosave autosave(options());
  fixture.listener = &autosave;
  fixture.listener->session_began(*fixture.session, fixture.drawing(), "n", "", false);
  autosave.attach(*fixture.ring, AutosaveFixture::kOffsetNs);
  fixture.steps(20);
  autosave.flush();
  fixture.hangs = true;
  {
    const std::unique_lock disk(FaultyVfs::the().stall);
    fixture.steps(10'000);
  }
  EXPECT_EQ(fixture.ring->dropped(), 0u);
  autosave.flush();
  const Result<Recovered> recovered = recover_autosave(autosave.status().folder);
  ASSERT_TRUE(recovered);
  for (int i = 20; i < 10'020; ++i) {
    PenSample late = AutosaveFixture::sample(i);
    late.time_ns += AutosaveFixture::kOffsetNs;
    ASSERT_TRUE(fixture.session->sample(late));
  }
  EXPECT_TRUE(recovered->drawing.document == fixture.ended());
}

/// Each call of a kind fails once. After that the database is never used again, another one
/// replaces it, and nothing is lost.
TEST_F(AutosaveFault, WhateverFailsIsNeverTriedAgainInTheSameFile) {
  for (const DiskCall kind : {DiskCall::kOpen, DiskCall::kWrite, DiskCall::kSync}) {
    for (const int code : {SQLITE_IOERR_WRITE, SQLITE_FULL, SQLITE_IOERR_FSYNC}) {
      bool any = true;
      for (int nth = 1; any && nth < 200; nth += 1 + nth / 12) {
        const TestFolder folder;
        AutosaveOptions how = options();
        how.roots = {folder.at("first"), folder.at("second")};
        how.max_log_bytes = 2'000;
        int seen = 0, after = 0;
        FaultyVfs::the().judge = [&](DiskCall call, const std::string& path) {
          if (!path.starts_with(folder.at("first"))) return SQLITE_OK;
          if (seen >= nth) {
            // A database that is not complete yet holds nothing, and is removed.
            if (path.find(kAutosaveDatabaseFile) != std::string::npos) ++after;
            return code;
          }
          if (call == kind) ++seen;
          return seen == nth ? code : SQLITE_OK;
        };
        AutosaveFixture fixture(how);
        for (int i = 0; i < 150; ++i) {
          fixture.step();
          if (i % 5 == 0) fixture.autosave->process();
          if (i % 40 == 20) fixture.draw(static_cast<std::uint64_t>(i));
        }
        fixture.autosave->process();
        any = seen >= nth;
        EXPECT_EQ(after, 0) << "the first place was used after its failure";
        EXPECT_EQ(fixture.autosave->status().state,
                  any ? AutosaveStatus::State::kElsewhere : AutosaveStatus::State::kWorking);
        const Recovered recovered = fixture.crashed();
        EXPECT_TRUE(recovered.problems.empty());
        EXPECT_TRUE(recovered.drawing.document == fixture.ended()) << "call " << nth;
      }
    }
  }
}

/// A database that failed in the middle of a commit still has all data of the previous commits.
TEST_F(AutosaveFault, AStoreThatFailedHoldsItsLastCommit) {
  for (int nth = 12; nth < 60; nth += 3) {
    const TestFolder folder;
    AutosaveOptions how = options();
    how.roots = {folder.at("first")};
    int writes = 0;
    FaultyVfs::the().judge = [&](DiskCall call, const std::string&) {
      return call == DiskCall::kWrite && ++writes >= nth ? SQLITE_FULL : SQLITE_OK;
    };
    AutosaveFixture fixture(how);
    fixture.autosave->process();
    std::vector<Document> states{fixture.session->document()};
    std::string store = fixture.autosave->status().folder;
    for (std::uint64_t i = 0; i < 20; ++i) {
      fixture.draw(i);
      fixture.autosave->process();
      if (fixture.autosave->status().state != AutosaveStatus::State::kWorking) break;
      store = fixture.autosave->status().folder;
      states.push_back(fixture.session->document());
    }
    if (store.empty()) continue;
    EXPECT_EQ(fixture.autosave->status().state, AutosaveStatus::State::kFailing);
    const Result<Recovered> recovered = recover_autosave(store);
    ASSERT_TRUE(recovered) << recovered.error().message;
    EXPECT_TRUE(recovered->drawing.document == states.back());
  }
}

/// The disk is full, then has space again.
TEST_F(AutosaveFault, AFullDiskIsSaidAndFoundMended) {
  AutosaveOptions how = options();
  how.retry = how.retry_first = std::chrono::milliseconds(0);
  std::vector<AutosaveStatus> reported;
  how.on_status = [&reported](const AutosaveStatus& status) { reported.push_back(status); };
  bool is_full = false;
  FaultyVfs::the().judge = [&](DiskCall call, const std::string&) {
    return is_full && call == DiskCall::kWrite ? SQLITE_FULL : SQLITE_OK;
  };
  AutosaveFixture fixture(how);
  fixture.draw(1);
  fixture.autosave->process();
  EXPECT_TRUE(reported.empty());
  is_full = true;
  fixture.draw(2);
  fixture.autosave->process();
  fixture.steps(70);
  fixture.autosave->process();
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back().state, AutosaveStatus::State::kFailing);
  EXPECT_NE(reported.back().why.find("full"), std::string::npos) << reported.back().why;
  is_full = false;
  fixture.steps(30);
  fixture.autosave->process();
  EXPECT_EQ(reported.back().state, AutosaveStatus::State::kWorking);
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.ended());
}

/// The disk has space for a new folder but not for a copy of the drawing. Failed attempts leave no
/// files.
TEST_F(AutosaveFault, RepeatedFailuresDoNotFillTheDisk) {
  const TestFolder folder;
  AutosaveOptions how = options();
  how.roots = {folder.at("first"), folder.at("second")};
  how.retry = how.retry_first = std::chrono::milliseconds(0);
  bool is_full = false;
  int writes = 0;
  FaultyVfs::the().judge = [&](DiskCall call, const std::string&) {
    return is_full && call == DiskCall::kWrite && ++writes % 40 == 0 ? SQLITE_FULL : SQLITE_OK;
  };
  AutosaveFixture fixture(how);
  for (std::uint64_t i = 0; i < 40; ++i) fixture.draw(i);
  fixture.autosave->process();
  const auto databases = [&] {
    std::size_t count = 0;
    for (const char* root : {"first", "second"}) {
      std::error_code none;
      for (const auto& entry : std::filesystem::directory_iterator(folder.at(root), none))
        count += entry.is_directory() ? 1 : 0;
    }
    return count;
  };
  ASSERT_EQ(databases(), 1u);
  is_full = true;
  std::size_t largest = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    fixture.draw(40 + i);
    fixture.autosave->process();
    largest = std::max(largest, databases());
  }
  EXPECT_LE(largest, 2u) << "the last complete one, and the one being written";
  is_full = false;
  fixture.draw(1000);
  fixture.autosave->process();
  EXPECT_EQ(databases(), 1u);
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.ended());
}

}  // namespace
}  // namespace felt::autosave_fault_test
