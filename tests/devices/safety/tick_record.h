#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/safety/safety_chain.h"

namespace felt::safety {

/// The inputs of the chain at one tick, in the sequence of a tick.
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

/// The outputs of the chain at one tick.
struct TickOutput {
  double model_dt_s = 0.0;
  bool admitted = false;
  Force asked;  ///< requested by the model; zero if the sample was not admitted
  StiffnessScale scale;
  Force sent;           ///< returned by limit(); zero if the read failed
  SafetyReport before;  ///< report of the tick before
  SafetyReport after;   ///< report of this tick, before a failed write is reported to the chain
};

}  // namespace felt::safety
