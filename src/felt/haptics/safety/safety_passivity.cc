#include "felt/haptics/safety/safety_passivity.h"

#include <algorithm>
#include <cmath>

namespace felt {

void PassivityObserver::reset() noexcept {
  *this = PassivityObserver{};
}

double PassivityObserver::update(const PenSample& sample, const Force& sent) noexcept {
  constexpr double kMostMj = 1e9;
  const bool is_in_contact = in_contact(sample);
  if (is_in_contact && !was_in_contact_) energy_mj_ = 0.0;
  if (has_last_) {
    const double work = work_mj(sent, sample.position - last_mm_);
    if (std::isfinite(work)) energy_mj_ = std::clamp(energy_mj_ + work, -kMostMj, kMostMj);
  }
  was_in_contact_ = is_in_contact;
  has_last_ = true;
  last_mm_ = sample.position;
  return energy_mj_;
}

}  // namespace felt
