#include "felt/io/svg/svg_css.h"

#include <algorithm>
#include <pugixml.hpp>
#include <utility>

#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

/// Returns the position of c outside quotes and brackets, or the end.
std::size_t find_outside(std::string_view text, char c, std::size_t from = 0) noexcept {
  char quote = 0;
  int depth = 0;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char at = text[i];
    if (quote != 0) {
      if (at == quote) quote = 0;
    } else if (at == '"' || at == '\'') {
      quote = at;
    } else if (at == '(' || at == '[') {
      ++depth;
    } else if (at == ')' || at == ']') {
      depth = std::max(0, depth - 1);
    } else if (at == c && depth == 0) {
      return i;
    }
  }
  return text.size();
}

/// Returns the position after the brace that closes the block. The block begins before `from`.
std::size_t end_of_block(std::string_view css, std::size_t from) noexcept {
  int depth = 1;
  for (; from < css.size() && depth > 0; ++from) {
    depth += css[from] == '{' ? 1 : css[from] == '}' ? -1 : 0;
  }
  return from;
}

bool has_class(std::string_view list, std::string_view name) noexcept {
  while (!list.empty()) {
    list = svg_trimmed(list);
    std::size_t end = 0;
    while (end < list.size() && !is_svg_space(list[end])) ++end;
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(end);
  }
  return false;
}

bool attribute_is(std::string_view actual, char relation, std::string_view value) noexcept {
  const auto at = actual.find(value);
  switch (relation) {
    case '=':
      return actual == value;
    case '~':
      return has_class(actual, value);
    case '|':
      return at == 0 && (actual.size() == value.size() || actual[value.size()] == '-');
    case '^':
      return !value.empty() && at == 0;
    case '$':
      return !value.empty() && actual.size() >= value.size() &&
             actual.substr(actual.size() - value.size()) == value;
    case '*':
      return !value.empty() && at != std::string_view::npos;
    default:
      return true;
  }
}

std::string_view local_name(std::string_view name) noexcept {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node element_before(pugi::xml_node node, std::int64_t& steps_left) {
  do {
    --steps_left;
    node = node.previous_sibling();
  } while (node && node.type() != pugi::node_element);
  return node;
}

pugi::xml_node element_after(pugi::xml_node node, std::int64_t& steps_left) {
  do {
    --steps_left;
    node = node.next_sibling();
  } while (node && node.type() != pugi::node_element);
  return node;
}

}  // namespace

void svg_declarations(std::string_view text,
                      const std::function<void(const SvgDeclaration&)>& found) {
  while (!text.empty()) {
    const std::size_t end = find_outside(text, ';');
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos) continue;
    SvgDeclaration d{svg_trimmed(part.substr(0, colon)), svg_trimmed(part.substr(colon + 1))};
    const std::size_t mark = d.value.rfind('!');
    if (mark != std::string_view::npos &&
        svg_same_word(svg_trimmed(d.value.substr(mark + 1)), "important")) {
      d.important = true;
      d.value = svg_trimmed(d.value.substr(0, mark));
    }
    if (!d.name.empty() && !d.value.empty()) found(d);
  }
}

std::string svg_without_comments(std::string_view css) {
  std::string clean;
  clean.reserve(css.size());
  while (!css.empty()) {
    const std::size_t begin = std::min(css.find("/*"), css.size());
    clean += css.substr(0, begin);
    css.remove_prefix(begin);
    if (css.empty()) break;
    const std::size_t end = css.find("*/", 2);
    clean += ' ';
    css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
  }
  for (const std::string_view mark : {"<!--", "-->"}) {
    const std::size_t at = clean.find(mark);
    if (at != std::string::npos) clean.replace(at, mark.size(), mark.size(), ' ');
  }
  return clean;
}

/// Parses the selectors and blocks of one text.
class SvgStyleSheet::Parser {
 public:
  Parser(SvgStyleSheet& style_sheet, std::string_view css) : style_sheet_(style_sheet), css_(css) {}

  void read() {
    while (true) {
      css_ = svg_trimmed(css_);
      if (css_.empty()) return;
      const std::size_t brace = find_outside(css_, '{');
      const std::size_t semicolon = find_outside(css_.substr(0, brace), ';');
      if (css_.front() == '@' && semicolon < brace) {
        ++style_sheet_.left_out_;
        css_.remove_prefix(semicolon + 1);
        continue;
      }
      const std::string_view selectors = css_.substr(0, brace);
      const std::size_t body = std::min(brace + 1, css_.size());
      const std::size_t end = end_of_block(css_, body);
      if (css_.front() == '@') {
        ++style_sheet_.left_out_;
      } else {
        const std::size_t close = end > body && css_[end - 1] == '}' ? end - 1 : end;
        const std::string_view block = css_.substr(body, close - body);
        add_rules(selectors, without_nested_rules(block));
      }
      css_.remove_prefix(end);
    }
  }

