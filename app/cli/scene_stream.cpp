#include "app/cli/scene_stream.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/cli/command.h"
#include "app/shell/documents.h"

namespace texelscope {
namespace {

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

}  // namespace

Error SceneStream::failure() const { return {name_, "cannot be read: " + std::generic_category().message(errno)}; }

Result<bool> SceneStream::read_line(std::string& text) {
    for (int c = getc_unlocked(file_.get()); c != EOF; c = getc_unlocked(file_.get())) {
        if (text.size() >= kMaxSceneBytes)
            return Error{name_, "is longer than " + std::to_string(kMaxSceneBytes) + " bytes, the most that is read"};
        text += static_cast<char>(c);
        if (c == '\n') return true;
    }
    if (std::ferror(file_.get()) != 0) return failure();
    return false;
}

Result<std::optional<SceneStream::Line>> SceneStream::line() {
    for (;;) {
        Line line{lines_read_, {}};
        const auto more = read_line(line.text);
        if (!more) return more.error();
        ++lines_read_;
        if (!is_blank(line.text)) return std::optional(std::move(line));
        if (!*more) return std::optional<Line>();
    }
}

std::optional<Error> SceneStream::read_rest(std::string& text) {
    for (;;) {
        const auto more = read_line(text);
        if (!more) return more.error();
        if (!*more) return std::nullopt;
    }
}

Result<SceneStream> SceneStream::open(const std::string& target, Lines lines) {
    namespace fs = std::filesystem;
    SceneStream stream;
    stream.name_ = target == "-" ? "stdin" : target;
    std::error_code ignored;
    if (target != "-" && fs::is_directory(target, ignored)) return Error{target, "is a folder, expected a scene file"};
    stream.file_.reset(target == "-" ? stdin : std::fopen(target.c_str(), "rb"));
    if (!stream.file_) return stream.failure();
    const fs::path folder = target == "-" ? fs::path() : fs::path(target).parent_path();
    stream.files_ = {folder.empty() ? fs::path(".") : folder, assets_folder()};
    stream.has_lines_ = lines == Lines::always;
    if (lines == Lines::always) return stream;

    auto first = stream.line();
    if (!first) return first.error();
    if (lines == Lines::if_there && *first) {
        auto second = stream.line();
        if (!second) return second.error();
        stream.has_lines_ = *second && is_scene_lines((*first)->text + "\n" + (*second)->text.substr(0, 256));
        stream.second_ = *std::move(second);
    }
    stream.first_ = *std::move(first);
    if (stream.has_lines_ || !stream.first_) return stream;
    stream.whole_.assign(static_cast<std::size_t>(stream.first_->number), '\n');
    stream.whole_ += stream.first_->text;
    if (stream.second_) {
        stream.whole_.append(static_cast<std::size_t>(stream.second_->number - stream.first_->number - 1), '\n');
        stream.whole_ += stream.second_->text;
    }
    if (const auto error = stream.read_rest(stream.whole_)) return *error;
    return stream;
}

Result<std::optional<SceneStream::Item>> SceneStream::next() {
    Line line;
    if (!has_lines_) {
        if (std::exchange(done_, true)) return std::optional<Item>();
        line.text = std::move(whole_);
    } else if (first_ || second_) {
        std::optional<Line>& ahead = first_ ? first_ : second_;
        line = *std::exchange(ahead, std::nullopt);
    } else {
        auto read = this->line();
        if (!read) return read.error();
        if (!*read) return std::optional<Item>();
        line = **std::move(read);
    }
    auto loaded = parse_scene(line.text, name_, files_, line.number + 1);
    if (!loaded) return loaded.error();
    return std::optional(Item{line.number, *std::move(loaded)});
}

void print_warnings(const LoadedScene& loaded) {
    for (const std::string& warning : loaded.warnings) warn(warning);
}

Result<Scene> read_scene(const std::string& target, const DrawOptions& options) {
    auto stream = SceneStream::open(target, SceneStream::Lines::never);
    if (!stream) return stream.error();
    auto item = stream->next();
    if (!item) return item.error();
    if (!*item) return Error{target, "is empty, expected a scene"};
    print_warnings((*item)->loaded);
    Scene scene = std::move((*item)->loaded.scene);
    snap_scene(scene, options);
    return scene;
}

}  // namespace texelscope
