#pragma once

#include <memory>

#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// A drawing session in which every editing tool makes its gestures on a small drawing, in each of
/// its modes, while the force that it wants is published: hovering, landing, on the way, lifting.
/// Each gesture is taken back afterwards.
std::unique_ptr<Session> make_editing_session();

}  // namespace felt::rt_test
