#pragma once

#include <QString>

namespace felt::desktop {

/// The options of the command line for a session with a participant.
struct TrialRequest {
  QString study;   ///< the path of the study; "" if no session is requested
  QString folder;  ///< of the results
  int participant = 0;
  QString session = QStringLiteral("train");  ///< one of kSessionKinds
};

}  // namespace felt::desktop
