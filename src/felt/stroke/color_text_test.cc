#include "felt/stroke/color_text.h"

#include <gtest/gtest.h>

namespace felt::color_text_test {
namespace {

TEST(ColorText, ReadsTheThreeForms) {
  EXPECT_EQ(color_from_text("#fff"), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(color_from_text("#0a1b2c"), (Rgba{10, 27, 44, 255}));
  EXPECT_EQ(color_from_text("#0A1B2C80"), (Rgba{10, 27, 44, 128}));
}

TEST(ColorText, RefusesEverythingElse) {
  for (const char* text : {"", "#", "white", "#ff", "#ffff", "#fffff", "#gggggg", "#ff ff ff",
                           "0a1b2c", "#0a1b2c80ff"}) {
    EXPECT_EQ(color_from_text(text), std::nullopt) << text;
  }
}

TEST(ColorText, WritesWhatItReads) {
  for (const Rgba color : {Rgba{}, Rgba{1, 2, 3, 255}, Rgba{255, 0, 128, 0}}) {
    EXPECT_EQ(color_from_text(color_to_text(color)), color);
  }
  EXPECT_EQ(color_to_text(Rgba{0, 16, 255, 255}), "#0010ff");
}

}  // namespace
}  // namespace felt::color_text_test
