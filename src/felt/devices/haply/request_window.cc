#include "felt/devices/haply/request_window.h"

#include <algorithm>

namespace felt::haply {

void RequestWindow::sent(bool bears_force) noexcept {
  if (is_overdue()) patience_ns_ = std::min(2 * patience_ns_, kMaxPatienceNs);
  unanswered_ = std::min(unanswered_ + 1, kMaxUnanswered);
  bears_force_ = bears_force;
  has_answered_ = false;
  waited_ns_ = 0;
}

void RequestWindow::answered() noexcept {
  if (unanswered_ > 0) --unanswered_;
  has_answered_ = true;
  waited_ns_ = 0;
  if (++prompt_answers_ < kPromptAnswers) return;
  prompt_answers_ = 0;
  patience_ns_ = kPatienceNs;
}

void RequestWindow::wait(std::int64_t ns) noexcept {
  if (unanswered_ == 0) return;
  waited_ns_ += ns;
  if (waited_ns_ < patience_ns_) return;
  prompt_answers_ = 0;
  if (!has_answered_) return;
  unanswered_ = 0;
  patience_ns_ = std::min(2 * patience_ns_, kMaxPatienceNs);
}

}  // namespace felt::haply
