// How many random cases a test runs.
#pragma once

namespace texelscope {

#ifdef TEXELSCOPE_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// `sanitized` of them, the first ones of the same seeds, where a sanitizer looks at each operation and takes ten times
/// as long: it looks for what an operation does, and a few cases of each kind do all of them.
[[nodiscard]] constexpr unsigned cases(unsigned all, unsigned sanitized) { return kSanitized ? sanitized : all; }

}  // namespace texelscope
