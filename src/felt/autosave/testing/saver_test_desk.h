#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "felt/autosave/recovery.h"
#include "felt/autosave/saver.h"
#include "felt/autosave/saver_feed.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"

namespace felt::testing {

/// A folder for a test, which goes with it: in memory where the machine has that, for thousands of
/// commits wait for their disk otherwise.
struct TestFolder {
  TestFolder() {
    const bool has_memory = ::access("/dev/shm", W_OK) == 0;
    std::string name = (has_memory ? "/dev/shm/" : ::testing::TempDir()) + "felt-store-XXXXXX";
    path = ::mkdtemp(name.data());
  }
  ~TestFolder() { std::filesystem::remove_all(path); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  [[nodiscard]] std::string at(const char* name) const { return path + '/' + name; }

  std::string path;
};

/// A session with a pen that writes by script, kept by a saver without a thread.
class SaverDesk {
 public:
  static constexpr std::int64_t kStepNs = 4'000'000;
  static constexpr std::int64_t kOffsetNs = 7'000'000'000;  // the session's clock less the loop's

  explicit SaverDesk(SaverOptions options) : options_(std::move(options)) {
    options_.live = false;
    SessionOptions how;
    how.on_event = [this](const Event& event) {
      if (feed) feed->hear(*session, event);
    };
    how.on_edit = [this](const Edit& edit) {
      if (feed) feed->hear(*session, edit);
    };
    session = std::make_unique<Session>(make_tools(), std::move(how));
    ring = std::make_unique<Servo::Ring>();
    saver = std::make_unique<Saver>(options_);
    feed.emplace(*saver);
    feed->begin(*session, drawing(), "Untitled", "", false);
    saver->attach(*ring, kOffsetNs);
  }

  [[nodiscard]] StoredDrawing drawing() const {
    SheetPage page;
    page.surface = session->sheet().material().id;
    return {session->document(), page, session->sheet().color(), session->layer()};
  }

  /// The k-th sample of a hand that writes loops and lifts between them.
  static PenSample sample(int k) {
    const double t = 0.05 * k;
    PenSample sample;
    sample.time_ns = k * kStepNs;
    const bool down = k % 60 >= 5 && k % 60 < 50;
    sample.position = {60.0 + 30.0 * std::cos(t) + 0.1 * k, 60.0 + 30.0 * std::sin(1.7 * t),
                       down ? -0.2 : 2.0};
    sample.pressure = down ? 0.4 + 0.2 * std::sin(t) : 0.0;
    return sample;
  }

  /// The loop makes the next sample; the session hears of it, unless its thread hangs.
  void step() {
    const PenSample of_loop = sample(k_++);
    ring->push(of_loop);
    if (hangs) return;
    PenSample told = of_loop;
    told.time_ns += kOffsetNs;
    ASSERT_TRUE(session->sample(told));
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void apply(decltype(Event::what) what) {
    const Result<void> done = session->apply({k_ * kStepNs + kOffsetNs, std::move(what)});
    EXPECT_TRUE(done) << done.error().message;
  }
  void draw(std::uint64_t seed, int count = 1) {
    Sketch sketch;
    for (int i = 0; i < count; ++i) {
      sketch.push_back({"s", random_stroke(100 * seed + static_cast<std::uint64_t>(i))});
    }
    ASSERT_TRUE(session->import(k_ * kStepNs + kOffsetNs, {"test"}, sketch));
  }
  /// What a crash now would leave, read.
  [[nodiscard]] RecoveredDrawing crashed() const {
    const SaverStatus status = saver->status();
    const Result<RecoveredDrawing> recovered = recover_store(status.folder);
    EXPECT_TRUE(recovered) << (recovered ? "" : recovered.error().message);
    return recovered.value_or(RecoveredDrawing{});
  }
  /// The document with what is in work ended as it is now.
  [[nodiscard]] Document ended() {
    feed.reset();
    EXPECT_TRUE(session->finish());
    return session->document();
  }

  std::unique_ptr<Servo::Ring> ring;
  std::unique_ptr<Session> session;
  std::unique_ptr<Saver> saver;
  std::optional<SaverFeed> feed;
  bool hangs = false;

 private:
  SaverOptions options_;
  int k_ = 0;
};

}  // namespace felt::testing
