// The framebuffer as what it is in memory: bytes in a row, three to a pixel, one row of pixels after the other.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::canvas::bytes_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Bytes", kNote = "$3 (y w + x)$", kNoteAt = "$3 ({} \\cdot {} + {}) = {}$";
constexpr std::string_view kTip = "byte **{}**: {} of pixel {}, {}, which is number {}";
constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};
constexpr int kBytesPerPixel = 3;
constexpr float kWritten = .55F, kNotWritten = .12F;  ///< how much of a channel's colour lies under its number
constexpr std::int64_t kMostWhole = 1 << 16;          ///< pixels of a framebuffer that is asked for whole

/// How the strip is broken into lines: as many whole pixels in each as there is room for.
struct Strip {
    ui::Area area;             ///< of the bytes, without the addresses at the left
    float cell = 0, line = 0;  ///< width of a byte; height of a line with its gap
    int pixels = 1;            ///< in a line
    std::int64_t first = 0;    ///< pixel at the beginning of the first line in view
    int lines = 1;

    [[nodiscard]] ui::Area place_of(std::int64_t pixel) const {
        const auto [row, at] = std::lldiv(pixel - first, pixels);
        return {area.x + static_cast<float>(at) * kBytesPerPixel * cell, area.y + static_cast<float>(row) * line,
                kBytesPerPixel * cell, line};
    }
};

/// The pixel that the strip is about: the current one, else what is pinned.
[[nodiscard]] std::optional<glm::ivec2> subject(const ViewContext& ctx) {
    const Rect frame = ctx.derived.scene().framebuffer.rect();
    const auto inside = [&](std::optional<glm::ivec2> p) { return p && frame.contains(p->x, p->y); };
    if (ctx.state.pinned.kind == Selection::Kind::pixel && inside(ctx.state.pinned.at)) return ctx.state.pinned.at;
    const auto pixel = ctx.derived.pixel();
    return inside(pixel) ? pixel : std::nullopt;
}

[[nodiscard]] Strip make_strip(const ViewContext& ctx, const ui::Area& content) {
    const ui::Ui& ui = ctx.ui;
    const ui::Font &count = ui.font(ui::Face::count), &number = ui.font(ui::Face::line_number);
    const Framebuffer& frame = ctx.derived.scene().framebuffer;
    const std::int64_t all = std::int64_t{frame.width} * frame.height;
    const float margin = std::ceil(ui::text_width(number, fmt::format("{}", all * kBytesPerPixel))) + ui.px(10);
    Strip strip;
    strip.cell = std::ceil(ui::text_width(count, "000")) + ui.px(6);
    strip.line = std::max(ui.px(26), std::round(count.em * 2.2F));
    strip.area = {content.x + margin, content.y, std::max(1.0F, content.w - margin), content.h};
    strip.pixels = std::max(1, static_cast<int>(strip.area.w / (kBytesPerPixel * strip.cell)));
    strip.lines = std::max(1, static_cast<int>(strip.area.h / strip.line));
    const auto at = subject(ctx);
    const std::int64_t line = at ? address_of(frame, *at) / strip.pixels : 0,
                       lines = (all + strip.pixels - 1) / strip.pixels;
    // The pixel's line stays in the middle, away from the picture's ends.
    strip.first = std::clamp<std::int64_t>(line - strip.lines / 2, 0, std::max<std::int64_t>(0, lines - strip.lines)) *
                  strip.pixels;
    return strip;
}

[[nodiscard]] glm::ivec2 pixel_of(const Framebuffer& frame, std::int64_t address) {
    return {frame.origin_x + static_cast<int>(address % frame.width),
            frame.origin_y + static_cast<int>(address / frame.width)};
}

