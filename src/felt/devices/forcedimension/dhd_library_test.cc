#include "felt/devices/forcedimension/dhd_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/driver/testing/fake_system.h"

namespace felt::dhd::dhd_library_test {
namespace {

using ::testing::ElementsAre;

TEST(DhdLibrary, WhatAPersonNamesIsAllThatIsTried) {
  FakeSystem system;
  system.set_environment("FDSDK", "/opt/sdk").add_file("/opt/sdk/lib/libdrd.so");
  EXPECT_THAT(library_names(system, "/mine/libdrd.so.3"), ElementsAre("/mine/libdrd.so.3"));
}

TEST(DhdLibrary, IsLookedForInTheSdkThenAtHomeThenInTheSystemDrdFirst) {
  FakeSystem system;
  system.set_environment("FORCEDIM_SDK", "/opt/sdk")
      .set_environment("HOME", "/home/ada")
      .add_file("/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so.3.17.5")
      .add_file("/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so.3.9.0")
      .add_file("/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so")
      .add_file("/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.a")
      .add_file("/opt/sdk/lib/release/lin-x86_64-gcc/libdhd.so")
      .add_file("/opt/sdk/lib/release/mac-arm64-clang/libdrd.so")
      .add_file("/opt/sdk/lib/libdrd.so")
      .add_file("/home/ada/.local/lib/libdrd.so.3")
      .add_file("/usr/local/lib/libdrdx.so");
  EXPECT_THAT(
      library_names(system, ""),
      ElementsAre("/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so",
                  "/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so.3.9.0",
                  "/opt/sdk/lib/release/lin-x86_64-gcc/libdrd.so.3.17.5", "/opt/sdk/lib/libdrd.so",
                  "/home/ada/.local/lib/libdrd.so.3", "libdrd.so", "libdrd.so.3",
                  "/opt/sdk/lib/release/lin-x86_64-gcc/libdhd.so", "libdhd.so", "libdhd.so.3"));
}

TEST(DhdLibrary, WithoutAnythingTheSystemIsAsked) {
  EXPECT_THAT(library_names(FakeSystem(), ""),
              ElementsAre("libdrd.so", "libdrd.so.3", "libdhd.so", "libdhd.so.3"));
}

TEST(DhdLibrary, ALibraryThatIsAnotherNamesWhatItLacks) {
  const auto loaded = Library::load({"libm.so.6"});
  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(loaded.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(loaded.error().message, ::testing::HasSubstr("dhdGetPosition"));
}

TEST(DhdLibrary, OneThatIsNotThereIsToldInTheLoadersWords) {
  const auto loaded = Library::load({"/no/such/libdrd.so"});
  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(loaded.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(loaded.error().message, ::testing::HasSubstr("cannot open shared object file"));
}

}  // namespace
}  // namespace felt::dhd::dhd_library_test
