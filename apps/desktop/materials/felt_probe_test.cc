#include "desktop/materials/felt_probe.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QSignalSpy>
#include <algorithm>

#include "desktop/materials/felt_plot.h"
#include "desktop/materials/stability_sign.h"
#include "desktop/materials/stability_words.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::desktop::felt_probe_test {
namespace {

FeltWish wish_of(const char* surface, const char* device = "touch") {
  return {.surface = *find_surface(surface),
          .medium = *find_medium("pencil"),
          .device = find_stylus_preset(device)->capabilities};
}

TEST(FeltProbe, AStrokeShowsItsFrictionAndItsGrain) {
  const FeltFigures wood = felt_figures(wish_of("wood")), glass = felt_figures(wish_of("glass"));
  ASSERT_GE(wood.drag_n.size(), 300u);
  EXPECT_TRUE(wood.is_sound);
  FeltPlot plot;
  plot.show_figures(wood);
  EXPECT_GT(plot.departure_n(), FeltPlot::kFeltN) << "docs/materials.md calls it felt";
  EXPECT_FALSE(plot.accessibleDescription().isEmpty());
  plot.show_figures(glass);
  EXPECT_LT(plot.departure_n(), FeltPlot::kFeltN);
  EXPECT_EQ(felt_figures(wish_of("wood")), wood) << "the same wish, the same figures";
}

TEST(FeltProbe, StrengthIsInWhatIsFelt) {
  FeltWish wish = wish_of("wood");
  const FeltFigures whole = felt_figures(wish);
  wish.strength = 0.5;
  const FeltFigures half = felt_figures(wish);
  ASSERT_EQ(half.drag_n.size(), whole.drag_n.size());
  EXPECT_NEAR(half.drag_n[100], 0.5 * whole.drag_n[100], 1e-12);
}

TEST(FeltProbe, TheNewestWishIsTheLastThatIsFigured) {
  FeltProbe probe;
  QSignalSpy figured(&probe, &FeltProbe::figured);
  FeltFigures last;
  QObject::connect(&probe, &FeltProbe::figured, [&last](const FeltFigures& f) { last = f; });
  for (const char* surface : {"paper", "canvas", "felt", "glass"}) probe.ask(wish_of(surface));
  while (probe.is_busy()) ASSERT_TRUE(figured.wait(8000));
  EXPECT_EQ(last, felt_figures(wish_of("glass")));
  EXPECT_LE(figured.count(), 2) << "those in between are nobody's wish any more";
}

TEST(Stability, WhatTheDeviceGivesAsWishedIsGreen) {
  const FeltWish wish = wish_of("paper", "omega");
  const StabilityWords words = stability_words(wish, felt_figures(wish), QStringLiteral("omega"));
  EXPECT_EQ(words.level, StabilityLevel::kGiven) << words.detail.join(u' ').toStdString();
  EXPECT_TRUE(words.detail.isEmpty());
  EXPECT_TRUE(words.number.contains(u'%'));
}

TEST(Stability, R55_AStiffSurfaceOnASlowDeviceIsRedAndSaysWhatTheDeviceMakesOfIt) {
  FeltWish wish = wish_of("paper");
  wish.surface.stiffness_n_per_m = 2000.0;
  wish.device.period_ns = 4'000'000;
  wish.device.delay_ticks = 2;
  const FeltFigures figures = felt_figures(wish);
  EXPECT_LT(figures.stiffness_n_per_m, 1000.0);
  EXPECT_LE(figures.budget_share, 1.0 + 1e-9) << "R56: however hard the wish";
  const StabilityWords words = stability_words(wish, figures, QStringLiteral("slow"));
  EXPECT_EQ(words.level, StabilityLevel::kNotGiven);
  EXPECT_TRUE(words.detail.join(u' ').remove(u',').contains(QStringLiteral("2000")))
      << "and not colour alone";
  StabilitySign sign;
  sign.show_words(words);
  EXPECT_EQ(sign.level(), StabilityLevel::kNotGiven);
  EXPECT_TRUE(sign.accessibleDescription().contains(words.state));
}

TEST(Stability, SteepGrainIsSaidToBeFeltLower) {
  FeltWish wish = wish_of("rough-paper");
  wish.surface.grain_um = 200.0;
  const FeltFigures figures = felt_figures(wish);
  EXPECT_LT(figures.grain_share, 0.5);
  EXPECT_EQ(felt_figures(wish_of("glass")).grain_share, 1.0);
  const StabilityWords words = stability_words(wish, figures, QStringLiteral("Touch"));
  EXPECT_NE(words.level, StabilityLevel::kGiven);
  EXPECT_TRUE(words.detail.join(u' ').contains(QStringLiteral("200")));
}

TEST(Stability, HeightsAreWrittenOutInWholeMicrometresFromTenOn) {
  FeltWish wish = wish_of("rough-paper");
  FeltFigures figures = felt_figures(wish);
  const auto words = [&](double wished_um, double share) {
    wish.surface.grain_um = wished_um;
    figures.grain_share = share;
    return stability_words(wish, figures, {}).detail.join(u' ');
  };
  const QString seven = QLocale().toString(7.0, 'f', 1);
  EXPECT_TRUE(words(200.0, 0.8).contains(QStringLiteral("you feel 160 of your 200 µm")));
  EXPECT_TRUE(words(14.0, 0.5).contains(QStringLiteral("you feel %1 of your 14 µm").arg(seven)));
}

TEST(Stability, TremblingIsRedWhateverElse) {
  const FeltWish wish = wish_of("paper");
  FeltFigures figures = felt_figures(wish);
  figures.rest_n = 0.035;
  EXPECT_EQ(stability_words(wish, figures, {}).level, StabilityLevel::kLess);
  figures.rest_n = 0.05;
  EXPECT_EQ(stability_words(wish, figures, {}).level, StabilityLevel::kNotGiven);
  figures.rest_n = 0.0;
  figures.is_sound = false;
  EXPECT_EQ(stability_words(wish, figures, {}).level, StabilityLevel::kNotGiven);
}

TEST(Stability, AMouseIsSaidToHaveNoMotors) {
  const FeltWish wish = wish_of("paper", "mouse");
  const FeltFigures figures = felt_figures(wish);
  EXPECT_FALSE(figures.drag_n.empty()) << "as on the Touch";
  const StabilityWords words = stability_words(wish, figures, QStringLiteral("Mouse"));
  ASSERT_FALSE(words.detail.isEmpty());
  EXPECT_TRUE(words.detail.first().contains(QStringLiteral("Mouse")));
}

}  // namespace
}  // namespace felt::desktop::felt_probe_test
