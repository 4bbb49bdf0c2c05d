#include "felt/store/stroke_blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_blob_test {
namespace {

using ::testing::HasSubstr;

std::string blob_of(const Stroke& stroke) {
  std::string bytes;
  EXPECT_TRUE(append_stroke_blob(bytes, stroke));
  return bytes;
}

/// Returns true if the strokes are equal bit for bit: -0.0 differs from 0.0 here.
bool same_bits(const StrokeData& a, const StrokeData& b) {
  return a == b &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0 &&
         std::memcmp(a.widths.data(), b.widths.data(), a.widths.size() * sizeof(WidthKnot)) == 0;
}

TEST(Crc32c, GivesTheValuesOfTheStandard) {
  EXPECT_EQ(crc32c("123456789"), 0xe3069283u);
  EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8a9136aau);
  EXPECT_EQ(crc32c(std::string(32, '\xff')), 0x62a8ab43u);
  const std::string text = "one after another, in pieces of any length";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    EXPECT_EQ(crc32c(text.substr(cut), crc32c(text.substr(0, cut))), crc32c(text));
  }
}

TEST(StrokeBlob, EveryStrokeReadsBackToTheBit) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    StrokeData data = felt::testing::random_stroke(seed).data();
    data.medium = seed % 3 == 0 ? "pencil" : seed % 3 == 1 ? "" : "Füller\n\"2\"";
    if (seed % 5 == 0) data.points[1].x = -0.0;
    Result<Stroke> stroke = Stroke::create(data);
    if (!stroke) continue;
    const std::string bytes = blob_of(*stroke);
    const Result<Stroke> back = read_stroke_blob(bytes);
    ASSERT_TRUE(back) << "seed " << seed << ": " << back.error().message;
    ASSERT_TRUE(same_bits(back->data(), data)) << "seed " << seed;
    ASSERT_EQ(blob_of(*back), bytes) << "seed " << seed;
  }
}

TEST(StrokeBlob, WhatIsCutOffOrChangedIsNoStroke) {
  const std::string bytes = blob_of(felt::testing::random_stroke(7));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_stroke_blob(bytes.substr(0, size))) << size;
  }
  EXPECT_FALSE(read_stroke_blob(bytes + '\0'));
  std::mt19937 random(1);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ (1 << (random() % 8)));
    EXPECT_FALSE(read_stroke_blob(changed)) << "byte " << i;
  }
}

/// Tests damage with a correct checksum, as an attacker would make it.
TEST(StrokeBlob, HostileBytesAreAnErrorOrAStroke) {
  std::mt19937 random(2);
  for (int run = 0; run < 20'000; ++run) {
    std::string bytes = blob_of(felt::testing::random_stroke(random() % 50));
    bytes.resize(bytes.size() - 4);
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 4 == 0) bytes.resize(1 + random() % bytes.size());
    const std::uint32_t crc = crc32c(bytes);
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>((crc >> (8 * i)) & 0xff);
    if (const Result<Stroke> stroke = read_stroke_blob(bytes)) {
      EXPECT_TRUE(check_invariants(stroke->data()));
    }
  }
}

/// Counts are checked before memory is allocated, because the file may not have so many bytes.
TEST(StrokeBlob, LimitsAreKeptExactly) {
  const auto read = [](std::uint64_t segments, std::uint64_t knots) {
    std::string bytes("\1\0\0\0\0\xff\0", 7);
    ByteWriter out(bytes);
    out.count(segments);
    out.count(knots);
    out.u32(crc32c(bytes));
    return read_stroke_blob(bytes).error();
  };
  for (const std::size_t less : {1U, 0U}) {
    EXPECT_THAT(read(kMaxStrokeSegments - less, 2).message, HasSubstr("fewer points"));
    EXPECT_THAT(read(1, kMaxStrokeKnots - less).message, HasSubstr("fewer points"));
  }
  EXPECT_EQ(read(kMaxStrokeSegments + 1, 2).code, ErrorCode::kLimitExceeded);
  EXPECT_EQ(read(1, kMaxStrokeKnots + 1).code, ErrorCode::kLimitExceeded);
  EXPECT_EQ(read(~std::uint64_t{0}, 2).code, ErrorCode::kLimitExceeded);
  EXPECT_THAT(read(0, 2).message, HasSubstr("no segment"));
  EXPECT_THAT(read(1, 1).message, HasSubstr("no width"));
  StrokeData data = felt::testing::random_stroke(1).data();
  for (const std::size_t size :
       {kMaxMaterialNameBytes - 1, kMaxMaterialNameBytes, kMaxMaterialNameBytes + 1}) {
    data.medium = std::string(size, 'm');
    const Stroke stroke = Stroke::create(data).value();
    std::string bytes;
    EXPECT_EQ(append_stroke_blob(bytes, stroke).has_value(), size <= kMaxMaterialNameBytes);
    if (size <= kMaxMaterialNameBytes) {
      EXPECT_TRUE(read_stroke_blob(bytes).value() == stroke);
    }
  }
}

