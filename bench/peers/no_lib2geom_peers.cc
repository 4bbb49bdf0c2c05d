#include "bench/peers/peer.h"

namespace felt::bench {

/// Replaces lib2geom_peers.cc if lib2geom is not installed: its rows are skipped.
Peers make_lib2geom_peers(double /*tolerance*/) {
  return {};
}

}  // namespace felt::bench
