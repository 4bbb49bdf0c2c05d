#include "desktop/panels/color_contrast.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace felt::desktop::color_contrast_test {
namespace {

constexpr Rgba kWhite{255, 255, 255}, kBlack{}, kChalk{0xf4, 0xf1, 0xe6};

TEST(ColorContrast, IsThatOfWcag) {
  EXPECT_NEAR(contrast_of({0, 0, 0}, {255, 255, 255}), 21.0, 1e-9);
  EXPECT_NEAR(contrast_of({119, 119, 119}, {255, 255, 255}), 4.48, 0.01);
  EXPECT_EQ(seen_on({0, 0, 0, 0}, {1, 2, 3}), (Rgba{1, 2, 3}));
  EXPECT_EQ(seen_on({200, 100, 50, 255}, {1, 2, 3}), (Rgba{200, 100, 50}));
}

TEST(ColorContrast, OnlyColoursThatAlmostDisappearAreHardToSee) {
  EXPECT_TRUE(is_hard_to_see(kWhite, kWhite));
  EXPECT_TRUE(is_hard_to_see(kChalk, kWhite));
  EXPECT_TRUE(is_hard_to_see({0, 0, 0, 20}, kWhite)) << "almost transparent";
  EXPECT_TRUE(is_hard_to_see({0x2b, 0x2d, 0x31}, {0x20, 0x24, 0x22}));
  EXPECT_TRUE(is_hard_to_see(kWhite, {0, 0, 0, 0})) << "no paper is shown as white";
  EXPECT_TRUE(is_hard_to_see(kBlack, {0x34, 0x46, 0x3e})) << "black on the blackboard, 2.0:1";
  EXPECT_FALSE(is_hard_to_see({0x90, 0x90, 0x90}, kWhite)) << "a light pencil";
  EXPECT_FALSE(is_hard_to_see({255, 230, 0}, kWhite)) << "yellow is light, but no white";
  EXPECT_FALSE(is_hard_to_see(kBlack, kWhite));
  EXPECT_FALSE(is_hard_to_see(kChalk, {0x2f, 0x4f, 0x3f}));
}

TEST(ColorContrast, TheUsualColourIsOfferedIfItIsVisible) {
  const Rgba blue{0x20, 0x40, 0xa0};
  EXPECT_EQ(visible_instead_of(kWhite, blue, kWhite), blue);
  EXPECT_EQ(visible_instead_of({255, 255, 255, 200}, blue, kWhite), (Rgba{0x20, 0x40, 0xa0, 200}));
  EXPECT_EQ(visible_instead_of(kWhite, kChalk, kWhite), kBlack);
  EXPECT_EQ(visible_instead_of(kBlack, kBlack, {20, 20, 20}), kWhite);
  EXPECT_EQ(visible_instead_of({0, 0, 0, 5}, kBlack, kWhite), kBlack) << "opaque";
}

RC_GTEST_PROP(ColorContrast, WhatIsOfferedIsVisible, ()) {
  const auto any = [] {
    return Rgba{*rc::gen::arbitrary<std::uint8_t>(), *rc::gen::arbitrary<std::uint8_t>(),
                *rc::gen::arbitrary<std::uint8_t>(), *rc::gen::arbitrary<std::uint8_t>()};
  };
  const Rgba ink = any(), usual = any(), paper = any();
  RC_ASSERT(!is_hard_to_see(visible_instead_of(ink, usual, paper), paper));
}

}  // namespace
}  // namespace felt::desktop::color_contrast_test
