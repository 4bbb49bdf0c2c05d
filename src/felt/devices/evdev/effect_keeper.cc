#include "felt/devices/evdev/effect_keeper.h"

#include <algorithm>
#include <utility>

namespace felt {
namespace {

constexpr bool is_wanted(std::uint32_t epoch) noexcept {
  return (epoch & 1) != 0;
}

}  // namespace

void EffectKeeper::want(const EffectPlan& plan) noexcept {
  plans_.publish(plan);
  const std::uint32_t epoch = epoch_.load(std::memory_order_relaxed);
  if (!is_wanted(epoch)) epoch_.store(epoch + 1, std::memory_order_seq_cst);
}

void EffectKeeper::silence() noexcept {
  const std::uint32_t epoch = epoch_.load(std::memory_order_relaxed);
  if (is_wanted(epoch)) epoch_.store(epoch + 1, std::memory_order_seq_cst);
}

/// Returns true if silence was requested since serve() began.
bool EffectKeeper::is_silenced() const noexcept {
  return epoch_.load(std::memory_order_seq_cst) != served_epoch_;
}

/// Plays an effect, or stops it if `times` is 0. Does nothing if the effect was not uploaded,
/// because it then has no force.
bool EffectKeeper::play(std::size_t kind, int times) noexcept {
  const std::int16_t id = ids_[kind];
  if (id < 0) return true;
  const auto sent = port_.send({evdev::kFf, static_cast<std::uint16_t>(id), times});
  if (!sent) error_.store(sent.error(), std::memory_order_relaxed);
  return sent.has_value();
}

/// Stops an effect. If that fails, the effect still counts as playing, and the next call tries
/// again to stop it.
void EffectKeeper::stop(std::size_t kind) noexcept {
  if (there_.plays[kind] && play(kind, 0)) there_.plays[kind] = false;
}

void EffectKeeper::stop_all() noexcept {
  for (std::size_t kind = 0; kind < EffectPlan::kKinds; ++kind) stop(kind);
}

bool EffectKeeper::update(std::size_t kind, const EffectPlan& plan, bool must_play) noexcept {
  if (!plan.plays[kind]) {
    stop(kind);
    return !there_.plays[kind];
  }
  if (is_silenced()) return false;
  if (ids_[kind] < 0 || plan.effects[kind] != there_.effects[kind]) {
    EvdevEffect effect = plan.effects[kind];
    effect.id = ids_[kind];
    const auto done = port_.upload(effect);
    if (!done) {
      error_.store(done.error(), std::memory_order_relaxed);
      return false;
    }
    ids_[kind] = *done;
    there_.effects[kind] = plan.effects[kind];
  }
  if (there_.plays[kind] && !must_play) return true;
  // Silence may have been requested during the upload, because uploads may take long.
  if (is_silenced()) return false;
  there_.plays[kind] = true;  // a play that returned an error may still have reached the device
  return play(kind, 1);
}

void EffectKeeper::serve(std::int64_t now_ns) noexcept {
  const std::uint32_t epoch = epoch_.load(std::memory_order_seq_cst);
  if (epoch != served_epoch_ || !is_wanted(epoch)) stop_all();
  served_epoch_ = epoch;
  renewed_ns_ = std::min(renewed_ns_, now_ns);  // the clock may have been set back
  if (has_renewed_ && now_ns - renewed_ns_ < kUploadNs) return;
  has_renewed_ = true;
  renewed_ns_ = now_ns;
  plans_.update();
  if (is_wanted(epoch)) {
    renew(now_ns);
  } else if (error() != 0) {
    probe();
  }
}

// Uploads the effects that changed, and plays those that are new or about to end. After an error,
// or if silence() was called meanwhile, stops all effects.
void EffectKeeper::renew(std::int64_t now_ns) noexcept {
  const EffectPlan& plan = plans_.get();
  const bool is_due = now_ns - played_ns_ >= kPlayAgainNs || now_ns < played_ns_;
  if (is_due) played_ns_ = now_ns;
  // Effects are uploaded one after another. If a mixture of old and new ones would be too strong,
  // stops the old ones first.
  if (there_.plays.any() && strongest_n(there_, plan, stick_) > max_n_) {
    stop_all();
    if (there_.plays.any()) return;  // the device did not respond; try again next time
  }
  bool all_well = true;
  for (std::size_t kind = 0; all_well && kind < EffectPlan::kKinds; ++kind) {
    all_well = update(kind, plan, is_due);
  }
  if (all_well) error_.store(0, std::memory_order_relaxed);
  // If only some of the effects play, the force is wrong. And if silence() was called meanwhile, no
  // effect may play.
  if (!all_well || is_silenced()) stop_all();
}

/// Checks whether the device accepts effects again: uploads an effect without force, but does not
/// play it.
void EffectKeeper::probe() noexcept {
  const std::size_t kind =
      stick_.effects[evdev::kFfSpring] ? EffectPlan::kSpring : EffectPlan::kConstant;
  EvdevEffect& effect = there_.effects[kind];
  effect = {};
  effect.type = kind == EffectPlan::kSpring ? evdev::kFfSpring : evdev::kFfConstant;
  effect.id = ids_[kind];
  effect.length_ms = kEffectMs;
  const auto done = port_.upload(effect);
  error_.store(done ? 0 : done.error(), std::memory_order_relaxed);
  if (done) ids_[kind] = *done;
}

void EffectKeeper::erase_all() noexcept {
  for (std::size_t kind = 0; kind < EffectPlan::kKinds; ++kind) {
    static_cast<void>(play(kind, 0));
    const std::int16_t id = std::exchange(ids_[kind], std::int16_t{-1});
    if (id >= 0) static_cast<void>(port_.erase(id));
  }
  there_ = {};
}

}  // namespace felt
