#include "app/cli/output.h"

#include <cerrno>
#include <system_error>
#include <utility>

namespace texelscope {
namespace {

namespace fs = std::filesystem;

std::string reason(int code) { return "cannot be written: " + std::generic_category().message(code); }

/// A new empty file beside `target`, named in `part`; null, with errno set, where there can be none.
std::FILE* create_beside(const fs::path& target, fs::path& part) {
    constexpr int kTries = 1000;  // names that a killed program left behind are passed over
    for (int i = 0; i < kTries; ++i) {
        part = target;
        part += ".part" + std::to_string(i);
        if (std::FILE* file = std::fopen(part.c_str(), "wbx")) return file;
        if (errno != EEXIST) break;
    }
    part.clear();
    return nullptr;
}

}  // namespace

Result<Output> Output::open(const std::string& target) {
    Output output;
    if (target.empty() || target == "-") return output;
    std::error_code bad;
    const fs::file_status status = fs::status(target, bad);
    if (fs::is_directory(status)) return Error{target, "cannot be written: it is a folder"};
    output.target_ = target;
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        output.file_.reset(std::fopen(target.c_str(), "wb"));
    } else {
        if (fs::exists(status)) {
            output.permissions_ = status.permissions();
            output.target_ = fs::canonical(target, bad);  // a link keeps pointing to its file
            if (bad) return Error{target, "cannot be written: " + bad.message()};
        }
        output.file_.reset(create_beside(output.target_, output.part_));
    }
    if (!output.file_) return Error{target, reason(errno)};
    return output;
}

Output::~Output() {
    if (!file_ || part_.empty()) return;
    file_.reset();
    std::error_code ignored;
    fs::remove(part_, ignored);
}

void Output::stop(int code) {
    if (!error_) error_ = Error{file_ ? target_.string() : "stdout", reason(code)};
}

void Output::write(std::string_view text) {
    if (error_ || text.empty()) return;
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file_ ? file_.get() : stdout) != text.size()) stop(errno);
}

std::optional<Error> Output::finish() {
    errno = 0;
    if (std::fflush(file_ ? file_.get() : stdout) != 0) stop(errno);
    if (error_ || !file_) return error_;
    errno = 0;
    if (std::fclose(file_.release()) != 0) error_ = Error{target_.string(), reason(errno)};
    if (part_.empty()) return error_;
    std::error_code bad, ignored;
    if (permissions_) fs::permissions(part_, *permissions_, ignored);
    if (!error_) fs::rename(part_, target_, bad);
    if (bad) error_ = Error{target_.string(), "cannot be written: " + bad.message()};
    if (error_) fs::remove(part_, ignored);
    return error_;
}

}  // namespace texelscope
