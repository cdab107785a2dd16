// Whole files in and out, within bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"

namespace texelscope {

/// The bytes of a file; pipes serve too. Fails on a folder, an unreadable file, and one of more than `limit` bytes;
/// never holds much more than `limit` bytes.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit);

/// Writes `bytes` to a new file beside `path` and renames it to `path`, so that a reader finds the old content or the
/// new, never a part. A symbolic link keeps pointing to its file; a device or pipe, which cannot be replaced, is
/// written directly. On failure returns why, the old content stays, and nothing else is left behind.
[[nodiscard]] std::optional<Error> write_file_atomically(const std::filesystem::path& path,
                                                         std::span<const std::uint8_t> bytes);

/// The same bytes, as file and image functions take them.
[[nodiscard]] inline std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace texelscope
