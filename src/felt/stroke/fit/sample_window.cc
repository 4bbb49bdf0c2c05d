#include "felt/stroke/fit/sample_window.h"

#include <algorithm>

namespace felt {
namespace {

constexpr std::size_t kGroup = 4;
// A group is thinned if it represents at most this fraction of all samples. Then there are fewer
// than 32 heavier groups, so that a full window is reduced to 3/4 or less.
constexpr double kGroupShare = 1.0 / 32.0;

}  // namespace

SampleWindow::SampleWindow(std::size_t capacity) {
  const std::size_t room = capacity + kPadding;
  for (auto* array : {&x_, &y_, &path_mm_, &inverse_limit_, &weight_}) array->resize(room);
  source_.resize(room);
  is_held_.resize(room);
}

void SampleWindow::clear() noexcept {
  size_ = 0;
  is_thinned_ = false;
}

void SampleWindow::add(const KeptSamples& kept, std::size_t source) noexcept {
  tolerance_mm_ = kept.tolerance_mm();
  x_[size_] = kept.point(source).x;
  y_[size_] = kept.point(source).y;
  path_mm_[size_] = kept.path_mm(source);
  const double share = is_thinned_ ? kThinnedShare : 1.0;
  inverse_limit_[size_] = kept.inverse_limit(source) / (share * share);
  weight_[size_] = 1.0;
  source_[size_] = source;
  is_held_[size_] = 0;
  ++size_;
}

void SampleWindow::move(std::size_t from, std::size_t to) noexcept {
  for (auto* array : {&x_, &y_, &path_mm_, &inverse_limit_, &weight_})
    (*array)[to] = (*array)[from];
  source_[to] = source_[from];
  is_held_[to] = is_held_[from];
}

void SampleWindow::thin(const double* left, const double* right, double* parameters) noexcept {
  if (!is_thinned_) {
    is_thinned_ = true;
    for (std::size_t i = 0; i < size_; ++i) inverse_limit_[i] /= kThinnedShare * kThinnedShare;
  }
  double whole = 0.0;
  for (std::size_t i = 0; i < size_; ++i) whole += weight_[i];
  std::size_t kept = 0;
  const auto keep = [&](std::size_t i) {
    move(i, kept);
    parameters[kept++] = parameters[i];
  };
  std::size_t i = 0;
  while (i < size_) {
    const double* w = weight_.data() + i;
    const std::uint8_t* held = is_held_.data() + i;
    const bool is_inner = i > 0 && i + kGroup < size_;
    const double group = is_inner ? w[0] + w[1] + w[2] + w[3] : whole;
    if (group > kGroupShare * whole || held[0] + held[1] + held[2] + held[3] > 0) {
      keep(i++);
      continue;
    }
    const auto a = static_cast<std::size_t>(std::min_element(left + i, left + i + kGroup) - left);
    std::size_t b = a == i ? i + 1 : i;
    for (std::size_t k = b + 1; k < i + kGroup; ++k) {
      if (k != a && right[k] >= right[b]) b = k;
    }
    for (const std::size_t stays : {std::min(a, b), std::max(a, b)}) {
      keep(stays);
      weight_[kept - 1] = 0.5 * group;
    }
    i += kGroup;
  }
  size_ = kept;
}

}  // namespace felt
