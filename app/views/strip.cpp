// One dimension: the texels above, the pixels below, and an arrow from each pixel to the texel that it takes.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_texture.h"
#include "app/views/canvas_values.h"
#include "app/views/strip_row.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"

namespace texelscope::canvas::strip_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Strip", kNoRow = "No row of the shape lies on the screen.";
constexpr std::string_view kOther = "The strip is for the method **sampling-1d**.";
constexpr std::string_view kTexels = "texels", kPixels = "pixels", kPast = "past end", kBefore = "before 0";
constexpr std::string_view kNever = "×0", kTimes = "×{}", kRatio = "$\\text{{ratio}} {}$",
                           kStart = "$\\text{{start}} {}$";
constexpr std::string_view kPixelTip = "pixel **{}** takes texel **{}**: $u$ = {}", kTexelTip = "texel **{}**, read {}";
constexpr std::string_view kWidthTip = "How many pixels the row has: both right corners move.";
constexpr std::array<std::string_view, 4> kStarts{"source", "0", "half", "ratio"};
constexpr std::array<std::string_view, 4> kStartTips{
    "As the source has it: 0 where it shrinks, one ratio where it grows", "The first pixel takes the texel at 0",
    "Half a ratio: the first pixel takes the texel under its middle", "The first pixel takes the texel at one ratio"};
constexpr std::string_view kRounded = "rounded", kRoundedTip = "The ratio rounded to two decimals, as in the source";
constexpr int kMostPixels = 32;

class StripView {
public:
    StripView(const ViewContext& ctx, const ui::Area& area, StripRow row)
        : ctx_(ctx), ui_(ctx.ui), theme_(ctx.ui.theme()), texture_(ctx.derived.texture()), row_(std::move(row)) {
        const float line = pitch(ui_, 18, ui::Face::count), names = pitch(ui_, 22, ui::Face::prose);
        ui::Area rest = area;
        const float controls = tuning_height(ui_) + ui_.px(6);
        if (may_drag(ctx.state, false) && rest.h > 2 * controls + names + 4 * line + ui_.px(56)) {
            controls_ = {rest.x, rest.y, rest.w, 2 * controls};
            rest = {rest.x, rest.y + controls_.h, rest.w, rest.h - controls_.h};
        }
        names_ = {rest.x, rest.y, rest.w, names};
        rest = {rest.x, rest.y + names, rest.w, std::max(1.0F, rest.h - names)};
        const float margin = std::ceil(ui::text_width(ui_.font(ui::Face::note), kTexels)) + ui_.px(10);
        const int in_view = std::max(1, row_.high - row_.low);
        cell_ = std::max(1.0F, std::floor(std::min((rest.w - margin) / static_cast<float>(in_view), ui_.px(72))));
        left_ = rest.x + margin;
        line_ = line;
        margin_ = {rest.x, rest.y, margin, rest.h};
        const float tall = std::clamp((rest.h - 3 * line - ui_.px(8)) * .3F, ui_.px(8), ui_.px(40));
        texels_y_ = rest.y + 2 * line, height_ = std::round(tall);
        const float lowest = rest.bottom() - line - height_ - ui_.px(4), gap = lowest - texels_y_ - height_;
        pixels_y_ = std::round(texels_y_ + height_ + std::clamp(gap, ui_.px(12), ui_.px(130)));
    }

