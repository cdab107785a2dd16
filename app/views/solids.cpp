// The solid that is being turned: what becomes of it from rotate to map, and each face with its sign, its doubled area
// on the screen, its light and when it is drawn.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/terms.h"
#include "core/scene/names.h"

namespace texelscope::solids_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Solids", kNote = "O + arrows, or the right button";
constexpr std::string_view kNoSolid = "This scene has no solid. Its polygons are its own.";
constexpr std::string_view kChooseTip = "Choose what is turned: hold O and press arrows, A or Z";
constexpr std::string_view kFocal = "focal", kFocalTip = "The eye's distance from the screen [px]: near eyes see less";
constexpr std::string_view kGoTip = "Face {}: click to go to where it is drawn";
constexpr std::string_view kBackTip = "Face {} looks away, so nothing is drawn";
constexpr std::string_view kSigns = "area × 2", kLight = "light", kOrder = "drawn";
constexpr std::string_view kNever = "no";
constexpr std::string_view kFrontDrawn = "Only faces that face us are drawn, the farthest first",
                           kAllDrawn = "All faces are drawn";
constexpr std::string_view kTimeTip = ". The time is the method's, for the whole picture",
                           kInArrays = ". The time is that of array passes over the whole picture; W: pixel by pixel",
                           kByPixel = ". The time is that of the whole picture, pixel by pixel; W: in array passes";
constexpr std::size_t kMostFaces = 512;  ///< rows; a model of more is shown in its stages alone
constexpr int kStages = 4;

struct StageText {
    std::string name, what, tip;
};

class SolidsView {
public:
    SolidsView(const ViewContext& context, const Area& area)
        : context_(context), ui_(context.ui), derived_(context.derived), area_(area), what_(derived_.turning()) {
        for (const PlacedFace& face : derived_.faces()) {
            if (face.mesh != what_.mesh) continue;
            faces_.push_back(&face);
            front_ += face.doubled_area > 0 ? 1 : 0;
            drawn_ += face.polygon >= 0 ? 1 : 0;
        }
        const int shape = derived_.shape();
        if (shape >= 0) {
            const Polygon& polygon = polygons()[static_cast<std::size_t>(derived_.drawing().polygon_of(shape))];
            if (polygon.mesh == what_.mesh) current_ = polygon.face;
        }
    }

    void draw() {
        foresee(ui_, "solids/scroll", run({0, 0, area_.w, area_.h}, false));
        const Area inner = ui_.begin_scroll("solids/scroll", area_);
        ui_.end_scroll(run(inner, true));
    }

private:
    /// Goes through all parts, drawing them or only measuring. @return the height of all.
    [[nodiscard]] float run(const Area& inner, bool draws) {
        draws_ = draws;
        float y = draw_choices(inner, inner.y);
        y = draw_stages(inner, y + ui_.px(6));
        if (faces_.size() <= kMostFaces) y = draw_faces(inner, y + ui_.px(8));
        return y - inner.y;
    }
    [[nodiscard]] const std::vector<Polygon>& polygons() const { return derived_.scene().polygons; }
    [[nodiscard]] const MeshPlacement& mesh() const {
        return derived_.scene().meshes[static_cast<std::size_t>(what_.mesh)];
    }
    [[nodiscard]] float button_height() const {
        return std::max(ui_.px(24), std::ceil(ui_.font(Face::title).em * 1.6F));
    }

    [[nodiscard]] static std::string name_of(const MeshPlacement& mesh, bool small) {
        if (mesh.shape == Shape3d::obj) return mesh.file;
        if (mesh.shape == Shape3d::jelly_cubes) return small ? "small cube" : "big cube";
        return std::string(kSolidNames[static_cast<std::size_t>(mesh.shape)]);
    }

