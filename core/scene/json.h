// The scene file, version 1: JSON text to a Scene and back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_files.h"

namespace texelscope {

inline constexpr std::size_t kMaxSceneBytes = std::size_t{256} << 20;  ///< the longest scene text
inline constexpr std::size_t kMaxSceneTexels = std::size_t{1} << 28;   ///< of all textures of a scene together
inline constexpr int kMaxTextures = 4096;                              ///< of one scene
inline constexpr int kMaxFrames = 256;                                 ///< of one texture that moves
inline constexpr int kMaxOrigin = 1 << 30;                             ///< the farthest window, either way [px]

struct LoadedScene {
    Scene scene;
    std::vector<std::string> warnings;  ///< one line each, "scene.json:12: polygon 3 draws nothing: ..."
};

/// Reads a scene. A JSON number is a double, as in any reader, rounded to float32. A polygon that polygon_fault names
/// stays in the scene, so that indices hold, and gets a warning. A polygon or mesh without a texture has the first one;
/// if the scene has none, a grey one is added. The meshes are placed (core/scene/place.h). Every error's place is
/// `name`:LINE.
/// @param first_line  the number of the text's first line.
Result<LoadedScene> parse_scene(std::string_view text, std::string_view name, const SceneFiles& files,
                                int first_line = 1);

/// The scene in a file, whose folder is where its textures lie.
Result<LoadedScene> load_scene(const std::filesystem::path& path, const std::filesystem::path& assets = {});

/// One line of JSON Lines; views into the text it was split from.
struct SceneLine {
    int number = 0;  ///< the line's number from 0, blank lines counted
    std::string_view text;
};

/// The lines that are not blank, to be given one by one to parse_scene with first_line = number + 1.
[[nodiscard]] std::vector<SceneLine> parse_scene_lines(std::string_view text);

/// Whether the text is JSON Lines of two or more scenes rather than one scene over several lines: its first line that
/// is not blank holds a whole object, and another follows.
[[nodiscard]] bool is_scene_lines(std::string_view text);

/// The scene as a file, without the polygons that were made from meshes. parse_scene gives an equal scene back,
/// provided that its textures came from parse_scene (a texture without a source becomes a grey one of its size) and
/// that files are found from the new place.
[[nodiscard]] std::string scene_to_json(const Scene& scene);

}  // namespace texelscope
