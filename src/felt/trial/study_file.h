#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/trial/study.h"

namespace felt {

/// The maximal size of the text of a study in bytes.
inline constexpr std::size_t kMaxStudyBytes = std::size_t{64} << 10;
/// study_problems() returns at most this number of errors.
inline constexpr std::size_t kMaxStudyProblems = 100;

/// Reads a study. `name` is the name of the file; messages start with it. Fails if the text is not
/// TOML, is too long, has an unknown key, or lacks a condition or a shape. Also fails if a value
/// has the wrong type or is out of range, or if a key has no effect because of another one. Reports
/// the first error with its line: "keefe.toml:12: condition.guidance is "grove", it must be one of
/// none, groove, ...". Opens no other file.
Result<Study> read_study(std::string_view text, const std::string& name = "study");

/// Returns the errors of a text in the order of their lines; empty if read_study accepts the text.
std::vector<Error> study_problems(std::string_view text, const std::string& name = "study");

}  // namespace felt
