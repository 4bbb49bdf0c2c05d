#include "felt/io/xml/xml_input.h"

#include <algorithm>
#include <utility>

#include "felt/base/ascii.h"
#include "felt/base/utf8.h"

namespace felt {
namespace {

constexpr std::size_t kLineBlock = 1024;

std::int64_t line_at(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return 1 + std::count(before.begin(), before.end(), '\n');
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xc0 | (code >> 6));
    byte(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    byte(0xe0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3f));
    byte(0x80 | (code & 0x3f));
  } else {
    byte(0xf0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3f));
    byte(0x80 | ((code >> 6) & 0x3f));
    byte(0x80 | (code & 0x3f));
  }
}

std::string utf8_of_utf16(std::string_view bytes, bool big_endian) {
  std::string out;
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::uint32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xd800 && code < 0xdc00 && i + 3 < bytes.size()) {
      const std::uint32_t low = unit(i + 2);
      if (low >= 0xdc00 && low < 0xe000) {
        code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
        i += 2;
      }
    }
    append_utf8(out, code);
  }
  return out;
}

bool declares_latin1(std::string_view text) {
  std::string head(text.substr(0, std::min<std::size_t>(text.find("?>"), 200)));
  for (char& c : head) c = ascii_lower(c);
  return head.substr(0, 5) == "<?xml" && head.find("iso-8859-1") != std::string::npos;
}

/// Returns the document as UTF-8 without a byte order mark.
Result<std::string> to_utf8(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xFF\xFE") return utf8_of_utf16(bytes.substr(2), false);
  if (bytes.substr(0, 2) == "\xFE\xFF") return utf8_of_utf16(bytes.substr(2), true);
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  if (is_utf8(bytes)) return std::string(bytes);
  if (!declares_latin1(bytes)) return invalid_data("is not UTF-8");
  std::string text;
  for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
  return text;
}

/// Scans the tags of a document and checks that it keeps to the limits. It distinguishes only tags
/// from text; all other errors are found by the XML parser.
class TagCounter {
 public:
  TagCounter(std::string_view text, const XmlLimits& limits) : text_(text), limits_(limits) {}

  Result<void> run() {
    for (at_ = text_.find('<'); at_ != std::string_view::npos; at_ = text_.find('<', at_)) {
      if (starts("<!--")) {
        skip("<!--", "-->");
      } else if (starts("<![CDATA[")) {
        skip("<![CDATA[", "]]>");
      } else if (starts("<?")) {
        skip("<?", "?>");
      } else if (starts("<!")) {
        if (auto ok = document_type(); !ok) return ok;
      } else if (auto ok = tag(); !ok) {
        return ok;
      }
    }
    return {};
  }

 private:
  [[nodiscard]] bool starts(std::string_view word) const {
    return text_.substr(at_, word.size()) == word;
  }
  /// Skips markup that begins with `start` here and ends with `end`. The end must not overlap the
  /// start, so "<!-->" does not end.
  void skip(std::string_view start, std::string_view end) {
    const std::size_t found = text_.find(end, at_ + start.size());
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  [[nodiscard]] std::string here() const {
    return "line " + std::to_string(line_at(text_, at_)) + ": ";
  }

  // Refuses a document type with an internal subset, because that could define entities that
  // expand. Without an internal subset, a document type only names the kind of document.
  Result<void> document_type() {
    const std::size_t end = text_.find_first_of("[>", at_);
    if (end != std::string_view::npos && text_[end] == '[') {
      return fail(ErrorCode::kUnsupported,
                  here() + "a document type with internal definitions is not supported");
    }
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    return {};
  }

  Result<void> tag() {
    const bool closes = starts("</");
    char quote = 0;
    std::size_t end = at_ + 1;
    for (; end < text_.size() && (quote != 0 || text_[end] != '>'); ++end) {
      if (quote != 0) {
        if (text_[end] == quote) quote = 0;
      } else if (text_[end] == '"' || text_[end] == '\'') {
        quote = text_[end];
      }
    }
    const bool empty = end < text_.size() && text_[end - 1] == '/';
    if (closes) {
      --depth_;
    } else {
      if (++count_ > limits_.elements) {
        return fail(ErrorCode::kLimitExceeded,
                    here() + "has more than " + std::to_string(limits_.elements) + " elements");
      }
      if (depth_ + 1 > limits_.depth) {
        return fail(ErrorCode::kLimitExceeded,
                    here() + "elements are nested deeper than " + std::to_string(limits_.depth));
      }
      if (!empty) ++depth_;
    }
    at_ = end;
    return {};
  }

  std::string_view text_;
  const XmlLimits& limits_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
  int depth_ = 0;
};

}  // namespace

Result<XmlInput> XmlInput::parse(std::string_view bytes, const XmlLimits& limits) {
  if (bytes.size() > limits.bytes) {
    return fail(ErrorCode::kLimitExceeded,
                "is larger than " + std::to_string(limits.bytes) + " bytes");
  }
  Result<std::string> text = to_utf8(bytes);
  if (!text) return tl::unexpected(text.error());
  if (auto ok = TagCounter(*text, limits).run(); !ok) return tl::unexpected(ok.error());
  XmlInput input;
  input.text_ = *std::move(text);
  input.document_ = std::make_unique<pugi::xml_document>();
  const pugi::xml_parse_result parsed = input.document_->load_buffer(
      input.text_.data(), input.text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    return invalid_data("line " + std::to_string(line_at(input.text_, at)) +
                        ": is not XML: " + parsed.description());
  }
  if (!input.root()) return invalid_data("is not XML: it has no element");
  std::uint32_t lines = 0;
  for (std::size_t at = 0; at < input.text_.size(); at += kLineBlock) {
    input.lines_before_.push_back(lines);
    const std::string_view block = std::string_view(input.text_).substr(at, kLineBlock);
    lines += static_cast<std::uint32_t>(std::count(block.begin(), block.end(), '\n'));
  }
  return input;
}

int XmlInput::other_roots() const {
  int others = 0;
  for (pugi::xml_node node = root().next_sibling(); node; node = node.next_sibling()) {
    if (node.type() == pugi::node_element) ++others;
  }
  return others;
}

std::int64_t XmlInput::line_of(const pugi::xml_node& node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset < 0 || static_cast<std::size_t>(offset) >= text_.size()) return 0;
  const auto at = static_cast<std::size_t>(offset);
  const std::string_view rest =
      std::string_view(text_).substr(at / kLineBlock * kLineBlock, at % kLineBlock);
  return 1 + lines_before_[at / kLineBlock] + std::count(rest.begin(), rest.end(), '\n');
}

std::string XmlInput::describe(const pugi::xml_node& node) {
  std::string text = node.name();
  const char* id =
      node.attribute("xml:id") ? node.attribute("xml:id").value() : node.attribute("id").value();
  if (*id != '\0') text += std::string(" '") + id + "'";
  return text;
}

std::string_view xml_local_name(std::string_view name) noexcept {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string xml_prefix_of(const pugi::xml_node& root, std::string_view space) {
  for (const pugi::xml_attribute& a : root.attributes()) {
    const std::string_view name = a.name();
    if (name.substr(0, 6) == "xmlns:" && a.value() == space) {
      return std::string(name.substr(6)) + ":";
    }
  }
  return {};
}

std::string xml_text_of(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      text += child.value();
    }
  }
  return text;
}

}  // namespace felt