    void draw() {
        draw_controls();
        draw_names();
        count();
        const float top = texels_y_ - 2 * line_, bottom = pixels_y_ + height_ + ui_.px(4) + line_;
        const ui::Area all{margin_.x, top, names_.w, bottom - top + 2};
        ui_.begin_clip(all);
        for (int n = row_.low; n < row_.high; ++n) draw_texel(n);
        for (std::size_t n = 0; n < row_.samples.size(); ++n) draw_arrow(n);
        for (std::size_t n = 0; n < row_.samples.size(); ++n) draw_pixel(n);
        caption(kTexels, texels_y_), caption(kPixels, pixels_y_);
        take_input(all);
        ui_.end_clip();
    }

private:
    [[nodiscard]] float x_of(double u) const { return left_ + static_cast<float>((u - row_.low) * double{cell_}); }
    [[nodiscard]] ui::Area texel_place(int n) const {
        const float a = std::round(x_of(n)), b = std::round(x_of(n + 1));
        return {a, texels_y_, b - a, height_};
    }
    /// Both strips are equally long, so that a pixel stands under the texels that it covers.
    [[nodiscard]] float x_of_pixel(double x) const {
        const double whole = row_.right - row_.left;
        const double part = whole > 0 ? (x - row_.left) / whole : 0;
        return x_of(row_.u_left + part * (row_.u_right - row_.u_left));
    }
    [[nodiscard]] ui::Area pixel_place(Integer x) const {
        const float a = std::round(x_of_pixel(static_cast<double>(x))),
                    b = std::round(x_of_pixel(static_cast<double>(x + 1)));
        return {std::min(a, b), pixels_y_, std::max(1.0F, std::abs(b - a)), height_};
    }
    [[nodiscard]] bool current(const Sample& s) const {
        const auto pixel = ctx_.derived.pixel();
        return pixel && pixel->x == s.x && pixel->y == s.y;
    }
    [[nodiscard]] bool in_texture(int n) const { return n >= 0 && n < texture_.width(); }
    [[nodiscard]] int reads(int n) const {
        return n >= row_.low && n < row_.high ? reads_[static_cast<std::size_t>(n - row_.low)] : 0;
    }

    void count() {
        reads_.assign(static_cast<std::size_t>(std::max(1, row_.high - row_.low)), 0);
        for (std::size_t n = 0; n < row_.done; ++n) {
            const int index = index_of(row_.samples[n]);
            if (index >= row_.low && index < row_.high) ++reads_[static_cast<std::size_t>(index - row_.low)];
        }
    }

    void caption(std::string_view text, float y) {
        ui_.text_within(ui::Face::note, {margin_.x, ui::baseline_at_middle(ui_.font(ui::Face::note), y + height_ / 2)},
                        margin_.w - ui_.px(4), Role::muted, text);
    }

    /// ratio and start, as far as the step knows them.
    void draw_names() {
        const float baseline = ui::baseline_at_middle(ui_.font(ui::Face::prose), names_.y + names_.h / 2);
        float x = names_.x;
        const auto say = [&](std::string_view name, std::string_view form) {
            const auto value = number_of(ctx_.derived, name);
            if (!value) return;
            const double shown = std::round(*value * 1e4) / 1e4;
            const std::string text = fmt::format("{} {:.6g}", shown == *value ? "=" : "\\approx", shown);
            x += ui_.rich_within(ui::Face::prose, {x, baseline}, names_.right() - x, Role::text,
                                 fmt::format(fmt::runtime(form), text)) +
                 ui_.px(24);
        };
        say("ratio", kRatio);
        say("start", kStart);
        if (row_.done < row_.samples.size() || x > names_.right()) return;
        const auto twice =
            std::count_if(reads_of_texture().begin(), reads_of_texture().end(), [](int n) { return n > 1; });
        const auto never = std::count(reads_of_texture().begin(), reads_of_texture().end(), 0);
        ui_.text_within(ui::Face::prose, {x, baseline}, names_.right() - x, Role::muted,
                        fmt::format("{} never read, {} read again", never, twice));
    }
    /// How often each texel of the texture is read in the row, in the end.
    [[nodiscard]] const std::vector<int>& reads_of_texture() {
        if (!in_all_.empty()) return in_all_;
        in_all_.assign(static_cast<std::size_t>(std::max(1, texture_.width())), 0);
        for (const Sample& s : row_.samples)
            if (in_texture(index_of(s))) ++in_all_[static_cast<std::size_t>(index_of(s))];
        return in_all_;
    }

