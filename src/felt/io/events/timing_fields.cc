#include "felt/io/events/timing_fields.h"

#include <array>
#include <utility>

#include "felt/io/events/layer_fields.h"

namespace felt::json {
namespace {

/// Reads a whole number from `least` to `most`.
Result<int> parse_frames(Value& value, const char* key, int least, int most) {
  const std::string_view token = token_of(value);
  std::uint64_t frames = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(frames) ||
      frames < static_cast<std::uint64_t>(least) || frames > static_cast<std::uint64_t>(most)) {
    return bad(std::string(key) + ": " + excerpt(token) + " is not a whole number from " +
               std::to_string(least) + " to " + std::to_string(most));
  }
  return static_cast<int>(frames);
}

Result<void> parse_key_pair(Value& value, std::vector<KeyPair>& out) {
  if (out.size() == KeyTiming::kMaxPairs) return bad("has more than 10000 pairs");
  std::array<StrokeId, 2> ids{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == ids.size()) return bad("a pair has only two strokes");
    if (token.size() > limits::kMaxNumberChars || item.get_uint64().get(ids[count++].value)) {
      return bad(excerpt(token) + " is not a stroke, which is a whole number");
    }
    return {};
  };
  if (Result<void> read = for_each_element(value, "pair", add); !read) return read;
  if (count < ids.size()) return bad("a pair has two strokes");
  out.push_back({ids[0], ids[1]});
  return {};
}

}  // namespace

Result<void> parse_timing_between(Value& value, EventFields& out) {
  const Result<int> frames = parse_frames(value, "between", 0, KeyTiming::kMaxBetween);
  if (!frames) return tl::unexpected(frames.error());
  out.timing.between = *frames;
  return {};
}

Result<void> parse_timing_hold(Value& value, EventFields& out) {
  const Result<int> frames = parse_frames(value, "hold", 1, KeyTiming::kMaxHold);
  if (!frames) return tl::unexpected(frames.error());
  out.timing.hold = *frames;
  return {};
}

Result<void> parse_timing_ease(Value& value, EventFields& out) {
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == numbers.size()) return bad("an ease has only four numbers");
    if (read_number(item, kCoordinateLimit, numbers[count++])) return {};
    return tl::unexpected(number_error(token, kCoordinateLimit));
  };
  if (Result<void> read = for_each_element(value, "ease", add); !read) return read;
  if (count < numbers.size()) return bad("ease: has fewer than four numbers");
  out.timing.ease = EaseCurve{numbers[0], numbers[1], numbers[2], numbers[3]};
  return {};
}

Result<void> parse_timing_pairs(Value& value, EventFields& out) {
  out.timing.pairs.emplace();
  return for_each_element(value, "pairs",
                          [&out](Value& item) { return parse_key_pair(item, *out.timing.pairs); });
}

Result<void> parse_hidden_layers(Value& value, EventFields& out) {
  return for_each_element(value, "hidden",
                          [&out](Value& item) { return parse_layer_number(item, out.layers); });
}

Result<TimingEvent> timing_event(EventFields&& fields) {
  TimingEvent& event = fields.timing;
  event.layers = std::move(fields.layers);
  if (event.layers.empty()) return bad("ids: there is no layer");
  const KeyTiming plain;
  const KeyTiming timing{event.between.value_or(plain.between), event.hold.value_or(plain.hold),
                         event.ease.value_or(plain.ease), event.pairs.value_or(plain.pairs)};
  if (Result<void> fine = check_key_timing(timing); !fine) return tl::unexpected(fine.error());
  return std::move(event);
}

}  // namespace felt::json
