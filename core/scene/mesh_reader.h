// The meshes and the camera of a scene file.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/scene_files.h"
#include "core/scene/scene_reader.h"

namespace texelscope {

inline constexpr float kMaxMove = 1e9F, kMaxDegrees = 1e6F, kMinScale = 1e-6F, kMaxScale = 1e6F;  ///< of a mesh
inline constexpr float kMinRatio = 0.01F, kMaxRatio = 100;                                        ///< of jelly cubes
inline constexpr float kMaxLight = 1e6F;                                                          ///< of a mesh
inline constexpr float kMinFocal = 1e-3F, kMaxFocal = 1e9F, kMinNear = 1e-6F, kMaxNear = 1e9F;    ///< of a camera

/// Errors are remembered by `read`.
class MeshReader {
public:
    /// The index of the texture of that name; remembers an error where there is none.
    using FindTexture = std::function<int(const JsonValue& name, std::string_view what)>;

    MeshReader(ValueReader& read, const SceneFiles& files, FindTexture find_texture)
        : read_(read), files_(files), find_texture_(std::move(find_texture)) {}

    [[nodiscard]] std::vector<MeshPlacement> meshes(const JsonValue& list);
    [[nodiscard]] Camera camera(const JsonValue& value);

private:
    MeshPlacement mesh(const JsonValue& value);
    [[nodiscard]] glm::vec3 vector(const JsonValue& value, std::string_view what, float most);
    [[nodiscard]] std::vector<int> textures(const JsonValue& value);
    [[nodiscard]] std::shared_ptr<const Mesh> model(const JsonValue& file);
    void allot(const JsonValue& value, const MeshPlacement& mesh);

    ValueReader& read_;
    const SceneFiles& files_;
    FindTexture find_texture_;
    std::unordered_map<std::string, std::shared_ptr<const Mesh>> models_;  ///< by path
    std::size_t faces_ = 0, corners_ = 0;                                  ///< of the meshes read so far
};

}  // namespace texelscope
