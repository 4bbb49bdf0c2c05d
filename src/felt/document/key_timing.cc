#include "felt/document/key_timing.h"

#include <algorithm>
#include <string>
#include <utility>

namespace felt {
namespace {

/// Returns true if an id other than zero is there twice.
bool has_repeated_id(std::vector<StrokeId> ids) {
  std::erase(ids, StrokeId{});
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
}

}  // namespace

Result<void> check_key_timing(const KeyTiming& timing) {
  const auto wrong = [](std::string what) {
    return fail(ErrorCode::kInvalidArgument, std::move(what));
  };
  if (timing.between < 0 || timing.between > KeyTiming::kMaxBetween) {
    return wrong("between: is not a number from 0 to 1000");
  }
  if (timing.hold < 1 || timing.hold > KeyTiming::kMaxHold) {
    return wrong("hold: is not a number from 1 to 1000");
  }
  const EaseCurve& ease = timing.ease;
  for (const double number : {ease.x1, ease.y1, ease.x2, ease.y2}) {
    if (!(number >= 0.0 && number <= 1.0)) return wrong("ease: the numbers must be from 0 to 1");
  }
  if (timing.pairs.size() > KeyTiming::kMaxPairs) return wrong("pairs: has more than 10000 pairs");
  std::vector<StrokeId> from, to;
  for (const KeyPair& pair : timing.pairs) {
    if (!pair.from && !pair.to) return wrong("pairs: a pair has no stroke");
    from.push_back(pair.from);
    to.push_back(pair.to);
  }
  if (has_repeated_id(std::move(from)) || has_repeated_id(std::move(to))) {
    return wrong("pairs: a stroke is in two pairs");
  }
  return {};
}

const KeyTiming& timing_or_default(const KeyTimingPtr& timing) noexcept {
  static const KeyTiming kDefault;
  return timing ? *timing : kDefault;
}

KeyTimingPtr shared_timing(KeyTiming timing) {
  if (timing == KeyTiming{}) return nullptr;
  return std::make_shared<const KeyTiming>(std::move(timing));
}

bool equal_timings(const KeyTimingPtr& a, const KeyTimingPtr& b) noexcept {
  return a == b || (a && b && *a == *b);
}

}  // namespace felt
