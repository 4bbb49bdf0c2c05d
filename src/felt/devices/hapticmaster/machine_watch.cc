#include "felt/devices/hapticmaster/machine_watch.h"

#include <algorithm>

namespace felt::hapticmaster {
namespace {

std::int64_t left_after(std::int64_t lasted_ns, std::int64_t ns, double forgets) noexcept {
  if (forgets == 0.0) return 0;
  const auto forgotten_ns = static_cast<std::int64_t>(forgets * static_cast<double>(ns));
  return std::max<std::int64_t>(0, lasted_ns - forgotten_ns);
}

}  // namespace

const Limit* MachineWatch::tick(std::int64_t ns, const Signs& signs) noexcept {
  const Limit* broken = nullptr;
  for (std::size_t i = 0; i < kConditions; ++i) {
    const Limit& limit = kLimits[i];
    if (signs[i] != Sign::kUnknown) is_present_[i] = signs[i] == Sign::kPresent;
    lasted_ns_[i] =
        is_present_[i] ? lasted_ns_[i] + ns : left_after(lasted_ns_[i], ns, limit.forgets);
    if (broken == nullptr && lasted_ns_[i] > limit.limit_ns) broken = &limit;
  }
  return broken;
}

}  // namespace felt::hapticmaster
