#pragma once

#include "felt/session/session.h"
#include "felt/sound/rubbing.h"

namespace felt {

/// A session's pen as the ear has it (felt/sound): what rubs on what, and how hard. Keeps what is
/// dear to ask for. Edit thread; one session.
class HeardPen {
 public:
  explicit HeardPen(const Session& session) : session_(&session) {}

  /// Another session goes on with the same sound.
  void follow(const Session& session) noexcept { session_ = &session; }

  /// Every sample that the session was told, after it was told.
  RubbingSample sample(const PenSample& pen);
  /// What rubs on what since the last sample(); looked at when the pen comes down, and each 64
  /// samples.
  [[nodiscard]] const RubbingPair& pair() const noexcept { return pair_; }

 private:
  void look();

  const Session* session_;
  RubbingPair pair_;
  double stiffness_n_per_m_ = 0.0, most_n_ = 0.0;
  int until_look_ = 0;
  bool is_down_ = false;
};

}  // namespace felt
