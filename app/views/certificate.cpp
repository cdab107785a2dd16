// Who decided each pixel's texel: a cheap value with a bound of its error, or, where a border of texels lies within
// that bound, better arithmetic. A map of the cursor's shape, and of the current pixel value, bound and distance.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"
#include "app/views/race_table.h"
#include "app/views/terms.h"

namespace texelscope::canvas::certificate_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Certificate";
constexpr std::string_view kNothing = "This shape is no triangle that is drawn: there is nothing to decide.";
constexpr std::string_view kPixelTip = "pixel **{}, {}**: {}";
constexpr std::string_view kChoose = "Go to a pixel: its values, their bounds, how near a border is.";
constexpr std::string_view kRows = "In perspective each row has its own bound.",
                           kSlow = "Double cannot hold these corners: every sample is decided in whole numbers.";
constexpr std::string_view kLine = "{} = {}", kWithin = "± {}", kAway = "border {} away";
constexpr std::string_view kSure = "certified", kUnsure = "in doubt";
constexpr std::string_view kScale = "distance to the next border [texels]";
constexpr float kLeastPicture = 90, kRuler = 26, kMarksFrom = 5;  ///< [px at 100 %]; marks from so many px a pixel
constexpr double kNearest = 1e-12, kFarthest = 0.5;               ///< ends of the ruler [texels]

struct DecisionInfo {
    Decision decision;
    Role role;
    std::string_view name, says;
};
constexpr std::array<DecisionInfo, 5> kShown{{
    {Decision::certificate, Role::covered, "certified", "certified: no border within the bound"},
    {Decision::tie, Role::now, "tie, by its gap", "exactly on a border: a tie, decided by the gap of all ties"},
    {Decision::in_double, Role::section_1, "in double", "decided again, in double"},
    {Decision::wide, Role::section_2, "in 128 bits", "decided again, in whole numbers of 128 bits"},
    {Decision::exact, Role::error, "exactly", "decided again, in whole numbers of any size"},
}};
[[nodiscard]] const DecisionInfo* info_of(Decision decision) {
    for (const DecisionInfo& info : kShown)
        if (info.decision == decision) return &info;
    return nullptr;
}
[[nodiscard]] Rgba rgba(ui::Color c) {
    const auto byte = [c](unsigned shift) { return static_cast<std::uint8_t>(c >> shift & 0xFFU); };
    return {byte(0), byte(8), byte(16), 255};
}
/// "0", "3.7e-09", "0.25": as few digits as tell sizes apart.
[[nodiscard]] std::string size_text(double value) {
    return value != 0 && value < 1e-3 ? fmt::format("{:.1e}", value) : fmt::format("{:.4g}", value);
}
/// Marks, so that colours are not needed: nothing, a ring, a dot, a bar, a cross.
void draw_mark(ImDrawList& list, Decision decision, const Area& at, ui::Color color) {
    const glm::vec2 c = at.centre();
    const float r = at.w * .28F, pen = std::max(1.0F, at.w / 9);
    switch (decision) {
        case Decision::tie: return list.AddCircle(ui::to_im(c), r, color, 16, pen);
        case Decision::in_double: return list.AddCircleFilled(ui::to_im(c), r * .8F, color, 12);
        case Decision::wide: return ui::line(list, {c.x - r, c.y}, {c.x + r, c.y}, pen, color);
        case Decision::exact: return ui::cross(list, c, r, pen, color);
        default: return;
    }
}

/// The pixels that are drawn, with one around them where the frame goes on.
[[nodiscard]] Rect box_of(const Decisions& found) {
    const Rect& frame = found.frame;
    Rect box{frame.x1, frame.y1, frame.x0, frame.y0};
    for (int y = frame.y0; y < frame.y1; ++y)
        for (int x = frame.x0; x < frame.x1; ++x)
            if (found.pixels.at(x - frame.x0, y - frame.y0) != Decision::none)
                box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
    return intersection(frame, {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1});
}

class CertificateView {
public:
    CertificateView(const ViewContext& ctx, const Area& area)
        : ctx_(ctx), ui_(ctx.ui), area_(area), found_(ctx.derived.decisions()), line_(pitch(ctx.ui, 20, Face::title)) {}

    void draw() {
        const float below = legend_height() + values_height();
        const float content = std::max(area_.h, below + ui_.px(kLeastPicture));
        foresee(ui_, "certificate/scroll", content);
        const Area inner = ui_.begin_scroll("certificate/scroll", area_);
        const Area picture{inner.x, inner.y, inner.w, content - below};
        draw_picture(picture);
        draw_legend({inner.x, picture.bottom(), inner.w, legend_height()});
        draw_values({inner.x, picture.bottom() + legend_height(), inner.w, values_height()});
        ui_.end_scroll(content);
    }

private:
    [[nodiscard]] int columns() const {
        float widest = 0;
        for (const DecisionInfo& info : kShown)
            widest = std::max(widest, ui::text_width(ui_.font(Face::title), info.name));
        widest += ui_.px(40) + ui::text_width(ui_.font(Face::code), "0,000");
        return std::clamp(static_cast<int>(area_.w / widest), 1, static_cast<int>(kShown.size()));
    }
    [[nodiscard]] float legend_height() const {
        const int across = columns(), rows = (static_cast<int>(kShown.size()) + across - 1) / across;
        return static_cast<float>(rows) * line_ + ui_.px(8);
    }
    [[nodiscard]] float axis_height() const { return line_ + ui_.px(kRuler); }
    [[nodiscard]] float values_height() const { return 2 * axis_height() + line_; }

