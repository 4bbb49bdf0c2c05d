#pragma once

#include <span>
#include <string_view>

namespace felt {

/// A hand as the stylus feels it: its mass moves with the stylus, and a spring and a damper lie
/// between the stylus and the place where the hand wants it (specification section 0). The four
/// hands bracket people; none is measured.
struct SimulatedHand {
  std::string_view name{};
  double mass_kg = 0.03;
  double stiffness_n_per_m = 300.0;
  double damping_n_s_per_m = 3.0;
};

/// light, soft, typical, firm (specification section 0).
std::span<const SimulatedHand> simulated_hands() noexcept;
/// By name, or null.
const SimulatedHand* find_hand(std::string_view name) noexcept;
/// The hand that is meant where nothing is said: typical.
const SimulatedHand& typical_hand() noexcept;

}  // namespace felt
