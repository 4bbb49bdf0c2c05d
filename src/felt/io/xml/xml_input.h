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

/// What an XML document of a stranger may be.
struct XmlLimits {
  std::size_t bytes = limits::kMaxImportBytes;
  std::size_t elements = limits::kMaxXmlElements;
  int depth = limits::kMaxXmlDepth;
};

/// An XML document of a stranger, read within limits: no DTD of its own (hence no entities but the
/// five of XML), bounded size, depth and number of elements, checked before a tree is built.
/// UTF-8, UTF-16 and, where its declaration says so, ISO-8859-1. Private to this layer, since it
/// shows the XML library.
class XmlInput {
 public:
  /// Error: not well-formed, or beyond the limits; names the line.
  static Result<XmlInput> parse(std::string_view bytes, const XmlLimits& limits = {});

  /// The outermost element.
  [[nodiscard]] pugi::xml_node root() const { return document_->document_element(); }
  /// Line of a node, from 1.
  [[nodiscard]] std::int64_t line_of(const pugi::xml_node& node) const;
  /// "trace 'g7'": its name, and its id where it has one, for messages.
  [[nodiscard]] static std::string describe(const pugi::xml_node& node);

 private:
  XmlInput() = default;

  std::string text_;  // as UTF-8
  std::unique_ptr<pugi::xml_document> document_;
  std::vector<std::uint32_t> lines_before_;  // ends of line before each block of kLineBlock bytes
};

/// The name of an element or attribute without its prefix.
std::string_view xml_local_name(std::string_view name) noexcept;

/// The prefix with its colon that `root` gives to a namespace ("felt:"); empty where it has none.
std::string xml_prefix_of(const pugi::xml_node& root, std::string_view space);

/// All text directly inside an element, comments left out.
std::string xml_text_of(const pugi::xml_node& node);

}  // namespace felt
