#include "felt/session/sound_input.h"

#include <algorithm>

#include "felt/session/session_medium.h"
#include "felt/tools/pressing.h"

namespace felt {
namespace {

constexpr int kLookSamples = 64;
constexpr double kMinPushN = 0.02;   // a touching pen always makes a sound
constexpr double kUsualPushN = 0.6;  // for a device without depth or pressure, such as a mouse

}  // namespace

void SoundInput::look() {
  until_look_ = kLookSamples;
  const SurfaceMaterial& surface = session_->surface();
  pair_ = rubbing_pair(surface, medium_in_hand(*session_));
  const Pressing pressing(surface, session_->device());
  stiffness_n_per_m_ = pressing.stiffness_n_per_m();
  max_n_ = pair_.firm_push_n = pressing.max_n();
}

RubbingSample SoundInput::sample(const PenSample& pen) {
  const bool is_down = in_contact(pen);
  if (--until_look_ <= 0 || is_down != is_down_) look();
  is_down_ = is_down;
  RubbingSample heard;
  heard.time_ns = pen.time_ns;
  heard.at = {pen.position.x, pen.position.y};
  if (!is_down) return heard;
  if (session_->device().sensed_axes >= 3 && pen.position.z < 0.0) {
    heard.push_n = 0.001 * stiffness_n_per_m_ * depth_mm(pen);
  } else {
    heard.push_n = pen.pressure ? *pen.pressure * max_n_ : kUsualPushN;
  }
  heard.push_n = std::max(heard.push_n, kMinPushN);
  heard.strike_mm_per_s = std::max(-pen.velocity.z, 0.0);
  return heard;
}

}  // namespace felt
