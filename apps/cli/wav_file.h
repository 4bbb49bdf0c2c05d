#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>

#include "felt/base/result.h"
#include "output.h"

namespace felt::cli {

/// A sound file as every player reads it: RIFF/WAVE, PCM, 16 bit, one channel, 48 kHz. How long it
/// is stands at its front, so samples wait in a temporary file without a name, and memory does not
/// grow with them. Nothing shows under the file's name before `finish`.
class WavFile {
 public:
  static constexpr std::uint32_t kRateHz = 48000;
  /// Some 12 hours: what a header of 32 bits can say.
  static constexpr std::uint64_t kMostSamples = 0x7FFFFF00u;

  /// Error: the place cannot be written. Messages begin with its name.
  static Result<WavFile> create(const std::string& path);

  /// The next samples, -1..1; beyond is clipped. Error: disk full; longer than kMostSamples.
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
  std::string bytes_;  // not yet in the spool
  std::uint64_t count_ = 0;
};

}  // namespace felt::cli
