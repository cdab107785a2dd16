// Jelly cubes: both in the world, and turned back into the big one's frame, where whatever lies beyond 1 is cut off;
// the corners' coordinates there, the cuts of the current piece with their weights, and the ratio of the sizes.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/terms.h"
#include "core/geometry/jelly_frame.h"
#include "core/scene/jelly_quirk.h"

namespace texelscope::cut_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Cut", kNote = "outside: beyond 1";
constexpr std::string_view kNone = "This scene has no jelly cubes.";
constexpr std::string_view kWorld = "world";
constexpr std::array<std::string_view, 2> kFrames{"big cube's frame", "small cube's frame"};
constexpr std::array<std::string_view, 2> kCubes{"big cube", "small cube"};
constexpr std::array<std::string_view, 6> kFaces{"+x", "−x", "+y", "−y", "+z", "−z"};
constexpr std::array<std::string_view, 2> kCorners{"corners of the big cube", "corners of the small cube"};
constexpr std::string_view kCutOff = "{}, face {}: beyond {}", kKept = "{}, face {}: inside";
constexpr std::string_view kNoCut = "None of its corners is a cut.";
constexpr std::string_view kCutsAre = "weight · outside + weight · inside";
constexpr std::string_view kRatio = "small / big",
                           kRatioTip = "The small cube's size over the big one's. Or hold O and press − or =";
constexpr std::array<std::string_view, 4> kRegimes{
    "Up to 0.577 nothing sticks out, however the cubes are turned: a corner is √3 times as far out as a face.",
    "Above 0.577 (1/√3) corners can stick out; whole edges only above 0.707.",
    "Above 0.707 (1/√2) whole edges can stick out, too; above 1 the cubes swap roles.",
    "Above 1 the cubes have swapped roles: now the big one's corners stick out of the small one."};
constexpr std::string_view kTwice = "size twice",
                           kTwiceTip =
                               "As the source's listing has it: multiplied by the small cube's size a second time, "
                               "where ±1 needs division by the big one's";
constexpr double kLeastRatio = 0.4, kMostRatio = 1.3;

class CutView {
public:
    CutView(const ViewContext& context, const Area& area, const MeshPlacement& mesh, const JellyCubes& cubes)
        : context_(context),
          ui_(context.ui),
          area_(area),
          mesh_(mesh),
          cubes_(cubes),
          guest_(mesh.ratio > kRolesSwap ? 0 : 1),
          turns_{rotation(mesh.rotate), rotation(mesh.rotate2)},
          twice_(context.derived.scene().size_twice),
          corners_(jelly_corners(mesh.ratio, turns_[0], turns_[1], guest_, twice_)),
          hidden_(asks_for_corners()) {
        const int shape = context.derived.shape();
        if (shape < 0) return;
        const Polygon& polygon =
            context.derived.scene().polygons[static_cast<std::size_t>(context.derived.drawing().polygon_of(shape))];
        const bool own = polygon.mesh == context.derived.turning().mesh && polygon.face >= 0;
        if (own && polygon.face < static_cast<int>(cubes.pieces.size()))
            piece_ = &cubes.pieces[static_cast<std::size_t>(polygon.face)];
    }

    void draw() {
        foresee(ui_, "cut/scroll", arrange({0, 0, area_.w, area_.h}).height);
        inner_ = ui_.begin_scroll("cut/scroll", area_);
        const Places at = arrange(inner_);
        draw_wires(at.world, kWorld, false);
        draw_wires(at.frame, kFrames[static_cast<std::size_t>(1 - guest_)], true);
        draw_corners(at.corners);
        draw_cuts(at.cuts);
        draw_ratio(at.ratio);
        static_cast<void>(ui_.prose("cut/regime", at.regime, regime()));
        ui_.end_scroll(at.height);
    }

private:
    /// The open question is which corners lie outside: nothing marks them.
    [[nodiscard]] bool asks_for_corners() const {
        const Prediction* asked = prediction_of(context_.state);
        if (asked == nullptr || asked->answer.substr(0, 11) != "cut-corners") return false;
        const auto& answers = context_.state.work.answers;
        return std::none_of(answers.begin(), answers.end(), [&](const Answer& a) {
            return a.beat == context_.state.cursor.beat && a.verdict != Answer::Verdict::open;
        });
    }