/// The window of the picture that the strip's lines come from.
[[nodiscard]] Window window_of(const Framebuffer& frame, const Strip& strip) {
    if (std::int64_t{frame.width} * frame.height <= kMostWhole) return {frame.rect(), 1};
    const glm::ivec2 a = pixel_of(frame, strip.first),
                     b = pixel_of(frame, strip.first + std::int64_t{strip.pixels} * strip.lines);
    return {{frame.origin_x, a.y, frame.origin_x + frame.width, std::min(frame.rect().y1, b.y + 1)}, 1};
}

/// The channel's colour at that level over the panel, as strong as the number on it stays readable.
[[nodiscard]] ui::Color byte_ground(const ui::Theme& theme, int value, int channel, float strength) {
    const std::uint8_t level = static_cast<std::uint8_t>(value);
    const ui::Color own = IM_COL32(channel == 0 ? level : 0, channel == 1 ? level : 0, channel == 2 ? level : 0, 255);
    const auto readable = [&](ui::Color ground) {
        return std::max(ui::contrast(ground, theme[Role::text]), ui::contrast(ground, theme[Role::on_now])) >=
               theme.text_contrast();
    };
    while (strength > 0 && !readable(ui::over(own, strength, theme.panel))) strength -= .05F;
    return ui::over(own, std::max(0.0F, strength), theme.panel);
}

void draw_byte(const ViewContext& ctx, const ui::Area& area, int value, int channel, bool written) {
    ui::Ui& ui = ctx.ui;
    const ui::Color plain = ui.ground();
    ui.set_ground(byte_ground(ui.theme(), value, channel, written ? kWritten : kNotWritten));
    ui::fill(ui.list(), area, ui.ground());
    const bool dark =
        ui::contrast(ui.ground(), ui.theme()[Role::text]) < ui::contrast(ui.ground(), ui.theme()[Role::on_now]);
    ui.text_centred(ui::Face::count, area,
                    dark      ? Role::on_now
                    : written ? Role::text
                              : Role::muted,
                    fmt::format("{}", value));
    ui.set_ground(plain);
}

void draw_pixel(const ViewContext& ctx, const Strip& strip, std::int64_t address, const CanvasCell& cell) {
    const ui::Area place = strip.place_of(address);
    const ui::Area bytes{place.x, place.y + 2, place.w - ctx.ui.px(3), place.h - ctx.ui.px(6)};
    const std::array<int, 3> values{cell.now.r, cell.now.g, cell.now.b};
    for (int n = 0; n < kBytesPerPixel; ++n) {
        const float x = bytes.x + static_cast<float>(n) * strip.cell;
        const float w = n == kBytesPerPixel - 1 ? bytes.right() - x : strip.cell - 1;
        draw_byte(ctx, {x, bytes.y, w, bytes.h}, values[static_cast<std::size_t>(n)], n, cell.written);
    }
}

void mark(const ViewContext& ctx, const Strip& strip, const Framebuffer& frame, glm::ivec2 pixel, float width) {
    if (!frame.rect().contains(pixel.x, pixel.y)) return;
    const std::int64_t address = address_of(frame, pixel);
    if (address < strip.first || address >= strip.first + std::int64_t{strip.pixels} * strip.lines) return;
    const ui::Area place = strip.place_of(address);
    const ui::Area bytes{place.x, place.y + 2, place.w - ctx.ui.px(3), place.h - ctx.ui.px(6)};
    ui::frame(ctx.ui.list(), bytes.inset(-width, -width), ctx.ui.theme()[Role::now], width);
}

