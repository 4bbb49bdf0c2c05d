#include "felt/devices/haply/json_scanner.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace felt::haply::json_scanner_test {
namespace {

using Json = nlohmann::json;

// Returns the document as text, rebuilt from the scanner's tokens, or nullopt if the scanner
// rejects it.
std::optional<std::string> rewritten(std::string_view text) {
  JsonScanner json(text);
  std::string out;
  bool wants_comma = false;
  for (;;) {
    const JsonToken token = json.next();
    const bool closes = token == JsonToken::kEndObject || token == JsonToken::kEndArray;
    if (wants_comma && !closes && token != JsonToken::kEnd) out += ',';
    wants_comma = token != JsonToken::kBeginObject && token != JsonToken::kBeginArray &&
                  token != JsonToken::kKey;
    switch (token) {
      case JsonToken::kBeginObject:
        out += '{';
        break;
      case JsonToken::kEndObject:
        out += '}';
        break;
      case JsonToken::kBeginArray:
        out += '[';
        break;
      case JsonToken::kEndArray:
        out += ']';
        break;
      case JsonToken::kKey:
        out += '"' + std::string(json.text()) + "\":";
        break;
      case JsonToken::kString:
        out += '"' + std::string(json.text()) + '"';
        break;
      case JsonToken::kNumber:
        out += Json(json.number()).dump();
        break;
      case JsonToken::kTrue:
        out += "true";
        break;
      case JsonToken::kFalse:
        out += "false";
        break;
      case JsonToken::kNull:
        out += "null";
        break;
      case JsonToken::kEnd:
        return out;
      case JsonToken::kBad:
        return std::nullopt;
    }
  }
}

Json random_json(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 7 : 5);
  switch (kind) {
    case 0:
      return nullptr;
    case 1:
      return *rc::gen::arbitrary<bool>();
    case 2:
      return *rc::gen::arbitrary<double>();
    case 3:
      return *rc::gen::string<std::string>();
    case 4:
      return *rc::gen::arbitrary<std::int32_t>();
    default:
      break;
  }
  Json many = kind == 5 ? Json::array() : Json::object();
  const int count = *rc::gen::inRange(0, 4);
  for (int i = 0; i < count; ++i) {
    if (kind == 5) {
      many.push_back(random_json(depth - 1));
    } else {
      many["k" + std::to_string(i)] = random_json(depth - 1);
    }
  }
  return many;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

// Compares the scanner with an independent implementation, nlohmann/json, for random documents.
RC_GTEST_PROP(JsonScanner, ReadsWhatAnotherWriterWrites, ()) {
  const Json json = random_json(4);
  const std::string text = text_of(json);
  const auto read = rewritten(text);
  RC_ASSERT(read.has_value());
  RC_ASSERT(Json::parse(*read) == Json::parse(text));
}

// Reads damaged documents. If the scanner accepts one, nlohmann/json must accept it too and read
// the same values.
RC_GTEST_PROP(JsonScanner, BelievesNothingThatAnotherReaderDoesNot, ()) {
  std::string text = text_of(random_json(3));
  const int changes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
    const char c =
        *rc::gen::elementOf(std::string("{}[]\",:0123456789eE+-.truefalsn \\ux\n\t\x01"));
    if (*rc::gen::arbitrary<bool>()) {
      text[at] = c;
    } else {
      text.erase(at, 1);
    }
  }
  const auto read = rewritten(text);
  if (!read) return;
  // The scanner returns the bytes unchanged. Therefore it does not detect half of a surrogate pair.
  const Json other = Json::parse(text, nullptr, false);
  RC_PRE(!other.is_discarded() || text.find("\\u") == std::string::npos);
  RC_ASSERT(!other.is_discarded());
  RC_ASSERT(Json::parse(*read) == other);
}

TEST(JsonScanner, RefusesWhatIsNoJson) {
  for (const char* text : {"",           " ",
                           "{",          "}",
                           "[1,]",       "[,1]",
                           "{\"a\"}",    "{\"a\":}",
                           "{\"a\":1,}", "{a:1}",
                           "[1 2]",      "01",
                           "-",          "1.",
                           ".5",         "1e",
                           "1e+",        "+1",
                           "NaN",        "Infinity",
                           "-Infinity",  "nan",
                           "1e999",      "-1e999",
                           "tru",        "truee",
                           "'a'",        "\"a",
                           "\"\\x\"",    "\"\\u12g4\"",
                           "\"a\nb\"",   "[1]]",
                           "{} {}",      "\xef\xbb\xbf{}",
                           "[1}",        "{\"a\":1]"}) {
    EXPECT_FALSE(rewritten(text).has_value()) << text;
  }
}

TEST(JsonScanner, DepthIsBounded) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_TRUE(rewritten(nested(JsonScanner::kMaxDepth)).has_value());
  EXPECT_FALSE(rewritten(nested(JsonScanner::kMaxDepth + 1)).has_value());
  EXPECT_FALSE(rewritten(std::string(100000, '[')).has_value());
}

TEST(JsonScanner, ValuesArePassedOver) {
  JsonScanner json(R"({"a":{"b":[1,{"c":"]}"}]},"d":[],"e":7})");
  ASSERT_EQ(json.next(), JsonToken::kBeginObject);
  ASSERT_EQ(json.next(), JsonToken::kKey);
  ASSERT_TRUE(json.skip_value());
  ASSERT_EQ(json.next(), JsonToken::kKey);
  EXPECT_EQ(json.text(), "d");
  ASSERT_TRUE(json.skip_value());
  ASSERT_EQ(json.next(), JsonToken::kKey);
  EXPECT_EQ(json.text(), "e");
  ASSERT_EQ(json.next(), JsonToken::kNumber);
  EXPECT_EQ(json.number(), 7.0);
  EXPECT_EQ(json.next(), JsonToken::kEndObject);
  EXPECT_EQ(json.next(), JsonToken::kEnd);
}

}  // namespace
}  // namespace felt::haply::json_scanner_test
