// Everything that can happen to a State. Views return these; keys, the mouse, tests and lessons make the same ones.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/state/state.h"

namespace texelscope {

namespace action {

struct Open {
    std::shared_ptr<const Document> document;
};  ///< at its first beat
struct Reload {
    std::shared_ptr<const Document> document;
};  ///< the same document, saved anew: the cursor stays
struct Say {
    Message message;
};

struct Step {
    int count = 1;
};  ///< forward, or back where negative, at the cursor's level
struct StepTo {
    Path path;
};  ///< also changes to the path's level
struct StepEnd {
    bool last = false;
};
struct Advance {
    int count = 1;
};  ///< PgDn, PgUp: a beat of the lesson; a step where there is none
struct SetLevel {
    Level level;
};
struct Finer {
    int count = 1;
};  ///< coarser where negative
struct StepIn {};
struct FinishUnit {};
struct Play {
    bool on;
};
struct Speed {
    float factor;
};
struct ToggleBookmark {};
struct GoToBookmark {
    int direction = 1;
};

struct MoveVertex {
    Handle handle;
    glm::vec2 to;
    int gesture = 0;
};  ///< moves of one gesture are one undo entry
/// All corners of a polygon on the screen at once: turned or scaled, it stays convex where one by one it would not.
struct MoveShape {
    int polygon = 0;
    std::vector<glm::vec2> to;  ///< one for each vertex
    int gesture = 0;
};
/// The depth of a corner.
struct SetDepth {
    Handle handle;
    float w = 1;  ///< > 0, see core/geometry/vertex.h
    int gesture = 0;
};
/// The ring of a polygon's corners begins one later: what cuts it into triangles takes the other diagonal of a quad.
struct TurnRing {
    int polygon = 0;
};
struct ChooseHandle {
    Handle handle;
};
struct Turn {
    Turning what;
    int axis = 0;        ///< of the world [0, 2]
    double degrees = 0;  ///< in the sense of core/geometry/camera.h
    int gesture = 0;     ///< as of MoveVertex
};
struct ChooseTurning {
    Turning what;
};
struct SetRatio {
    int mesh = 0;
    float ratio = 1;  ///< of jelly cubes
    int gesture = 0;
};
struct SetSizeTwice {
    bool on = false;
};  ///< the quirk of jelly cubes
struct SetFocal {
    float focal = 0;  ///< [px]
    int gesture = 0;
};
struct SetFrame {
    int frame = 0;  ///< of textures that move; wraps
    int gesture = 0;
};
struct SetRandom {
    RandomTriangles to;  ///< kept within the limits of app/lesson/lesson.h
    int gesture = 0;
};  ///< where the scene has random triangles
struct StartRace {
    bool on;
};  ///< times all methods, one after the other; or stops
struct FinishLap {
    Lap lap;
    bool last = false;
};  ///< of the race that runs
struct StartMeasure {
    Measure::What what;
    bool on;
};  ///< and goes on measuring when the scene changes, until it is stopped
struct MeasureOn {
    Measure found;
};  ///< what is known by now, of the measuring that runs
struct PlayFrames {
    bool on;
};
struct FrameRate {
    float factor;
};
struct SetFormat {
    NumberFormat format;
};
struct SetMode {
    NumberMode mode;
};
struct SetVariant {
    std::string id;
};
struct SetQuirk {
    int index;
    bool on;
};
struct SetQuirks {
    QuirkSet quirks;
};  ///< all at once, as one entry to undo
struct SetMethod {
    std::string id;
};
struct SetTexture {
    std::string file;
    std::shared_ptr<const Texture> texture;
};

struct Choose {
    int option;
};  ///< of the beat's prediction; toggles where many may be chosen
struct Type {
    std::string text;
};  ///< a number as the answer
struct Point {
    glm::ivec2 place;
};  ///< a pixel, texel or line as the answer
struct Check {};
struct Skip {};

struct Hover {
    Selection what;
};
struct Pin {
    Selection what;
};  ///< pinning what is pinned lets it go
struct SetLook {
    Look look;
};
struct Show {
    Overlay overlay;
};
struct ChooseLesson {
    int index;
};
struct Escape {};  ///< closes what is open, then lets go of pins, then stops playing

struct Undo {};
struct Redo {};
struct Reset {};  ///< the document as it was opened; undoable
struct Restore {
    Work work;
    Cursor cursor;
    ComparedRun other;
    bool difference = false;  ///< as of Look
    std::string rung = {};    ///< the same
    std::uint32_t skips = kAllSkips;
};  ///< a pasted state of the document that is open

}  // namespace action

using Action =
    std::variant<action::Open, action::Reload, action::Say, action::Step, action::StepTo, action::StepEnd,
                 action::Advance, action::SetLevel, action::Finer, action::StepIn, action::FinishUnit, action::Play,
                 action::Speed, action::ToggleBookmark, action::GoToBookmark, action::MoveVertex, action::MoveShape,
                 action::SetDepth, action::TurnRing, action::ChooseHandle, action::Turn, action::ChooseTurning,
                 action::SetRatio, action::SetSizeTwice, action::SetFocal, action::SetFrame, action::SetRandom,
                 action::StartRace, action::FinishLap, action::StartMeasure, action::MeasureOn, action::PlayFrames,
                 action::FrameRate, action::SetFormat, action::SetMode, action::SetVariant, action::SetQuirk,
                 action::SetQuirks, action::SetMethod, action::SetTexture, action::Choose, action::Type, action::Point,
                 action::Check, action::Skip, action::Hover, action::Pin, action::SetLook, action::Show,
                 action::ChooseLesson, action::Escape, action::Undo, action::Redo, action::Reset, action::Restore>;

}  // namespace texelscope
