#include "felt/formats/fit_and_save.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "felt/formats/drawing_reader.h"
#include "tests/support/scratch_path.h"

namespace felt::fit_and_save_test {
namespace {

std::vector<InkSample> wave(double y_mm) {
  std::vector<InkSample> samples;
  for (int i = 0; i < 80; ++i) {
    samples.push_back(
        {{1.0 * i, y_mm + 5.0 * std::sin(0.1 * i)}, 0.5, std::int64_t{5'000'000} * i});
  }
  return samples;
}

class FitAndSave : public ::testing::Test {
 protected:
  FitAndSave() { std::filesystem::create_directory(folder_); }
  ~FitAndSave() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  std::filesystem::path folder_ = scratch_path("save");
};

TEST_F(FitAndSave, WhatIsSavedIsReadBackInItsOrder) {
  std::vector<Stroke> strokes;
  for (const double y_mm : {10.0, 30.0, 50.0}) strokes.push_back(fit_stroke(wave(y_mm)).value());
  for (const char* name : {"a.felt", "a.svg", "a.ndjson", "a.inkml"}) {
    ASSERT_TRUE(save_strokes(file(name), strokes)) << name;
    const auto read = read_drawing(file(name));
    ASSERT_TRUE(read) << name;
    const auto& back = read->drawing.document.layers()[0].strokes;
    ASSERT_EQ(back.size(), 3u) << name;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(read->drawing.document.find(back[i])->bounds().y0, strokes[i].bounds().y0, 0.01)
          << name;
    }
  }
}

TEST_F(FitAndSave, NoSampleNoStroke) {
  EXPECT_FALSE(fit_stroke({}));
  const std::vector<InkSample> nowhere{{{std::nan(""), 0.0}, std::nullopt, std::nullopt}};
  EXPECT_FALSE(fit_stroke(nowhere));
}

TEST_F(FitAndSave, AnUnknownEndingIsRefusedByName) {
  const auto saved = save_strokes(file("a.doc"), {});
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find("a.doc"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("a.doc")));
  EXPECT_TRUE(save_strokes(file("empty.felt"), {}));
}

}  // namespace
}  // namespace felt::fit_and_save_test
