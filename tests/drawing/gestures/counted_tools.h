#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "felt/tools/tool.h"

namespace felt::gestures {

/// Makes the tools of make_tools(). Each of them adds 1 to `touches` when the session reports that
/// a contact begins, that is, when a new gesture may begin. Only the session can tell: after some
/// events its Contact starts again without the speed of the pen, which decides whether the next gap
/// is a bounce or a lift. `touches` must live as long as the tools.
std::vector<std::unique_ptr<Tool>> make_counted_tools(std::uint64_t& touches);

}  // namespace felt::gestures
