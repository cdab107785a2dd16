// The files that a scene may name.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace texelscope {

/// Where a scene's files may lie: in either folder's tree, links resolved.
struct SceneFiles {
    std::filesystem::path folder;  ///< what file names are relative to; empty: the scene may have no files
    std::filesystem::path assets;  ///< may be empty
};

/// The file that a scene means by `name`, all links followed. Fails on one that lies elsewhere, whether or not it is
/// there, and on one that is not; the error lacks its place.
Result<std::filesystem::path> resolve_scene_file(const std::string& name, const SceneFiles& files);

}  // namespace texelscope
