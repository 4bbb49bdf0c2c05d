#pragma once

#include <memory>

#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// A whole drawing session beside the loop: a hand that draws stroke after stroke with the pencil,
/// a session that gets each sample, publishes what its tool wants the hand to feel every 4 ms, and
/// changes materials, snapping and stabiliser on the way.
std::unique_ptr<Session> make_drawing_session();

}  // namespace felt::rt_test
