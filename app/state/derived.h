// What follows from a State: the drawing, the step the cursor stands on, pictures, links. Computed when first asked
// for and kept while what it depends on stays the same; views read it and compute nothing themselves.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/state/comparisons.h"
#include "app/state/state.h"
#include "core/fast/who_decided.h"
#include "core/geometry/jelly_cubes.h"
#include "core/image/rgba.h"
#include "core/measure/rung_picture.h"
#include "core/method/steps.h"
#include "core/scene/place.h"
#include "core/trace/listing.h"

namespace texelscope {

/// A sample as the canvas shows it at the cursor's step.
struct CanvasCell {
    Rgb now{}, later{};    ///< written so far; what will be there in the end
    bool written = false;  ///< so far, by any shape
    bool will_be_written = false;
    bool visited = false;           ///< by the current shape so far, written or not
    bool will_be_visited = false;   ///< by the current shape, in the end
    Fate fate = Fate::outside_box;  ///< of the current shape's last sample there
    Note note = Note::none;
};

/// The part of the picture that the canvas has in view.
struct CanvasPicture {
    Window window;  ///< one cell for each sample in it
    Grid<CanvasCell> cells;
    std::uint64_t version = 0;  ///< another whenever a cell differs
    bool ghosts = false;        ///< some cell's note is Note::ghost
};

/// One child of a unit in a lane of the timeline.
enum class TickKind : std::uint8_t { empty, covered, rejected, mark };

/// A lane: the children of the unit above. Runs, never lists of ranges without bound: at most kMaxTicks are listed.
struct Lane {
    Level level = Level::pixel;
    char letter = 't';
    Integer first = 0, count = 0;
    int step = 1;
    Integer current = -1;              ///< position of the cursor's child among them, or -1
    std::vector<std::string> labels;   ///< of stages and expressions; empty: the index is the label
    std::vector<TickKind> kinds;       ///< where count <= kMaxTicks; else empty
    std::vector<std::uint8_t> folded;  ///< of expressions: trivial, drawn narrow
};
inline constexpr Integer kMaxTicks = 4096;

/// A variable in the table and in formulas.
struct Variable {
    std::string name;
    Value value;
    int line = 0;
    bool changed = false;     ///< since the step before
    bool own = false;         ///< made in the current unit
    std::int32_t named = -1;  ///< index in the tape's names
};

/// What a selection means in every view.
struct Highlight {
    std::vector<glm::ivec2> pixels, texels;  ///< absolute pixels; texels of the shape's texture
    std::vector<std::string> names;
    std::vector<int> lines;
    std::vector<Path> ticks;
};

/// Frames of the textures that move.
struct FrameStrip {
    int count = 0, current = 0;  ///< of the first of them; count 0: nothing moves
    int texture = -1;            ///< index into Scene::textures
};

/// A shape that is not drawn, or a number that has no value: said in words at its place.
struct Notice {
    int shape = 0;
    std::string text;
};

/// A row of a shape that is walked along its sides, as its own step has it.
struct WalkedRow {
    Path path;                   ///< of the row
    Integer y = 0;               ///< [px]
    double left = 0, right = 0;  ///< x_l and x_r, where it meets the sides [px]
};
inline constexpr Integer kMaxWalkedRows = 128;

/// How far a row's numbers are from the same method's run in exact arithmetic.
struct RowError {
    struct At {
        Integer x = 0;        ///< [px]
        double u = 0, v = 0;  ///< in the chosen format less exact [texels]
        bool other = false;   ///< it reads another texel, or only one of the two runs draws it
    };
    std::vector<At> pixels;  ///< in order of x
    int others = 0;          ///< how many of them read another texel
};
/// The same over a whole shape.
struct ShapeError {
    int pixels = 0, others = 0;
    double most = 0;  ///< greatest |error| of u or v [texels]
};
inline constexpr Integer kMaxCompared = 4096;  ///< pixels of a shape's box; exact numbers are slow

/// Where the colours of the cursor's texture are used.
struct PaletteUse {
    std::array<Integer, 256> texels{};  ///< how many texels of the texture have each index
    std::array<Integer, 256> pixels{};  ///< how many pixels of the final picture show it
    Grid<std::int16_t>
        shown;  ///< the index of each pixel of the framebuffer; -1 where it is of no texel of the texture
};

struct Lockstep;       // app/state/lockstep.h
struct TwoPassBuffer;  // core/method/two_pass_buffer.h

class Derived {
public:
    Derived();
    ~Derived();
    Derived(const Derived&) = delete;
    Derived& operator=(const Derived&) = delete;

    /// Takes over a new state; what no longer holds is forgotten. Call before anything else.
    void update(const State& state);

    [[nodiscard]] const Scene& scene() const;  ///< with the person's edits
    [[nodiscard]] const Drawing& drawing() const;
    [[nodiscard]] Steps& steps() const;
    [[nodiscard]] const Method& method() const;
    [[nodiscard]] const Listing& listing() const;
    /// The cursor's unit; for a state without shapes an empty visit.
    [[nodiscard]] const Visit& visit() const;
    /// The traced value the cursor stands on at expression level, else the last one of its unit; null where none.
    [[nodiscard]] const Named* named() const;
    [[nodiscard]] int line() const;                ///< the current line of the listing; 0 for none
    [[nodiscard]] int shape() const;               ///< the cursor's; -1 without shapes
    [[nodiscard]] const Texture& texture() const;  ///< of the cursor's shape
    /// The current pixel (absolute), where the step lies in one.
    [[nodiscard]] std::optional<glm::ivec2> pixel() const;
    [[nodiscard]] std::optional<Integer> row() const;
    /// The texel that the current pixel reads, once the cursor has come so far.
    [[nodiscard]] std::optional<glm::ivec2> texel() const;

