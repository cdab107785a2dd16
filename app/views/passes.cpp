// The form with arrays: what each pass over the box hands to the next, with the element under work.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/formula_blocks.h"
#include "app/views/terms.h"

namespace texelscope::passes_view {
namespace {

constexpr std::string_view kTitle = "Passes over arrays", kTab = "Passes";
constexpr std::string_view kNoArrays =
    "The method runs as one loop over pixels. Switch its form **arrays** on to see the passes.";
constexpr std::string_view kNoBox = "Nothing of the shape lies on the screen: there is no box to pass over.";
constexpr std::string_view kSoFar = "{} of {}", kStageTip = "{}. Click to go to the pass.";
constexpr int kMostCells = 1 << 14;  ///< of a picture; larger boxes are thinned out

enum class Pass : std::uint8_t { box, mask, indices, uv, store };
struct PassInfo {
    Pass pass;
    std::string_view stage, tip;
};
constexpr std::array<PassInfo, 5> kPasses{{
    {Pass::box, "box", "The samples that can lie inside, row by row"},
    {Pass::mask, "mask", "One truth for each sample of the box: inside all three sides or not"},
    {Pass::indices, "indices", "The places of the samples inside, as addresses in the framebuffer"},
    {Pass::uv, "uv", "For each of them the texel: column to the right in red, row down in green"},
    {Pass::store, "store", "The texels' colours, written at the addresses"},
}};

struct BoxSamples {
    Window window;
    Grid<std::optional<Sample>> cells;
    Integer tested = 0, inside = 0;
};

[[nodiscard]] std::optional<Integer> whole(const Tape& tape, std::string_view name) {
    const std::int32_t n = find_name(tape, name, static_cast<std::int32_t>(tape.names.size()) - 1);
    if (n < 0) return std::nullopt;
    return static_cast<Integer>(approximate(
        tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(n)].operation)].value));
}

/// The shape's box as the method computed it, inside the framebuffer; empty where it has none.
[[nodiscard]] Rect box_of(const Derived& derived) {
    const Tape& tape = derived.visit().tape;
    const auto x0 = whole(tape, "x_a"), x1 = whole(tape, "x_b"), y0 = whole(tape, "y_a"), y1 = whole(tape, "y_b");
    if (!x0 || !x1 || !y0 || !y1) return {};
    const Rect frame = derived.scene().framebuffer.rect();
    const auto in = [](Integer a, int low, int high) { return static_cast<int>(std::clamp<Integer>(a, low, high)); };
    return {in(*x0, frame.x0, frame.x1), in(*y0, frame.y0, frame.y1), in(*x1, frame.x0, frame.x1),
            in(*y1, frame.y0, frame.y1)};
}

[[nodiscard]] BoxSamples samples_of(const Derived& derived, const Rect& box) {
    BoxSamples s;
    int stride = 1;
    while ((box.width() / stride) * (box.height() / stride) > kMostCells) ++stride;
    s.window = {box, stride};
    s.cells = Grid<std::optional<Sample>>((box.width() + stride - 1) / stride, (box.height() + stride - 1) / stride);
    const int shape = derived.shape();
    each_sample(derived.drawing(), shape, shape + 1, s.window, [&](int, const Sample& sample) {
        const int x = static_cast<int>(sample.x - box.x0) / stride, y = static_cast<int>(sample.y - box.y0) / stride;
        if (x < 0 || y < 0 || x >= s.cells.width() || y >= s.cells.height()) return;
        s.cells.at(x, y) = sample;
        ++s.tested;
        s.inside += sample.fate == Fate::written;
    });
    return s;
}

[[nodiscard]] std::uint8_t scaled(int index, int size) {
    return static_cast<std::uint8_t>(60 + index * 195 / std::max(1, size - 1));
}

[[nodiscard]] Rgba to_rgba(ui::Color c) {
    return {static_cast<std::uint8_t>(c & 255U), static_cast<std::uint8_t>(c >> 8U & 255U),
            static_cast<std::uint8_t>(c >> 16U & 255U), 255};
}

[[nodiscard]] std::uint64_t hash_of(const Grid<Rgba>& pixels) {
    std::uint64_t hash = 1469598103934665603ULL;
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        const Rgba& p = pixels.data()[n];
        const std::uint32_t word = static_cast<std::uint32_t>(p.r) | static_cast<std::uint32_t>(p.g) << 8U |
                                   static_cast<std::uint32_t>(p.b) << 16U;
        hash = (hash ^ word) * 1099511628211ULL;
    }
    return hash;
}