 private:
  /// Returns the declarations before the first nested rule. Nested rules and all declarations after
  /// the first one are ignored.
  std::string_view without_nested_rules(std::string_view block) {
    const std::size_t brace = block.find('{');
    if (brace == std::string_view::npos) return block;
    ++style_sheet_.left_out_;
    const std::size_t last = block.substr(0, brace).rfind(';');
    return block.substr(0, last == std::string_view::npos ? 0 : last);
  }

  /// Adds one rule for each selector of a list.
  void add_rules(std::string_view selectors, std::string_view body) {
    while (!selectors.empty()) {
      const std::size_t end = find_outside(selectors, ',');
      Rule rule;
      rule.body = body;
      if (style_sheet_.rules_.size() < kMaxSelectors &&
          read_selector(selectors.substr(0, end), rule)) {
        add(std::move(rule));
      } else {
        ++style_sheet_.left_out_;
      }
      selectors.remove_prefix(std::min(end + 1, selectors.size()));
    }
  }

  void add(Rule rule) {
    const auto index = static_cast<std::uint32_t>(style_sheet_.rules_.size());
    rule.precedence = rule.precedence << 24 | index;
    const Compound& last = rule.compounds.back();
    if (!last.id.empty()) {
      style_sheet_.by_id_[last.id].push_back(index);
    } else if (!last.classes.empty()) {
      style_sheet_.by_class_[last.classes.front()].push_back(index);
    } else if (!last.type.empty()) {
      style_sheet_.by_type_[last.type].push_back(index);
    } else {
      style_sheet_.for_all_.push_back(index);
    }
    style_sheet_.rules_.push_back(std::move(rule));
  }

  /// Returns false if the selector has an unsupported part, so that the rule must not apply.
  static bool read_selector(std::string_view text, Rule& rule) {
    SvgScan scan(svg_trimmed(text));
    if (scan.empty()) return false;
    char combinator = ' ';
    std::uint64_t ids = 0, classes = 0, types = 0;
    while (true) {
      Compound c;
      c.combinator = combinator;
      if (!read_compound(scan, c)) return false;
      ids += c.id.empty() ? 0 : 1;
      types += c.type.empty() ? 0 : 1;
      classes += c.classes.size() + c.attributes.size() + (c.first_child ? 1 : 0) +
                 (c.last_child ? 1 : 0) + (c.root ? 1 : 0);
      rule.compounds.push_back(std::move(c));
      const bool space = is_svg_space(scan.peek());
      if (scan.at_end()) break;
      combinator = ' ';
      for (const char sign : {'>', '+', '~'}) {
        if (scan.take(sign)) combinator = sign;
      }
      if (combinator == ' ' && !space) return false;
      scan.skip_spaces();
      if (rule.compounds.size() == 64) return false;
    }
    constexpr std::uint64_t kMax = 255;
    rule.precedence =
        std::min(ids, kMax) << 16 | std::min(classes, kMax) << 8 | std::min(types, kMax);
    return true;
  }

  static bool read_compound(SvgScan& scan, Compound& c) {
    const std::size_t before = scan.taken();
    if (!scan.take('*')) c.type = scan.name();
    if (scan.take('|') && !scan.take('*')) c.type = scan.name();  // in any namespace
    while (true) {
      if (scan.take('#')) {
        const std::string_view id = scan.name();
        if (id.empty() || (!c.id.empty() && c.id != id)) return false;
        c.id = id;
      } else if (scan.take('.')) {
        c.classes.push_back(scan.name());
        if (c.classes.back().empty()) return false;
      } else if (scan.take('[')) {
        if (!read_attribute(scan.until(']'), c)) return false;
      } else if (scan.take(':')) {
        if (!read_pseudo(scan.name(), c)) return false;
      } else {
        return scan.taken() > before;
      }
    }
  }

  static bool read_attribute(std::string_view text, Compound& c) {
    SvgScan scan(svg_trimmed(text));
    Attribute a;
    a.name = scan.name();
    scan.skip_spaces();
    if (a.name.empty()) return false;
    if (!scan.empty()) {
      a.relation = scan.peek();
      if (std::string_view("=~|^$*").find(a.relation) == std::string_view::npos) return false;
      scan.take(a.relation);
      if (a.relation != '=' && !scan.take('=')) return false;
      a.value = svg_trimmed(scan.rest());
      if (a.value.size() >= 2 && (a.value.front() == '"' || a.value.front() == '\'') &&
          a.value.back() == a.value.front()) {
        a.value = a.value.substr(1, a.value.size() - 2);
      }
    }
    c.attributes.push_back(a);
    return true;
  }

