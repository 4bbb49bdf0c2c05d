#include "felt/motion/key_film.h"

#include <utility>

namespace felt {

Result<void> KeyFilm::add(Drawing key, std::vector<GivenPair> pairs) {
  if (!keys_.empty()) {
    Result<Inbetween> step =
        Inbetween::create(keys_.back(), key, {std::move(pairs), options_.lone});
    if (!step) return tl::unexpected(step.error());
    steps_.push_back(*std::move(step));
  }
  keys_.push_back(std::move(key));
  return {};
}

std::size_t KeyFilm::size() const noexcept {
  return keys_.empty() ? 0 : keys_.size() + steps_.size() * (stride() - 1);
}

Drawing KeyFilm::picture(std::size_t picture) const {
  const std::size_t key = picture / stride(), between = picture % stride();
  if (between == 0) return keys_[key];
  const double time = static_cast<double>(between) / static_cast<double>(stride());
  return steps_[key].at(options_.ease.at(time));
}

}  // namespace felt