    // -- places, one beside the other while there is room
    struct Places {
        Area world, frame, corners, cuts, ratio, regime;
        float height = 0;  ///< of all
    };
    [[nodiscard]] Places arrange(const Area& inner) const {
        glm::vec2 pen{inner.x, inner.y};
        float row = 0;
        const auto next_row = [&] {
            if (row > 0) pen = {inner.x, pen.y + row + ui_.px(8)};
            row = 0;
        };
        const auto next = [&](glm::vec2 size) {
            size.x = std::min(size.x, inner.w);
            if (pen.x > inner.x && pen.x + size.x > inner.right() + 1) next_row();
            const Area place{pen.x, pen.y, size.x, size.y};
            pen.x += size.x + ui_.px(14);
            row = std::max(row, size.y);
            return place;
        };
        const float bars = ratio_height() + title_height() + ui_.px(2);
        const float regime = ui::layout_prose(ui_.fonts(), this->regime(), inner.w).height;
        // As large as leaves the rest in view, where there is so much room.
        const float named = ui::text_width(ui_.font(Face::count), kFrames[0]) + ui_.px(2);
        const float free = area_.h - bars - regime - title_height() - ui_.px(16);
        const bool below = area_.h > 2 * (corners_size().y + ui_.px(8));  // room for the lists under the wires
        const float most = (inner.w - ui_.px(14)) / 2;
        const float side = std::clamp(below ? free - std::max(corners_size().y, cuts_size().y) - ui_.px(8) : free,
                                      std::min(most, std::max(named, ui_.px(96))), most);
        Places at;
        if (twice_) at.regime = {inner.x, pen.y, inner.w, regime}, pen.y += regime + ui_.px(8);  // what is wrong: first
        at.world = next({side, side + title_height()});
        at.frame = next({side, side + title_height()});
        at.corners = next(corners_size());
        at.cuts = next(cuts_size());
        next_row();
        at.ratio = {inner.x, pen.y, inner.w, bars};
        if (!twice_) at.regime = {inner.x, at.ratio.bottom(), inner.w, regime};
        at.height = std::max(at.ratio.bottom(), at.regime.bottom()) - inner.y;
        return at;
    }
    [[nodiscard]] float title_height() const { return pitch(ui_, 16, Face::count); }
    void title(const Area& place, std::string_view text) {
        ui_.text_within(Face::count, {place.x, place.y + title_height() - ui_.px(4)}, place.w, Role::muted, text);
    }

    // -- the cubes as wires, seen along z
    void draw_wires(const Area& place, std::string_view name, bool back) {
        title(place, name);
        const Area box{place.x, place.y + title_height(), place.w, place.h - title_height()};
        ui::fill(ui_.list(), box, ui_.theme().canvas);
        ui::frame(ui_.list(), box, ui_.theme().hairline);
        const glm::dmat3 frame = back ? glm::transpose(turns_[static_cast<std::size_t>(1 - guest_)]) : glm::dmat3(1);
        const double largest = std::max(1.0, double{mesh_.ratio});
        const double scale = double{box.w} / 2 / (largest * (back ? 1.5 : 1.8));
        const auto at = [&](const glm::dvec3& world) {
            const glm::dvec3 p = frame * world;
            return glm::vec2(box.centre()) + glm::vec2(p.x * scale, -p.y * scale);
        };
        ui_.begin_clip(box);
        if (piece_ != nullptr) {
            std::vector<glm::vec2> ring;
            for (const ClipVertex& vertex : piece_->ring) ring.push_back(at(glm::dvec3(vertex.position)));
            ui::fill_convex(ui_.list(), ring, ui::with_alpha(ui_.theme()[Role::now], .30F));
        }
        const int host = 1 - guest_;
        draw_edges(jelly_corners(mesh_.ratio, turns_[0], turns_[1], host), at, ui_.theme()[Role::muted], 1.2F);
        draw_edges(corners_, at, ui_.theme()[Role::text], 1.6F);
        for (std::size_t n = 0; n < corners_.size(); ++n) draw_corner(n, at(corners_[n].world));
        ui_.end_clip();
    }
    void draw_edges(const std::array<JellyCorner, 8>& corners, const auto& at, ui::Color color, float width) {
        for (std::size_t n = 0; n < corners.size(); ++n) {
            for (const std::size_t bit : {1U, 2U, 4U}) {
                if ((n & bit) == 0)
                    ui::line(ui_.list(), at(corners[n].world), at(corners[n | bit].world), width, color);
            }
        }
    }
    /// A filled square outside, a ring inside; its number beside it.
    void draw_corner(std::size_t n, glm::vec2 at) {
        const float radius = ui_.px(4);
        if (corners_[n].outside && !hidden_)
            ui::fill(ui_.list(), {std::round(at.x - radius), std::round(at.y - radius), 2 * radius, 2 * radius},
                     ui_.theme()[Role::now]);
        else
            ui::vertex_ring(ui_.list(), at, radius, ui_.theme()[Role::text], ui_.theme().canvas);
        const std::string number = std::to_string(n);
        const ui::Font& font = ui_.font(Face::count);
        const float width = ui::text_width(font, number);
        const Area plate{std::round(at.x + radius + 1), std::round(at.y - radius - font.cap - 3), width + 4,
                         font.cap + 6};
        const ui::Color ground = ui_.ground();
        ui_.set_ground(ui_.theme().canvas);
        ui::fill(ui_.list(), plate, ui_.theme().canvas, 2);
        if (ui_.clip().covers(plate)) ui_.text(Face::count, {plate.x + 2, plate.y + 3 + font.cap}, Role::text, number);
        ui_.set_ground(ground);
    }

