// How many random cases a test runs.
#pragma once

namespace texelscope {

/// `sanitized` of them, the first ones of the same seeds, where a sanitizer looks at each operation and takes ten times
/// as long: it looks for what an operation does, and a few cases of each kind do all of them. No check is left out.
[[nodiscard]] constexpr unsigned cases([[maybe_unused]] unsigned all, [[maybe_unused]] unsigned sanitized) {
#ifdef TEXELSCOPE_SANITIZED
    return sanitized;
#else
    return all;
#endif
}

}  // namespace texelscope
