#include "bench/peers/peer.h"

namespace felt::bench {

/// Stands in where lib2geom is not installed: its rows are left out.
Peers make_lib2geom_peers(double /*tolerance*/) {
  return {};
}

}  // namespace felt::bench
