// The operands of a printed expression, so that a script can evaluate it again in the number format.
#pragma once

#include <string>
#include <string_view>

#include "core/trace/tape.h"

namespace texelscope {

/// "truth", "integer", or "real": a number of the format that the method runs with.
[[nodiscard]] std::string_view type_name(const Value& value);
/// All digits: true, a JSON number, or in quotes what JSON has no number for.
[[nodiscard]] std::string value_json(const Value& value);

/// A JSON list of the names and numbers in the text of formula() and substituted(), in the order in which they stand
/// there: {"name":"u_x","value":0.5,"type":"real"}; no name for a constant. An integer that is taken as a real there
/// has the type real.
[[nodiscard]] std::string operands_json(const Tape& tape, const Named& named);

}  // namespace texelscope
