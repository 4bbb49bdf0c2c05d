#include "felt/timelapse/drawing_time.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

namespace felt {
namespace {

/// Returns true for events that never change the picture.
bool is_unseen(const Event& event) {
  return std::visit(
      []<class What>(const What&) {
        return std::is_same_v<What, SelectTool> || std::is_same_v<What, SetOption> ||
               std::is_same_v<What, SelectStrokes> || std::is_same_v<What, UseDevice> ||
               std::is_same_v<What, UseMaterial> || std::is_same_v<What, UseGuide> ||
               std::is_same_v<What, UseEdges> || std::is_same_v<What, UseRing>;
      },
      event.what);
}

}  // namespace

std::int64_t DrawingTime::at(const Event& event) {
  if (const auto* pen = std::get_if<PenEvent>(&event.what)) {
    const bool is_down = in_contact(sample_of(event.time_ns, *pen));
    if (!std::exchange(is_down_, is_down) && !is_down) return now_ns_;
  } else if (is_unseen(event)) {
    return now_ns_;
  }
  if (last_moment_ns_) {
    now_ns_ += std::clamp(event.time_ns - *last_moment_ns_, std::int64_t{0}, kLongestPauseNs);
  }
  last_moment_ns_ = event.time_ns;
  return now_ns_;
}

}  // namespace felt
