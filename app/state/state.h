// The application is one value. Actions (action.h) turn it into the next by reduce(); views draw it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/lesson/lesson.h"
#include "core/measure/front.h"
#include "core/measure/race.h"
#include "core/measure/skip_bill.h"
#include "core/method/drawing.h"
#include "core/scene/scene.h"

namespace texelscope {

/// What is open: a lesson with its scene, or a scene alone. Never changes once made; a reload makes another.
struct Document {
    std::string id;  ///< the lesson's id, or the scene's path
    std::optional<Lesson> lesson;
    Scene scene;
    std::vector<std::string> warnings;
    std::vector<FrontPoint> front;  ///< measured earlier, from front.csv beside the lesson; `scene` is front_key()
    std::vector<std::filesystem::path> files;  ///< watched for changes
};

/// A corner that a person moved or typed; it replaces the scene's.
struct VertexEdit {
    int polygon = 0, vertex = 0;
    Vertex value;
    friend bool operator==(const VertexEdit&, const VertexEdit&) = default;
};

/// How a person turned a mesh, or sized the small one of jelly cubes; it replaces the scene's.
struct MeshEdit {
    int mesh = 0;
    glm::vec3 rotate{0}, rotate2{0};  ///< as MeshPlacement's [degrees], in steps of 0.01
    float ratio = 0.8F;
    friend bool operator==(const MeshEdit&, const MeshEdit&) = default;
};

/// What turns: a mesh, or of jelly cubes one cube.
struct Turning {
    int mesh = -1;       ///< index into Scene::meshes
    bool small = false;  ///< the small cube of the two
    friend bool operator==(const Turning&, const Turning&) = default;
};

/// An answer under way, to the prediction of one beat.
struct Answer {
    int beat = 0;
    std::vector<int> chosen;         ///< options
    std::string typed;               ///< a number
    std::vector<glm::ivec2> places;  ///< pixels or texels; a line is {line, 0}
    enum class Verdict : std::uint8_t { open, right, wrong, skipped } verdict = Verdict::open;
    std::string sentence;  ///< what the engine says of it, once checked
    Path explain;          ///< the step that explains a wrong answer; empty for none
    friend bool operator==(const Answer&, const Answer&) = default;
};

/// What undo brings back: everything that changes what is computed.
struct Work {
    std::string method, variant;  ///< ids
    NumberFormat format = NumberFormat::f64;
    NumberMode mode;
    QuirkSet quirks = 0;                    ///< as they stand, the variant's with the switches applied
    std::vector<VertexEdit> edits;          ///< sorted by polygon, then vertex
    std::vector<MeshEdit> meshes;           ///< sorted by mesh
    float focal = 0;                        ///< of the camera [px]; 0: the scene's
    int frame = 0;                          ///< of all textures that move, from 0
    std::optional<RandomTriangles> random;  ///< in place of the scene's, where it has some
    std::optional<bool> size_twice;         ///< the quirk of jelly cubes; nothing: as the scene has it
    std::string texture_file;  ///< a person's own image in place of the scene's first texture; empty for none
    std::shared_ptr<const Texture> texture;  ///< its texels
    std::vector<Answer> answers;
    friend bool operator==(const Work&, const Work&) = default;
};

/// Where the cursor stands.
struct Cursor {
    Level level = Level::pixel;
    Path step;  ///< empty only where the scene has no shape
    int beat = 0;
    friend bool operator==(const Cursor&, const Cursor&) = default;
};

/// One thing that is selected; all views show it at once.
struct Selection {
    enum class Kind : std::uint8_t { none, pixel, texel, name, line, tick, colour };
    Kind kind = Kind::none;
    glm::ivec2 at{0};  ///< pixel (absolute) or texel
    std::string name;  ///< of a variable
    int line = 0;
    int colour = 0;  ///< of the palette of the cursor's texture
    Path tick;
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// The run that the view `difference` compares with. app/state/compared_run.h reads, prints and completes it.
struct ComparedRun {
    std::string method;                  ///< id; empty: barycentric, beside which it is edge-equations
    std::string variant;                 ///< id; empty: the corrected one
    std::optional<NumberFormat> format;  ///< nothing: the work's own
    friend bool operator==(const ComparedRun&, const ComparedRun&) = default;
};

enum class Theme : std::uint8_t { dark, light };

/// How it is shown; stays when lessons change.
struct Look {
    Theme theme = Theme::dark;
    float scale = 1;  ///< of text [1, 2.5]
    bool presenting = false, blank = false;
    bool hits = false;          ///< the hit map: how often each pixel was written
    bool palette = false;       ///< the view `palette` stands in the first place beside the canvas
    bool plain_code = true;     ///< trace(…) folded away in the listing
    std::vector<int> unfolded;  ///< folds of the listing that were opened, by their first lines
    bool reduced_motion = false, letter_keys = true;
    int tab = 0;                      ///< of the presenter's panel, or of the column above 150 %
    float zoom = 0;                   ///< canvas pixels per scene pixel; 0: fit
    glm::vec2 centre{0};              ///< scene point at the canvas' centre, where zoom is not 0
    float speed = 8;                  ///< steps a second while playing
    ComparedRun other;                ///< what the view `difference` compares with
    bool difference = false;          ///< that view stands in the side's last place, whatever the lesson shows
    float frame_rate = 8;             ///< frames a second of textures that move
    std::string rung;                 ///< id of the rung that the view `front` is about; empty for none
    std::uint32_t skips = kAllSkips;  ///< of the view `skips`, as RasterSettings::skips
    friend bool operator==(const Look&, const Look&) = default;
};

/// What covers a part of the window: the two large lists, the header's small ones, its field for a place to go to.
enum class Overlay : std::uint8_t { none, lessons, keys, formats, quirks, go_to };

/// Which methods have been timed over the scene as it stands. No part of Work: undo brings no timings back.
struct Race {
    bool running = false;
    std::vector<Lap> laps;  ///< finished, in the order of racers() (core/measure/bill.h)
};

/// What the views `front` and `skips` time: rungs, or the scene without some of its skips. No part of Work: undo brings
/// no timings back.
struct Measure {
    enum class What : std::uint8_t { nothing, front, skips } what = What::nothing;
    bool running = false;
    bool live = false;  ///< measured anew whenever the scene changes
    double share = 0;   ///< of the run [0, 1]
    std::string doing;  ///< for a person to see
    std::vector<FrontPoint> front;
    std::vector<SkipTime> skips;
};

/// The corner that keys move.
struct Handle {
    int polygon = -1, vertex = -1;
    bool texture = false;  ///< its (u, v), else its (x, y)
    friend bool operator==(const Handle&, const Handle&) = default;
};

struct Message {
    std::string text;
    bool error = false;
    friend bool operator==(const Message&, const Message&) = default;
};

struct State {
    std::shared_ptr<const Document> document;
    Work work;
    Cursor cursor;
    Look look;
    Selection hover, pinned;
    Handle handle;
    Turning turning;  ///< what keys and the mouse turn; no mesh: that of the cursor's shape
    Overlay overlay = Overlay::none;
    int chosen_lesson = 0;  ///< in the list, index
    std::vector<int> done;  ///< numbers of lessons that were gone through
    bool playing = false;
    bool moving = false;  ///< textures that move do
    std::vector<Path> bookmarks;
    Race race;
    Measure measure;
    Message message;  ///< one line, until the next action
};

}  // namespace texelscope
