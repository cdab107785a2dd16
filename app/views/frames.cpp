// The frames of a texture that moves, the current one marked; a click shows another, two buttons change the rate.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::frames_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Frames", kNote = "frame {} of {}";
constexpr std::string_view kStill = "No texture of this scene moves.";
constexpr std::string_view kFrameTip = "Frame {}: a click puts it into the texture's array";
constexpr std::string_view kRun = "Run", kRunTip = "Run through the frames (F)", kStop = "Stop",
                           kStopTip = "Stop at this frame (F)";
constexpr std::string_view kSlower = "−", kSlowerTip = "Half as many frames a second", kFaster = "+",
                           kFasterTip = "Twice as many frames a second";
constexpr std::string_view kRate = "{} frames a second";
constexpr float kMostSide = 72;

class FramesView {
public:
    FramesView(const ViewContext& context, const Area& area, const Animation& animation)
        : context_(context), ui_(context.ui), area_(area), animation_(animation), strip_(context.derived.frames()) {}

    void draw() {
        const int count = strip_.count;
        const float gap = ui_.px(6), note = pitch(ui_, 16, Face::count) + ui_.px(5), least = ui_.px(32);
        const int fit = std::max(1, static_cast<int>((area_.w + gap) / (least + gap)));
        const int in_row = (count + (count + fit - 1) / fit - 1) / ((count + fit - 1) / fit);
        const float side =
            std::floor(std::min(ui_.px(kMostSide), (area_.w - ui_.px(10) - gap * static_cast<float>(in_row - 1)) /
                                                       static_cast<float>(in_row)));
        const int rows = (count + in_row - 1) / in_row;
        const float high = std::max(ui_.px(24), std::ceil(ui_.font(Face::title).em * 1.6F));
        const float content = static_cast<float>(rows) * (side + note) + 2 * gap + 2 * high + gap;
        foresee(ui_, "frames/scroll", content);
        const Area inner = ui_.begin_scroll("frames/scroll", area_);
        for (int n = 0; n < count; ++n) {
            const int column = n % in_row, row = n / in_row;
            const float x = inner.x + ui_.px(5) + static_cast<float>(column) * (side + gap);
            draw_frame(n, {x, inner.y + gap + static_cast<float>(row) * (side + note), side, side}, note);
        }
        draw_controls(inner, inner.y + static_cast<float>(rows) * (side + note) + 2 * gap, high, gap);
        ui_.end_scroll(content);
    }

private:
    void draw_frame(int n, const Area& place, float note) {
        const std::string name = fmt::format("frames/{}", n);
        const ui::Control control =
            ui_.control({name, place, ui::Kind::choice, fmt::format("frame {}", n), fmt::format(kFrameTip, n)});
        if (control.clicked) context_.act(action::SetFrame{n});
        const Image& texels = animation_.frames[static_cast<std::size_t>(n)]->texels;
        Grid<Rgba> pixels(texels.width(), texels.height());
        std::transform(texels.data(), texels.data() + texels.size(), pixels.data(), [](const Rgb& c) {
            return Rgba{c.r, c.g, c.b, 255};
        });
        const ImTextureID id = context_.textures.image(ui::id_of(name), canvas::version_of(pixels), pixels);
        ui_.list().AddImage(id, {place.x, place.y}, {place.right(), place.bottom()});
        const bool current = n == strip_.current;
        if (current)
            ui::pixel_ring(ui_.list(), place, ui_.theme()[Role::now], ui_.theme().outline, 2.5F);
        else
            ui::frame(ui_.list(), place.inset(-1, -1), ui_.theme()[control.hovered ? Role::now : Role::faint]);
        ui_.text_centred(current ? Face::line_number : Face::count,
                         {place.x, place.bottom() + ui_.px(5), place.w, note - ui_.px(5)},
                         current ? Role::now : Role::muted, std::to_string(n));
    }

    void draw_controls(const Area& inner, float y, float high, float gap) {
        const bool on = context_.state.moving;
        const float run = std::max(ui::button_width(ui_, kRun), ui::button_width(ui_, kStop));
        float x = inner.x;
        if (ui::toggle(ui_, "frames/run", {x, y, run, high}, on ? kStop : kRun, on, on ? kStopTip : kRunTip).clicked)
            context_.act(action::PlayFrames{!on});
        x += run + 2 * gap;
        if (ui::button(ui_, "frames/slower", {x, y, high, high}, kSlower, kSlowerTip).clicked)
            context_.act(action::FrameRate{.5F});
        x += high + gap;
        if (ui::button(ui_, "frames/faster", {x, y, high, high}, kFaster, kFasterTip).clicked)
            context_.act(action::FrameRate{2});
        x += high + 2 * gap;
        const std::string rate = fmt::format(kRate, ui::format_number(double{context_.state.look.frame_rate}).text);
        const bool beside = x + ui::text_width(ui_.font(Face::title), rate) <= inner.right();
        const float middle = y + high / 2 + (beside ? 0 : high + gap), left = beside ? x : inner.x;
        ui_.text_within(Face::title, {left, ui::baseline_at_middle(ui_.font(Face::title), middle)},
                        inner.right() - left, Role::muted, rate);
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    Area area_;
    const Animation& animation_;
    FrameStrip strip_;
};

void draw(const ViewContext& context, const Area& place) {
    const FrameStrip strip = context.derived.frames();
    const auto& animations = context.derived.scene().animations;
    const auto moves =
        std::find_if(animations.begin(), animations.end(), [](const Animation& a) { return !a.frames.empty(); });
    const std::string note = strip.count > 0 ? fmt::format(kNote, strip.current, strip.count) : std::string();
    const Area area = begin_view(context, "frames", place, kTitle, note);
    if (moves == animations.end())
        draw_empty(context, area, kStill);
    else
        FramesView(context, area, *moves).draw();
    context.ui.end_panel();
}

constexpr View kView{"frames", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::frames_view