    /// Text on a colour of the picture: dark or light, whichever reads; else, or with `plate`, on a plate.
    void text_on(const ui::Area& place, ui::Color ground, std::string_view text, bool plate = false) {
        const ui::Color plain = ui_.ground();
        ui_.set_ground(ground);
        const double light = ui::contrast(ground, theme_[Role::text]),
                     dark = ui::contrast(ground, theme_[Role::on_now]);
        if (plate || std::max(light, dark) < theme_.text_contrast()) {
            const float w =
                std::min(place.w - 2, std::ceil(ui::text_width(ui_.font(ui::Face::count), text)) + ui_.px(6));
            const float h = std::min(place.h - 2, std::round(ui_.font(ui::Face::count).em * 1.3F));
            ui_.set_ground(theme_.canvas);
            ui::fill(ui_.list(), {std::round(place.centre().x - w / 2), std::round(place.centre().y - h / 2), w, h},
                     theme_.canvas, ui::size::kBadgeRadius);
        }
        const bool on_dark =
            ui::contrast(ui_.ground(), theme_[Role::text]) >= ui::contrast(ui_.ground(), theme_[Role::on_now]);
        ui_.text_centred(ui::Face::count, place, on_dark ? Role::text : Role::on_now, text);
        ui_.set_ground(plain);
    }
    [[nodiscard]] bool roomy(const ui::Area& place, std::string_view text) const {
        return ui::text_width(ui_.font(ui::Face::count), text) + 2 <= place.w;
    }

    void draw_texel(int n) {
        const ui::Area place = texel_place(n);
        const std::string name = fmt::format("{}", n);
        const int row = row_.samples.front().row;
        if (in_texture(n)) {
            const Rgb c = texture_.texels.at(n, std::clamp(row, 0, texture_.height() - 1));
            const ui::Color color = IM_COL32(c.r, c.g, c.b, 255);
            ui::fill(ui_.list(), place.inset(1, 0), color);
            if (roomy(place, name)) text_on(place, color, name);
        } else {
            static constexpr std::array<float, 2> kDashes{4, 4};
            const std::array<glm::vec2, 5> ring{{{place.x + 1, place.y},
                                                 {place.right() - 1, place.y},
                                                 {place.right() - 1, place.bottom()},
                                                 {place.x + 1, place.bottom()},
                                                 {place.x + 1, place.y}}};
            ui::draw_dashed(ui_.list(), ring, kDashes, 1.5F, theme_[Role::error]);
            if (roomy(place, name)) ui_.text_centred(ui::Face::count, place, Role::text, name);
        }
        draw_reads(n, place);
        for (const glm::ivec2 texel : ctx_.pinned.texels)
            if (texel.x == n) ui::frame(ui_.list(), place.inset(-1, -2), theme_[Role::now], 2);
        for (const glm::ivec2 texel : ctx_.hover.texels)
            if (texel.x == n) ui::frame(ui_.list(), place.inset(-1, -2), theme_[Role::now], 1);
    }

    /// Never read: hatched. Read again: a bar over it for each time. Both say how often.
    void draw_reads(int n, const ui::Area& place) {
        const int times = reads(n);
        const bool complete = row_.done == row_.samples.size();
        const ui::Area above{place.x, place.y - line_ - ui_.px(4), place.w, line_};
        const float bar = std::max(2.0F, ui_.px(2));
        for (int k = 0; k < std::min(times, 4); ++k)
            ui::fill(ui_.list(), {place.x + 2, place.y - static_cast<float>(k + 1) * (bar + 2), place.w - 4, bar},
                     theme_[times > 1 ? Role::now : Role::muted]);
        const ui::Area text = above.moved(0, -ui_.px(6));
        if (in_texture(n) && complete && times == 0) {
            const std::array<glm::vec2, 4> quad{{{place.x, place.y},
                                                 {place.right(), place.y},
                                                 {place.right(), place.bottom()},
                                                 {place.x, place.bottom()}}};
            ui::draw_hatch(ui_.list(), quad, 45, ui_.px(6), quad[0], 1.5F, theme_.canvas);
            ui::frame(ui_.list(), place, theme_[Role::error], 2);
            const std::string name = fmt::format("{}", n);
            if (roomy(place, name)) text_on(place, theme_.canvas, name, true);
            if (roomy(place, kNever)) ui_.text_centred(ui::Face::count, text, Role::error, kNever);
        } else if (!in_texture(n)) {
            const std::string_view where = n < 0 ? kBefore : kPast;
            const std::string_view said = roomy(place, where) ? where : std::string_view("!");
            ui_.text_centred(ui::Face::count, text, Role::error, said);
        } else if (times > 1) {
            const std::string said = fmt::format(kTimes, times);
            if (roomy(place, said)) ui_.text_centred(ui::Face::count, text, Role::text, said);
        }
    }

