#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/document/document.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/event.h"

namespace felt::kill {

constexpr std::int64_t kTickNs = 1'000'000;
constexpr std::int64_t kOffsetNs = 5'000'000'000;  ///< session clock minus haptic loop clock
constexpr std::size_t kMaxTicks = 8192;

struct Tick {
  PenSample sample;
  std::int64_t made_ns = 0;  ///< CLOCK_MONOTONIC
  bool is_ink = false;       ///< the haptic loop passed the sample on to the edit thread
};

/// Record that the killed process writes while it runs. Lies in shared memory, so it survives the
/// process.
struct Testimony {
  std::atomic<std::uint32_t> read{0};       ///< number of ticks with a recorded sample
  std::atomic<std::uint32_t> confirmed{0};  ///< number of completed ticks
  std::atomic<std::int64_t> committed_ns{INT64_MIN};
  std::atomic<bool> has_store{false};
  std::array<Tick, kMaxTicks> ticks;

  // Written by the process that checks the result.
  std::atomic<bool> is_judged{false};
  bool is_good = false;
  std::int64_t age_ns = 0;
  int strokes = 0, live_samples = 0;
  std::array<char, 2048> reason{};
};

/// Parameters of one run. Everything else is computed from the seed.
struct Picture {
  std::uint64_t seed = 0;
  int base_strokes = 0;
  bool with_forces = false;
  std::uint32_t hangs_at = UINT32_MAX;  ///< number of the sample at which the edit thread hangs
  bool stalls = false;                  ///< the edit thread and the autosave often pause for long
  std::string root;                     ///< folder of the autosaves
  std::string base_path;                ///< the file that was opened, "" for a new drawing
  std::string save_path;                ///< the file to which the drawing is saved periodically
};

/// Position that the simulated hand wants at a tick.
struct Target {
  Vec3 place;
  bool down = false;
};
Target target_at(std::uint64_t seed, std::uint32_t tick);

/// Returns the user's events before sample number `sample` of the session. Usually empty.
std::vector<decltype(Event::what)> events_at(std::uint64_t seed, std::uint32_t sample);

const StylusPreset& device_of(const Picture& picture);
Document base_document(const Picture& picture);

std::int64_t monotonic_ns();

/// Draws until the process is killed or kMaxTicks have passed.
[[noreturn]] void draw(const Picture& picture, Testimony& testimony);

/// Recovers the autosave of `process`, compares it with `testimony` and writes the result there.
void judge(const Picture& picture, std::int64_t process, Testimony& testimony);

}  // namespace felt::kill