    /// Every face of every mesh, mesh by mesh, with its polygon in scene() where it has one.
    [[nodiscard]] const std::vector<PlacedFace>& faces() const;
    /// What keys turn: the state's choice, else the mesh of the cursor's shape, else the first; no mesh: none there.
    [[nodiscard]] Turning turning() const;
    /// The mesh of jelly cubes that turning() is about, cut; null where it is another solid.
    [[nodiscard]] const JellyCubes* jelly() const;
    [[nodiscard]] FrameStrip frames() const;

    [[nodiscard]] const Image& final_picture() const;
    /// How long it took to draw, nobody watching [ms]. Another each time, so for a person's eyes alone.
    [[nodiscard]] double frame_time() const;
    [[nodiscard]] const CanvasPicture& canvas(const Window& window) const;
    /// Cells of canvases drawn so far, in all: what stays the same from one drawing to the next is not drawn again.
    [[nodiscard]] std::int64_t cells_drawn() const;
    /// How often the whole drawing writes each cell of the window, up to 255.
    [[nodiscard]] const Grid<std::uint8_t>& hits(const Window& window) const;
    [[nodiscard]] const ErrorMap& errors(const Window& window) const;
    /// Against the run that the look asks for.
    [[nodiscard]] const Difference& difference(const Window& window) const;
    /// The methods that take the texture's plane as one matrix, and the state's own, over the cursor's polygon.
    [[nodiscard]] const std::vector<MethodCost>& costs() const;
    /// What each method of a race computes for the scene, in the order of racers(); empty without shapes.
    [[nodiscard]] const std::vector<Bill>& bills() const;
    /// What a rung of the front draws of the scene, against the definition.
    [[nodiscard]] const RungPicture& rung_picture(const Rung& rung) const;
    /// Of the scene, with the skips that the look asks for.
    [[nodiscard]] const SkipCount& skip_count() const;
    /// Which way `fast` takes to each pixel of the cursor's shape; of nothing where that is no triangle it draws.
    [[nodiscard]] const Decisions& decisions() const;
    /// Of the cursor's texture. Pixels are those of opaque shapes with a light of 1, which keep the palette's colours.
    [[nodiscard]] const PaletteUse& palette_use() const;
    [[nodiscard]] std::vector<Lane> lanes() const;                 ///< T, G, S, P, E in this order, always five
    [[nodiscard]] const std::vector<Variable>& variables() const;  ///< changed first, then by age
    /// How often each line ran in the current shape, up to the cursor; empty for a shape too large to count.
    [[nodiscard]] const LineCounts& line_counts() const;
    /// (u, v) of every sample of the current row of the current shape, in order: the path on the texture.
    [[nodiscard]] const std::vector<Sample>& row_samples() const;
    /// All rows of the current shape that have x_l and x_r, in the order in which they are drawn; none where there are
    /// more than kMaxWalkedRows.
    [[nodiscard]] const std::vector<WalkedRow>& walked_rows() const;
    /// The current row of the current shape against exact arithmetic; empty outside of rows.
    [[nodiscard]] const RowError& row_error() const;
    /// The current shape against exact arithmetic; nothing where its box has more than kMaxCompared pixels.
    [[nodiscard]] std::optional<ShapeError> shape_error() const;
    /// The cursor's shape drawn by its texture and by the screen, after as many rows and columns of either.
    [[nodiscard]] const Lockstep& lockstep() const;
    /// What the first of two passes makes of the cursor's shape; without columns where it makes nothing.
    [[nodiscard]] const TwoPassBuffer& two_pass_buffer() const;
    [[nodiscard]] const std::vector<Notice>& notices() const;
    [[nodiscard]] Highlight highlight(const Selection& selection) const;
    /// Every sample written to a pixel so far, oldest first.
    [[nodiscard]] std::vector<std::pair<int, Sample>> writers(glm::ivec2 pixel) const;
    /// How often the whole drawing writes a pixel.
    [[nodiscard]] int writes_in_all(glm::ivec2 pixel) const;
    /// The step at which the pixel was last written before, or else at all; empty where never.
    [[nodiscard]] std::optional<Path> last_write(glm::ivec2 pixel) const;

private:
    /// Two whole numbers that the current unit has computed by now.
    [[nodiscard]] std::optional<glm::ivec2> whole_pair(std::string_view first, std::string_view second) const;
    /// The canvas as it is before the current shape's first sample, and which samples that is going to visit; where
    /// the canvas was last asked for the frame's every pixel, else null.
    [[nodiscard]] const CanvasPicture* whole_frame_in_view() const;

    struct Cache;
    std::unique_ptr<Cache> cache_;
};

/// The works make the same scene of a document.
[[nodiscard]] bool same_scene(const Work& a, const Work& b);
/// Timings taken with one hold with the other: methods race corrected, whichever is chosen.
[[nodiscard]] bool same_race(const Work& a, const Work& b);
/// The scene with a state's edits and texture.
/// @param faces  takes every face of every mesh; may be null.
[[nodiscard]] Scene edited_scene(const Document& document, const Work& work, std::vector<PlacedFace>* faces = nullptr);
/// The corner of a handle; null where there is none.
[[nodiscard]] const Vertex* vertex_of(const Scene& scene, const Handle& handle);
/// Where a handle stands in the edited scene.
[[nodiscard]] glm::vec2 position_of(const Scene& scene, const Handle& handle);

}  // namespace texelscope
