#include "tests/devices/stability/stability_matrix.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "felt/haptics/bricks/drawing_feel.h"

namespace felt {
namespace {

// All devices whose surface can be felt.
constexpr std::array kDevices{"worst", "touch",    "premium", "falcon",      "touch-x",
                              "omega", "inverse3", "delta",   "hapticmaster"};

// Returns the periods of loops to try on a device. One that holds its forces has one period only.
std::vector<std::int64_t> periods_of(const StylusPreset& device) {
  if (device.force_hold_ns > 0) return {device.force_hold_ns};
  return {1'000'000, 250'000, 200'000};
}

// Returns true for the pencil and for the eraser, which has the strongest friction. All other media
// are softer or have less friction.
bool is_extreme(const Medium& tool) {
  return tool.id == "pencil" || tool.id == "eraser";
}

bool is_usual_loop(const StabilityCell& c) {
  return c.period_ns == 1'000'000 && c.delay_ticks == 1;
}

// Adds the cells of one trial, hand and device with all loops, surfaces and media.
void add_loops(StabilityCell cell, std::vector<StabilityCell>& cells) {
  for (const std::int64_t period_ns : periods_of(*cell.device)) {
    for (const int delay : {0, 1, 2}) {
      for (const SurfaceMaterial& surface : surface_materials()) {
        for (const Medium& tool : media()) {
          cell.period_ns = period_ns;
          cell.delay_ticks = delay;
          cell.surface = &surface;
          cell.tool = &tool;
          if (is_extreme(tool) || is_usual_loop(cell)) cells.push_back(cell);
        }
      }
    }
  }
}

// Adds the cells of the guides of a drawing, which only the pencil draws along.
void add_guides(const std::vector<const SimulatedHand*>& hands, std::vector<StabilityCell>& cells) {
  for (const Trial trial : kGuideTrials) {
    for (const StylusPreset& device : stylus_presets()) {
      for (const SimulatedHand* hand : hands) {
        StabilityCell cell{.trial = trial,
                           .device = &device,
                           .hand = hand,
                           .surface = surface_materials().data(),
                           .tool = media().data()};
        if (!device.renders_surface() && device.capabilities.has_force()) {
          cell.delay_ticks = device.capabilities.delay_ticks;
          cells.push_back(cell);
          continue;
        }
        cell.period_ns = periods_of(device).front();
        for (cell.delay_ticks = 0; cell.delay_ticks <= 2; ++cell.delay_ticks) cells.push_back(cell);
        if (device.force_hold_ns > 0) continue;
        cell.delay_ticks = 1;
        cell.period_ns = 200'000;
        cells.push_back(cell);
      }
    }
  }
}

template <class Values>
bool has(const Values& values, std::string_view value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

std::vector<StabilityCell> all_cells() {
  std::vector<const SimulatedHand*> hands;
  for (const SimulatedHand& hand : simulated_hands()) hands.push_back(&hand);
  hands.push_back(nullptr);
  std::vector<StabilityCell> cells;
  for (const Trial trial : kTrials) {
    for (const char* device : kDevices) {
      for (const SimulatedHand* hand : hands) {
        StabilityCell cell;
        cell.trial = trial;
        cell.device = find_stylus_preset(device);
        cell.hand = hand;
        add_loops(cell, cells);
      }
    }
  }
  add_guides(hands, cells);
  return cells;
}

std::vector<StabilityCell> representative_cells(const std::vector<StabilityCell>& cells) {
  constexpr std::array<std::string_view, 5> kOf{"worst", "touch", "premium", "falcon", "omega"};
  std::vector<StabilityCell> some;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(some), [&](const StabilityCell& c) {
    const bool hand = c.hand == nullptr || c.hand->name == "light" || c.hand->name == "typical";
    const bool loop =
        c.period_ns == 1'000'000 ? c.delay_ticks > 0 : c.period_ns == 200'000 && c.delay_ticks == 1;
    // The most common hand and device, and the hand and device with the least damping.
    const bool as_usual = c.device->name == "touch" && c.hand != nullptr &&
                          c.hand->name == "typical" && is_usual_loop(c);
    const bool at_worst = c.device->name == "worst" && c.hand != nullptr &&
                          c.hand->name == "light" && is_usual_loop(c);
    // The surface with the least friction, and one of the hardest with the strongest friction.
    const bool ends = c.surface->id == "paper" || c.surface->id == "blackboard";
    const bool surface = as_usual || (ends && (is_extreme(*c.tool) || at_worst));
    return has(kOf, c.device->name) && hand && loop && surface;
  });
  return some;
}

std::vector<StabilityResult> run_cells(const std::vector<StabilityCell>& cells, unsigned threads) {
  for (const SurfaceMaterial& surface : surface_materials()) surface_grain(surface);  // loads it
  std::vector<StabilityResult> results(cells.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < cells.size(); i = next++) results[i] = run_trial(cells[i]);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
  workers.clear();
  return results;
}

}  // namespace felt
