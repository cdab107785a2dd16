// What repeated drawing took, and the line that `texelscope bench` and its peers print of it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace texelscope {

/// Of an even number the mean of the middle two. 0 where there is none.
[[nodiscard]] double median_of(std::vector<double> values);

struct Timing {
    double median_ms = 0, least_ms = 0;
};
/// Requires at least one.
[[nodiscard]] Timing timing_of(std::vector<double> milliseconds);

/// What one drawing draws.
struct TimedWork {
    std::string_view method, name;  ///< name: of the triangles; a file's stem
    int threads = 1;
    std::uint64_t samples = 0;  ///< those drawn again counted again
    std::uint64_t triangles = 0;
};
/// "method,t<threads>,<name>,median_ms,min_ms,Mpix_s,Mtri_s", both rates by the median; no end of line.
[[nodiscard]] std::string timing_line(const TimedWork& work, const Timing& timing);

}  // namespace texelscope