  static bool read_pseudo(std::string_view name, Compound& c) {
    const bool only = name == "only-child", root = name == "root";
    const bool first = only || name == "first-child", last = only || name == "last-child";
    c.first_child = c.first_child || first;
    c.last_child = c.last_child || last;
    c.root = c.root || root;
    return first || last || root;
  }

  SvgStyleSheet& style_sheet_;
  std::string_view css_;
};

void SvgStyleSheet::add(std::string_view css) {
  texts_.push_back(svg_without_comments(css));
  Parser(*this, texts_.back()).read();
}

std::string_view SvgStyleSheet::keep(std::string_view value) {
  constexpr std::size_t kMaxKeptBytes = std::size_t{16} << 20;
  if (const auto known = kept_.find(value); known != kept_.end()) return *known;
  if ((kept_bytes_ += value.size()) > kMaxKeptBytes) return {};
  return *kept_.emplace(value).first;
}

bool SvgStyleSheet::is_like(const Compound& c, const pugi::xml_node& node) {
  if (!c.type.empty() && local_name(node.name()) != c.type) return false;
  if (!c.id.empty() && node.attribute("id").value() != c.id) return false;
  if (!c.classes.empty()) {
    const std::string_view list = node.attribute("class").value();
    for (const std::string_view name : c.classes) {
      if (!has_class(list, name)) return false;
    }
  }
  for (const Attribute& a : c.attributes) {
    const pugi::xml_attribute actual = node.attribute(std::string(a.name).c_str());
    if (!actual || !attribute_is(actual.value(), a.relation, a.value)) return false;
  }
  if (c.first_child && element_before(node, steps_left_)) return false;
  if (c.last_child && element_after(node, steps_left_)) return false;
  return !c.root || node.parent().type() == pugi::node_document;
}

/// Compares the compounds from the last to the first, and tries every element that a compound may
/// match. Counts the steps for the whole file, because a malicious rule can need very many.
bool SvgStyleSheet::matches(const Rule& rule, pugi::xml_node node) {
  struct Choice {
    std::size_t compound;
    pugi::xml_node node;
  };
  std::vector<Choice> open{{rule.compounds.size() - 1, node}};
  while (!open.empty()) {
    const Choice at = open.back();
    open.pop_back();
    if (--steps_left_ < 0) return false;
    if (!is_like(rule.compounds[at.compound], at.node)) continue;
    if (at.compound == 0) return true;
    const char combinator = rule.compounds[at.compound].combinator;
    const bool up = combinator == ' ' || combinator == '>';
    const bool once = combinator == '>' || combinator == '+';
    pugi::xml_node other = at.node;
    do {
      other = up ? other.parent() : element_before(other, steps_left_);
      if (!other || other.type() != pugi::node_element) break;
      if (--steps_left_ < 0) return false;
      open.push_back({at.compound - 1, other});
    } while (!once);
  }
  return false;
}

bool SvgStyleSheet::match(
    const pugi::xml_node& node,
    const std::function<void(const SvgDeclaration&, std::uint64_t precedence)>& found) {
  std::string_view list = svg_trimmed(node.attribute("class").value());
  const std::int64_t cost = 1 + static_cast<std::int64_t>(list.size() / 16);
  const auto try_rules = [&](const std::vector<std::uint32_t>& indices) {
    for (const std::uint32_t i : indices) {
      if ((steps_left_ -= cost) < 0) return;
      const Rule& rule = rules_[i];
      if (!matches(rule, node)) continue;
      steps_left_ -= static_cast<std::int64_t>(rule.body.size() / 16);
      svg_declarations(rule.body, [&](const SvgDeclaration& d) { found(d, rule.precedence); });
    }
  };
  const auto try_key = [&](const auto& table, std::string_view key) {
    if (const auto at = table.find(key); at != table.end()) try_rules(at->second);
  };
  if (rules_.empty()) return true;
  try_rules(for_all_);
  try_key(by_type_, local_name(node.name()));
  if (const pugi::xml_attribute id = node.attribute("id")) try_key(by_id_, id.value());
  while (!list.empty()) {
    --steps_left_;
    std::size_t end = 0;
    while (end < list.size() && !is_svg_space(list[end])) ++end;
    try_key(by_class_, list.substr(0, end));
    list = svg_trimmed(list.substr(end));
  }
  return steps_left_ >= 0;
}

}  // namespace felt