    // -- the guest's corners in the host's frame
    [[nodiscard]] float coordinate_width() const {
        return std::ceil(ui::text_width(ui_.font(Face::code_note), "−0.000"));
    }
    [[nodiscard]] float corner_row() const { return pitch(ui_, 15, Face::code_note); }
    [[nodiscard]] glm::vec2 corners_size() const {
        const float wide = ui_.px(34) + 3 * (coordinate_width() + ui_.px(6));
        const float named = ui::text_width(ui_.font(Face::count), kCorners[static_cast<std::size_t>(guest_)]);
        return {std::ceil(std::max(wide, named)) + 1, title_height() + 9 * corner_row()};
    }
    void draw_corners(const Area& place) {
        title(place, kCorners[static_cast<std::size_t>(guest_)]);
        const float row = corner_row(), wide = coordinate_width() + ui_.px(6);
        const float heads = ui::baseline_at_middle(ui_.font(Face::count), place.y + title_height() + row / 2);
        for (int axis = 0; axis < 3; ++axis) {
            const float right = place.x + ui_.px(30) + wide * static_cast<float>(axis + 1);
            if (right <= place.right() + 1)
                ui_.text_right(Face::count, {right, heads}, Role::muted, std::string(1, "xyz"[axis]));
        }
        for (std::size_t n = 0; n < corners_.size(); ++n) {
            const JellyCorner& corner = corners_[n];
            const Area line{place.x, place.y + title_height() + static_cast<float>(n + 1) * row, place.w, row};
            const float base = ui::baseline_at_middle(ui_.font(Face::code_note), line.centre().y);
            const bool out = corner.outside && !hidden_;
            const float side = ui_.px(8);
            const Area mark{line.x, std::round(line.centre().y - side / 2), side, side};
            if (out)
                ui::fill(ui_.list(), mark, ui_.theme()[Role::now]);
            else
                ui_.list().AddCircle(ui::to_im(mark.centre()), side / 2 - .5F, ui_.theme()[Role::muted], 0, 1.2F);
            ui_.text_within(Face::code_note, {line.x + ui_.px(14), base}, ui_.px(20), Role::muted, std::to_string(n));
            for (int axis = 0; axis < 3; ++axis) {
                const double value = corner.turned[axis];
                const bool beyond = !hidden_ && std::fabs(value) > 1;
                const float right = line.x + ui_.px(30) + wide * static_cast<float>(axis + 1);
                if (right > line.right() + 1) continue;
                ui_.text_right(Face::code_note, {right, base}, beyond ? Role::now : Role::text, coordinate(value));
                if (beyond)
                    ui::fill(ui_.list(), {right - coordinate_width(), line.bottom() - 2, coordinate_width(), 1},
                             ui_.theme()[Role::now]);
            }
        }
    }
    [[nodiscard]] static std::string coordinate(double value) {
        return fmt::format("{}{:.3f}", value < 0 ? "−" : "", std::fabs(value));
    }

