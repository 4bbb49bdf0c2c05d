#include "felt/devices/simulated/simulated_hand.h"

#include <array>

namespace felt {
namespace {

constexpr std::array<SimulatedHand, 4> kHands{{
    {.name = "light", .mass_kg = 0.0, .stiffness_n_per_m = 30.0, .damping_n_s_per_m = 0.3},
    {.name = "soft", .mass_kg = 0.02, .stiffness_n_per_m = 100.0, .damping_n_s_per_m = 1.0},
    {.name = "typical", .mass_kg = 0.03, .stiffness_n_per_m = 300.0, .damping_n_s_per_m = 3.0},
    {.name = "firm", .mass_kg = 0.05, .stiffness_n_per_m = 800.0, .damping_n_s_per_m = 8.0},
}};

}  // namespace

std::span<const SimulatedHand> simulated_hands() noexcept {
  return kHands;
}

const SimulatedHand* find_hand(std::string_view name) noexcept {
  for (const SimulatedHand& hand : kHands) {
    if (hand.name == name) return &hand;
  }
  return nullptr;
}

const SimulatedHand& typical_hand() noexcept {
  return kHands[2];
}

}  // namespace felt
