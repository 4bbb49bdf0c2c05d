#pragma once

#include <array>
#include <optional>
#include <string>

#include "felt/session/heard_pen.h"
#include "felt/sound/rubbing_sound.h"
#include "wav_file.h"

namespace felt::cli {

/// The file of `replay --sound`: what a session's pen sounds like, in virtual time, from its first
/// sample to its last.
class ReplaySound {
 public:
  /// Error: the place cannot be written. Messages begin with its name.
  static Result<ReplaySound> create(const std::string& path);

  /// Whose tool and sheet it is. Before the first add(); must outlive the last.
  void begin(const Session& session) { pen_.emplace(session); }
  /// The next sample of the pen. Error: as of WavFile.
  Result<void> add(const PenSample& pen);
  /// Completes the file. Call once.
  Result<void> finish();

 private:
  explicit ReplaySound(WavFile file) : file_(std::move(file)) {}
  Result<void> render(std::size_t samples);

  WavFile file_;
  std::optional<HeardPen> pen_;
  RubbingSound sound_;
  std::array<float, 4096> block_{};
};

}  // namespace felt::cli
