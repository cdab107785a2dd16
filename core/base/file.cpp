#include "core/base/file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

namespace texelscope {
namespace {

namespace fs = std::filesystem;

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

std::string reason(int code) { return std::generic_category().message(code); }

Error unwritable(const fs::path& path, const std::string& why) { return {path.string(), "cannot be written: " + why}; }

std::optional<Error> write_to(File file, const fs::path& path, std::span<const std::uint8_t> bytes) {
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    const bool closed = std::fclose(file.release()) == 0;  // the last bytes may fail only here
    if (!written || !closed) return unwritable(path, reason(errno));
    return std::nullopt;
}

/// A new empty file beside `target`; its name in `name`. Null, with errno set, where there can be none.
File create_beside(const fs::path& target, fs::path& name) {
    constexpr int kTries = 1000;  // names that a killed program left behind are passed over
    for (int i = 0; i < kTries; ++i) {
        name = target;
        name += ".part" + std::to_string(i);
        if (File file{std::fopen(name.c_str(), "wbx")}) return file;
        if (errno != EEXIST) break;
    }
    return nullptr;
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t limit) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return Error{path.string(), "is a folder, expected a file"};
    const File file{std::fopen(path.c_str(), "rb")};
    if (!file) return Error{path.string(), "cannot be read: " + reason(errno)};
    std::string bytes;
    std::array<char, 65536> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), file.get())) {
        if (got > limit - bytes.size())
            return Error{path.string(), "is longer than " + std::to_string(limit) + " bytes, the most that is read"};
        bytes.append(block.data(), got);
    }
    if (std::ferror(file.get()) != 0) return Error{path.string(), "cannot be read: " + reason(errno)};
    return bytes;
}

std::optional<Error> write_file_atomically(const fs::path& path, std::span<const std::uint8_t> bytes) {
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::is_directory(status)) return unwritable(path, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        File device{std::fopen(path.c_str(), "wb")};
        if (!device) return unwritable(path, reason(errno));
        return write_to(std::move(device), path, bytes);
    }
    fs::path target = path;
    if (fs::exists(status)) {
        target = fs::canonical(path, failed);
        if (failed) return unwritable(path, failed.message());
    }
    fs::path part;
    File file = create_beside(target, part);
    if (!file) return unwritable(path, reason(errno));
    std::optional<Error> error = write_to(std::move(file), path, bytes);
    std::error_code ignored;
    if (!error) {
        if (fs::exists(status)) fs::permissions(part, status.permissions(), ignored);
        fs::rename(part, target, failed);
        if (failed) error = unwritable(path, failed.message());
    }
    if (error) fs::remove(part, ignored);
    return error;
}

}  // namespace texelscope
