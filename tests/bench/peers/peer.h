// What the peers have in common: FILE.tri ROUNDS [OUT.png] in, the line of `texelscope bench` and a picture out.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/image/load.h"
#include "core/measure/timing.h"
#include "core/scene/triangles_file.h"

namespace texelscope::peer {

struct Call {
    std::string path, picture;  ///< picture: empty for none
    int rounds = 1;
    TrianglesFile file;
};

/// One line on stderr, and the exit code for bad usage.
[[noreturn]] inline void stop(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(2);
}

[[nodiscard]] inline Call read_call(int count, char** words) {
    if (count < 3) stop("expected FILE.tri ROUNDS [OUT.png]");
    const auto bytes = read_file(words[1], kMaxFileBytes);
    if (!bytes) stop(bytes.error().text());
    auto file = parse_triangles(*bytes, words[1]);
    if (!file) stop(file.error().text());
    return {words[1], count > 3 ? words[3] : "", std::max(1, std::atoi(words[2])), *std::move(file)};
}

/// Clears and draws once for what is done once, then as often as asked; drawing alone is timed.
template <class Clear, class Draw>
void race(const Call& call, const char* name, const Clear& clear, const Draw& draw) {
    std::vector<double> times;
    for (int round = -1; round < call.rounds; ++round) {
        clear();
        const auto start = std::chrono::steady_clock::now();
        draw();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        if (round >= 0) times.push_back(time.count());
    }
    const std::string stem = std::filesystem::path(call.path).stem().string();
    const TimedWork work{
        .method = name, .name = stem, .samples = call.file.covered, .triangles = call.file.vertices.size() / 3};
    std::puts(timing_line(work, timing_of(std::move(times))).c_str());
}

inline void write_picture(const Call& call, const Image& picture) {
    const auto png = encode_png(picture);
    if (!png) stop(png.error().text());
    if (const auto error = write_file_atomically(call.picture, *png)) stop(error->text());
}

}  // namespace texelscope::peer
