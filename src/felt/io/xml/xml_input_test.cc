#include "felt/io/xml/xml_input.h"

#include <gmock/gmock.h>

namespace felt::xml_input_test {
namespace {

using ::testing::HasSubstr;

std::string error_of(std::string_view text, const XmlLimits& limits = {}) {
  const Result<XmlInput> input = XmlInput::parse(text, limits);
  return input ? "" : input.error().message;
}

TEST(XmlInput, KnowsTheLineOfEachElement) {
  std::string text = "<?xml version=\"1.0\"?>\r\n<a>\n";
  for (int i = 0; i < 5000; ++i) text += "<b n='" + std::to_string(i) + "'/>\n";
  text += "</a>";
  const XmlInput input = XmlInput::parse(text).value();
  EXPECT_EQ(input.line_of(input.root()), 2);
  std::int64_t line = 3;
  for (const pugi::xml_node& b : input.root().children()) EXPECT_EQ(input.line_of(b), line++);
}

TEST(XmlInput, TakesLimitsExactly) {
  const std::string deep3 = "<a><b><c/></b></a>", deep4 = "<a><b><c><d/></c></b></a>";
  EXPECT_EQ(error_of(deep3, {.depth = 3}), "");
  EXPECT_EQ(error_of(deep3, {.depth = 4}), "");
  EXPECT_THAT(error_of(deep4, {.depth = 3}),
              HasSubstr("line 1: elements are nested deeper than 3"));
  EXPECT_EQ(error_of("<a><b/><b/></a>", {.elements = 3}), "");
  EXPECT_THAT(error_of("<a>\n<b/><b/>\n<b></b></a>", {.elements = 3}),
              HasSubstr("line 3: has more than 3 elements"));
  EXPECT_EQ(error_of("<a/>", {.bytes = 4}), "");
  EXPECT_THAT(error_of("<a/> ", {.bytes = 4}), HasSubstr("is larger than 4 bytes"));
}

TEST(XmlInput, TheRealLimitsHold) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<g>";
    for (int i = 0; i < depth; ++i) text += "</g>";
    return text;
  };
  EXPECT_EQ(error_of(nested(255)), "");
  EXPECT_EQ(error_of(nested(256)), "");
  EXPECT_THAT(error_of(nested(257)), HasSubstr("nested deeper than 256"));
  EXPECT_THAT(error_of(nested(200'000)), HasSubstr("nested deeper than 256"));
  const auto many = [](std::size_t count) {
    std::string text = "<a>";
    for (std::size_t i = 1; i < count; ++i) text += "<b/>";
    return text + "</a>";
  };
  EXPECT_EQ(error_of(many(limits::kMaxXmlElements)), "");
  EXPECT_THAT(error_of(many(limits::kMaxXmlElements + 1)), HasSubstr("more than 2000000 elements"));
}

TEST(XmlInput, WhatIsNoWholeCommentHidesNothing) {
  // "<!-->" begins a comment and does not end it, so the elements below are elements.
  for (const char* start : {"<!--><![CDATA[ -->", "<!--> <!-- -->", "<?><![CDATA[ ?>"}) {
    const std::string text = std::string("<a>") + start + "<b><c><d/></c></b><!-- ]]> --></a>";
    EXPECT_THAT(error_of(text, {.depth = 3}), HasSubstr("nested deeper than 3")) << text;
    EXPECT_THAT(error_of(text, {.elements = 3}), HasSubstr("more than 3 elements")) << text;
  }
}

TEST(XmlInput, TextThatLooksLikeTagsIsNotCounted) {
  EXPECT_EQ(error_of("<a t='<b><c>'><!-- <d><e> --><![CDATA[<f><g>]]><?p <h> ?></a>",
                     {.elements = 1, .depth = 1}),
            "");
}

TEST(XmlInput, RefusesDefinitionsOfEntities) {
  EXPECT_THAT(error_of("<!DOCTYPE a [<!ENTITY b 'bb'>]><a>&b;</a>"),
              HasSubstr("a document type with internal definitions"));
  EXPECT_EQ(error_of("<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x.dtd\"><svg/>"), "");
}

TEST(XmlInput, SaysWhereItIsNoXml) {
  EXPECT_THAT(error_of("<a>\n<b>\n</a>"), HasSubstr("line 3: is not XML"));
  EXPECT_THAT(error_of(""), HasSubstr("is not XML"));
  EXPECT_THAT(error_of("hello"), HasSubstr("is not XML"));
  EXPECT_THAT(error_of("<a>\xff</a>"), HasSubstr("is not UTF-8"));
}

TEST(XmlInput, ReadsOtherEncodings) {
  const auto text_of = [](std::string_view bytes) {
    return xml_text_of(XmlInput::parse(bytes).value().root());
  };
  EXPECT_EQ(text_of("\xEF\xBB\xBF<a>\xC3\xA9</a>"), "\xC3\xA9");
  EXPECT_EQ(text_of("<?xml version='1.0' encoding='ISO-8859-1'?><a>\xE9</a>"), "\xC3\xA9");
  using namespace std::string_view_literals;
  EXPECT_EQ(text_of("\xFF\xFE<\0a\0>\0\xE9\0<\0/\0a\0>\0"sv), "\xC3\xA9");
  EXPECT_EQ(text_of("\xFE\xFF\0<\0a\0>\xD8\x3D\xDE\x00\0<\0/\0a\0>"sv), "\xF0\x9F\x98\x80");
}

TEST(XmlInput, CutAnywhereItIsAnErrorNotACrash) {
  const std::string text = "<?xml version='1.0'?><!-- x --><a b='<'><![CDATA[x]]><c/>\n</a>";
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_NE(error_of(text.substr(0, n)), "");
}

}  // namespace
}  // namespace felt::xml_input_test
