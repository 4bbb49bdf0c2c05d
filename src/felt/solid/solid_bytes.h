#pragma once

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>

#include "felt/geometry/vec3.h"

namespace felt {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

/// Appends a number as it is in memory, little-endian.
template <class T>
void append_raw(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

/// Appends three floats.
inline void append_floats(std::string& out, const Vec3& v) {
  for (const double value : {v.x, v.y, v.z}) append_raw(out, static_cast<float>(value));
}

/// Appends the shortest text that reads back as the same float.
inline void append_text(std::string& out, double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  out.append(text, end);
}

/// Appends a whole number as text.
inline void append_text(std::string& out, std::uint64_t value) {
  char text[24];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace felt
