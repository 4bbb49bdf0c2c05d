// A force functor that allocates two calls down. check_tick_symbols.sh must find it.
#include <memory>

#include "felt/haptics/force_model.h"

namespace planted {

[[gnu::noinline]] std::unique_ptr<felt::Force> allocates(double x) {
  return std::make_unique<felt::Force>(felt::Force{x, 0.0, 0.0});
}

[[gnu::noinline]] double helps(double x) {
  return allocates(x)->x;
}

struct Allocating {
  felt::Force operator()(const felt::PenSample& sample, felt::ForceMemory&) const noexcept;
};

felt::Force Allocating::operator()(const felt::PenSample& sample,
                                   felt::ForceMemory&) const noexcept {
  return {helps(sample.position.x), 0.0, 0.0};
}

}  // namespace planted
