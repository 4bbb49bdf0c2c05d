#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "felt/material/toml_entries.h"
#include "felt/trial/study.h"

namespace felt {

/// Checks the tables [[hypothesis]] of a study whose conditions are read: that their keys are
/// complete, that their conditions and sessions exist and their measures are metrics of a trial,
/// and that no two are equal. Calls `say` with the line and the text of each problem. `is_refused`
/// says whether the value of a key was refused before, so that it is not reported twice.
void check_hypotheses(
    const Study& study, std::span<const TomlEntry> entries,
    const std::function<bool(std::string_view key, std::size_t table)>& is_refused,
    const std::function<void(int line, const std::string& what)>& say);

/// Returns the session in which a hypothesis is tested: its own, or the first session of the study
/// that has both conditions. Requires a study that read_study() accepted.
SessionKind hypothesis_session(const Study& study, const StudyHypothesis& hypothesis);

/// Returns the index of the condition of a name. Requires a condition of that name.
std::size_t condition_index(const Study& study, std::string_view name);

/// Returns a hypothesis as a sentence: "err_total_mm is smaller in default than in air", with the
/// labels of the conditions.
std::string hypothesis_text(const Study& study, const StudyHypothesis& hypothesis);

}  // namespace felt
