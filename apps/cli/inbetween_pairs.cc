#include "inbetween_pairs.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "felt/document/visible_strokes.h"

namespace felt::cli {
namespace {

constexpr std::string_view kNoStroke = "none";

std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> words{""};
  for (const char c : text) {
    if (c == ':') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

std::optional<std::uint64_t> whole_number_of(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Result<std::optional<std::size_t>> find_stroke(const std::string& name, const KeyStrokes& key,
                                               std::size_t number) {
  if (name == kNoStroke) return std::optional<std::size_t>();
  const auto id = whole_number_of(name.starts_with('s') ? name.substr(1) : name);
  const auto found = std::find(key.ids.begin(), key.ids.end(), StrokeId{id.value_or(0)});
  if (!id || found == key.ids.end()) {
    return fail(ErrorCode::kNotFound, "--pair: key drawing " + std::to_string(number) +
                                          " has no visible stroke '" + name + "'");
  }
  return std::optional(static_cast<std::size_t>(found - key.ids.begin()));
}

std::string name_in(const KeyStrokes& key, const std::optional<std::size_t>& i) {
  return i ? stroke_name(key.ids[*i]) : std::string(kNoStroke);
}

}  // namespace

Result<PairArgument> parse_pair(const std::string& text) {
  const auto wrong = [&] {
    return fail(ErrorCode::kInvalidArgument,
                "--pair: '" + text + "' is not a pair; use FROM:TO or STEP:FROM:TO, such as 3:5, " +
                    "3:none or 2:3:5");
  };
  std::vector<std::string> words = split_at_colons(text);
  PairArgument pair;
  if (words.size() == 3) {
    const auto step = whole_number_of(words.front());
    if (!step || *step == 0) return wrong();
    pair.step = static_cast<std::size_t>(*step - 1);
    words.erase(words.begin());
  }
  const bool is_pair = words.size() == 2 && !words[0].empty() && !words[1].empty();
  if (!is_pair || (words[0] == kNoStroke && words[1] == kNoStroke)) return wrong();
  pair.from = words[0];
  pair.to = words[1];
  return pair;
}

Result<std::vector<GivenPair>> pairs_of_step(std::span<const PairArgument> pairs, std::size_t step,
                                             const KeyStrokes& from, const KeyStrokes& to) {
  std::vector<GivenPair> given;
  for (const PairArgument& pair : pairs) {
    if (pair.step != step) continue;
    const auto first = find_stroke(pair.from, from, step + 1);
    if (!first) return tl::unexpected(first.error());
    const auto second = find_stroke(pair.to, to, step + 2);
    if (!second) return tl::unexpected(second.error());
    given.push_back({*first, *second});
  }
  return given;
}

std::string matches_header() {
  return "step,from,to,from_start,from_end,to_start,to_end,reversed,cost\n";
}

std::string matches_rows(const Correspondence& correspondence, std::size_t step,
                         const KeyStrokes& from, const KeyStrokes& to) {
  std::string text;
  for (const StrokeMatch& m : correspondence.matches) {
    text += fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{:.3f}\n", step + 1,
                        name_in(from, m.from), name_in(to, m.to), m.from_start, m.from_end,
                        m.to_start, m.to_end, m.reversed ? 1 : 0, m.cost);
  }
  return text;
}

}  // namespace felt::cli
