#pragma once

#include <string>

#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke and its name in a file, for example the stroke of one line of JSON or of one trace of
/// InkML.
struct NamedStroke {
  std::string id;
  Stroke stroke;

  friend bool operator==(const NamedStroke&, const NamedStroke&) = default;
};

}  // namespace felt