void take_input(const ViewContext& ctx, const Strip& strip, const Framebuffer& frame) {
    ui::Ui& ui = ctx.ui;
    const float width = static_cast<float>(strip.pixels * kBytesPerPixel) * strip.cell;
    const ui::Area area{strip.area.x, strip.area.y, width, static_cast<float>(strip.lines) * strip.line};
    const glm::vec2 in = ui.input().mouse - glm::vec2(area.x, area.y);
    const bool inside = area.contains(ui.input().mouse) && ui.clip().contains(ui.input().mouse);
    const auto column = static_cast<std::int64_t>(inside ? in.x / strip.cell : 0),
               row = static_cast<std::int64_t>(inside ? in.y / strip.line : 0);
    const std::int64_t byte = (strip.first + row * strip.pixels) * kBytesPerPixel +
                              std::min<std::int64_t>(column, strip.pixels * kBytesPerPixel - 1);
    const std::int64_t address = byte / kBytesPerPixel;
    const bool on_pixel = inside && address < std::int64_t{frame.width} * frame.height;
    const glm::ivec2 pixel = pixel_of(frame, on_pixel ? address : 0);
    const std::string tip = on_pixel
                                ? fmt::format(kTip, byte, kChannels[static_cast<std::size_t>(byte % kBytesPerPixel)],
                                              pixel.x, pixel.y, address)
                                : std::string();
    const ui::Control region = ui.control(
        {.name = "bytes", .area = area, .kind = ui::Kind::region, .label = kTitle, .tip = tip, .focusable = false});
    const Selection here{.kind = Selection::Kind::pixel, .at = pixel};
    tell_hover(ctx, area, on_pixel && region.hovered, here);
    if (region.clicked && on_pixel) ctx.act(action::Pin{here});
}

void draw(const ViewContext& ctx, const ui::Area& place) {
    ui::Ui& ui = ctx.ui;
    const Framebuffer& frame = ctx.derived.scene().framebuffer;
    const auto at = subject(ctx);
    const std::string note = !at ? std::string(kNote)
                                 : fmt::format(kNoteAt, at->y - frame.origin_y, frame.width, at->x - frame.origin_x,
                                               address_of(frame, *at) * kBytesPerPixel);
    ui::Area content = begin_view(ctx, "bytes", place, kTitle, note);
    if (ui.presenting()) {  // the tab leaves no line for it
        const float line = std::round(ui::line_height(ui.font(ui::Face::note)));
        ui.rich_within(ui::Face::note,
                       {content.x, ui::baseline_at_middle(ui.font(ui::Face::note), content.y + line / 2)}, content.w,
                       Role::muted, note);
        content = {content.x, content.y + line + ui.px(4), content.w, std::max(0.0F, content.h - line - ui.px(4))};
    }
    const Strip strip = make_strip(ctx, content);
    const CanvasPicture& picture = ctx.derived.canvas(window_of(frame, strip));
    ui.begin_clip(content);
    take_input(ctx, strip, frame);
    const std::int64_t all = std::int64_t{frame.width} * frame.height;
    for (int line = 0; line < strip.lines; ++line) {
        const std::int64_t begin = strip.first + std::int64_t{line} * strip.pixels;
        if (begin >= all) break;
        const ui::Area row = strip.place_of(begin);
        const float baseline = ui::baseline_at_middle(ui.font(ui::Face::line_number), row.y + row.h / 2 - 1);
        ui.text_right(ui::Face::line_number, {strip.area.x - ui.px(8), baseline}, Role::muted,
                      fmt::format("{}", begin * kBytesPerPixel));
        for (std::int64_t address = begin; address < std::min(all, begin + strip.pixels); ++address) {
            const glm::ivec2 pixel =
                pixel_of(frame, address) - glm::ivec2(picture.window.rect.x0, picture.window.rect.y0);
            if (pixel.x < picture.cells.width() && pixel.y >= 0 && pixel.y < picture.cells.height())
                draw_pixel(ctx, strip, address, picture.cells.at(pixel.x, pixel.y));
        }
    }
    for (const glm::ivec2 pixel : ctx.hover.pixels) mark(ctx, strip, frame, pixel, 1);
    for (const glm::ivec2 pixel : ctx.pinned.pixels) mark(ctx, strip, frame, pixel, 2);
    if (const auto pixel = ctx.derived.pixel()) mark(ctx, strip, frame, *pixel, 3);
    ui.end_clip();
    ui.end_panel();
}

constexpr View kView{"bytes", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::bytes_view
