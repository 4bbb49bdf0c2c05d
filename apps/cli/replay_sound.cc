#include "replay_sound.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

namespace felt::cli {
namespace {

constexpr std::size_t kWavBufferBytes = std::size_t{64} << 10;

tl::unexpected<Error> wav_error(const char* doing) {
  return fail(ErrorCode::kIo, std::string("temporary file: cannot ") + doing + ": " +
                                  std::generic_category().message(errno));
}

void append(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFFu);
}

std::string header_of(std::uint32_t samples) {
  const std::uint32_t data = 2 * samples;
  std::string bytes = "RIFF";
  append(bytes, 36 + data, 4);
  bytes += "WAVEfmt ";
  append(bytes, 16, 4);
  append(bytes, 1, 2);  // format: PCM
  append(bytes, 1, 2);  // number of channels
  append(bytes, WavFile::kRateHz, 4);
  append(bytes, 2 * WavFile::kRateHz, 4);
  append(bytes, 2, 2);   // bytes per sample of all channels
  append(bytes, 16, 2);  // bits per sample
  bytes += "data";
  append(bytes, data, 4);
  return bytes;
}

}  // namespace

Result<WavFile> WavFile::create(const std::string& path) {
  Result<Output> output = Output::create(path);
  if (!output) return tl::unexpected(output.error());
  WavFile file(*std::move(output));
  file.spool_.reset(std::tmpfile());
  if (!file.spool_) return wav_error("create");
  return file;
}

Result<void> WavFile::add(std::span<const float> samples) {
  count_ += samples.size();
  if (count_ > kMaxSamples) {
    return fail(ErrorCode::kUnsupported,
                "a .wav file can hold at most 12 hours of sound, and this recording is longer");
  }
  for (const float sample : samples) {
    const double value = std::clamp(static_cast<double>(sample), -1.0, 1.0);
    append(bytes_, static_cast<std::uint32_t>(std::lround(32767.0 * value)), 2);
  }
  if (bytes_.size() < kWavBufferBytes) return {};
  if (std::fwrite(bytes_.data(), 1, bytes_.size(), spool_.get()) != bytes_.size()) {
    return wav_error("write");
  }
  bytes_.clear();
  return {};
}

Result<void> WavFile::finish() {
  const bool is_spooled =
      std::fwrite(bytes_.data(), 1, bytes_.size(), spool_.get()) == bytes_.size() &&
      std::fflush(spool_.get()) == 0;
  if (!is_spooled) return wav_error("write");
  if (std::fseek(spool_.get(), 0, SEEK_SET) != 0) return wav_error("read");
  Result<void> written = output_.write(header_of(static_cast<std::uint32_t>(count_)));
  std::vector<char> buffer(kWavBufferBytes);
  while (written) {
    const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), spool_.get());
    if (n == 0) break;
    written = output_.write({buffer.data(), n});
  }
  if (!written) return written;
  return std::ferror(spool_.get()) ? wav_error("read") : output_.commit();
}

Result<ReplaySound> ReplaySound::create(const std::string& path) {
  Result<WavFile> file = WavFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return ReplaySound(*std::move(file));
}

Result<void> ReplaySound::render(std::size_t samples) {
  while (samples > 0) {
    const auto part = std::span(block_).first(std::min(samples, block_.size()));
    sound_.render(part);
    if (Result<void> added = file_.add(part); !added) return added;
    samples -= part.size();
  }
  return {};
}

Result<void> ReplaySound::add(const PenSample& pen) {
  sound_.push(pen_->sample(pen));
  sound_.set_pair(pen_->pair());
  return render(sound_.ready());
}

/// Adds the fade-out of the last touch and completes the file.
Result<void> ReplaySound::finish() {
  constexpr auto kTail =
      static_cast<std::size_t>(RubbingSynth::kSilentAfterS * RubbingPlayer::kRateHz);
  if (Result<void> rendered = render(kTail); !rendered) return rendered;
  return file_.finish();
}

}  // namespace felt::cli
