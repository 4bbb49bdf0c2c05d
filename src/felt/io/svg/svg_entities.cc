#include "felt/io/svg/svg_entities.h"

#include <algorithm>
#include <map>

#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

constexpr std::string_view kDoctype = "<!DOCTYPE";

/// Where the document type begins; npos where the first element comes before one.
std::size_t find_doctype(std::string_view text) noexcept {
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = text.substr(at);
    if (rest.substr(0, kDoctype.size()) == kDoctype) return at;
    const bool is_comment = rest.substr(0, 4) == "<!--", is_instruction = rest.substr(0, 2) == "<?";
    if (!is_comment && !is_instruction) return std::string_view::npos;
    at = text.find(is_comment ? "-->" : "?>", at + (is_comment ? 4 : 2));
  }
  return at;
}

/// Where its definitions begin, or npos where it has none.
std::size_t find_definitions(std::string_view text, std::size_t doctype) noexcept {
  if (doctype == std::string_view::npos) return doctype;
  char quote = 0;
  for (std::size_t i = doctype; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '[') {
      return i + 1;
    } else if (text[i] == '>') {
      break;
    }
  }
  return std::string_view::npos;
}

/// Reads the definitions of a document type.
class Definitions {
 public:
  Definitions(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  /// Where the document type ends; npos where it does not.
  std::size_t read() {
    while (at_ < text_.size() && text_[at_] != ']') {
      if (text_.substr(at_, 4) == "<!--") {
        skip("<!--", "-->");
      } else if (text_.substr(at_, 2) == "<?") {
        skip("<?", "?>");
      } else if (text_[at_] == '<') {
        definition();
      } else {
        ++at_;
      }
    }
    const std::size_t end = text_.find('>', at_);
    return end == std::string_view::npos ? end : end + 1;
  }

  [[nodiscard]] const std::map<std::string_view, std::string_view>& entities() const noexcept {
    return entities_;
  }

 private:
  /// What begins with `start` here and ends with `end`; the two share no character ("<!-->").
  void skip(std::string_view start, std::string_view end) {
    const std::size_t found = text_.find(end, at_ + start.size());
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  /// <!ENTITY name "text">
  void definition() {
    const std::size_t begin = at_;
    char quote = 0;
    for (; at_ < text_.size() && (quote != 0 || text_[at_] != '>'); ++at_) {
      if (quote != 0) {
        if (text_[at_] == quote) quote = 0;
      } else if (text_[at_] == '"' || text_[at_] == '\'') {
        quote = text_[at_];
      }
    }
    SvgScan scan(text_.substr(begin, at_ - begin));
    if (at_ < text_.size()) ++at_;
    if (!scan.take("<!ENTITY")) return;
    scan.skip_spaces();
    const std::string_view name = scan.name();
    scan.skip_spaces();
    const char mark = scan.peek();
    if (name.empty() || (mark != '"' && mark != '\'') || !scan.take(mark)) return;
    entities_.emplace(name, scan.until(mark));
  }

  std::string_view text_;
  std::size_t at_;
  std::map<std::string_view, std::string_view> entities_;
};

/// Replaces entities, also those inside of others, within a budget for the whole file.
class Expander {
 public:
  using Entities = std::map<std::string_view, std::string_view>;
  explicit Expander(const Entities& entities) : entities_(entities) {}

  /// False: more is added than a file may, or they are nested too deep.
  bool append(std::string_view text, std::string& result, int nesting) {
    constexpr int kMaxNesting = 16;
    added_ += text.size();
    if (nesting > kMaxNesting || added_ > limits::kMaxSvgEntityBytes) return false;
    while (true) {
      const std::size_t mark = std::min(text.find('&'), text.size());
      result += text.substr(0, mark);
      text.remove_prefix(mark);
      if (text.empty()) return true;
      SvgScan scan(text.substr(1, 256));
      const auto entity = entities_.find(scan.name());
      if (entity == entities_.end() || !scan.take(';')) {
        result += '&';
        text.remove_prefix(1);
        continue;
      }
      if (!append(entity->second, result, nesting + 1)) return false;
      text.remove_prefix(1 + scan.taken());
    }
  }

 private:
  const Entities& entities_;
  std::size_t added_ = 0;
};

}  // namespace

bool has_svg_entities(std::string_view text) noexcept {
  return find_definitions(text, find_doctype(text)) != std::string_view::npos;
}

Result<std::string> svg_with_entities(std::string_view text) {
  const std::size_t begin = find_doctype(text);
  Definitions definitions(text, find_definitions(text, begin));
  const std::size_t end = definitions.read();
  if (end == std::string_view::npos) {
    return fail(ErrorCode::kInvalidData, "is no XML: its document type does not end");
  }
  std::string result(text.substr(0, begin));
  const std::string_view doctype = text.substr(begin, end - begin);
  result.append(static_cast<std::size_t>(std::count(doctype.begin(), doctype.end(), '\n')), '\n');
  Expander expander(definitions.entities());
  std::string_view rest = text.substr(end);
  while (!rest.empty()) {
    const std::size_t mark = std::min(rest.find('&'), rest.size());
    result += rest.substr(0, mark);
    rest.remove_prefix(mark);
    if (rest.empty()) break;
    SvgScan scan(rest.substr(1, 256));
    const auto entity = definitions.entities().find(scan.name());
    if (entity == definitions.entities().end() || !scan.take(';')) {
      result += '&';
      rest.remove_prefix(1);
      continue;
    }
    if (!expander.append(entity->second, result, 0)) {
      return fail(ErrorCode::kLimitExceeded,
                  "has entities that add more than 1 MiB, or are nested more than 16 deep");
    }
    rest.remove_prefix(1 + scan.taken());
  }
  return result;
}

}  // namespace felt
