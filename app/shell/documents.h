// Finds and reads what people open: lessons by number, name or file, scenes, their own images.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/state/state.h"
#include "core/base/result.h"

namespace texelscope {

/// The folder that holds lessons/ and assets/: TEXELSCOPE_DATA, or where the program was built, or beside it.
[[nodiscard]] std::filesystem::path data_folder();
[[nodiscard]] std::filesystem::path assets_folder();
/// All lessons, in order; faulty ones are left out and named in `errors`.
[[nodiscard]] std::vector<Lesson> built_in_lessons(std::vector<Error>& errors);

/// A lesson ("5", "05-half-planes", a lesson.md, its folder) or a scene file.
Result<std::shared_ptr<const Document>> open_document(const std::string& target);
/// A person's own image as a texture that repeats.
Result<std::shared_ptr<const Texture>> open_texture(const std::filesystem::path& file);

/// A document or a state as the command line and the clipboard give them, ready to be shown.
Result<State> open_state(const std::string& target, const State& before);

}  // namespace texelscope
