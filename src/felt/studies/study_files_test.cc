#include "felt/studies/study_files.h"

#include <gmock/gmock.h>

#include "felt/studies/testing/study_fixture.h"

namespace felt::study_files_test {
namespace {

using ::testing::HasSubstr;

class StudyFilesTest : public felt::testing::StudyFixture {
 protected:
  Result<StudyFiles> read(const std::string& shape, const std::string& condition = "") {
    write("s.toml", "id = \"s\"\n[[condition]]\nname = \"free\"\n" + condition +
                        "\n[[shape]]\nname = \"shape\"\n" + shape + "\n");
    return read_study_files(path("s.toml"));
  }
  std::string error_of(const std::string& shape, const std::string& condition = "") {
    const Result<StudyFiles> files = read(shape, condition);
    return files ? "no error" : files.error().message;
  }
};

Rect box_of(const std::vector<Point>& points) {
  Rect box;
  for (const Point p : points) box.extend(p);
  return box;
}

TEST_F(StudyFilesTest, PutsEachShapeInTheMiddleOfThePage) {
  const StudyFiles files = small_study();
  ASSERT_EQ(files.paths.size(), 2U);
  EXPECT_EQ(files.paths[0].ends, TrialPathEnds::kClosed);
  EXPECT_EQ(files.paths[1].ends, TrialPathEnds::kOpen);
  for (const StudyPath& path : files.paths) {
    EXPECT_NEAR(middle_of(box_of(path.points)).x, 148.5, 1e-9);
    EXPECT_NEAR(middle_of(box_of(path.points)).y, 105.0, 1e-9);
  }
  EXPECT_NEAR(box_of(files.paths[0].points).width(), 20.0, 1e-9);
  ASSERT_EQ(files.sources.size(), 1U);
  EXPECT_EQ(files.sources[0].first, "small.toml");
  EXPECT_EQ(files.sources[0].second, felt::testing::kSmallStudy);
}

TEST_F(StudyFilesTest, CopiesInTheRightHalfFromAModelInTheLeftHalf) {
  const StudyFiles files = read("kind = \"circle\"\ntask = \"copy\"\nsize_mm = 40").value();
  EXPECT_NEAR(middle_of(box_of(files.paths[0].points)).x, 222.75, 1e-9);
  EXPECT_NEAR(middle_of(box_of(model_of(files.paths[0]).points)).x, 74.25, 1e-9);
}

TEST_F(StudyFilesTest, ReadsAShapeFromADrawingAndScalesIt) {
  write("bow.ndjson",
        R"({"id":"s1","closed":false,"segments":[[0,0,10,20,30,20,40,0]],"joints":[],)"
        R"("widths":[[0,1],[1,1]]})"
        "\n");
  const StudyFiles own = read("file = \"bow.ndjson\"").value();
  EXPECT_NEAR(box_of(own.paths[0].points).width(), 40.0, 1e-9);
  EXPECT_NEAR(box_of(own.paths[0].points).height(), 15.0, 2e-3) << "the top of the curve";
  const StudyFiles large = read("file = \"bow.ndjson\"\nsize_mm = 80").value();
  EXPECT_NEAR(box_of(large.paths[0].points).width(), 80.0, 1e-9);
  EXPECT_NEAR(middle_of(box_of(large.paths[0].points)).x, 148.5, 1e-9);
  EXPECT_EQ(large.sources.at(1).first, "bow.ndjson");
}

TEST_F(StudyFilesTest, NamesTheLineAndTheKeyOfAShapeThatItCannotUse) {
  EXPECT_THAT(error_of("file = \"none.felt\""), HasSubstr("s.toml:6: shape.file: "));
  EXPECT_THAT(error_of("file = \"none.felt\""), HasSubstr("none.felt"));
  EXPECT_THAT(error_of("kind = \"line\"\nsize_mm = 298"),
              HasSubstr("s.toml:6: shape.size_mm: \"shape\" does not fit on the page"));
  EXPECT_THAT(error_of("kind = \"circle\"\nsize_mm = 211"), HasSubstr("does not fit"));
  EXPECT_THAT(error_of("kind = \"circle\"\ntask = \"copy\"\nsize_mm = 150"),
              HasSubstr("half a page"));
  write("two.ndjson", R"({"points":[[0,0],[9,0]]})"
                      "\n"
                      R"({"points":[[0,5],[9,5]]})"
                      "\n");
  EXPECT_THAT(error_of("file = \"two.ndjson\""), HasSubstr("two.ndjson has 2 lines"));
  EXPECT_THAT(error_of("file = \"study.toml\""), HasSubstr("is a name in the folder"));
  write("junk.felt", "junk");
  EXPECT_THAT(error_of("file = \"junk.felt\""), HasSubstr("junk.felt"));
}

TEST_F(StudyFilesTest, NeedsARecordingOfATeacher) {
  const std::string condition = "guidance = \"replayed-teacher\"\nteacher = \"t.ndjson\"";
  EXPECT_THAT(error_of("kind = \"line\"", condition), HasSubstr("s.toml:3: condition.teacher: "));
  write("t.ndjson", R"({"points":[[0,0],[9,0]]})"
                    "\n");
  EXPECT_THAT(error_of("kind = \"line\"", condition), HasSubstr("t.ndjson has no recording"));
}

TEST_F(StudyFilesTest, ReadsAllStudiesThatComeWithFeltline) {
  for (const char* name :
       {"improving-sketching", "keefe-2007", "langerak-complexity", "stabilisers"}) {
    const auto files = read_study_files("share/studies/" + std::string(name) + ".toml");
    EXPECT_TRUE(files) << files.error().message;
  }
}

}  // namespace
}  // namespace felt::study_files_test
