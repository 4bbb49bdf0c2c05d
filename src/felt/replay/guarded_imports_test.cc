#include "felt/replay/guarded_imports.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "felt/base/atomic_file.h"

namespace felt::guarded_imports_test {
namespace {

TEST(GuardedImports, ReadInTheFolderOfTheScriptAndNeverTheOutput) {
  const std::string folder = ::testing::TempDir() + "/guarded_imports/";
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(write_file(folder + "a.svg", "<svg/>"));
  std::string asked;
  const ReadImport read = [&asked](const std::string& path) -> Result<VisibleInk> {
    asked = path;
    return VisibleInk{};
  };
  EXPECT_TRUE(guarded_imports(folder, {"", "-", folder + "b.svg"}, read)("a.svg"));
  EXPECT_EQ(asked, folder + "a.svg");
  EXPECT_TRUE(guarded_imports("elsewhere/", {}, read)(folder + "a.svg"));
  EXPECT_EQ(asked, folder + "a.svg") << "an absolute path stays";
  asked.clear();
  const auto refused = guarded_imports(folder, {folder + "./a.svg"}, read)("a.svg");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("would overwrite"), std::string::npos);
  EXPECT_EQ(asked, "") << "it was not read";
}

}  // namespace
}  // namespace felt::guarded_imports_test
