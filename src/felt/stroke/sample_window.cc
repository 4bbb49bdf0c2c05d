#include "felt/stroke/sample_window.h"

#include <algorithm>

namespace felt {

SampleWindow::SampleWindow(double tolerance_mm, double spacing_mm, std::size_t capacity)
    : tolerance_mm_((1.0 - kReserve) * tolerance_mm), spacing_squared_(spacing_mm * spacing_mm) {
  const std::size_t room = capacity + kPadding;
  for (auto* array : {&x_, &y_, &path_mm_, &inverse_limit_, &slack_, &turns_}) array->resize(room);
  counts_.resize(room);
  corners_.resize(room);
}

void SampleWindow::clear() noexcept {
  size_ = 0;
}

void SampleWindow::grow() {
  const std::size_t room = 2 * capacity() + kPadding;
  for (auto* array : {&x_, &y_, &path_mm_, &inverse_limit_, &slack_, &turns_}) array->resize(room);
  counts_.resize(room);
  corners_.resize(room);
}

bool SampleWindow::add(Point p) {
  newest_ = p;
  double path = 0.0;
  if (size_ > 0) {
    const std::size_t last = size_ - 1;
    const double squared = distance_squared(point(last), p);
    if (squared <= spacing_squared_) {
      ++counts_[last];
      if (squared > slack_[last] * slack_[last]) {
        slack_[last] = std::sqrt(squared);
        const double limit = tolerance_mm_ - slack_[last];
        inverse_limit_[last] = 1.0 / (limit * limit);
      }
      return false;
    }
    path = path_mm_[last] + std::sqrt(squared);
  }
  if (size_ == capacity()) grow();
  x_[size_] = p.x;
  y_[size_] = p.y;
  path_mm_[size_] = path;
  inverse_limit_[size_] = 1.0 / (tolerance_mm_ * tolerance_mm_);
  slack_[size_] = 0.0;
  turns_[size_] = 0.0;
  counts_[size_] = 1;
  corners_[size_] = 0;
  ++size_;
  return true;
}

void SampleWindow::drop_front(std::size_t count) noexcept {
  const auto from = static_cast<std::ptrdiff_t>(count);
  const auto to = static_cast<std::ptrdiff_t>(size_);
  const auto shift = [&](auto& array) {
    std::copy(array.begin() + from, array.begin() + to, array.begin());
  };
  for (auto* array : {&x_, &y_, &path_mm_, &inverse_limit_, &slack_, &turns_}) shift(*array);
  shift(counts_);
  shift(corners_);
  size_ -= count;
}

}  // namespace felt
