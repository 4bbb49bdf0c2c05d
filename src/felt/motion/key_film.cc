#include "felt/motion/key_film.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace felt {
namespace {

/// Returns the index of a stroke; nullopt if the key drawing does not have it.
std::optional<std::size_t> index_of_stroke(const KeyStrokes& key, StrokeId id) {
  const auto found = std::find(key.ids.begin(), key.ids.end(), id);
  if (found == key.ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - key.ids.begin());
}

}  // namespace

KeySettings settings_of(const KeyTiming& timing) {
  return {timing.between, timing.hold, Ease::of(timing.ease)};
}

std::vector<GivenPair> given_pairs(const KeyTiming& timing, const KeyStrokes& from,
                                   const KeyStrokes& to) {
  std::vector<GivenPair> given;
  for (const KeyPair& pair : timing.pairs) {
    const GivenPair indices{index_of_stroke(from, pair.from), index_of_stroke(to, pair.to)};
    const bool is_missing = (pair.from && !indices.from) || (pair.to && !indices.to);
    if (!is_missing) given.push_back(indices);
  }
  return given;
}

Result<void> KeyFilm::add(Drawing key, KeySettings settings, std::vector<GivenPair> pairs) {
  std::size_t first = 0;
  if (!keys_.empty()) {
    const Key& last = keys_.back();
    Result<Inbetween> step = Inbetween::create(last.drawing, key, {std::move(pairs), lone_});
    if (!step) return tl::unexpected(step.error());
    steps_.push_back(*std::move(step));
    first = last.first_picture + static_cast<std::size_t>(last.settings.between) + 1;
  }
  keys_.push_back({std::move(key), std::move(settings), first});
  last_timing_ = {};
  return {};
}

Result<void> KeyFilm::add(FilmKey key) {
  std::vector<GivenPair> pairs;
  if (!keys_.empty()) {
    pairs = given_pairs(last_timing_, key_strokes(keys_.back().drawing.document),
                        key_strokes(key.drawing.document));
  }
  Result<void> added = add(std::move(key.drawing), settings_of(key.timing), std::move(pairs));
  if (added) last_timing_ = std::move(key.timing);
  return added;
}

const KeyFilm::Key& KeyFilm::key_of(std::size_t picture) const noexcept {
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), picture,
                       [](std::size_t p, const Key& key) { return p < key.first_picture; });
  return *(next - 1);
}

Drawing KeyFilm::picture(std::size_t picture) const {
  const Key& key = key_of(picture);
  const std::size_t between = picture - key.first_picture;
  if (between == 0) return key.drawing;
  const double time = static_cast<double>(between) / static_cast<double>(key.settings.between + 1);
  return steps_[static_cast<std::size_t>(&key - keys_.data())].at(key.settings.ease.at(time));
}

}  // namespace felt