/// A stroke without own tones is written as before strokes had tones, byte for byte: one segment
/// from (0, 0) to (3, 0), 0.5 to 1 mm wide.
TEST(StrokeBlob, WithoutTonesOfItsOwnItIsWhatItEverWas) {
  const Stroke stroke = felt::testing::straight_stroke({0, 0}, {3, 0}, 0.5, 1.0);
  const std::string bytes = blob_of(stroke);
  EXPECT_EQ(bytes.substr(0, 2), std::string("\1\0", 2));
  constexpr char kOld[] =
      "\x01\x00\x00\x00\x00\xff\x06pencil\x01\x02\x00\x0a\x09\x0a\xaa\xf0\x3f\x40\x08\x40\xe0\x3f"
      "\xf0"
      "\x3f\x67\x5c\xd9\x86";
  EXPECT_EQ(bytes, std::string(kOld, sizeof kOld - 1));
  EXPECT_TRUE(read_stroke_blob(bytes).value() == stroke);
}

TEST(StrokeBlob, TonesMakeItVersion2) {
  StrokeData data = felt::testing::straight_stroke({0, 0}, {3, 0}, 0.5, 1.0).data();
  data.widths[0].tone = 0.75;
  const std::string bytes = blob_of(Stroke::create(data).value());
  EXPECT_EQ(bytes[0], 2);
  EXPECT_TRUE(read_stroke_blob(bytes).value().data() == data);
}

/// Tests hostile bytes with a correct checksum.
TEST(StrokeBlob, TonesThatAreNoneAreAnErrorThatNamesThePlace) {
  StrokeData data = felt::testing::straight_stroke({0, 0}, {3, 0}, 0.5, 1.0).data();
  data.widths[0].tone = 0.75;
  data.widths[1].tone = 0.75;  // takes no byte, because it equals the tone before it
  std::string bytes = blob_of(Stroke::create(data).value());
  bytes.resize(bytes.size() - 4);
  const auto with_tone = [&](double tone) {
    std::string made = bytes;
    const std::size_t at = made.rfind('\xe8');  // 0.75 = 3fe8 0000 0000 0000
    const auto bits = std::bit_cast<std::uint64_t>(tone);
    made[at] = static_cast<char>((bits >> 48) & 0xff);
    made[at + 1] = static_cast<char>((bits >> 56) & 0xff);
    ByteWriter(made).u32(crc32c(made));
    return read_stroke_blob(made);
  };
  EXPECT_TRUE(with_tone(0.75));
  EXPECT_TRUE(with_tone(1.0));
  EXPECT_THAT(with_tone(1.5).error().message, HasSubstr("I7: width breakpoint 0 has tone 1.5"));
  EXPECT_THAT(with_tone(-0.5).error().message, HasSubstr("I7: width breakpoint 0 has tone -0.5"));
  EXPECT_THAT(with_tone(std::numeric_limits<double>::infinity()).error().message,
              HasSubstr("I3: width breakpoint 0 is not finite"));
}

TEST(StrokeBlob, SaysWhatIsWrong) {
  std::string bytes = blob_of(felt::testing::random_stroke(1));
  bytes[0] = 9;
  EXPECT_THAT(read_stroke_blob(bytes).error().message, HasSubstr("version 9"));
  EXPECT_EQ(read_stroke_blob(bytes).error().code, ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace felt::stroke_blob_test