    // -- the current piece's cuts
    [[nodiscard]] std::vector<std::string> cut_lines() const {
        std::vector<std::string> lines;
        if (piece_ == nullptr) return lines;
        const auto cube = static_cast<std::size_t>(piece_->cube), face = static_cast<std::size_t>(piece_->face);
        const auto& stages = cubes_.cuts[cube][face];
        if (piece_->inside && stages.empty()) return lines;
        const ClipStage& stage = piece_->inside ? stages.back() : stages[static_cast<std::size_t>(piece_->plane)];
        for (const ClipVertex& vertex : piece_->ring) {
            if (!vertex.is_cut()) continue;
            double ends[] = {1 - stage.distances[static_cast<std::size_t>(vertex.from)],
                             1 - stage.distances[static_cast<std::size_t>(vertex.to)]};
            double shares[] = {vertex.from_share, vertex.to_share};
            if (ends[0] < ends[1]) std::swap(ends[0], ends[1]), std::swap(shares[0], shares[1]);
            lines.push_back(fmt::format("{:.2f} · {:.2f} + {:.2f} · {} ≈ 1", shares[0], ends[0], shares[1],
                                        fmt::format("{}{:.2f}", ends[1] < 0 ? "−" : "", std::fabs(ends[1]))));
        }
        return lines;
    }
    [[nodiscard]] std::string piece_title() const {
        const auto cube = static_cast<std::size_t>(piece_->cube), face = static_cast<std::size_t>(piece_->face);
        if (piece_->inside) return fmt::format(kKept, kCubes[cube], kFaces[face]);
        return fmt::format(kCutOff, kCubes[cube], kFaces[face], kFaces[static_cast<std::size_t>(piece_->plane)]);
    }
    [[nodiscard]] glm::vec2 cuts_size() const {
        if (piece_ == nullptr) return {1, 1};
        const std::vector<std::string> lines = cut_lines();
        float width = ui::text_width(ui_.font(Face::title), piece_title());
        const std::string_view hint = lines.empty() ? kNoCut : kCutsAre;
        width = std::max(width, std::min(area_.w / 2, ui::text_width(ui_.font(Face::count), hint)));
        for (const std::string& line : lines)
            width = std::max(width, ui::text_width(ui_.font(Face::line_number), line));
        const float row = pitch(ui_, 18, Face::line_number), head = pitch(ui_, 18, Face::title);
        return {std::ceil(width) + 1, head + title_height() + row * static_cast<float>(lines.size())};
    }
    void draw_cuts(const Area& place) {
        if (piece_ == nullptr) return;
        const float head = pitch(ui_, 18, Face::title), row = pitch(ui_, 18, Face::line_number);
        ui_.text_within(Face::title, {place.x, ui::baseline_at_middle(ui_.font(Face::title), place.y + head / 2)},
                        place.w, Role::text, piece_title());
        const std::vector<std::string> lines = cut_lines();
        title({place.x, place.y + head, place.w, title_height()}, lines.empty() ? kNoCut : kCutsAre);
        float y = place.y + head + title_height();
        for (const std::string& line : lines) {
            ui_.text_within(Face::line_number,
                            {place.x, ui::baseline_at_middle(ui_.font(Face::line_number), y + row / 2)}, place.w,
                            Role::text, line);
            y += row;
        }
    }