    /// A button for each solid, and the focal length. @return where the next row begins.
    float draw_choices(const Area& inner, float y) {
        const float high = button_height(), gap = ui_.px(6);
        float x = inner.x;
        const auto& meshes = derived_.scene().meshes;
        const auto choose = [&](const Turning& what, const std::string& name) {
            const float width = std::min(inner.w, ui::button_width(ui_, name));
            if (x > inner.x && x + width > inner.right()) x = inner.x, y += high + gap;
            const std::string id = fmt::format("solids/choose{}{}", what.mesh, what.small ? "s" : "");
            if (draws_ && ui::toggle(ui_, id, {x, y, width, high}, name, what == what_, kChooseTip).clicked)
                context_.act(action::ChooseTurning{what});
            x += width + gap;
        };
        constexpr std::size_t kMostChoices = 12;
        for (std::size_t n = 0; n < std::min(kMostChoices, meshes.size()); ++n) {
            choose({static_cast<int>(n)}, name_of(meshes[n], false));
            if (meshes[n].shape == Shape3d::jelly_cubes) choose({static_cast<int>(n), true}, name_of(meshes[n], true));
        }
        const Viewpoint view = view_of(derived_.scene());
        const std::string focal = fmt::format("{:.0f} px", view.focal);
        const float name = ui::text_width(ui_.font(Face::title), kFocal) + gap;
        const float number = ui::text_width(ui_.font(Face::code), "8888 px"), bar = ui_.px(96);
        x += ui_.px(10);
        if (x + name + bar + gap + number > inner.right()) x = inner.x, y += high + gap;
        if (!draws_) return y + high;
        const float middle = y + high / 2;
        ui_.text_within(Face::title, {x, ui::baseline_at_middle(ui_.font(Face::title), middle)}, inner.right() - x,
                        Role::muted, kFocal);
        const double width = derived_.scene().framebuffer.width;
        const auto moved = ui::slider(ui_, "solids/focal", {x + name, y, bar, high}, view.focal,
                                      {std::ceil(width / 2), std::max(view.focal, width * 4), 1}, kFocal, kFocalTip);
        if (moved) context_.act(action::SetFocal{static_cast<float>(*moved), ui_.memory().presses});
        const float at = x + name + bar + gap;
        ui_.text_within(Face::code, {at, ui::baseline_at_middle(ui_.font(Face::code), middle)}, inner.right() - at,
                        Role::text, focal);
        return y + high;
    }

    [[nodiscard]] std::array<StageText, kStages> stages() const {
        const glm::vec3& angles = what_.small ? mesh().rotate2 : mesh().rotate;
        const auto degrees = [](float a) { return ui::format_number(double{a}).text + "°"; };
        const bool culls = derived_.scene().cull == Cull::back;
        const std::size_t all = faces_.size();
        return {{{"rotate", fmt::format("{} {} {}", degrees(angles.x), degrees(angles.y), degrees(angles.z)),
                  "The angles about x, y and z, in the planes yz, xz and xy"},
                 {"project", "x · focal / z", "Divided by the distance, corners come to lie on the screen"},
                 {"cull", fmt::format("{} of {} face us", front_, all),
                  "The sign of a face's area on the screen says whether it shows its outside"},
                 {"map", fmt::format("{} polygon{}{}", drawn_, drawn_ == 1 ? "" : "s", frame_time()),
                  fmt::format("{}{}", culls ? kFrontDrawn : kAllDrawn, context_.timed ? time_tip() : "")}}};
    }
    /// How long the whole picture took, where that is shown at all.
    [[nodiscard]] std::string frame_time() const {
        return context_.timed ? fmt::format(" {:6.1f} ms", derived_.frame_time()) : std::string();
    }
    [[nodiscard]] std::string_view time_tip() const {
        const int arrays = quirk_index(derived_.method(), "arrays");
        if (arrays < 0) return kTimeTip;
        return (context_.state.work.quirks >> arrays & 1U) != 0 ? kInArrays : kByPixel;
    }

