#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/safety/safety_chain.h"

namespace felt::safety {

/// What the world did at one tick, in the order of a tick.
struct TickInput {
  bool arm = false;
  bool disarm = false;
  std::optional<std::int64_t> heartbeat_ns;
  std::int64_t now_ns = 0;
  bool read_fails = false;
  bool write_fails = false;
  PenSample sample;
  Slopes slopes;
};

/// What the chain, or what stands for it, did with that.
struct TickOutput {
  double model_dt_s = 0.0;
  bool admitted = false;
  Force asked;  ///< what the model said; only where the sample was admitted
  StiffnessScale scale;
  Force sent;           ///< as limit() returned it; none where reading failed
  SafetyReport before;  ///< of the tick before
  SafetyReport after;   ///< of this one, before a failing write is told
};

}  // namespace felt::safety
