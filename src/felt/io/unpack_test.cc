#include "felt/io/unpack.h"

#include <gmock/gmock.h>
#include <zip.h>

#include <random>
#include <utility>

namespace felt::unpack_test {
namespace {

using ::testing::HasSubstr;

/// Returns a zip archive of these files, made by the library that we read with.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files) {
  zip_error_t error;
  zip_source_t* archive = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(archive);
  zip_t* zip = zip_open_from_source(archive, ZIP_TRUNCATE, &error);
  for (const auto& [name, text] : files) {
    zip_file_add(zip, name.c_str(), zip_source_buffer(zip, text.data(), text.size(), 0), 0);
  }
  EXPECT_EQ(zip_close(zip), 0);
  zip_source_open(archive);
  zip_source_seek(archive, 0, SEEK_END);
  std::string bytes(static_cast<std::size_t>(zip_source_tell(archive)), '\0');
  zip_source_seek(archive, 0, SEEK_SET);
  zip_source_read(archive, bytes.data(), bytes.size());
  zip_source_close(archive);
  zip_source_free(archive);
  return bytes;
}

std::string random_text(std::size_t size) {
  std::mt19937 random(7);
  std::string text;
  while (text.size() < size) text += static_cast<char>(random() & 0xff);
  return text;
}

TEST(Unpack, GzipAndBack) {
  for (const std::string& text : {std::string(), std::string("ink"), random_text(300'000)}) {
    const std::string packed = gzip(text);
    EXPECT_TRUE(is_gzip(packed));
    EXPECT_EQ(gunzip(packed).value(), text);
    EXPECT_EQ(packed, gzip(text));
    EXPECT_EQ(gunzip(packed + packed).value(), text + text) << "two members";
    EXPECT_EQ(gunzip(packed + "trailing").value(), text);
  }
}

TEST(Unpack, TheHeaderHoldsNoTimeAndNoSystem) {
  using namespace std::string_view_literals;
  EXPECT_EQ(gzip("ink").substr(0, 8), "\x1F\x8B\x08\0\0\0\0\0"sv);
  EXPECT_EQ(gzip("ink")[9], '\xFF');
}

TEST(Unpack, CutOrDamagedIsAnError) {
  const std::string packed = gzip(random_text(1000));
  for (std::size_t n = 0; n < packed.size(); ++n) EXPECT_FALSE(gunzip(packed.substr(0, n))) << n;
  EXPECT_THAT(gunzip(packed.substr(0, 500)).error().message, HasSubstr("is incomplete"));
  for (std::size_t n = 15; n < packed.size(); n += 7) {
    std::string damaged = packed;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x10);
    EXPECT_FALSE(gunzip(damaged)) << n;
  }
}

TEST(Unpack, LimitsBelowAtAndAbove) {
  const std::string packed = gzip(std::string(5000, 'a'));
  const auto fits = [&](std::size_t bytes) {
    return gunzip(packed, {.bytes = bytes, .free_bytes = 1 << 20}).has_value();
  };
  EXPECT_TRUE(fits(5001));
  EXPECT_TRUE(fits(5000));
  EXPECT_FALSE(fits(4999));
  const std::size_t ratio = (5000 + packed.size() - 1) / packed.size();
  const auto fits_ratio = [&](std::size_t largest) {
    return gunzip(packed, {.free_bytes = 100, .ratio = largest}).has_value();
  };
  EXPECT_TRUE(fits_ratio(ratio + 1));
  EXPECT_TRUE(fits_ratio(ratio));
  EXPECT_FALSE(fits_ratio(ratio - 1));
}

TEST(Unpack, ABombIsStoppedEarly) {
  const std::string bomb = gzip(std::string(std::size_t{64} << 20, ' '));
  ASSERT_LT(bomb.size(), 100'000u);
  const auto result = gunzip(bomb);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kLimitExceeded);
  const std::string zip = zip_of({{"content.xml", std::string(std::size_t{64} << 20, ' ')}});
  ASSERT_LT(zip.size(), 100'000u);
  EXPECT_EQ(file_in_zip(zip, "content.xml").error().code, ErrorCode::kLimitExceeded);
}

TEST(Unpack, FilesInZips) {
  const std::string zip = zip_of({{"a", "one"}, {"../b", "two"}});
  EXPECT_TRUE(is_zip(zip));
  EXPECT_EQ(file_in_zip(zip, "a").value(), "one");
  EXPECT_THAT(file_in_zip(zip, "c").error().message, HasSubstr("without a readable 'c'"));
  EXPECT_FALSE(file_in_zip(zip.substr(0, zip.size() / 2), "a"));
  EXPECT_FALSE(file_in_zip("PK\x03\x04", "a"));
  for (std::size_t n = 0; n < zip.size(); ++n) {
    std::string damaged = zip;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x40);
    const auto result = file_in_zip(damaged, "a");
    EXPECT_EQ(result.value_or("one"), "one") << n;
  }
}

}  // namespace
}  // namespace felt::unpack_test
