#include "replay_sound.h"

#include <algorithm>
#include <utility>

namespace felt::cli {

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

/// The last touch dies away.
Result<void> ReplaySound::finish() {
  constexpr auto kTail = static_cast<std::size_t>(RubVoice::kSilentAfterS * RubbingSound::kRateHz);
  if (Result<void> rendered = render(kTail); !rendered) return rendered;
  return file_.finish();
}

}  // namespace felt::cli
