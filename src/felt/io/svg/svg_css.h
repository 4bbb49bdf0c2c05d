#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/io/svg/svg_variables.h"

namespace pugi {
class xml_node;
}

namespace felt {

/// One "property: value" of CSS.
struct SvgDeclaration {
  std::string_view name;
  std::string_view value;
  bool important = false;
};

/// Splits "name: value; ..." into declarations. Anything else is skipped.
void svg_declarations(std::string_view text,
                      const std::function<void(const SvgDeclaration&)>& found);

/// Returns CSS without its comments.
std::string svg_without_comments(std::string_view css);

/// The rules of the style elements of a file. Supported selectors: type, *, #id, .class,
/// [attribute] with its operators, :first-child, :last-child, :only-child, :root, and the four
/// combinators. Rules with other selectors, and rules inside @media and similar, are skipped and
/// counted.
class SvgStyleSheet {
 public:
  static constexpr std::size_t kMaxSelectors = 100000;

  /// Appends the text of a style element.
  void add(std::string_view css);

  /// Calls `found` with every declaration that applies to an element. If several declarations set
  /// the same property, the one with the greatest `precedence` wins; the order of declarations with
  /// equal precedence is unspecified. The number of matching steps for a file is limited. Returns
  /// false if no steps are left; from then on, no rules apply.
  bool match(const pugi::xml_node& node,
             const std::function<void(const SvgDeclaration&, std::uint64_t precedence)>& found);

  [[nodiscard]] bool empty() const noexcept { return rules_.empty(); }
  /// Keeps a value for the lifetime of the sheet. Returns "" if the values of a file exceed 16 MiB.
  std::string_view keep(std::string_view value);
  /// Returns the custom properties of the root element. Each of them applies to all elements that
  /// have no other value for it.
  [[nodiscard]] const SvgVariables& root_variables() const noexcept { return root_variables_; }
  void set_root_variables(SvgVariables variables) { root_variables_ = std::move(variables); }
  /// Returns the number of bytes that may still be read in this file to replace variables. The
  /// caller subtracts the bytes that it reads.
  [[nodiscard]] std::size_t& variable_bytes_left() noexcept { return variable_bytes_left_; }
  /// Returns the number of rules and @-rules that were skipped.
  [[nodiscard]] std::int64_t left_out() const noexcept { return left_out_; }

 private:
  struct Attribute {
    std::string_view name, value;
    char relation = 0;  ///< 0: the attribute is present; or '=', '~', '|', '^', '$', '*'
  };
  /// The conditions for one element: "rect.leaf:first-child".
  struct Compound {
    char combinator =
        ' ';  ///< how the element is related to that of the previous compound: ' ', '>', '+', '~'
    std::string_view type, id;
    std::vector<std::string_view> classes;
    std::vector<Attribute> attributes;
    bool first_child = false, last_child = false, root = false;
  };
  struct Rule {
    std::vector<Compound> compounds;  ///< the last compound is for the element itself
    std::uint64_t precedence = 0;
    std::string_view body;
  };
  class Parser;

  bool matches(const Rule& rule, pugi::xml_node node);
  bool is_like(const Compound& compound, const pugi::xml_node& node);

  std::deque<std::string> texts_;  ///< the text that the views refer to
  std::vector<Rule> rules_;
  std::map<std::string_view, std::vector<std::uint32_t>> by_id_, by_class_, by_type_;
  std::vector<std::uint32_t> for_all_;
  SvgVariables root_variables_;
  std::set<std::string, std::less<>> kept_;
  std::size_t kept_bytes_ = 0;
  std::size_t variable_bytes_left_ = std::size_t{256} << 20;
  std::int64_t left_out_ = 0;
  std::int64_t steps_left_ = 20'000'000;
};

}  // namespace felt
