#include "felt/driver/dynamic_library.h"
#include "tests/support/scratch_path.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

namespace felt::dynamic_library_test {
namespace {

using ::testing::HasSubstr;
using Names = std::vector<std::string>;

// Both are part of every glibc. This program does not link against kUnused.
const std::string kPresent = "libm.so.6";
const std::string kUnused = "libanl.so.1";

bool is_loaded(const std::string& name) {
  void* handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

TEST(DynamicLibrary, TakesTheFirstNameThatIsThere) {
  const Names names{"libfelt-is-not-there.so", kPresent, kUnused};
  const auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsUsed);
  ASSERT_TRUE(library.has_value());
  EXPECT_EQ(library->name(), kPresent);
  EXPECT_THAT(library->path(), HasSubstr("/libm"));
  EXPECT_NE(library->symbol("cos"), nullptr);
  EXPECT_EQ(library->symbol("felt_is_not_there"), nullptr);
}

TEST(DynamicLibrary, ErrorHasEachNameWithTheLoadersOwnWords) {
  const std::filesystem::path broken = scratch_path("broken-library.so");
  std::ofstream(broken) << "this is no library at all, whatever it is called";
  const Names names{"libfelt-is-not-there.so", "", broken.string()};
  const auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsUsed);
  std::filesystem::remove(broken);
  ASSERT_FALSE(library.has_value());
  EXPECT_EQ(library.error().code, ErrorCode::kNotFound);
  const std::string& message = library.error().message;
  EXPECT_THAT(message, HasSubstr("\"libfelt-is-not-there.so\": libfelt-is-not-there.so: cannot"));
  EXPECT_THAT(message, HasSubstr("\"\": no name"));
  EXPECT_THAT(message, HasSubstr(broken.string() + ": "));
  EXPECT_FALSE(DynamicLibrary::open({}, LibraryLife::kAsLongAsUsed).has_value());
}

TEST(DynamicLibrary, IsUnloadedWithItsLastUser) {
  ASSERT_FALSE(is_loaded(kUnused)) << "this program loads it itself: choose another one";
  {
    auto first = DynamicLibrary::open(Names{kUnused}, LibraryLife::kAsLongAsUsed);
    ASSERT_TRUE(first.has_value());
    DynamicLibrary second = std::move(*first);
    EXPECT_EQ(second.name(), kUnused);
    auto third = DynamicLibrary::open(Names{kPresent}, LibraryLife::kAsLongAsUsed);
    ASSERT_TRUE(third.has_value());
    EXPECT_TRUE(is_loaded(kUnused));
    second = std::move(*third);
    EXPECT_EQ(second.name(), kPresent);
    EXPECT_FALSE(is_loaded(kUnused));
  }
  { auto kept = DynamicLibrary::open(Names{kUnused}, LibraryLife::kAsLongAsProgram); }
  EXPECT_TRUE(is_loaded(kUnused));
}

TEST(SymbolLoader, FindsFunctionsOfTheirTypesAndNamesAllThatAreMissing) {
  const auto library = DynamicLibrary::open(Names{kPresent}, LibraryLife::kAsLongAsUsed);
  ASSERT_TRUE(library.has_value());
  SymbolLoader symbols(*library);
  double (*cosine)(double) = nullptr;
  symbols.require(cosine, "cos");
  ASSERT_NE(cosine, nullptr);
  EXPECT_DOUBLE_EQ(cosine(0.0), 1.0);
  int (*newer)(int) = nullptr;
  EXPECT_FALSE(symbols.find(newer, "felt_newer"));
  EXPECT_TRUE(symbols.done().has_value());

  void (*first)() = nullptr;
  void (*second)() = nullptr;
  symbols.require(first, "felt_first");
  symbols.require(second, "felt_second");
  EXPECT_EQ(first, nullptr);
  const auto done = symbols.done();
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(done.error().message, HasSubstr("it lacks felt_first, felt_second"));
  EXPECT_THAT(done.error().message, HasSubstr("libm"));
}

}  // namespace
}  // namespace felt::dynamic_library_test
