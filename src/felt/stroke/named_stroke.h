#pragma once

#include <string>

#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke and its name in a file. In a file, it is one line of JSON or one trace of InkML.
struct NamedStroke {
  std::string id;
  Stroke stroke;

  friend bool operator==(const NamedStroke&, const NamedStroke&) = default;
};

}  // namespace felt
