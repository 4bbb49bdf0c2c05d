#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Appends `text` as the value of an attribute in double quotes. Fails, and appends nothing, if the
/// text is not UTF-8 or has a character that XML forbids (most control characters, U+FFFE, U+FFFF).
Result<void> append_xml_attribute(std::string& out, std::string_view text);

/// Returns name_in_file(), or stroke_name() if XML forbids that name.
std::string xml_stroke_name(const Drawing& drawing, StrokeId id);

/// The names of strokes in a file of XML, from which a reader gets both names and ids.
class XmlStrokeNames {
 public:
  struct Names {
    std::string name;  ///< xml_stroke_name()
    std::string
        number;  ///< stroke_name() if a reader would not get the id from the name; else empty
  };
  /// Requires that the drawing lives longer.
  explicit XmlStrokeNames(const Drawing& drawing);
  [[nodiscard]] Names of(StrokeId id) const;

 private:
  const Drawing& drawing_;
  bool has_numbers_;
};

}  // namespace felt
