#pragma once

#include "felt/validate/test_subject.h"

namespace felt::cli {

/// The person at the terminal. With `agrees_to_all` (--yes) nothing is asked, and what needs hands
/// on cables is not done where nobody is there.
class ConsolePerson final : public TestPerson {
 public:
  explicit ConsolePerson(bool agrees_to_all) : agrees_to_all_(agrees_to_all) {}
  bool does(PersonTask task, const std::string& words) override;

 private:
  bool agrees_to_all_;
};

}  // namespace felt::cli
