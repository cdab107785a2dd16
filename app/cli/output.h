// Where a command's output goes: stdout, or a file that is replaced only once it is whole.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace texelscope {

/// Streams; a file's content goes beside it until finish() renames it. Without finish() the old content stays.
class Output {
public:
    /// @param target  a file name; empty or "-" for stdout.
    static Result<Output> open(const std::string& target);
    Output(Output&&) = default;
    Output& operator=(Output&&) = delete;
    ~Output();

    void write(std::string_view text);
    /// After a failed write nothing more is written; a long loop may stop.
    [[nodiscard]] bool failed() const { return error_.has_value(); }
    /// What went wrong, if anything.
    [[nodiscard]] std::optional<Error> finish();

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    Output() = default;
    void stop(int code);

    std::unique_ptr<std::FILE, Closer> file_;  ///< null: stdout
    std::filesystem::path target_, part_;      ///< part_ is empty where the target is written directly
    std::optional<std::filesystem::perms> permissions_;
    std::optional<Error> error_;
};

}  // namespace texelscope
