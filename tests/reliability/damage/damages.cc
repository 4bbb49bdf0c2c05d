#include "tests/reliability/damage/damages.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <random>

namespace felt::damage {
namespace {

constexpr std::size_t kSector = 512;
constexpr std::size_t kMax = 400;

std::size_t largest() {
  const char* text = std::getenv("FELT_DAMAGES");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : kMax;
}

/// Calls `use` with about most() evenly spaced positions from 0 to below `size`.
template <class Use>
void spread(std::size_t size, Use use) {
  const std::size_t step = std::max<std::size_t>(1, size / std::max<std::size_t>(1, largest()));
  for (std::size_t at = 0; at < size; at += step) use(at);
}

}  // namespace

void for_each_damage(std::string_view whole, const std::function<void(const Damage&)>& use) {
  const std::string file(whole);
  std::mt19937_64 random(1);
  spread(file.size(), [&](std::size_t at) {
    use({"cut at " + std::to_string(at), at, file.size(), true, file.substr(0, at)});
  });
  spread(file.size(), [&](std::size_t at) {
    std::string bytes = file;
    const auto bit = random() % 8;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1u << bit));
    use({"flip " + std::to_string(bit) + " of byte " + std::to_string(at), at, at + 1, true,
         std::move(bytes)});
  });
  // The first bytes of a database page hold the positions of its content, so damage them too.
  constexpr std::size_t kPage = 4096, kHead = 32, kPages = 16;
  for (std::size_t i = 0; i < std::min(kPages, file.size() / kPage) * kHead; ++i) {
    const std::size_t at = i / kHead * kPage + i % kHead;
    for (const unsigned bit : {0u, 3u, 7u}) {
      std::string bytes = file;
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1u << bit));
      use({"flip " + std::to_string(bit) + " of byte " + std::to_string(at), at, at + 1, true,
           std::move(bytes)});
    }
  }
  spread((file.size() + kSector - 1) / kSector, [&](std::size_t sector) {
    const std::size_t at = sector * kSector, size = std::min(kSector, file.size() - at);
    for (const auto& [name, fill] : {std::pair{"zeros", '\0'}, std::pair{"ones", '\xff'}}) {
      use({std::string(name) + " at " + std::to_string(at), at, at + size, true,
           std::string(file).replace(at, size, size, fill)});
    }
    use({"twice at " + std::to_string(at), at + size, file.size(), false,
         std::string(file).insert(at, file, at, size)});
    use({"missing at " + std::to_string(at), at, file.size(), false,
         std::string(file).erase(at, size)});
    std::string bytes = file;
    const std::size_t other = random() % (file.size() / kSector + 1) * kSector;
    if (other + kSector <= file.size() && at + kSector <= file.size() && other != at) {
      std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes.begin() + static_cast<std::ptrdiff_t>(at + kSector),
                       bytes.begin() + static_cast<std::ptrdiff_t>(other));
      use({"exchanged " + std::to_string(at) + " and " + std::to_string(other), std::min(at, other),
           file.size(), false, std::move(bytes)});
    }
  });
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::size_t peak_bytes() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace felt::damage
