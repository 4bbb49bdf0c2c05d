#include "felt/driver/evdev_port.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace felt {
namespace {

/// The bytes of a haptic effect, from Linux 6.18. Older headers do not have this member of the
/// union.
struct HapticBytes {
  std::uint16_t hid_usage;
  std::uint16_t vendor_id;
  std::uint8_t vendor_waveform_page;
  std::uint16_t intensity;
  std::uint16_t repeat_count;
  std::uint16_t retrigger_period;
};
static_assert(sizeof(HapticBytes) == 12 && sizeof(HapticBytes) <= sizeof(ff_effect::u));
static_assert(sizeof(ff_effect) <= kEvdevEffectBytes);

ff_condition_effect condition_of(const EvdevCondition& condition) noexcept {
  ff_condition_effect bytes{};
  bytes.right_saturation = condition.right_saturation;
  bytes.left_saturation = condition.left_saturation;
  bytes.right_coeff = condition.right_coefficient;
  bytes.left_coeff = condition.left_coefficient;
  bytes.deadband = condition.deadband;
  bytes.center = condition.center;
  return bytes;
}

ff_effect effect_of(const EvdevEffect& effect) noexcept {
  ff_effect bytes{};
  bytes.type = effect.type;
  bytes.id = effect.id;
  bytes.direction = effect.direction;
  bytes.replay.length = effect.length_ms;
  switch (effect.type) {
    case evdev::kFfConstant:
      bytes.u.constant.level = effect.level;
      break;
    case evdev::kFfRumble:
      bytes.u.rumble.strong_magnitude = effect.strong;
      bytes.u.rumble.weak_magnitude = effect.weak;
      break;
    case evdev::kFfHaptic: {
      HapticBytes haptic{};
      haptic.hid_usage = effect.hid_usage;
      haptic.intensity = effect.intensity_percent;
      std::memcpy(&bytes.u, &haptic, sizeof haptic);
      break;
    }
    default:
      for (std::size_t i = 0; i < 2; ++i) bytes.u.condition[i] = condition_of(effect.conditions[i]);
      break;
  }
  return bytes;
}

class EvdevFile final : public EvdevPort {
 public:
  explicit EvdevFile(int descriptor) noexcept : descriptor_(descriptor) {}
  ~EvdevFile() override { close(descriptor_); }

  tl::expected<bool, int> next(EvdevEvent& event) noexcept override {
    input_event bytes{};
    const ssize_t count = read(descriptor_, &bytes, sizeof bytes);
    if (count < 0) {
      if (errno == EAGAIN || errno == EINTR) return false;
      return tl::unexpected(errno);
    }
    if (count != sizeof bytes) return tl::unexpected(count == 0 ? ENODEV : EIO);
    event = {bytes.type, bytes.code, bytes.value};
    return true;
  }

  tl::expected<EvdevAxis, int> axis(std::uint16_t code) noexcept override {
    input_absinfo info{};
    if (code >= evdev::kAxisCount) return tl::unexpected(EINVAL);
    if (ioctl(descriptor_, EVIOCGABS(code), &info) < 0) return tl::unexpected(errno);
    return EvdevAxis{info.value, info.minimum, info.maximum, info.flat};
  }

  tl::expected<bool, int> key(std::uint16_t code) noexcept override {
    std::array<std::uint8_t, evdev::kKeyCount / 8> bits{};
    if (code >= evdev::kKeyCount) return tl::unexpected(EINVAL);
    if (ioctl(descriptor_, EVIOCGKEY(bits.size()), bits.data()) < 0) return tl::unexpected(errno);
    return (bits[code / 8] >> (code % 8) & 1) != 0;
  }

  tl::expected<int, int> slots() noexcept override {
    int count = 0;
    if (ioctl(descriptor_, EVIOCGEFFECTS, &count) < 0) return tl::unexpected(errno);
    return count;
  }

  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    ff_effect bytes = effect_of(effect);
    if (ioctl(descriptor_, EVIOCSFF, &bytes) < 0) return tl::unexpected(errno);
    return bytes.id;
  }

  tl::expected<void, int> erase(std::int16_t id) noexcept override {
    if (ioctl(descriptor_, EVIOCRMFF, static_cast<int>(id)) < 0) return tl::unexpected(errno);
    return {};
  }

  tl::expected<void, int> send(const EvdevEvent& event) noexcept override {
    input_event bytes{};
    bytes.type = event.type;
    bytes.code = event.code;
    bytes.value = event.value;
    const ssize_t count = write(descriptor_, &bytes, sizeof bytes);
    if (count == sizeof bytes) return {};
    return tl::unexpected(count < 0 ? errno : EIO);
  }

 private:
  int descriptor_;
};

}  // namespace

std::array<std::byte, kEvdevEffectBytes> packed(const EvdevEffect& effect) noexcept {
  const ff_effect bytes = effect_of(effect);
  std::array<std::byte, kEvdevEffectBytes> all{};
  std::memcpy(all.data(), &bytes, sizeof bytes);
  return all;
}

Result<std::unique_ptr<EvdevPort>> open_evdev(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    const int error = errno;
    return fail(error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
                path + ": " + std::strerror(error));
  }
  return std::make_unique<EvdevFile>(descriptor);
}

}  // namespace felt
