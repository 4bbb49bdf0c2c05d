#pragma once

#include "felt/session/session.h"
#include "felt/sound/rubbing.h"

namespace felt {

/// Converts the pen samples of a session to the input of the sound (felt/sound): which medium rubs
/// on which surface, and how hard. Caches values that are expensive to compute. Use it on the edit
/// thread, with one session at a time.
class SoundInput {
 public:
  explicit SoundInput(const Session& session) : session_(&session) {}

  /// Replaces the session, without interrupting the sound.
  void follow(const Session& session) noexcept { session_ = &session; }

  /// Returns the input for a sample. Call it for every sample, after the session has processed it.
  RubbingSample sample(const PenSample& pen);
  /// Returns the medium and surface as of the last sample(). They are updated when the pen touches
  /// or lifts, and every 64 samples.
  [[nodiscard]] const RubbingPair& pair() const noexcept { return pair_; }

 private:
  void look();

  const Session* session_;
  RubbingPair pair_;
  double stiffness_n_per_m_ = 0.0, max_n_ = 0.0;
  int until_look_ = 0;
  bool is_down_ = false;
};

}  // namespace felt
