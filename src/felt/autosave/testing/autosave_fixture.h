#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "felt/autosave/autosave.h"
#include "felt/autosave/recovery.h"
#include "felt/base/testing/test_folder.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"

namespace felt::testing {

/// A session with a simulated pen, saved by an autosave without a thread.
class AutosaveFixture {
 public:
  static constexpr std::int64_t kStepNs = 4'000'000;
  static constexpr std::int64_t kOffsetNs = 7'000'000'000;  // the session's clock minus the loop's

  explicit AutosaveFixture(AutosaveOptions options) : options_(std::move(options)) {
    options_.live = false;
    SessionOptions how;
    how.on_event = [this](const Event& event) {
      if (listener) listener->event_applied(*session, event);
    };
    how.on_edit = [this](const Edit& edit) {
      if (listener) listener->edit_applied(*session, edit);
    };
    session = std::make_unique<Session>(make_tools(), std::move(how));
    ring = std::make_unique<Servo::Ring>();
    autosave = std::make_unique<Autosave>(options_);
    listener = autosave.get();
    listener->session_began(*session, drawing(), "Untitled", "", false);
    autosave->attach(*ring, kOffsetNs);
  }

  [[nodiscard]] Drawing drawing() const {
    Page page;
    page.surface = session->surface().id;
    return {.document = session->document(),
            .page = page,
            .color = session->ink_color(),
            .layer = session->layer()};
  }

  /// Returns the k-th sample of a hand that writes loops and lifts between them.
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

  /// Makes the loop's next sample. The session receives it unless its thread hangs.
  void step() {
    const PenSample of_loop = sample(k_++);
    ring->push(of_loop);
    if (hangs) return;
    PenSample reported = of_loop;
    reported.time_ns += kOffsetNs;
    ASSERT_TRUE(session->sample(reported));
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void apply(decltype(Event::what) what) {
    const Result<void> done = session->apply({k_ * kStepNs + kOffsetNs, std::move(what)});
    EXPECT_TRUE(done) << done.error().message;
  }
  void draw(std::uint64_t seed, int count = 1) {
    std::vector<StrokePtr> strokes;
    for (int i = 0; i < count; ++i) {
      strokes.push_back(std::make_shared<const Stroke>(
          random_stroke(100 * seed + static_cast<std::uint64_t>(i))));
    }
    ASSERT_TRUE(session->import(k_ * kStepNs + kOffsetNs, {"test"}, strokes));
  }
  /// Returns what recovery would read after a crash now.
  [[nodiscard]] Recovered crashed() const {
    const AutosaveStatus status = autosave->status();
    const Result<Recovered> recovered = recover_autosave(status.folder);
    EXPECT_TRUE(recovered) << (recovered ? "" : recovered.error().message);
    return recovered.value_or(Recovered{});
  }
  /// Returns the document as if the gesture in progress ended now.
  [[nodiscard]] Document ended() {
    listener = nullptr;
    EXPECT_TRUE(session->finish());
    return session->document();
  }

  std::unique_ptr<Servo::Ring> ring;
  std::unique_ptr<Session> session;
  std::unique_ptr<Autosave> autosave;
  Autosave* listener = nullptr;  // receives the session's events and edits; may be null
  bool hangs = false;

 private:
  AutosaveOptions options_;
  int k_ = 0;
};

}  // namespace felt::testing
