// Any text is a scene or an error of one line with a place, and a scene that was read can be written and read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/scene/json.h"

namespace {

void demand(bool law) {
    if (!law) std::abort();
}

/// A text may ask for textures of up to a gigabyte; that is bounded but slow, and not what is looked for here.
bool is_small(std::string_view text) {
    int digits = 0;
    for (const char c : text) {
        digits = (c >= '0' && c <= '9') ? digits + 1 : 0;
        if (digits > 3 || c == 'E' || c == 'e' || c == '.') return text.find("size") == text.npos;
    }
    return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace texelscope;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (!is_small(text)) return 0;
    const SceneFiles none;
    for (const SceneLine& line : parse_scene_lines(text)) demand(!line.text.empty());
    static_cast<void>(is_scene_lines(text));
    const Result<LoadedScene> read = parse_scene(text, "fuzz", none);
    if (!read) {
        demand(read.error().where.rfind("fuzz:", 0) == 0);
        demand(!read.error().what.empty() && read.error().what.find('\n') == std::string::npos);
        return 0;
    }
    const std::string written = scene_to_json(read->scene);
    const Result<LoadedScene> again = parse_scene(written, "written", none);
    demand(static_cast<bool>(again));
    demand(scene_to_json(again->scene) == written);
    demand(again->warnings.size() == read->warnings.size());
    return 0;
}
