#include "artist.h"

namespace felt::bench {

std::unique_ptr<Artist> mypaint_preset(const std::string& /*preset*/) {
  return nullptr;
}

}  // namespace felt::bench
