#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "felt/session/sound_input.h"
#include "felt/sound/rubbing_player.h"
#include "output.h"

namespace felt::cli {

/// Writes a sound file in a format that every player reads: RIFF/WAVE, PCM, 16 bit, one channel, 48
/// kHz. The file begins with its length, which is known only at the end. Therefore samples are
/// first written to an unnamed temporary file instead of being kept in memory. The file gets its
/// name when finish() succeeds, not before.
class WavFile {
 public:
  static constexpr std::uint32_t kRateHz = 48000;
  /// Maximum number of samples, because sizes in the header have 32 bits. This is a sound of about
  /// 12 hours.
  static constexpr std::uint64_t kMaxSamples = 0x7FFFFF00u;

  /// Fails if the file cannot be written. Messages begin with its name.
  static Result<WavFile> create(const std::string& path);

  /// Adds samples, clipped to -1..1. Fails if the disk is full, or if there would be more than
  /// kMaxSamples.
  Result<void> add(std::span<const float> samples);
  /// Completes the file. Call once.
  Result<void> finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  explicit WavFile(Output output) : output_(std::move(output)) {}

  Output output_;
  std::unique_ptr<std::FILE, Close> spool_;
  std::string bytes_;  // bytes that are not yet in the temporary file
  std::uint64_t count_ = 0;
};

/// Writes the file of `replay --sound`: the sound of a session's pen in virtual time, from the
/// pen's first sample to its last sample.
class ReplaySound {
 public:
  /// Fails if the file cannot be written. Messages begin with its name.
  static Result<ReplaySound> create(const std::string& path);

  /// Sets the session that provides tool and surface. Call before the first add(). The session must
  /// outlive the last add().
  void begin(const Session& session) { pen_.emplace(session); }
  /// Adds a sample of the pen. Fails like WavFile::add().
  Result<void> add(const PenSample& pen);
  /// Completes the file. Call once.
  Result<void> finish();

 private:
  explicit ReplaySound(WavFile file) : file_(std::move(file)) {}
  Result<void> render(std::size_t samples);

  WavFile file_;
  std::optional<SoundInput> pen_;
  RubbingPlayer sound_;
  std::array<float, 4096> block_{};
};

}  // namespace felt::cli
