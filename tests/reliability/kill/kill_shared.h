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
constexpr std::int64_t kOffsetNs = 5'000'000'000;  ///< the session's clock less the loop's
constexpr std::size_t kMaxTicks = 8192;

struct Tick {
  PenSample sample;
  std::int64_t made_ns = 0;  ///< CLOCK_MONOTONIC
  bool is_ink = false;       ///< the loop handed it over
};

/// What the process that is killed says while it lives, in memory that outlives it.
struct Testimony {
  std::atomic<std::uint32_t> read{0};       ///< ticks whose sample is written
  std::atomic<std::uint32_t> confirmed{0};  ///< ticks that are over
  std::atomic<std::int64_t> committed_ns{INT64_MIN};
  std::atomic<bool> has_store{false};
  std::array<Tick, kMaxTicks> ticks;

  // What the process that judges says.
  std::atomic<bool> is_judged{false};
  bool is_good = false;
  std::int64_t age_ns = 0;
  int strokes = 0, live_samples = 0;
  std::array<char, 2048> reason{};
};

/// What is to be drawn; all else follows from the seed.
struct Picture {
  std::uint64_t seed = 0;
  int base_strokes = 0;
  bool with_forces = false;
  std::uint32_t hangs_at = UINT32_MAX;  ///< the session's sample at which the edit thread hangs
  std::string root;                     ///< of the autosaves
  std::string base_path;                ///< the file that was opened, "" for a new drawing
  std::string save_path;                ///< where it is saved now and then
};

/// Where the hand wants the pen at a tick.
struct Target {
  Vec3 place;
  bool down = false;
};
Target target_at(std::uint64_t seed, std::uint32_t tick);

/// What the person does before the session's sample of this number; as a rule nothing.
std::vector<decltype(Event::what)> events_at(std::uint64_t seed, std::uint32_t sample);

const StylusPreset& device_of(const Picture& picture);
Document base_document(const Picture& picture);

std::int64_t monotonic_ns();

/// Draws until it is killed, or kMaxTicks are over.
[[noreturn]] void draw(const Picture& picture, Testimony& testimony);

/// Recovers the store of that process and compares it with what the testimony says.
void judge(const Picture& picture, std::int64_t process, Testimony& testimony);

}  // namespace felt::kill
