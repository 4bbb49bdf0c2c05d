#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "felt/trial/study_file.h"
#include "felt/trial/study_keys.h"
#include "felt/trial/study_order.h"

namespace felt::study_document_test {
namespace {

using ::testing::HasSubstr;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(StudyDocument, HasEveryKeyWithItsRange) {
  std::string table = "| key | allowed | without it | |\n|---|---|---|---|\n";
  for (const StudyKey& key : study_keys()) {
    table += "| `" + std::string(key.id) + "` | " + allowed_text(key) + " | " +
             std::string(key.fallback) + " | " + std::string(key.help) + " |\n";
  }
  EXPECT_THAT(text_of("docs/formats/study.md"), HasSubstr(table));
}

TEST(StudyDocument, HasAnExampleThatIsAStudy) {
  const std::string text = text_of("docs/formats/study.md");
  const std::size_t begin = text.find("```toml\n");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = text.find("```", begin + 8);
  for (const Error& error : study_problems(text.substr(begin + 8, end - begin - 8))) {
    ADD_FAILURE() << error.message;
  }
}

TEST(Studies, ThatAreSharedCanBePlanned) {
  int studies = 0;
  for (const auto& file : std::filesystem::directory_iterator("share/studies")) {
    if (file.path().extension() != ".toml") continue;
    const std::string name = file.path().filename().string();
    const std::string text = text_of(file.path());
    for (const Error& error : study_problems(text, name)) ADD_FAILURE() << error.message;
    const Result<Study> study = read_study(text, name);
    ASSERT_TRUE(study);
    EXPECT_EQ(study->id + ".toml", name);
    for (const SessionKind session : study->sessions) {
      const auto trials = plan_trials(*study, 1, session);
      ASSERT_TRUE(trials);
      EXPECT_EQ(trials->size(), trial_count(*study, session));
    }
    ++studies;
  }
  EXPECT_GE(studies, 3);
}

}  // namespace
}  // namespace felt::study_document_test
