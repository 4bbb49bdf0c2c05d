#include "felt/timelapse/timelapse_film.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "felt/base/read_file.h"
#include "felt/timelapse/testing/drawn_recording.h"

namespace felt::timelapse_film_test {
namespace {

TEST(TimelapseFilm, TheFormatFollowsFromTheName) {
  EXPECT_EQ(timelapse_format_of("a.WebM"), TimelapseFormat::kWebm);
  EXPECT_EQ(timelapse_format_of("b/a.gif"), TimelapseFormat::kGif);
  EXPECT_EQ(timelapse_format_of("a.SVG"), TimelapseFormat::kSvg);
  EXPECT_EQ(timelapse_format_of("a.mp4"), std::nullopt);
}

RC_GTEST_PROP(TimelapseFilm, TheSizeHasTheShapeOfTheAreaAndAnEvenShorterSide, ()) {
  const int longer = *rc::gen::inRange(FilmOptions::kMinSidePx, FilmOptions::kMaxSidePx + 1);
  const double width = *rc::gen::inRange(1, 500), height = *rc::gen::inRange(1, 500);
  const FilmSize size = film_size(longer, {0.0, 0.0, width, height});
  const bool is_wide = width >= height;
  RC_ASSERT((is_wide ? size.width_px : size.height_px) == longer);
  const int shorter = is_wide ? size.height_px : size.width_px;
  RC_ASSERT(shorter % 2 == 0 || shorter == FilmOptions::kMinSidePx);
  const double exact = longer * std::min(width, height) / std::max(width, height);
  RC_ASSERT(shorter == FilmOptions::kMinSidePx || std::abs(shorter - exact) <= 1.0 + 1e-9);
}

TEST(TimelapseFilm, ACancelledSvgIsNotWritten) {
  const std::string path = ::testing::TempDir() + "/timelapse_film.svg";
  std::filesystem::remove(path);
  TimelapseSource source{felt::testing::random_recording(1, 6)};
  const auto survey = survey_recording(source);
  ASSERT_TRUE(survey);
  TimelapseFilm film;
  film.format = TimelapseFormat::kSvg;
  film.area = {0.0, 0.0, 100.0, 70.0};
  film.size = film_size(320, film.area);
  source.is_cancelled = [] { return true; };
  const Result<void> cancelled = write_timelapse(path, "it", source, *survey, film);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, path + ": cancelled");
  EXPECT_FALSE(std::filesystem::exists(path));
  source.is_cancelled = {};
  ASSERT_TRUE(write_timelapse(path, "it", source, *survey, film));
  EXPECT_NE(read_file(path, 1 << 26).value().find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace felt::timelapse_film_test
