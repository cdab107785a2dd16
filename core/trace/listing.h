// The text of the method files, embedded by the build: the listing on screen is the code that runs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texelscope {

struct EmbeddedFile {
    std::string_view path;  ///< from the project's root
    std::string_view text;
};

/// Defined by a file that the build writes.
[[nodiscard]] std::span<const EmbeddedFile> embedded_files();

struct Listing {
    std::string path;
    std::vector<std::string> lines;  ///< lines[0] is line 1
};

/// The lines of an embedded file; empty where there is none of that path.
[[nodiscard]] Listing load_listing(std::string_view path);
/// Line `line`, from 1, without the spaces before it. Requires that there is one.
[[nodiscard]] std::string code_at(const Listing& listing, int line);
/// The first line, from 1, on which `text` stands; 0 where there is none.
[[nodiscard]] int line_with(const Listing& listing, std::string_view text);
/// Source text with each trace("name", value) folded to its value: plain mathematics. A statement that only names a
/// value, or assigns it to itself, becomes name = value; trace("x", x) stays. Lines remain lines.
[[nodiscard]] std::string without_trace(std::string_view source);
[[nodiscard]] Listing without_trace(const Listing& listing);

}  // namespace texelscope