    [[nodiscard]] Decision decision_at(glm::ivec2 pixel) const {
        return found_.pixels.at(pixel.x - found_.frame.x0, pixel.y - found_.frame.y0);
    }
    [[nodiscard]] ui::Color color_of(const DecisionInfo& info) const {
        const ui::Color color = ui_.theme()[info.role];
        return info.decision == Decision::certificate ? ui::over(color, .35F, ui_.theme().canvas) : color;
    }

    // -- the map
    void draw_picture(const Area& area) {
        const Rect box = box_of(found_);
        const CanvasMap map = make_map(area, {box.width(), box.height(), box.x0, box.y0, {}}, Look{});
        Grid<Rgba> pixels(box.width(), box.height(), Rgba{0, 0, 0, 0});
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x)
                if (const DecisionInfo* const info = info_of(decision_at({x, y})))
                    pixels.at(x - box.x0, y - box.y0) = rgba(color_of(*info));
        const Area at = map.place_of(box);
        const ImTextureID image = ctx_.textures.image(ui::id_of("certificate"), version_of(pixels), pixels);
        ui_.begin_clip(map.area);
        ui_.list().AddImage(image, {at.x, at.y}, {at.right(), at.bottom()});
        ui::frame(ui_.list(), at, ui_.theme().hairline);
        if (map.zoom >= double{kMarksFrom}) draw_marks(map);
        take_pixel(map);
        const auto ring = [&](glm::ivec2 pixel, float width) {
            ui::pixel_ring(ui_.list(), ui::grown_to(map.place_of(pixel), 4), ui_.theme()[Role::now],
                           ui_.theme().outline, width, 1);
        };
        if (ctx_.hover.pixels.size() == 1) ring(ctx_.hover.pixels.front(), 1);
        if (ctx_.pinned.pixels.size() == 1) ring(ctx_.pinned.pixels.front(), 2);
        if (const auto pixel = ctx_.derived.pixel()) ring(*pixel, 2);
        ui_.end_clip();
    }
    void draw_marks(const CanvasMap& map) {
        const Rect box = box_of(found_);
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x)
                draw_mark(ui_.list(), decision_at({x, y}), map.place_of(glm::ivec2(x, y)), ui_.theme().outline);
    }
    void take_pixel(const CanvasMap& map) {
        const glm::ivec2 pixel = map.pixel_at(ui_.input().mouse);
        const bool on = map.area.contains(ui_.input().mouse) && found_.frame.contains(pixel.x, pixel.y);
        const DecisionInfo* const info = on ? info_of(decision_at(pixel)) : nullptr;
        const ui::Control region =
            ui_.control({.name = "certificate/picture",
                         .area = map.area,
                         .kind = ui::Kind::region,
                         .label = kTitle,
                         .tip = info != nullptr ? fmt::format(kPixelTip, pixel.x, pixel.y, info->says) : std::string(),
                         .focusable = false});
        const Selection what{.kind = Selection::Kind::pixel, .at = pixel};
        tell_hover(ctx_, map.area, on && region.hovered, what);
        if (region.double_clicked && on) {
            if (const auto step = ctx_.derived.last_write(pixel)) ctx_.act(action::StepTo{*step});
        } else if (region.clicked && on) {
            point_or_pin(ctx_, what);
        }
    }
    void draw_legend(const Area& area) {
        const int across = columns();
        const float width = std::floor(area.w / static_cast<float>(across));
        const float side = std::max(ui_.px(12), std::round(ui_.font(Face::title).em * .7F));
        for (std::size_t n = 0; n < kShown.size(); ++n) {
            const DecisionInfo& info = kShown[n];
            const int column = static_cast<int>(n) % across, row = static_cast<int>(n) / across;
            const float x = area.x + static_cast<float>(column) * width;
            const float middle = area.y + ui_.px(4) + (static_cast<float>(row) + .5F) * line_;
            const Area swatch{x, std::round(middle - side / 2), side, side};
            ui::fill(ui_.list(), swatch, color_of(info));
            draw_mark(ui_.list(), info.decision, swatch, ui_.theme().outline);
            const std::uint64_t count = found_.of(info.decision);
            const Role role = count > 0 ? Role::text : Role::muted;
            const float text = x + side + ui_.px(6), right = x + width - ui_.px(6);
            const float used =
                ui_.text_within(Face::title, {text, ui::baseline_at_middle(ui_.font(Face::title), middle)},
                                right - text, role, info.name);
            const float number = text + used + ui_.px(7);
            ui_.text_within(Face::code, {number, ui::baseline_at_middle(ui_.font(Face::code), middle)},
                            std::max(0.0F, right - number), role, grouped(static_cast<double>(count)));
        }
    }

    // -- the current pixel
    /// What the shape draws there, in exact numbers: the pixel that is pinned, or else the cursor's.
    [[nodiscard]] std::optional<Sample> current_sample() const {
        std::optional<glm::ivec2> pixel = ctx_.derived.pixel();
        if (ctx_.state.pinned.kind == Selection::Kind::pixel) pixel = ctx_.state.pinned.at;
        if (!pixel) return std::nullopt;
        std::optional<Sample> found;
        const int shape = ctx_.derived.shape();
        each_sample(ctx_.derived.drawing(), shape, shape + 1, {{pixel->x, pixel->y, pixel->x + 1, pixel->y + 1}, 1},
                    [&](int, const Sample& sample) {
                        if (sample.fate == Fate::written) found = sample;
                    });
        return found;
    }
    void draw_values(const Area& area) {
        const auto sample = current_sample();
        const float baseline = ui::baseline_at_middle(ui_.font(Face::title), area.y + line_ / 2);
        if (!sample) return say(area, baseline, kChoose);
        if (found_.u_bound == 0) return say(area, baseline, found_.slow ? kSlow : kRows);
        draw_axis({area.x, area.y, area.w, axis_height()}, "u", Role::u, sample->u, found_.u_bound);
        draw_axis({area.x, area.y + axis_height(), area.w, axis_height()}, "v", Role::v, sample->v, found_.v_bound);
        ui_.text_within(Face::note, {area.x, area.bottom() - ui_.px(5)}, area.w, Role::muted, kScale);
    }
    void say(const Area& area, float baseline, std::string_view text) {
        ui_.text_within(Face::title, {area.x, baseline}, area.w, Role::muted, text);
    }
    /// Value, bound and distance as text; below a logarithmic ruler of distances, shaded up to the bound, with a dot.
    void draw_axis(const Area& area, std::string_view name, Role role, double value, double bound) {
        const double distance = std::abs(value - std::round(value));
        const bool sure = distance > bound;
        const float baseline = ui::baseline_at_middle(ui_.font(Face::code), area.y + line_ / 2);
        float x = area.x;
        const auto put = [&](Face face, Role of, const std::string& text) {
            x += ui_.text_within(face, {x, baseline}, std::max(0.0F, area.right() - x), of, text) + ui_.px(12);
        };
        put(Face::code_strong, role, fmt::format(kLine, name, ui::format_number(value, 6).text));
        put(Face::code, Role::text, fmt::format(kWithin, size_text(bound)));
        put(Face::code, Role::text, fmt::format(kAway, size_text(distance)));
        put(Face::code_strong, sure ? Role::text : Role::now, std::string(sure ? kSure : kUnsure));
        const Area ruler{area.x + ui_.px(6), area.y + line_ + ui_.px(6), area.w - ui_.px(12), ui_.px(9)};
        const auto place = [&](double texels) {
            const double share = std::log(std::max(texels, kNearest) / kNearest) / std::log(kFarthest / kNearest);
            return std::round(ruler.x + ruler.w * static_cast<float>(std::clamp(share, 0.0, 1.0)));
        };
        ui::fill(ui_.list(), ruler, ui_.theme().raise);
        ui::fill(ui_.list(), {ruler.x, ruler.y, place(bound) - ruler.x, ruler.h},
                 ui::with_alpha(ui_.theme()[Role::now], .55F));
        for (int decade = -12; decade < 0; ++decade) {
            const float at = place(std::pow(10.0, decade));
            ui::line(ui_.list(), {at, ruler.bottom()}, {at, ruler.bottom() + ui_.px(3)}, 1, ui_.theme()[Role::faint]);
        }
        const glm::vec2 dot{place(distance), ruler.y + ruler.h / 2};
        ui_.list().AddCircleFilled(ui::to_im(dot), ui_.px(6), ui_.theme().outline, 20);
        ui_.list().AddCircleFilled(ui::to_im(dot), ui_.px(4.5F), ui_.theme()[role], 20);
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    Area area_;
    const Decisions& found_;
    float line_;
};

void draw(const ViewContext& context, const Area& place) {
    const Area area = begin_view(context, "certificate", place, kTitle);
    const Decisions& found = context.derived.decisions();
    const bool any = std::any_of(found.count.begin() + 1, found.count.end(), [](std::uint64_t n) { return n > 0; });
    if (any)
        CertificateView(context, area).draw();
    else
        draw_empty(context, area, kNothing);
    context.ui.end_panel();
}

constexpr View kView{"certificate", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::certificate_view