    void draw_arrow(std::size_t n) {
        if (n >= row_.done) return;
        const Sample& s = row_.samples[n];
        const ui::Area from = pixel_place(s.x);
        const bool now = current(s);
        const glm::vec2 a(from.centre().x, from.y - 2),
            b(x_of(std::clamp(s.u, double(row_.low), double(row_.high))), texels_y_ + height_ + 2);
        if (now) ui::line(ui_.list(), a, b, 5, theme_.panel);
        ui::arrow(ui_.list(), a, b, now ? 2.5F : 1.4F, theme_[now ? Role::now : Role::muted], ui_.px(now ? 9 : 6));
    }

    void draw_pixel(std::size_t n) {
        const Sample& s = row_.samples[n];
        const ui::Area place = pixel_place(s.x);
        const bool done = n < row_.done;
        if (done) ui::fill(ui_.list(), place.inset(1, 0), IM_COL32(s.colour.r, s.colour.g, s.colour.b, 255));
        ui::frame(ui_.list(), place, theme_[done ? Role::muted : Role::faint], 1);
        if (current(s)) ui::pixel_ring(ui_.list(), place, theme_[Role::now], theme_.outline, 2.5F);
        for (const glm::ivec2 pixel : ctx_.pinned.pixels)
            if (pixel == glm::ivec2(s.x, s.y)) ui::frame(ui_.list(), place.inset(-2, -2), theme_[Role::now], 2);
        for (const glm::ivec2 pixel : ctx_.hover.pixels)
            if (pixel == glm::ivec2(s.x, s.y)) ui::frame(ui_.list(), place.inset(-1, -1), theme_[Role::now], 1);
        const std::string index = fmt::format("{}", index_of(s));
        const ui::Area below{place.x, place.bottom() + ui_.px(4), place.w, line_};
        if (done && roomy(place, index))
            ui_.text_centred(ui::Face::count, below,
                             !in_texture(index_of(s)) ? Role::error
                             : current(s)             ? Role::now
                                                      : Role::text,
                             index);
    }

