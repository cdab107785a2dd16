// A lesson as data: what its text file says, checked for form. lessons/README.md tells how to write one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/trace/path.h"

namespace texelscope {

inline constexpr std::size_t kMaxLessonBytes = std::size_t{1} << 16;  ///< the longest lesson text
inline constexpr int kMaxLessons = 999;                               ///< folders that load_lessons looks into
inline constexpr int kMaxBeats = 64;                                  ///< of one lesson
inline constexpr int kMaxOptions = 8;                                 ///< of one prediction
inline constexpr int kMaxViews = 3;                                   ///< the places beside the canvas
/// The most that fits its place at 100 %, in letters that are seen (visible_length, app/lesson/prose.h).
inline constexpr int kMaxTitle = 40, kMaxGroup = 24, kMaxSummary = 150;
inline constexpr int kMaxLead = 56, kMaxProse = 130;
inline constexpr int kMaxAsk = 84, kMaxOption = 18, kMaxAllOptions = 40;

/// Random triangles that a lesson or a person may ask for: as many as can be drawn in every frame.
inline constexpr int kMostTriangles = 10'000;
inline constexpr float kLeastTriangleSide = 1, kMostTriangleSide = 640;  ///< of the square that holds one [px]
inline constexpr int kMostSeed = 9999;

/// On which lines of the file the keys of a block stand.
struct KeyLines {
    int block = 0;  ///< where the block begins
    std::vector<std::pair<std::string, int>> keys{};

    [[nodiscard]] bool has(std::string_view key) const;
    /// The block's own line where it has no such key.
    [[nodiscard]] int of(std::string_view key) const;
};

/// What a beat sets when it is reached; what is absent stays as the beat before left it.
struct BeatSettings {
    std::optional<Path> step;
    std::optional<Level> level;
    std::optional<std::string> method;                 ///< id; without `variant` it is the corrected one
    std::optional<std::string> number, variant;        ///< ids
    std::vector<std::pair<std::string, bool>> quirks;  ///< id or field, on
    /// "pixel 16,11", "texel 7,9", "name u_x", "line quirk.inclusive"; of this beat alone.
    std::optional<std::string> pin;
    std::optional<RandomTriangles> random;            ///< in place of the scene's
    std::optional<bool> play, hits;                   ///< start playing, in this beat alone; show the hit map
    std::optional<std::string> rung;                  ///< what the view `front` is about
    std::vector<std::pair<std::string, bool>> skips;  ///< of the view `skips`: id, on; of this beat alone
    std::optional<std::string> against;  ///< what the view `difference` compares with: "METHOD VARIANT NUMBER"
    std::vector<std::string> views;      ///< replaces the lesson's views, in slot order
    KeyLines lines;
};

/// A question whose answer the engine computes from the scene as it stands.
struct Prediction {
    enum class Kind : std::uint8_t { choice, many, number, pixel, texel, line };
    std::string ask{};  ///< prose with $mathematics$
    Kind kind = Kind::choice;
    std::vector<std::string> options{};  ///< of choice and many
    std::string answer{};   ///< what the engine is to compute: a question of app/lesson/questions.h and its arguments
    std::string explain{};  ///< the step that explains a wrong answer; a path, or "auto"
    KeyLines lines{};
};

/// One press of PgDn.
struct Beat {
    std::string lead;  ///< the first sentence, set in bold
    std::string
        prose;  ///< Markdown of a small kind: paragraphs divided by an empty line, **strong**, `code`, $mathematics$
    BeatSettings set;
    std::optional<Prediction> prediction;
    int line = 0;  ///< of the lesson file
};

struct Lesson {
    std::string id;                       ///< the folder's name, "05-half-planes"
    int number = 0;                       ///< 1 to 21 are built in, up to 99 a lecturer's; 0: its folder has none
    std::string title, group;             ///< group: the heading it stands under in the list
    std::string icon;                     ///< one of kIconNames; empty: none was chosen
    std::string summary;                  ///< two sentences for the list
    std::string method, variant, format;  ///< ids
    std::string scene;                    ///< file beside the lesson
    std::vector<std::string> views;       ///< for the small, the wide and the large place, in this order
    std::string levels;                   ///< those that make sense here, of "TGSPE"
    std::string drag;                     ///< "vertices", "screen", "texture" or "none"
    std::vector<std::string> quirks;      ///< quirks (id or field) that the lesson offers as switches
    std::vector<Beat> beats;              ///< at least one
    std::filesystem::path file;
    KeyLines lines;  ///< of the front matter
};

/// Reads a lesson's text. Every fault is an error that names FILE:LINE, and what was expected there.
/// @param file        its folder's name is the lesson's id; "05-half-planes" is also the number 5, others have 0.
/// @param view_names  those that `views` may name; empty: names are checked for form only.
Result<Lesson> parse_lesson(std::string_view text, const std::filesystem::path& file,
                            std::span<const std::string_view> view_names = {});
Result<Lesson> load_lesson(const std::filesystem::path& file, std::span<const std::string_view> view_names = {});

/// Every lesson folder below `lessons`, in order of number; faulty ones are left out and named in `errors`.
[[nodiscard]] std::vector<Lesson> load_lessons(const std::filesystem::path& lessons, std::vector<Error>& errors,
                                               std::span<const std::string_view> view_names = {});

/// The lesson as a file: parse_lesson gives an equal lesson back, but for line numbers.
[[nodiscard]] std::string print_lesson(const Lesson& lesson);

}  // namespace texelscope
