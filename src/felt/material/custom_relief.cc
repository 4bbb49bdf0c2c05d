#include "felt/material/custom_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace felt {
namespace {

constexpr std::size_t kSide = kOwnReliefSide;
constexpr std::size_t kBytes = kSide * kSide * 2;
constexpr std::size_t kLineLetters = 76;
constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Heights of two bytes each, high byte first.
using Bytes = std::vector<std::uint8_t>;

/// Compares as text, because g++ 12 at -O3 warns in its own header about operator< of byte vectors.
struct ByText {
  bool operator()(const Bytes& a, const Bytes& b) const noexcept { return text(a) < text(b); }
  static std::string_view text(const Bytes& bytes) noexcept {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

/// The custom reliefs that are in use, by their heights.
class OwnReliefs {
 public:
  Result<std::shared_ptr<const HeightField>> of(Bytes bytes) {
    const std::lock_guard lock(mutex_);
    std::erase_if(known_, [](const auto& entry) { return entry.second.expired(); });
    const auto at = known_.find(bytes);
    if (at != known_.end()) {
      if (std::shared_ptr<const HeightField> made = at->second.lock()) return made;
    }
    Result<HeightField> field = height_field_of(picture_of(bytes));
    if (!field) return tl::unexpected(field.error());
    auto made = std::make_shared<const HeightField>(*std::move(field));
    known_[std::move(bytes)] = made;
    return made;
  }

  /// Returns the heights of a relief; empty if this object did not make it.
  Bytes bytes_of(const HeightField& relief) {
    const std::lock_guard lock(mutex_);
    for (const auto& [bytes, known] : known_) {
      if (known.lock().get() == &relief) return bytes;
    }
    return {};
  }

 private:
  static HeightPicture picture_of(const Bytes& bytes) {
    HeightPicture picture{.width = kOwnReliefSide, .height = kOwnReliefSide, .heights = {}};
    picture.heights.reserve(kSide * kSide);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
      picture.heights.push_back(static_cast<float>(bytes[i] * 256 + bytes[i + 1]) / 65535.0F);
    }
    return picture;
  }

  std::mutex mutex_;
  std::map<Bytes, std::weak_ptr<const HeightField>, ByText> known_;
};

OwnReliefs& own_reliefs() {
  static OwnReliefs& reliefs = *new OwnReliefs;
  return reliefs;
}

/// Quantises heights to 16 bits, with 0 for the lowest and 65535 for the highest.
Bytes bytes_of(const std::vector<double>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double span = *high - *low;
  Bytes bytes;
  bytes.reserve(kBytes);
  for (const double height : heights) {
    const double share = span > 0.0 ? (height - *low) / span : 0.0;
    const auto level = static_cast<unsigned>(std::lround(65535.0 * share));
    bytes.push_back(static_cast<std::uint8_t>(level >> 8));
    bytes.push_back(static_cast<std::uint8_t>(level & 0xFF));
  }
  return bytes;
}

/// The pixels of a row of `count` pixels that cell `i` of kSide cells covers, and the weight of
/// each.
struct Cover {
  int first = 0;
  std::vector<double> weights;
};

Cover cover_of(std::size_t i, int count) {
  const double scale = static_cast<double>(count) / static_cast<double>(kSide);
  if (scale < 1.0) {  // fewer pixels than cells: interpolate between two pixels
    const double at = std::clamp(scale * (static_cast<double>(i) + 0.5) - 0.5, 0.0, count - 1.0);
    const int first = std::max(std::min(static_cast<int>(at), count - 2), 0);
    if (count == 1) return {0, {1.0}};
    return {first, {1.0 - (at - first), at - first}};
  }
  const double from = scale * static_cast<double>(i), to = scale * static_cast<double>(i + 1);
  Cover cover{std::min(static_cast<int>(from), count - 1), {}};
  for (int k = cover.first; k < count && k < to; ++k) {
    cover.weights.push_back(std::min(to, k + 1.0) - std::max(from, static_cast<double>(k)));
  }
  return cover;
}

/// Returns the mean of the pixels in each cell of a square grid.
std::vector<double> cells_of(const HeightPicture& picture) {
  std::vector<Cover> columns;
  for (std::size_t i = 0; i < kSide; ++i) columns.push_back(cover_of(i, picture.width));
  std::vector<double> cells;
  cells.reserve(kSide * kSide);
  for (std::size_t j = 0; j < kSide; ++j) {
    const Cover rows = cover_of(j, picture.height);
    for (const Cover& column : columns) {
      double sum = 0.0, weights = 0.0;
      for (std::size_t y = 0; y < rows.weights.size(); ++y) {
        const std::size_t row =
            (static_cast<std::size_t>(rows.first) + y) * static_cast<std::size_t>(picture.width);
        for (std::size_t x = 0; x < column.weights.size(); ++x) {
          const double weight = rows.weights[y] * column.weights[x];
          sum += weight * static_cast<double>(
                              picture.heights[row + static_cast<std::size_t>(column.first) + x]);
          weights += weight;
        }
      }
      cells.push_back(sum / weights);
    }
  }
  return cells;
}

std::string base64_of(const Bytes& bytes) {
  std::string text;
  std::size_t in_line = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kLetters[group >> (18 - 6 * k) & 63] : '=';
    }
    in_line += 4;
    if (in_line < kLineLetters && i + 3 < bytes.size()) continue;
    text += '\n';
    in_line = 0;
  }
  return text;
}

Result<Bytes> bytes_of(std::string_view text) {
  const auto bad = [](const std::string& what) { return fail(ErrorCode::kInvalidData, what); };
  Bytes bytes;
  bytes.reserve(kBytes);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    if (c == '\n' || c == '\r' || c == ' ' || c == '\t' || c == '=') continue;
    const std::size_t letter = kLetters.find(c);
    if (letter == std::string_view::npos) return bad("are not base64");
    bits = (bits << 6 | static_cast<std::uint32_t>(letter)) & 0xFFFFFF;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> bit_count & 0xFF));
    if (bytes.size() > kBytes) break;
  }
  if (bytes.size() == kBytes) return bytes;
  return bad("are not " + std::to_string(kSide) + " x " + std::to_string(kSide) +
             " heights of two bytes");
}

}  // namespace

Result<std::shared_ptr<const HeightField>> custom_relief(const HeightPicture& picture) {
  // Only checks the picture: the relief itself is made from the 16-bit heights.
  if (const Result<HeightField> fits = height_field_of(picture); !fits) {
    return tl::unexpected(fits.error());
  }
  return own_reliefs().of(bytes_of(cells_of(picture)));
}

Result<std::shared_ptr<const HeightField>> custom_relief(std::string_view text) {
  Result<Bytes> bytes = bytes_of(text);
  if (!bytes) return tl::unexpected(bytes.error());
  return own_reliefs().of(*std::move(bytes));
}

std::string custom_relief_text(const HeightField& relief) {
  if (const Bytes known = own_reliefs().bytes_of(relief); !known.empty()) return base64_of(known);
  std::vector<double> heights;
  heights.reserve(kSide * kSide);
  const double step_mm = relief.tile_mm() / static_cast<double>(kSide);
  for (std::size_t j = 0; j < kSide; ++j) {
    for (std::size_t i = 0; i < kSide; ++i) {
      const Point at{step_mm * static_cast<double>(i), step_mm * static_cast<double>(j)};
      heights.push_back(relief.at(at).height_mm);
    }
  }
  return base64_of(bytes_of(heights));
}

}  // namespace felt