class PassesView {
public:
    PassesView(const ViewContext& context, const ui::Area& area)
        : context_(context),
          ui_(context.ui),
          visit_(context.derived.visit()),
          area_(area),
          samples_(samples_of(context.derived, box_of(context.derived))) {
        const auto stage = visit_.path.index_of('s');
        const bool in_stage = stage && *stage < static_cast<Integer>(visit_.stages.size());
        const std::string name = in_stage ? visit_.stages[static_cast<std::size_t>(*stage)].name : std::string();
        for (std::size_t n = 0; n < kPasses.size(); ++n) {
            if (kPasses[n].stage == name) current_ = static_cast<int>(n);
        }
        if (!stage) current_ = static_cast<int>(kPasses.size());  // at the shape's end all passes are done
    }

    void draw() {
        const float caption = pitch(ui_, 17, ui::Face::title), note = pitch(ui_, 15, ui::Face::count), gap = ui_.px(18);
        const float aspect = static_cast<float>(samples_.cells.width()) / static_cast<float>(samples_.cells.height());
        int best = 1;
        float size = 0;
        for (int columns = 1; columns <= 5; ++columns) {
            const int in_rows = (5 + columns - 1) / columns;
            const auto rows = static_cast<float>(in_rows);
            const float w = (area_.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
            const float h = (area_.h - ui_.px(6)) / rows - caption - note - ui_.px(6);
            const float fits = std::min(w, h * aspect);
            if (fits > size) size = fits, best = columns;
        }
        const float w = std::max(ui_.px(24), std::floor(size)), h = std::floor(w / aspect);
        for (int n = 0; n < 5; ++n) {
            const int column = n % best, row = n / best;
            const ui::Area cell{area_.x + static_cast<float>(column) * (w + gap),
                                area_.y + static_cast<float>(row) * (h + caption + note + ui_.px(6)), w,
                                h + caption + note};
            draw_pass(n, cell, caption, {cell.x, cell.y + caption, w, h});
            if (column + 1 < best && n < 4) {
                const float y = cell.y + caption + h / 2;
                ui::arrow(ui_.list(), {cell.right() + ui_.px(3), y}, {cell.right() + gap - ui_.px(3), y}, 1.5F,
                          ui_.theme()[ui::Role::faint], ui_.px(5));
            }
        }
    }

private:
    /// Whether the pass has come to a sample: all of it, none of it, or what lies before the cursor's element.
    [[nodiscard]] bool reached(int pass, const Sample& s) const {
        if (pass < current_) return true;
        if (pass > current_) return false;
        const Path& step = context_.state.cursor.step;
        const auto y = step.index_of('y'), x = step.index_of('x');
        if (!y) return true;  // a stage's step is its end
        return s.y < *y || (s.y == *y && (!x || s.x <= *x));
    }

    [[nodiscard]] ui::Color colour(Pass pass, const Sample& s, const Texture& texture) const {
        const ui::Theme& theme = ui_.theme();
        const bool inside = s.fate == Fate::written;
        switch (pass) {
            case Pass::box: return ui::over(theme[ui::Role::rejected], .7F, theme.canvas);
            case Pass::mask: return inside ? theme[ui::Role::covered] : theme[ui::Role::rejected];
            case Pass::indices:
                return inside ? ui::over(theme[ui::Role::covered], (s.x + s.y) % 2 == 0 ? 1.0F : .8F, theme.canvas)
                              : theme.canvas;
            case Pass::uv:
                if (!inside) return theme.canvas;
                return ui::hex(static_cast<std::uint32_t>(scaled(s.column, texture.width()) << 16 |
                                                          scaled(s.row, texture.height()) << 8 | 60));
            case Pass::store:
                if (!inside) return theme.canvas;
                return ui::hex(static_cast<std::uint32_t>(s.colour.r << 16 | s.colour.g << 8 | s.colour.b));
        }
        return theme.canvas;
    }

    void draw_pass(int n, const ui::Area& cell, float caption, const ui::Area& picture) {
        const PassInfo& info = kPasses[static_cast<std::size_t>(n)];
        const std::string name = "passes/" + std::string(info.stage);
        const ui::Control control =
            ui_.control({name, picture, ui::Kind::link, info.stage, fmt::format(kStageTip, info.tip)});
        if (control.clicked) go_to(info.stage);
        Grid<Rgba> pixels(samples_.cells.width(), samples_.cells.height(), to_rgba(ui_.theme().canvas));
        const Texture& texture = context_.derived.texture();
        for (int y = 0; y < pixels.height(); ++y) {
            for (int x = 0; x < pixels.width(); ++x) {
                const auto& sample = samples_.cells.at(x, y);
                if (!sample || (n > 0 && !reached(n, *sample))) continue;
                pixels.at(x, y) = to_rgba(colour(info.pass, *sample, texture));
            }
        }
        const ImTextureID id = context_.textures.image(ui::id_of(name), hash_of(pixels), pixels);
        ui_.list().AddImage(id, {picture.x, picture.y}, {picture.right(), picture.bottom()});
        const bool current = n == current_;
        ui::frame(ui_.list(), picture.inset(-1, -1),
                  ui_.theme()[current || control.hovered ? ui::Role::now : ui::Role::faint], current ? 2.0F : 1.0F);
        if (current) draw_element(picture);
        const float baseline = cell.y + caption - ui_.px(6);
        ui_.text_within(ui::Face::title, {cell.x, baseline}, cell.w, current ? ui::Role::now : ui::Role::text,
                        title(n));
        const ui::Font& font = ui_.font(ui::Face::count);
        ui_.text_within(ui::Face::count, {cell.x, picture.bottom() + ui_.px(5) + font.cap}, cell.w, ui::Role::muted,
                        note(n));
    }

    /// The box is no pass: those that run over it are numbered.
    [[nodiscard]] static std::string title(int n) {
        const std::string stage(kPasses[static_cast<std::size_t>(n)].stage);
        return n == 0 ? stage : fmt::format("{} {}", n, stage);
    }

    /// What the pass has come to: all samples of the box in the mask, later only those inside.
    [[nodiscard]] std::string note(int n) const {
        const Rect& box = samples_.window.rect;
        if (n == 0) return fmt::format("{} × {}", box.width(), box.height());
        if (samples_.window.stride > 1) return {};  // thinned out: the counts would be estimates
        const bool mask = kPasses[static_cast<std::size_t>(n)].pass == Pass::mask;
        const Integer all = mask ? samples_.tested : samples_.inside;
        const Integer done = std::count_if(
            samples_.cells.data(), samples_.cells.data() + samples_.cells.size(),
            [&](const std::optional<Sample>& s) { return s && (mask || s->fate == Fate::written) && reached(n, *s); });
        return done < all ? fmt::format(kSoFar, done, all) : fmt::format("{}", all);
    }

    void draw_element(const ui::Area& picture) {
        const auto pixel = context_.derived.pixel();
        const Window& window = samples_.window;
        if (!pixel || !window.rect.contains(pixel->x, pixel->y)) return;
        const float w = picture.w / static_cast<float>(samples_.cells.width()),
                    h = picture.h / static_cast<float>(samples_.cells.height());
        const int column = (pixel->x - window.rect.x0) / window.stride,
                  row = (pixel->y - window.rect.y0) / window.stride;
        const ui::Area element{std::round(picture.x + static_cast<float>(column) * w),
                               std::round(picture.y + static_cast<float>(row) * h), std::max(2.0F, std::round(w)),
                               std::max(2.0F, std::round(h))};
        ui::pixel_ring(ui_.list(), element, ui_.theme()[ui::Role::now], ui_.theme().outline, 2);
    }

    /// The box is the stage that is called so in the set-up; the others are the passes.
    void go_to(std::string_view stage) const {
        for (std::size_t n = 0; n < visit_.stages.size(); ++n) {
            if (visit_.stages[n].name == stage)
                context_.act(action::StepTo{visit_.path.prefix(1).child('s', static_cast<Integer>(n))});
        }
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Visit& visit_;
    ui::Area area_;
    BoxSamples samples_;
    int current_ = -1;
};

[[nodiscard]] bool has_arrays(const Visit& visit) {
    return std::any_of(visit.stages.begin(), visit.stages.end(), [](const Stage& s) { return s.name == "mask"; });
}

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "passes", place, kTitle);
    const bool shape = context.derived.shape() >= 0;
    if (!shape || !has_arrays(context.derived.visit()))
        draw_empty(context, area, kNoArrays);
    else if (box_of(context.derived).empty())
        draw_empty(context, area, kNoBox);
    else
        PassesView(context, area).draw();
    context.ui.end_panel();
}

constexpr View kView{"passes", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::passes_view