    void draw_controls() {
        if (controls_.empty()) return;
        const float height = tuning_height(ui_), pitch_of_rows = controls_.h / 2;
        const double width = row_.right - row_.left;
        const ui::Area first{controls_.x, controls_.y, controls_.w, height};
        if (const auto to = draw_tuning(ui_, first, {"strip/n", "$n$", fmt::format("{:.0f}", width), kWidthTip},
                                        std::round(width), {1, kMostPixels, 1}))
            widen(std::round(*to));
        const Method& method = ctx_.derived.method();
        const float rounded = ui::button_width(ui_, kRounded);
        const ui::Area second = first.moved(0, pitch_of_rows);
        const float label =
            ui_.text_within(ui::Face::prose,
                            {second.x, ui::baseline_at_middle(ui_.font(ui::Face::prose), second.centre().y)},
                            second.w * .2F, Role::muted, "start") +
            ui_.px(8);
        const ui::Area choice{second.x + label, second.y, std::max(1.0F, second.w - label - rounded - ui_.px(12)),
                              height};
        const auto on = [&](std::string_view field) {
            const int n = quirk_index(method, field);
            return n >= 0 && (ctx_.state.work.quirks >> n & 1U) != 0;
        };
        const int chosen = on("uneven_start") ? 0 : on("start_zero") ? 1 : on("start_ratio") ? 3 : 2;
        if (const auto picked = ui::segments(ui_, "strip/start", choice, kStarts, chosen, kStartTips)) choose(*picked);
        if (ui::toggle(ui_, "strip/rounded", {second.right() - rounded, second.y, rounded, height}, kRounded,
                       on("rounded"), kRoundedTip)
                .clicked)
            ctx_.act(action::SetQuirk{quirk_index(method, "rounded"), !on("rounded")});
    }
    void choose(int start) {
        static constexpr std::array<std::string_view, 4> kFields{"uneven_start", "start_zero", "", "start_ratio"};
        QuirkSet quirks = ctx_.state.work.quirks;
        for (std::size_t n = 0; n < kFields.size(); ++n) {
            const int index = quirk_index(ctx_.derived.method(), kFields[n]);
            if (index < 0) continue;
            const QuirkSet bit = QuirkSet{1} << index;
            quirks = static_cast<int>(n) == start ? quirks | bit : quirks & ~bit;
        }
        ctx_.act(action::SetQuirks{quirks});
    }
    /// The corners at the right end go to `pixels` from the left one.
    void widen(double pixels) {
        const int polygon = ctx_.derived.drawing().polygon_of(ctx_.derived.shape());
        std::vector<glm::vec2> to;
        const auto& corners = ctx_.derived.scene().polygons[static_cast<std::size_t>(polygon)].vertices;
        const double middle = (row_.left + row_.right) / 2;
        for (const Vertex& v : corners)
            to.emplace_back(double{v.x} > middle ? static_cast<float>(row_.left + pixels) : v.x, v.y);
        const int gesture = ui_.memory().active != 0 ? ui_.memory().presses : 0;
        ctx_.act(action::MoveShape{polygon, std::move(to), gesture});
    }

    void take_input(const ui::Area& all) {
        const ui::Area shown = ui::intersection(all, ui_.clip());
        const glm::vec2 mouse = ui_.input().mouse;
        Selection here;
        std::string tip;
        if (shown.contains(mouse)) {
            for (std::size_t n = 0; n < row_.samples.size(); ++n) {
                const Sample& s = row_.samples[n];
                if (!pixel_place(s.x).contains(mouse)) continue;
                here = {.kind = Selection::Kind::pixel, .at = {static_cast<int>(s.x), static_cast<int>(s.y)}};
                if (n < row_.done) tip = fmt::format(kPixelTip, s.x, index_of(s), ui::format_number(s.u).text);
            }
            for (int n = row_.low; n < row_.high; ++n) {
                if (!texel_place(n).contains(mouse) || !in_texture(n)) continue;
                here = {.kind = Selection::Kind::texel,
                        .at = {n, std::clamp(row_.samples.front().row, 0, texture_.height() - 1)}};
                tip = fmt::format(kTexelTip, n, fmt::format(kTimes, reads(n)));
            }
        }
        const ui::Area region{margin_.x, texels_y_, names_.w, pixels_y_ + height_ - texels_y_};
        const ui::Control control = ui_.control({.name = "strip",
                                                 .area = ui::intersection(region, shown),
                                                 .kind = ui::Kind::region,
                                                 .label = kTitle,
                                                 .tip = tip,
                                                 .focusable = false});
        const bool on_it = control.hovered && here.kind != Selection::Kind::none;
        tell_hover(ctx_, region, on_it, here);
        if (control.clicked && on_it) point_or_pin(ctx_, here);
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    const ui::Theme& theme_;
    const Texture& texture_;
    StripRow row_;
    std::vector<int> reads_, in_all_;
    ui::Area controls_, names_, margin_;
    float cell_ = 1, left_ = 0, line_ = 0, texels_y_ = 0, pixels_y_ = 0, height_ = 0;
};

void draw(const ViewContext& ctx, const ui::Area& place) {
    const ui::Area area = begin_view(ctx, "strip", place, kTitle);
    if (ctx.derived.shape() < 0 || ctx.derived.method().id != "sampling-1d")
        draw_empty(ctx, area, kOther);
    else if (auto row = strip_row(ctx))
        StripView(ctx, area, std::move(*row)).draw();
    else
        draw_empty(ctx, area, kNoRow);
    ctx.ui.end_panel();
}

constexpr View kView{"strip", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::strip_view