    // -- the sizes
    [[nodiscard]] std::vector<ui::Span> regime() const {
        if (twice_) return guilty();
        const double ratio = mesh_.ratio;
        const std::size_t n = ratio > kRolesSwap ? 3 : ratio > kEdgesOut ? 2 : ratio > kCornersOut ? 1 : 0;
        return ui::spans_of(kRegimes[n], Role::text);
    }
    /// What the quirk does, and the line that does it.
    [[nodiscard]] static std::vector<ui::Span> guilty() {
        const Listing listing = load_listing(kJellyListing);
        const int line = guilty_line(listing, kJellyQuirk);
        std::vector<ui::Span> spans = ui::spans_of(std::string(kJellyQuirk.sentence) + " ", Role::text);
        if (line == 0) return spans;
        spans.push_back({ui::Span::Kind::code, code_at(listing, line), Role::now});
        spans.push_back({ui::Span::Kind::text, fmt::format(" ({}:{})", listing.path, line), Role::muted});
        return spans;
    }
    [[nodiscard]] float ratio_height() const {
        return std::max(ui_.px(24), std::ceil(ui_.font(Face::title).em * 1.6F));
    }
    void draw_ratio(const Area& place) {
        const float high = ratio_height(), gap = ui_.px(10);
        const float name = ui::text_width(ui_.font(Face::title), kRatio) + gap;
        const float number = ui::text_width(ui_.font(Face::code), "0.000") + gap;
        const float twice = ui::button_width(ui_, kTwice);
        const Area all{place.x, place.y, place.w - twice - gap, place.h};
        const Area bar{all.x + name, all.y, std::max(ui_.px(60), all.w - name - number), high};
        const float middle = place.y + high / 2;
        ui_.text_within(Face::title, {place.x, ui::baseline_at_middle(ui_.font(Face::title), middle)}, name,
                        Role::muted, kRatio);
        const double ratio = mesh_.ratio;
        const ui::SliderRange range{std::min(kLeastRatio, ratio), std::max(kMostRatio, ratio), 0.01};
        const auto moved = ui::slider(ui_, "cut/ratio", bar, ratio, range, kRatio, kRatioTip);
        const int mesh = context_.derived.turning().mesh;
        if (moved) context_.act(action::SetRatio{mesh, static_cast<float>(*moved), ui_.memory().presses});
        const Area button{place.right() - twice, place.y, twice, high};
        if (ui::toggle(ui_, "cut/twice", button, kTwice, twice_, kTwiceTip).clicked)
            context_.act(action::SetSizeTwice{!twice_});
        if (bar.right() + number <= all.right() + 1)
            ui_.text_right(Face::code, {all.right(), ui::baseline_at_middle(ui_.font(Face::code), middle)}, Role::text,
                           fmt::format("{:.3f}", ratio));
        draw_ticks(bar, range);
    }
    void draw_ticks(const Area& bar, const ui::SliderRange& range) {
        const ui::Font& font = ui_.font(Face::count);
        const float knob = ui_.px(6);
        float free = inner_.x;
        for (const double threshold : {kCornersOut, kEdgesOut, kRolesSwap}) {
            const double share = (threshold - range.low) / (range.high - range.low);
            const float x = std::round(bar.x + knob + (bar.w - 2 * knob) * static_cast<float>(share));
            ui::fill(ui_.list(), {x, bar.bottom() - ui_.px(7), 1, ui_.px(7)}, ui_.theme()[Role::muted]);
            const std::string text = fmt::format("{:.{}f}", threshold, threshold == 1 ? 0 : 3);
            const float width = ui::text_width(font, text), left = std::min(x - width / 2, inner_.right() - width);
            if (left < free) continue;
            ui_.text(Face::count, {left, bar.bottom() + ui_.px(2) + font.cap}, Role::muted, text);
            free = left + width + ui_.px(4);
        }
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    Area area_, inner_;
    const MeshPlacement& mesh_;
    const JellyCubes& cubes_;
    int guest_ = 1;  ///< the cube that sticks out: the smaller one
    std::array<glm::dmat3, 2> turns_;
    bool twice_ = false;  ///< the quirk
    std::array<JellyCorner, 8> corners_;
    bool hidden_ = false;
    const JellyPiece* piece_ = nullptr;  ///< the cursor's; null where its shape is none
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "cut", place, kTitle, kNote);
    const JellyCubes* cubes = context.derived.jelly();
    if (cubes == nullptr) {
        draw_empty(context, area, kNone);
    } else {
        const int mesh = context.derived.turning().mesh;
        CutView(context, area, context.derived.scene().meshes[static_cast<std::size_t>(mesh)], *cubes).draw();
    }
    context.ui.end_panel();
}

constexpr View kView{"cut", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::cut_view
