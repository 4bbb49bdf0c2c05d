#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "tests/devices/stability/stability_matrix.h"

namespace felt::stability_test {
namespace {

// Returns true if the result is not near the limits. Near them, rounding differences between
// compilers may change the verdict.
bool is_clear(const StabilityResult& r) {
  const auto far = [](double value, double bound) {
    return value < 0.9 * bound || value > 1.1 * bound;
  };
  return far(r.high_frequency_n, kCleanForceN) && far(r.energy_mj, kPassiveEnergyMj);
}

class StabilityMatrix : public ::testing::TestWithParam<Trial> {};

// R12, R30, R41, R43 and R56 in the whole loop: cells that docs/stability.md does not list as
// failing are clean and passive; cells that it lists do fail.
TEST_P(StabilityMatrix, R12_FailsNowhereButWhereTheReportSays) {
  std::ifstream in("docs/stability.md");
  const std::string report{std::istreambuf_iterator<char>(in), {}};
  ASSERT_FALSE(report.empty());
  const auto names = failing_names(report);
  const std::set<std::string> documented(names.begin(), names.end());
  auto cells = representative_cells(all_cells());
  std::erase_if(cells, [](const StabilityCell& c) { return c.trial != GetParam(); });
  const std::size_t extremes = 5u * 3u * 3u * 2u * 2u;
  const std::size_t surfaces = surface_materials().size(), tools = media().size();
  ASSERT_EQ(cells.size(), is_guide_of_drawing(GetParam())
                              ? 5u * 3u * 3u
                              : extremes + surfaces * tools - 2u * 2u + 2u * (tools - 2u));
  const auto results = run_cells(cells, 1);
  int clear = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const StabilityResult& r = results[i];
    EXPECT_TRUE(r.finite);
    if (cells[i].hand != nullptr && cells[i].trial != Trial::kTap) {
      EXPECT_GT(r.mean_press_n, 0.1) << name_of(cells[i]) << ": the forces never engaged";
    }
    if (!is_clear(r)) continue;
    ++clear;
    EXPECT_EQ(!passes(r), documented.contains(name_of(cells[i])))
        << name_of(cells[i]) << ": HF " << r.high_frequency_n << " N, energy " << r.energy_mj
        << " mJ, fault " << static_cast<int>(r.fault);
    if (cells[i].trial == Trial::kRest && cells[i].hand != nullptr) {
      EXPECT_GT(r.mean_press_n, 0.4) << "it did press: " << name_of(cells[i]);
    }
  }
  EXPECT_GT(clear, static_cast<int>(cells.size() * 3 / 4));
}

INSTANTIATE_TEST_SUITE_P(, StabilityMatrix, ::testing::ValuesIn(kTrials),
                         [](const auto& trial) { return std::string(name_of(trial.param)); });

INSTANTIATE_TEST_SUITE_P(Guides, StabilityMatrix, ::testing::ValuesIn(kGuideTrials),
                         [](const auto& trial) { return std::string(name_of(trial.param)); });

// The measurements detect an unstable loop: a plane that is far too stiff for its delay.
TEST(StabilityTrial, NoticesAnUnstableLoop) {
  StylusPreset hard = *find_stylus_preset("worst");
  hard.capabilities.max_stiffness_n_per_m = 1e6;
  const SurfaceMaterial steel{
      .id = "steel", .label = "Steel", .stiffness_n_per_m = 800.0, .damping_n_s_per_m = 0.0};
  const StabilityCell cell{.trial = Trial::kRest,
                           .device = &hard,
                           .hand = find_hand("light"),
                           .delay_ticks = 1,
                           .surface = &steel,
                           .tool = find_medium("pencil")};
  const StabilityResult result = run_trial(cell);
  EXPECT_FALSE(passes(result)) << result.high_frequency_n;
}

TEST(StabilityTrial, GivesTheSameTwice) {
  const auto cells = representative_cells(all_cells());
  for (const std::size_t i : {std::size_t{0}, cells.size() / 2, cells.size() - 1}) {
    const StabilityResult a = run_trial(cells[i]), b = run_trial(cells[i]);
    EXPECT_EQ(a.high_frequency_n, b.high_frequency_n);
    EXPECT_EQ(a.energy_mj, b.energy_mj);
  }
}

}  // namespace
}  // namespace felt::stability_test
