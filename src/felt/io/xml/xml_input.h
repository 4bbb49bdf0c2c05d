#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt {

/// Limits of an untrusted XML document.
struct XmlLimits {
  std::size_t bytes = limits::kMaxImportBytes;
  std::size_t elements = limits::kMaxXmlElements;
  int depth = limits::kMaxXmlDepth;
};

/// An untrusted XML document, read within limits. The size, the depth and the number of elements
/// are bounded, and an internal DTD is an error, so there are no entities except the five that XML
/// predefines. All this is checked before the tree is built. Accepts UTF-8 and UTF-16, and also
/// ISO-8859-1 if the XML declaration names it. Private to this layer, because it exposes the XML
/// library.
class XmlInput {
 public:
  /// Parses a document. Fails if the document is not well-formed or exceeds a limit; the message
  /// states the line.
  static Result<XmlInput> parse(std::string_view bytes, const XmlLimits& limits = {});

  /// Returns the outermost element.
  [[nodiscard]] pugi::xml_node root() const { return document_->document_element(); }
  /// Returns the number of elements beside the outermost one: further documents in the same file,
  /// which a well-formed document does not have.
  [[nodiscard]] int other_roots() const;
  /// Returns the line of a node, from 1.
  [[nodiscard]] std::int64_t line_of(const pugi::xml_node& node) const;
  /// Returns "trace 'g7'" for messages: the name of the node, and its id if it has one.
  [[nodiscard]] static std::string describe(const pugi::xml_node& node);

 private:
  XmlInput() = default;

  std::string text_;  // as UTF-8
  std::unique_ptr<pugi::xml_document> document_;
  std::vector<std::uint32_t> lines_before_;  // line ends before each block of kLineBlock bytes
};

/// Returns the name of an element or attribute without its prefix.
std::string_view xml_local_name(std::string_view name) noexcept;

/// Returns the prefix that `root` declares for a namespace, with its colon ("felt:"), or "" if
/// `root` declares none.
std::string xml_prefix_of(const pugi::xml_node& root, std::string_view space);

/// Returns all text directly inside an element, without comments.
std::string xml_text_of(const pugi::xml_node& node);

}  // namespace felt
