#pragma once

#include <memory>

#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// Returns a drawing session in which every editing tool makes its gestures on a small drawing, in
/// each of its modes. The tool's force model is published during the whole gesture: while the pen
/// hovers, lands, moves and lifts. Each gesture is undone afterwards.
std::unique_ptr<Session> make_editing_session();

}  // namespace felt::rt_test