    float draw_stages(const Area& inner, float y) {
        const auto texts = stages();
        const ui::Font &title = ui_.font(Face::title), &code = ui_.font(Face::line_number);
        const float pad = ui_.px(8), arrow = ui_.px(18);
        const float high = std::ceil(title.em * 1.3F + code.em * 1.4F) + ui_.px(4);
        std::array<float, kStages> widths{};
        float all = 3 * arrow;
        for (std::size_t n = 0; n < widths.size(); ++n) {
            widths[n] = std::ceil(std::max(ui::text_width(title, texts[n].name), ui::text_width(code, texts[n].what))) +
                        2 * pad;
            all += widths[n];
        }
        const bool one_row = all <= inner.w;
        const float spare = one_row ? (inner.w - all) / kStages : 0;
        float x = inner.x;
        for (std::size_t n = 0; n < widths.size(); ++n) {
            const float w = std::floor(std::min(inner.w, one_row ? widths[n] + spare : widths[n]));
            if (x > inner.x && x + w > inner.right() + 1) x = inner.x, y += high + ui_.px(4);
            if (draws_) draw_stage(texts[n], {x, y, w, high}, pad);
            x += w;
            if (draws_ && n + 1 < widths.size() && x + arrow <= inner.right() + 1)
                ui::arrow(ui_.list(), {x + ui_.px(3), y + high / 2}, {x + arrow - ui_.px(3), y + high / 2},
                          ui_.px(1.5F), ui_.theme()[Role::muted], ui_.px(6));
            x += arrow;
        }
        return y + high;
    }
    void draw_stage(const StageText& text, const Area& place, float pad) {
        static_cast<void>(ui_.control({.name = "solids/stage/" + text.name,
                                       .area = place,
                                       .kind = ui::Kind::region,
                                       .label = text.name,
                                       .tip = text.tip,
                                       .focusable = false}));
        const ui::Color ground = ui_.ground();
        ui_.set_ground(ui_.theme().raise);
        ui::fill(ui_.list(), place, ui_.ground(), ui::size::kRadius);
        ui::frame(ui_.list(), place, ui_.theme().hairline, 1, ui::size::kRadius);
        const float width = place.w - 2 * pad, first = place.y + place.h * .29F, second = place.y + place.h * .72F;
        ui_.text_within(Face::title, {place.x + pad, ui::baseline_at_middle(ui_.font(Face::title), first)}, width,
                        Role::muted, text.name);
        ui_.text_within(Face::line_number, {place.x + pad, ui::baseline_at_middle(ui_.font(Face::line_number), second)},
                        width, Role::text, text.what);
        ui_.set_ground(ground);
    }

    // -- faces
    struct Columns {
        float number = 0, area = 0, light = 0, order = 0, all = 0;  ///< right ends from the row's left
    };
    [[nodiscard]] Columns columns() const {
        const auto wide = [&](Face face, std::string_view text) {
            return std::ceil(ui::text_width(ui_.font(face), text));
        };
        const float gap = ui_.px(8);
        Columns c;
        c.number = ui_.px(22) + wide(Face::code, "88");
        c.area = c.number + gap + std::max(wide(Face::code, "−8888.8"), wide(Face::count, kSigns));
        c.light = c.area + gap + std::max(wide(Face::code, "0.88"), wide(Face::count, kLight));
        c.order = c.light + gap + std::max(wide(Face::code, "88"), wide(Face::count, kOrder));
        c.all = c.order + ui_.px(4);
        return c;
    }

