#include "desktop/materials/force_probe.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QSignalSpy>
#include <algorithm>

#include "desktop/materials/probe_plot.h"
#include "desktop/materials/stability_sign.h"
#include "desktop/materials/stability_words.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::desktop::force_probe_test {
namespace {

ProbeRequest wish_of(const char* surface, const char* device = "touch") {
  return {.surface = *find_surface(surface),
          .medium = *find_medium("pencil"),
          .device = find_stylus_preset(device)->capabilities};
}

TEST(ForceProbe, AStrokeShowsItsFrictionAndItsGrain) {
  const ProbeFigures wood = probe_figures(wish_of("wood")), glass = probe_figures(wish_of("glass"));
  ASSERT_GE(wood.drag_n.size(), 300u);
  EXPECT_TRUE(wood.is_sound);
  ProbePlot plot;
  plot.show_figures(wood);
  EXPECT_GT(plot.departure_n(), ProbePlot::kFeltN) << "docs/materials.md calls it felt";
  EXPECT_FALSE(plot.accessibleDescription().isEmpty());
  plot.show_figures(glass);
  EXPECT_LT(plot.departure_n(), ProbePlot::kFeltN);
  EXPECT_EQ(probe_figures(wish_of("wood")), wood) << "the same request, the same figures";
}

TEST(ForceProbe, StrengthIsInWhatIsFelt) {
  ProbeRequest request = wish_of("wood");
  const ProbeFigures whole = probe_figures(request);
  request.strength = 0.5;
  const ProbeFigures half = probe_figures(request);
  ASSERT_EQ(half.drag_n.size(), whole.drag_n.size());
  EXPECT_NEAR(half.drag_n[100], 0.5 * whole.drag_n[100], 1e-12);
}

TEST(ForceProbe, TheNewestWishIsTheLastThatIsFigured) {
  ForceProbe probe;
  QSignalSpy figured(&probe, &ForceProbe::figured);
  ProbeFigures last;
  QObject::connect(&probe, &ForceProbe::figured, [&last](const ProbeFigures& f) { last = f; });
  for (const char* surface : {"paper", "canvas", "felt", "glass"}) probe.ask(wish_of(surface));
  while (probe.is_busy()) ASSERT_TRUE(figured.wait(8000));
  EXPECT_EQ(last, probe_figures(wish_of("glass")));
  EXPECT_LE(figured.count(), 2) << "those in between are nobody's request any more";
}

TEST(Stability, WhatTheDeviceGivesAsWishedIsGreen) {
  const ProbeRequest request = wish_of("paper", "omega");
  const StabilityWords words =
      stability_words(request, probe_figures(request), QStringLiteral("omega"));
  EXPECT_EQ(words.level, StabilityLevel::kGiven) << words.detail.join(u' ').toStdString();
  EXPECT_TRUE(words.detail.isEmpty());
  EXPECT_TRUE(words.number.contains(u'%'));
}

TEST(Stability, R55_AStiffSurfaceOnASlowDeviceIsRedAndSaysWhatTheDeviceMakesOfIt) {
  ProbeRequest request = wish_of("paper");
  request.surface.stiffness_n_per_m = 2000.0;
  request.device.period_ns = 4'000'000;
  request.device.delay_ticks = 2;
  const ProbeFigures figures = probe_figures(request);
  EXPECT_LT(figures.stiffness_n_per_m, 1000.0);
  EXPECT_LE(figures.budget_share, 1.0 + 1e-9) << "R56: however hard the request";
  const StabilityWords words = stability_words(request, figures, QStringLiteral("slow"));
  EXPECT_EQ(words.level, StabilityLevel::kNotGiven);
  EXPECT_TRUE(words.detail.join(u' ').remove(u',').contains(QStringLiteral("2000")))
      << "and not colour alone";
  StabilitySign sign;
  sign.show_words(words);
  EXPECT_EQ(sign.level(), StabilityLevel::kNotGiven);
  EXPECT_TRUE(sign.accessibleDescription().contains(words.state));
}

TEST(Stability, SteepGrainIsSaidToBeFeltLower) {
  ProbeRequest request = wish_of("rough-paper");
  request.surface.grain_um = 200.0;
  const ProbeFigures figures = probe_figures(request);
  EXPECT_LT(figures.grain_share, 0.5);
  EXPECT_EQ(probe_figures(wish_of("glass")).grain_share, 1.0);
  const StabilityWords words = stability_words(request, figures, QStringLiteral("Touch"));
  EXPECT_NE(words.level, StabilityLevel::kGiven);
  EXPECT_TRUE(words.detail.join(u' ').contains(QStringLiteral("200")));
}

TEST(Stability, HeightsAreWrittenOutInWholeMicrometresFromTenOn) {
  ProbeRequest request = wish_of("rough-paper");
  ProbeFigures figures = probe_figures(request);
  const auto words = [&](double wished_um, double share) {
    request.surface.grain_um = wished_um;
    figures.grain_share = share;
    return stability_words(request, figures, {}).detail.join(u' ');
  };
  const QString seven = QLocale().toString(7.0, 'f', 1);
  EXPECT_TRUE(words(200.0, 0.8).contains(QStringLiteral("you feel 160 of your 200 µm")));
  EXPECT_TRUE(words(14.0, 0.5).contains(QStringLiteral("you feel %1 of your 14 µm").arg(seven)));
}

TEST(Stability, TremblingIsRedWhateverElse) {
  const ProbeRequest request = wish_of("paper");
  ProbeFigures figures = probe_figures(request);
  figures.rest_n = 0.035;
  EXPECT_EQ(stability_words(request, figures, {}).level, StabilityLevel::kLess);
  figures.rest_n = 0.05;
  EXPECT_EQ(stability_words(request, figures, {}).level, StabilityLevel::kNotGiven);
  figures.rest_n = 0.0;
  figures.is_sound = false;
  EXPECT_EQ(stability_words(request, figures, {}).level, StabilityLevel::kNotGiven);
}

TEST(Stability, AMouseIsSaidToHaveNoMotors) {
  const ProbeRequest request = wish_of("paper", "mouse");
  const ProbeFigures figures = probe_figures(request);
  EXPECT_FALSE(figures.drag_n.empty()) << "as on the Touch";
  const StabilityWords words = stability_words(request, figures, QStringLiteral("Mouse"));
  ASSERT_FALSE(words.detail.isEmpty());
  EXPECT_TRUE(words.detail.first().contains(QStringLiteral("Mouse")));
}

}  // namespace
}  // namespace felt::desktop::force_probe_test
