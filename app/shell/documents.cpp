#include "app/shell/documents.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "app/state/link.h"
#include "app/state/store.h"
#include "app/views/view.h"
#include "core/base/file.h"
#include "core/image/load.h"
#include "core/scene/json.h"

namespace texelscope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFrontFile = "front.csv";  ///< beside a lesson: what `texelscope front LESSON` wrote
constexpr std::size_t kMostFront = 4U << 20U;         ///< [bytes]

[[nodiscard]] bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// The lesson file that a word means: a number, a folder's name, the folder, the file itself; empty where none.
[[nodiscard]] fs::path lesson_file(const std::string& word) {
    fs::path path(word);
    if (path.filename() == "lesson.md" || path.extension() == ".md") return path;
    if (is_there(path / "lesson.md")) return path / "lesson.md";
    const fs::path lessons = data_folder() / "lessons";
    const bool number = !word.empty() && word.size() <= 2 && word.find_first_not_of("0123456789") == std::string::npos;
    if (!number && path.filename() == path && is_there(lessons / path / "lesson.md"))
        return lessons / path / "lesson.md";
    if (!number) return {};
    const std::string prefix = (word.size() == 1 ? "0" + word : word) + "-";
    std::error_code bad;
    for (const auto& entry : fs::directory_iterator(lessons, bad)) {
        if (entry.path().filename().string().starts_with(prefix)) return entry.path() / "lesson.md";
    }
    return {};
}

/// What a lesson's `views` may name: the canvas is there without being asked for.
[[nodiscard]] std::vector<std::string_view> side_view_names() {
    std::vector<std::string_view> names;
    for (const View* view : views()) {
        if (view->name != "canvas") names.push_back(view->name);
    }
    return names;
}

/// What a pasted state opens the lesson by, wherever the program then runs: its name, or for one that does not come
/// with the program its folder, or the file where that has another name.
[[nodiscard]] std::string name_of(const Lesson& lesson) {
    std::error_code bad;
    const fs::path file = fs::absolute(lesson.file, bad).lexically_normal();
    if (fs::equivalent(file, data_folder() / "lessons" / lesson.id / "lesson.md", bad)) return lesson.id;
    return (file.filename() == "lesson.md" ? file.parent_path() : file).string();
}

/// A scene with all files that it is made of.
Result<std::shared_ptr<Document>> open_scene(const fs::path& file) {
    auto scene = load_scene(file, assets_folder());
    if (!scene) return scene.error();
    auto document = std::make_shared<Document>();
    document->id = file.string();
    document->scene = std::move(scene->scene);
    document->warnings = std::move(scene->warnings);
    document->files = {file};
    for (const auto& texture : document->scene.textures) {
        if (!texture->source.file.empty()) document->files.push_back(file.parent_path() / texture->source.file);
    }
    return document;
}

Result<std::shared_ptr<const Document>> open_lesson(const fs::path& file) {
    const std::vector<std::string_view> names = side_view_names();
    auto lesson = load_lesson(file, names);
    if (!lesson) return lesson.error();
    const fs::path scene = file.parent_path() / lesson->scene;
    if (!is_there(scene))
        return Error{
            fmt::format("{}:{}", file.string(), lesson->lines.of("scene")),
            fmt::format("scene is '{}', which is not there, expected a file beside the lesson", lesson->scene)};
    auto document = open_scene(scene);
    if (!document) return document.error();
    if (const fs::path front = file.parent_path() / kFrontFile; is_there(front)) {
        const auto text = read_file(front, kMostFront);
        auto points = text ? parse_front(*text, front.string()) : Result<std::vector<FrontPoint>>(text.error());
        if (!points) return points.error();
        (*document)->front = *std::move(points);
        (*document)->files.push_back(front);
    }
    (*document)->id = name_of(*lesson);
    (*document)->files.insert((*document)->files.begin(), file);
    (*document)->lesson = *std::move(lesson);
    return std::shared_ptr<const Document>(*std::move(document));
}

/// The image a pasted line names: the one in use, or one of the assets. A line from elsewhere opens no other file.
Result<std::shared_ptr<const Texture>> texture_of_link(const std::string& file, const State& before) {
    if (before.work.texture && before.work.texture_file == file) return before.work.texture;
    std::error_code bad;
    const fs::path assets = fs::weakly_canonical(assets_folder(), bad),
                   wanted = fs::weakly_canonical(assets / file, bad);
    const auto [end, ignored] = std::mismatch(assets.begin(), assets.end(), wanted.begin(), wanted.end());
    if (!bad && end == assets.end()) return open_texture(wanted);
    return Error{"state", "it uses the image " + file + ": drop that on the window first, then paste again"};
}

}  // namespace

fs::path data_folder() {
    if (const char* chosen = std::getenv("TEXELSCOPE_DATA"); chosen != nullptr && *chosen != '\0') return chosen;
    if (fs::path built = TEXELSCOPE_DATA_FOLDER; is_there(built / "lessons")) return built;
    std::error_code bad;
    const fs::path program = fs::read_symlink("/proc/self/exe", bad);
    return bad ? fs::path(".") : program.parent_path() / ".." / "share" / "texelscope";
}

fs::path assets_folder() { return data_folder() / "assets"; }

std::vector<Lesson> built_in_lessons(std::vector<Error>& errors) {
    return load_lessons(data_folder() / "lessons", errors, side_view_names());
}

Result<std::shared_ptr<const Document>> open_document(const std::string& target) {
    if (const fs::path file = lesson_file(target); !file.empty()) return open_lesson(file);
    if (!is_there(target))
        return Error{target, "there is no such lesson or file; 'texelscope list lessons' names the lessons"};
    auto document = open_scene(target);
    if (!document) return document.error();
    return std::shared_ptr<const Document>(*std::move(document));
}

Result<std::shared_ptr<const Texture>> open_texture(const fs::path& file) {
    auto image = load_image(file);
    if (!image) return image.error();
    auto texture = std::make_shared<Texture>();
    texture->name = file.filename().string();
    texture->source.file = file.string();
    texture->texels = *std::move(image);
    return std::shared_ptr<const Texture>(std::move(texture));
}

Result<State> open_state(const std::string& target, const State& before) {
    if (!looks_like_link(target)) {
        auto document = open_document(target);
        if (!document) return document.error();
        return opened(*document, before);
    }
    auto link = parse_link(target);
    if (!link) return link.error();
    auto document = before.document && before.document->id == link->document ? Result(before.document)
                                                                             : open_document(link->document);
    if (!document) return document.error();
    if (!link->work.texture_file.empty()) {
        auto texture = texture_of_link(link->work.texture_file, before);
        if (!texture) return texture.error();
        link->work.texture = *texture;
    }
    State state = opened(*document, before);
    Derived derived;
    return reduce(state,
                  action::Restore{link->work, link->cursor, link->other, link->difference, link->rung, link->skips},
                  derived);
}

}  // namespace texelscope
