#pragma once

#include <memory>

#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// Returns a complete drawing session that runs next to the haptic loop. The simulated hand draws
/// one stroke after the other with the pencil. The session receives each sample, publishes its
/// tool's force model every 4 ms, and from time to time changes materials, snapping and stabiliser.
std::unique_ptr<Session> make_drawing_session();

}  // namespace felt::rt_test
