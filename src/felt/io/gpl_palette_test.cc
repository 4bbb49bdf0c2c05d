#include "felt/io/gpl_palette.h"

#include <gtest/gtest.h>

#include <random>

namespace felt::gpl_palette_test {
namespace {

std::string error_of(const std::string& text) {
  const Result<Palette> read = read_gpl("p.gpl", text);
  return read ? "" : read.error().message;
}

TEST(Palette, ReadsNameColumnsColoursAndComments) {
  const Result<Palette> read = read_gpl("p.gpl",
                                        "GIMP Palette\r\n"
                                        "Name: Box of pencils\r\n"
                                        "Columns: 4\r\n"
                                        "# made by hand\r\n"
                                        "\r\n"
                                        "  0   0   0\tBlack\r\n"
                                        "255 128 0 Signal  orange \r\n"
                                        "1 2 3");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->name, "Box of pencils");
  EXPECT_EQ(read->columns, 4U);
  const std::vector<NamedColor> wanted = {
      {{0, 0, 0}, "Black"}, {{255, 128, 0}, "Signal  orange"}, {{1, 2, 3}, ""}};
  EXPECT_EQ(read->colors, wanted);
}

TEST(Palette, ReadsTheOldFormWithoutAHeadAndAByteOrderMark) {
  const Result<Palette> read =
      read_gpl("p.gpl", "\xef\xbb\xbfGIMP Palette\n#\n9 8 7\tGr\xc3\xbcn\n");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->name, "");
  ASSERT_EQ(read->colors.size(), 1U);
  EXPECT_EQ(read->colors[0], (NamedColor{{9, 8, 7}, "Gr\xc3\xbcn"}));
}

TEST(Palette, SaysWhichLineIsWrongAndWhy) {
  const std::string head = "GIMP Palette\n";
  EXPECT_EQ(error_of(""), "p.gpl:1: not a GIMP palette: the first line does not match");
  EXPECT_EQ(error_of("gimp palette\n"),
            "p.gpl:1: not a GIMP palette: the first line does not match");
  const std::string no_color = ": a colour is three numbers from 0 to 255 and a name";
  for (const char* line : {"1 2", "1 2 256", "-1 2 3", "1 2 3x", "1.5 2 3", "name", "1,2,3",
                           "99999999999999999999 1 1"}) {
    EXPECT_EQ(error_of(head + "#\n" + line + "\n1 2 3\n"), "p.gpl:3" + no_color) << line;
  }
  for (const char* columns : {"", " x", " -1", " 65", " 4 4"}) {
    EXPECT_EQ(error_of(head + "Columns:" + columns + "\n"),
              "p.gpl:2: the columns are not a number from 0 to 64");
  }
  for (const char* name :
       {"\xff", "a\x01", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc2\x85"}) {
    EXPECT_EQ(error_of(head + "1 2 3 " + name + "\n"), "p.gpl:2: the name is not UTF-8 text");
    EXPECT_EQ(error_of(head + "Name: " + name + "\n"), "p.gpl:2: the name is not UTF-8 text");
  }
}

TEST(Palette, KeepsItsLimits) {
  const std::string head = "GIMP Palette\n";
  const std::string name(PaletteLimits::kMaxNameBytes, 'n');
  EXPECT_EQ(error_of(head + "1 2 3 " + name), "");
  EXPECT_EQ(error_of(head + "1 2 3 " + name + "n"), "p.gpl:2: the name is longer than 200 bytes");
  std::string many = head;
  for (std::size_t i = 0; i < PaletteLimits::kMaxColors; ++i) many += "1 2 3\n";
  EXPECT_EQ(error_of(many), "");
  EXPECT_EQ(error_of(many + "1 2 3\n"), "p.gpl:10002: there are more than 10000 colours");
  EXPECT_EQ(error_of(head + "#" + std::string(PaletteLimits::kMaxBytes, '-')),
            "p.gpl: is larger than 1 MiB, the limit for a palette");
}

TEST(Palette, WritesWhatItReads) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto word = [&random] {
      constexpr std::string_view kLetters[] = {
          "a", "Z", "#", "0", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x8e\xa8"};
      std::string text = random() % 2 ? "Name:" : "";
      for (std::size_t i = random() % 6; i-- > 0;) text += kLetters[random() % 7];
      return text;
    };
    Palette palette{word(), random() % (PaletteLimits::kMaxColumns + 1), {}};
    for (std::size_t i = random() % 20; i-- > 0;) {
      const auto part = [&random] { return static_cast<std::uint8_t>(random()); };
      palette.colors.push_back({{part(), part(), part()}, word()});
    }
    const Result<Palette> read = read_gpl("p.gpl", write_gpl(palette));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, palette);
  }
}

TEST(Palette, AnyBytesAreReadOrRefusedAndWhatIsReadIsWrittenAgain) {
  constexpr std::string_view kPieces[] = {
      "GIMP Palette\n", "Name: ", "Columns: ", "\n",  "255 ", "0\t", "#", "x", "\r",
      "\xc3",           "\xa4",   "-",         "300", " ",    "\x00"};
  std::size_t good = 0;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string text = random() % 8 ? "GIMP Palette\n" : "";
    for (std::size_t i = random() % 12; i-- > 0;) text += kPieces[random() % 15];
    const Result<Palette> read = read_gpl("p", text);
    if (!read) continue;
    ++good;
    const Result<Palette> again = read_gpl("p", write_gpl(*read));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(*again, *read);
  }
  EXPECT_GT(good, 500U) << "the pieces make palettes, too";
}

}  // namespace
}  // namespace felt::gpl_palette_test
