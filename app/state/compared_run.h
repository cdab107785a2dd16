// The run that a drawing is compared with, as words: "barycentric", "edge-equations as-printed", "sections f32".
#pragma once

#include <string>
#include <string_view>

#include "app/state/state.h"
#include "core/base/result.h"

namespace texelscope {

/// Reads a method's id, and behind it a variant's and a number format's where they are given.
Result<ComparedRun> parse_run(std::string_view words);
/// As words; empty where no method was chosen.
[[nodiscard]] std::string text_of(const ComparedRun& run);

/// How `run` draws beside `own`: what it leaves open is filled in.
[[nodiscard]] DrawSettings settings_of(const ComparedRun& run, const DrawSettings& own);
/// The run with what it leaves open filled in.
[[nodiscard]] ComparedRun completed(const ComparedRun& run, const DrawSettings& own);

}  // namespace texelscope