    float draw_faces(const Area& inner, float y) {
        const Columns c = columns();
        const float row = pitch(ui_, 20, Face::code), head = pitch(ui_, 15, Face::count), gap = ui_.px(12);
        const auto count = static_cast<int>(faces_.size());
        const int blocks =
            std::clamp(static_cast<int>((inner.w + gap) / (c.all + gap)), 1, std::max(1, (count + 5) / 6));
        const int rows = (count + blocks - 1) / blocks;
        const float width = std::floor((inner.w - gap * static_cast<float>(blocks - 1)) / static_cast<float>(blocks));
        for (int block = 0; draws_ && block < blocks; ++block) {
            const float x = inner.x + static_cast<float>(block) * (width + gap);
            const float base = y + head - ui_.px(3);
            const auto title = [&](float right, std::string_view text) {
                if (right <= width + 1) ui_.text_right(Face::count, {x + right, base}, Role::muted, text);
            };
            title(c.area, kSigns), title(c.light, kLight), title(c.order, kOrder);
            for (int n = 0; n < rows && block * rows + n < count; ++n) {
                const int index = block * rows + n;
                draw_face(*faces_[static_cast<std::size_t>(index)],
                          {x, y + head + static_cast<float>(n) * row, width, row}, c);
            }
        }
        return y + head + static_cast<float>(rows) * row;
    }

    void draw_face(const PlacedFace& face, const Area& row, const Columns& c) {
        const bool front = face.doubled_area > 0, drawn = face.polygon >= 0;
        const std::string tip = fmt::format(fmt::runtime(drawn ? kGoTip : kBackTip), face.face);
        const ui::Control control = ui_.control(
            {fmt::format("solids/face{}", face.face), row, ui::Kind::link, fmt::format("face {}", face.face), tip});
        if (control.clicked && drawn)
            context_.act(action::StepTo{Path{{{'t', derived_.drawing().first_shape_of(face.polygon)}}}});
        if (face.face == current_)
            ui::current_row(ui_, row);
        else if (control.hovered)
            ui::frame(ui_.list(), row, ui_.theme()[Role::now], 1, ui::size::kRadius);
        const float side = ui_.px(12);
        draw_sign({row.x + ui_.px(6), std::round(row.centre().y - side / 2), side, side}, front);
        const Role role = front ? Role::text : Role::muted;
        const float base = ui::baseline_at_middle(ui_.font(Face::code), row.centre().y);
        const auto cell = [&](float right, Role ink, std::string_view text) {
            if (right <= row.w + 1) ui_.text_right(Face::code, {row.x + right, base}, ink, text);
        };
        cell(c.number, role, std::to_string(face.face));
        cell(c.area, role, signed_text(face.doubled_area));
        cell(c.light, role, fmt::format("{:.2f}", face.light));
        cell(c.order, role, drawn ? std::to_string(face.polygon + 1) : std::string(kNever));
    }
    /// Plus on a filled plate, or minus on an outlined one.
    void draw_sign(const Area& at, bool front) {
        const ui::Color ink = ui_.theme()[front ? Role::now : Role::muted];
        if (front)
            ui::fill(ui_.list(), at, ink, 2);
        else
            ui::frame(ui_.list(), at, ink, 1, 2);
        const float arm = std::round(at.w * .3F), x = at.centre().x, y = at.centre().y;
        const ui::Color mark = front ? ui_.theme()[Role::on_now] : ink;
        ui::fill(ui_.list(), {std::round(x - arm), std::round(y - 1), 2 * arm, 2}, mark);
        if (front) ui::fill(ui_.list(), {std::round(x - 1), std::round(y - arm), 2, 2 * arm}, mark);
    }
    [[nodiscard]] static std::string signed_text(double area) {
        const std::string text = fmt::format("{:.1f}", std::fabs(area));
        return (area > 0 ? "+" : area < 0 ? "−" : "") + text;
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Derived& derived_;
    Area area_;
    Turning what_;
    std::vector<const PlacedFace*> faces_;
    int front_ = 0, drawn_ = 0, current_ = -1;
    bool draws_ = true;
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "solids", place, kTitle, kNote);
    if (context.derived.turning().mesh < 0)
        draw_empty(context, area, kNoSolid);
    else
        SolidsView(context, area).draw();
    context.ui.end_panel();
}

constexpr View kView{"solids", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::solids_view
