#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "web/page/core/api_state.h"

#define FELT_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace felt::page {

/// Makes this the reply, and returns its size.
inline std::size_t reply(std::string text) {
  core().reply = std::move(text);
  return core().reply.size();
}
inline std::size_t reply(const Result<void>& done, const std::vector<std::string>& notices = {}) {
  return reply(done_text(done, notices));
}
/// Returns the first `size` bytes that JavaScript has written.
inline std::string_view input(std::size_t size) {
  return {core().input.data(), size};
}

}  // namespace felt::page
