#include "felt/io/gpl_palette.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

namespace felt {
namespace {

constexpr std::string_view kSpace = " \t";
constexpr std::string_view kMagic = "GIMP Palette";
constexpr std::string_view kName = "Name:";
constexpr std::string_view kColumns = "Columns:";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// Removes the next line from the text and returns it without its terminator.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Removes a whole number up to `most` from the line. Returns nullopt if no number is found.
std::optional<unsigned> take_number(std::string_view& line, unsigned max_value) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
  unsigned number = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  const auto length = static_cast<std::size_t>(end - line.data());
  if (error != std::errc{} || number > max_value) return {};
  line.remove_prefix(length);
  if (!line.empty() && kSpace.find(line.front()) == std::string_view::npos) return {};
  return number;
}

/// Returns the number of bytes of the UTF-8 character at the start of the text, or 0 if the text
/// does not start with a valid character or starts with a control character.
std::size_t character(std::string_view text) {
  const auto byte = [&text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead < 0x20 || lead == 0x7f ? 0 : 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  std::uint32_t code = lead & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fU);
  }
  constexpr std::uint32_t kMin[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  const bool is_control = code < 0xa0;
  return code < kMin[length] || code > 0x10ffff || is_surrogate || is_control ? 0 : length;
}

/// Returns the reason why this is not a valid name, or "" if it is valid.
std::string_view fault_of(std::string_view name) {
  if (name.size() > PaletteLimits::kMaxNameBytes) return "the name is longer than 200 bytes";
  while (!name.empty()) {
    const std::size_t length = character(name);
    if (length == 0) return "the name is not UTF-8 text";
    name.remove_prefix(length);
  }
  return {};
}

/// Reads a file line by line. The functions return an error message, or "" if the line is valid.
class GplReader {
 public:
  std::string_view first(std::string_view line) {
    if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
    return trimmed(line) == kMagic ? "" : "not a GIMP palette: the first line does not match";
  }

  std::string_view next(std::string_view line) {
    if (trimmed(line).empty() || line.front() == '#') return {};
    // These lines are accepted anywhere, because no line with a colour looks like them.
    if (line.starts_with(kName)) return name(trimmed(line.substr(kName.size())));
    if (line.starts_with(kColumns)) return columns(line.substr(kColumns.size()));
    return color(line);
  }

  Palette palette;

 private:
  std::string_view name(std::string_view text) {
    palette.name = text;
    return fault_of(text);
  }

  std::string_view columns(std::string_view text) {
    const auto number = take_number(text, PaletteLimits::kMaxColumns);
    if (!number || !trimmed(text).empty()) return "the columns are not a number from 0 to 64";
    palette.columns = *number;
    return {};
  }

  std::string_view color(std::string_view line) {
    const auto r = take_number(line, 255);
    const auto g = r ? take_number(line, 255) : std::nullopt;
    const auto b = g ? take_number(line, 255) : std::nullopt;
    if (!b) return "a colour is three numbers from 0 to 255 and a name";
    if (palette.colors.size() >= PaletteLimits::kMaxColors)
      return "there are more than 10000 colours";
    const std::string_view name = trimmed(line);
    palette.colors.push_back({{static_cast<std::uint8_t>(*r), static_cast<std::uint8_t>(*g),
                               static_cast<std::uint8_t>(*b)},
                              std::string(name)});
    return fault_of(name);
  }
};

}  // namespace

Result<Palette> read_gpl(const std::string& file, std::string_view text) {
  if (text.size() > PaletteLimits::kMaxBytes) {
    return fail(ErrorCode::kLimitExceeded,
                file + ": is larger than 1 MiB, the limit for a palette");
  }
  GplReader reader;
  std::size_t number = 1;
  std::string_view fault = reader.first(take_line(text));
  while (fault.empty() && !text.empty()) {
    ++number;
    fault = reader.next(take_line(text));
  }
  if (!fault.empty()) {
    return fail(ErrorCode::kInvalidData,
                file + ":" + std::to_string(number) + ": " + std::string(fault));
  }
  return std::move(reader.palette);
}

std::string write_gpl(const Palette& palette) {
  std::string text = std::string(kMagic) + "\n";
  if (!palette.name.empty()) text += "Name: " + palette.name + "\n";
  if (palette.columns > 0) text += "Columns: " + std::to_string(palette.columns) + "\n";
  text += "#\n";
  for (const NamedColor& entry : palette.colors) {
    for (const std::uint8_t part : {entry.color.r, entry.color.g, entry.color.b}) {
      const std::string digits = std::to_string(part);
      text += std::string(3 - digits.size(), ' ') + digits + " ";
    }
    text += "\t" + entry.name + "\n";
  }
  return text;
}

}  // namespace felt
