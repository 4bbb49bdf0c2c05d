#pragma once

#include <string>

#include "felt/stroke/stroke.h"

namespace felt {

/// A stroke and the name that it has in its file: one line of JSON, one trace of InkML.
struct NamedStroke {
  std::string id;
  Stroke stroke;

  friend bool operator==(const NamedStroke&, const NamedStroke&) = default;
};

}  // namespace felt
