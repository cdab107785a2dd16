// Where a step stands: t0/s3/y11/x7/e2 is expression 2 of pixel x = 7, row y = 11, stage 3, triangle 0.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/number/real.h"

namespace texelscope {

/// The five sizes of step, coarse to fine.
enum class Level : std::uint8_t { triangle, stage, scanline, pixel, expression };
inline constexpr int kLevels = 5;

[[nodiscard]] std::string_view id_of(Level level);
[[nodiscard]] std::optional<Level> level_from(std::string_view id);

/// One part of a path: 't' shape, 's' stage, 'e' expression, or the letter of a loop (y, x, v, u …).
struct PathPart {
    char letter = 't';
    Integer index = 0;
    friend bool operator==(const PathPart&, const PathPart&) = default;
};

struct Path {
    std::vector<PathPart> parts;

    [[nodiscard]] bool empty() const { return parts.empty(); }
    [[nodiscard]] bool at_expression() const { return !parts.empty() && parts.back().letter == 'e'; }
    /// How deep the unit lies: 1 shape, 2 stage, 3 first loop, 4 second loop; an expression counts as its unit.
    [[nodiscard]] int depth() const { return static_cast<int>(parts.size()) - at_expression(); }
    /// The first `depth` parts.
    [[nodiscard]] Path prefix(int depth) const {
        return {{parts.begin(),
                 parts.begin() + std::min<std::ptrdiff_t>(depth, static_cast<std::ptrdiff_t>(parts.size()))}};
    }
    [[nodiscard]] Path unit() const { return prefix(depth()); }
    [[nodiscard]] Path child(char letter, Integer index) const {
        Path path = *this;
        path.parts.push_back({letter, index});
        return path;
    }
    /// The index under `letter`, if the path has it.
    [[nodiscard]] std::optional<Integer> index_of(char letter) const {
        for (const PathPart& part : parts) {
            if (part.letter == letter) return part.index;
        }
        return std::nullopt;
    }
    [[nodiscard]] std::string text() const;
    friend bool operator==(const Path&, const Path&) = default;
};

/// Reads what text() prints; nothing where it is anything else.
[[nodiscard]] std::optional<Path> parse_path(std::string_view text);

}  // namespace texelscope
