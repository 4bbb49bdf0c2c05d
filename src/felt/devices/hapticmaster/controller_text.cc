#include "felt/devices/hapticmaster/controller_text.h"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/driver/text_writer.h"

namespace felt::hapticmaster {
namespace {

bool is_letter(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Reads a number and the character after it.
bool read_number(std::string_view& text, char after, double& number) noexcept {
  while (text.starts_with(' ')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto used = static_cast<std::size_t>(end - text.data());
  if (error != std::errc{} || used >= text.size() || text[used] != after) return false;
  text.remove_prefix(used + 1);
  return std::isfinite(number);
}

constexpr double kMinSizeMm = 20.0, kMaxSizeMm = 2000.0;

// Half of the angle in which the arm can turn to both sides.
double half_angle(const Sector& sector) noexcept {
  return std::min(-sector.phi_rad.x, sector.phi_rad.z);
}

}  // namespace

AnswerKind kind_of(std::string_view answer) noexcept {
  if (answer.find("--- ERROR") != std::string_view::npos) return AnswerKind::kError;
  if (answer.starts_with('[')) return AnswerKind::kVector;
  if (answer.empty() || !is_letter(answer.front())) return AnswerKind::kOther;
  return std::all_of(answer.begin(), answer.end(), is_letter) ? AnswerKind::kWord
                                                              : AnswerKind::kSentence;
}

std::optional<Vec3> read_vector(std::string_view answer) noexcept {
  if (!answer.starts_with('[')) return std::nullopt;
  answer.remove_prefix(1);
  Vec3 read;
  const bool is_read = read_number(answer, ',', read.x) && read_number(answer, ',', read.y) &&
                       read_number(answer, ']', read.z);
  if (!is_read || !answer.empty()) return std::nullopt;
  return read;
}

// The letters are the digits of a hash of the process, the time and a counter.
EffectName new_effect_name() {
  static std::atomic<std::uint64_t> count{0};
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  const std::array<std::uint64_t, 4> parts{static_cast<std::uint64_t>(getpid()),
                                           static_cast<std::uint64_t>(now.tv_sec),
                                           static_cast<std::uint64_t>(now.tv_nsec), ++count};
  std::uint64_t hash = 0;
  for (const std::uint64_t part : parts) hash = Random(hash ^ part).bits();
  constexpr std::string_view kStart = "felt";
  EffectName name{};
  char* at = std::copy(kStart.begin(), kStart.end(), name.data());
  for (; at != name.data() + name.size(); hash >>= 4) *at++ = static_cast<char>('a' + (hash & 15u));
  return name;
}

std::string_view text_of(const EffectName& name) noexcept {
  return {name.data(), name.size()};
}

std::string_view write_force(const EffectName& effect, const Force& force,
                             ForceText& room) noexcept {
  char* at = append_text(room.data(), "set ");
  at = append_text(at, text_of(effect));
  at = append_text(at, " force [");
  at = append_decimal(at, force.x);
  at = append_text(at, ",");
  at = append_decimal(at, force.y);
  at = append_text(at, ",");
  at = append_decimal(at, force.z);
  at = append_text(at, "]");
  return {room.data(), static_cast<std::size_t>(at - room.data())};
}

std::optional<Box> inner_box(const Sector& sector) noexcept {
  const double angle = half_angle(sector);
  const double near_m = sector.r_m.x + sector.r_m.y;  // from the axis to the low stop
  if (!(angle > 0.0 && angle < 0.25 * kTau && near_m > 0.0 && sector.r_m.y > 0.0)) {
    return std::nullopt;
  }
  // At the low stop, the arm reaches y = near tan(angle) before it meets the stop of its angle;
  // this takes a little less. The far corners must be within the high stop, too.
  const double y_m = near_m * std::sin(angle);
  const double far_m = sector.r_m.y + sector.r_m.z;
  if (!(far_m > y_m)) return std::nullopt;
  const double x_m = std::sqrt(far_m * far_m - y_m * y_m) - sector.r_m.y;
  const Box box{{kMmPerM * sector.r_m.x, -kMmPerM * y_m, kMmPerM * sector.z_m.x},
                {kMmPerM * x_m, kMmPerM * y_m, kMmPerM * sector.z_m.z}};
  const Vec3 size = box.max_mm - box.min_mm;
  for (const double side : {size.x, size.y, size.z}) {
    if (!(side >= kMinSizeMm && side <= kMaxSizeMm)) return std::nullopt;
  }
  return box;
}

Box outer_box(const Sector& sector) noexcept {
  const double far_m = sector.r_m.y + sector.r_m.z;
  const double angle = std::max(-sector.phi_rad.x, sector.phi_rad.z);
  const double near_m = (sector.r_m.y + sector.r_m.x) * std::cos(angle) - sector.r_m.y;
  const double y_m = far_m * std::sin(std::min(angle, 0.25 * kTau));
  return {{kMmPerM * std::min(near_m, sector.r_m.x), -kMmPerM * y_m, kMmPerM * sector.z_m.x},
          {kMmPerM * sector.r_m.z, kMmPerM * y_m, kMmPerM * sector.z_m.z}};
}

}  // namespace felt::hapticmaster
