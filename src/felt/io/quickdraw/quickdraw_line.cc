#include "felt/io/quickdraw/quickdraw_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "felt/io/line_steps.h"
#include "felt/io/ndjson/ndjson_fields.h"
#include "felt/io/ndjson/ndjson_object.h"

namespace felt {
namespace {

using json::Field;
using json::Value;

/// The columns of a stroke, one array for each.
using InkColumns = std::array<std::vector<double>, 3>;
constexpr std::array<const char*, 3> kColumnNames = {"x", "y", "t"};

Result<void> parse_column(Value& value, std::size_t column, InkColumns& columns) {
  if (column >= columns.size()) return json::check_ignored(value);
  const json::NumberLimit limit = column == 2 ? json::kTimeLimit : json::kCoordinateLimit;
  columns[column].clear();
  return json::for_each_element(value, kColumnNames[column], [&](Value& item) -> Result<void> {
    const std::string_view token = json::token_of(item);
    double number = 0.0;
    if (!json::read_number(item, limit, number)) {
      return tl::unexpected(json::number_error(token, limit));
    }
    columns[column].push_back(number);
    return {};
  });
}

Result<void> parse_stroke(Value& value, std::vector<InkSample>& samples) {
  const std::string_view whole = json::token_of(value);
  simdjson::ondemand::array parts;
  if (value.get_array().get(parts)) {
    return json::bad(json::excerpt(whole) + " is not an array");
  }
  InkColumns columns;
  std::size_t count = 0;
  for (auto element : parts) {
    Value part;
    if (const auto error = element.get(part)) return tl::unexpected(json::syntax_error(error));
    if (Result<void> parsed = parse_column(part, count, columns); !parsed) return parsed;
    ++count;
  }
  const auto& [x, y, t] = columns;
  if (x.size() != y.size() || (count > 2 && t.size() != x.size())) {
    return json::bad("a stroke needs equal numbers of x, y and t");
  }
  if (x.empty()) return json::bad("a stroke needs at least one point");
  samples.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    InkSample sample{{x[i], y[i]}, {}, {}};
    if (count > 2) sample.time_ns = std::llround(t[i] * 1e6);
    samples.push_back(sample);
  }
  return {};
}

Result<void> parse_drawing(Value& value, QuickdrawRecord& out) {
  Result<void> done = json::for_each_element(value, "drawing", [&](Value& item) {
    out.strokes.emplace_back();
    return parse_stroke(item, out.strokes.back());
  });
  if (done && out.strokes.empty()) return json::bad("drawing: contains no stroke");
  return done;
}

Result<void> parse_word(Value& value, QuickdrawRecord& out) {
  Result<std::string> word = json::read_name(value);
  if (!word) return tl::unexpected(with_context(word.error(), "word"));
  out.word = *std::move(word);
  return {};
}

constexpr std::array kFields = {
    Field<QuickdrawRecord>{"word", false, parse_word},
    Field<QuickdrawRecord>{"key_id", false,
                           [](Value& v, QuickdrawRecord& r) {
                             Result<void> done = json::parse_id(v, r.key_id);
                             return done ? done
                                         : tl::unexpected(with_context(done.error(), "key_id"));
                           }},
    Field<QuickdrawRecord>{"drawing", true, parse_drawing},
};

}  // namespace

struct QuickdrawParser::State {
  simdjson::ondemand::parser parser;
};

QuickdrawParser::QuickdrawParser() : state_(std::make_unique<State>()) {}
QuickdrawParser::~QuickdrawParser() = default;
QuickdrawParser::QuickdrawParser(QuickdrawParser&&) noexcept = default;
QuickdrawParser& QuickdrawParser::operator=(QuickdrawParser&&) noexcept = default;

bool looks_like_quickdraw(std::string_view line) noexcept {
  const auto has = [&](std::string_view key) { return line.find(key) != std::string_view::npos; };
  return has("\"drawing\"") && !has("\"points\"") && !has("\"segments\"");
}

void restore_simplified(std::vector<InkSample>& stroke) {
  constexpr double kSide = 255.0, kFirstStep = 1.0, kMaxStep = 8.0;
  const auto is_simplified = [](const InkSample& s) {
    return !s.time_ns && s.position.x >= 0.0 && s.position.x <= kSide && s.position.y >= 0.0 &&
           s.position.y <= kSide;
  };
  if (stroke.size() > kMaxSimplifiedPoints ||
      !std::all_of(stroke.begin(), stroke.end(), is_simplified)) {
    return;
  }
  std::vector<InkSample> full;
  std::vector<double> steps;
  for (const InkSample& sample : stroke) {
    const Point from = full.empty() ? sample.position : full.back().position;
    line_steps(distance(from, sample.position), kFirstStep, kMaxStep, steps);
    for (const double t : steps) full.push_back({lerp(from, sample.position, t), {}, {}});
    full.push_back(sample);
  }
  stroke = std::move(full);
}

Result<void> QuickdrawParser::parse(const NdjsonLine& line, QuickdrawRecord& out) {
  out.word.clear();
  out.key_id.clear();
  out.strokes.clear();
  json::Fields<QuickdrawRecord> fields(kFields, out);
  const auto take = [&](std::string_view key, Value value) { return fields.take(key, value); };
  if (Result<void> walked = json::for_each_member(state_->parser, line, take); !walked) {
    return walked;
  }
  return fields.finish();
}

}  // namespace felt
