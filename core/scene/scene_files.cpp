#include "core/scene/scene_files.h"

#include <algorithm>
#include <system_error>

namespace texelscope {
namespace {

namespace fs = std::filesystem;

/// Whether `path`, which is canonical, lies in the tree of `folder`.
bool is_inside(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return false;
    std::error_code failed;
    const fs::path root = fs::canonical(folder, failed);
    return !failed && std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

}  // namespace

Result<fs::path> resolve_scene_file(const std::string& name, const SceneFiles& files) {
    if (name.empty() || name.find('\0') != name.npos) return Error{"", "is not a file name"};
    if (files.folder.empty()) return Error{"", "cannot be read: this scene has no folder"};
    std::error_code failed;
    fs::path path = fs::weakly_canonical(files.folder / name, failed);
    if (failed) return Error{"", "cannot be read: " + failed.message()};
    if (!is_inside(path, files.folder) && !is_inside(path, files.assets))
        return Error{"", "lies outside the scene's folder and the assets"};
    if (!fs::exists(path, failed)) return Error{"", "does not exist"};
    return path;
}

}  // namespace texelscope
