#include "app/views/canvas_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/canvas_parts.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kSectionStage = "section", kLeft = "left", kRight = "right";
constexpr float kCanvasSectionsHatchStep = 9, kFutureFill = .10F, kFutureHatch = .28F;
constexpr double kHatchFrom = 3;  ///< window pixels per row; below, hatching would be a grey

/// Every value that a name was given, oldest first: a name of a section's is given once in each.
using Values = std::map<std::string, std::vector<double>>;

[[nodiscard]] Values values_of(const Visit& visit) {
    Values values;
    for (const Named& named : visit.tape.names)
        values[named.name.text()].push_back(
            approximate(visit.tape.operations[static_cast<std::size_t>(named.operation)].value));
    return values;
}

[[nodiscard]] std::vector<RingCorner> ring_from(const Values& values) {
    std::vector<RingCorner> ring;
    for (int n = 0;; ++n) {
        const auto get = [&](const char* name) { return values.find(fmt::format("{}_{}", name, n)); };
        const auto x = get("x"), y = get("y"), u = get("u"), v = get("v");
        if (x == values.end() || y == values.end() || u == values.end() || v == values.end()) return ring;
        ring.push_back({x->second.front(), y->second.front(), u->second.front(), v->second.front()});
    }
}

/// Columns of one row that the shape writes: those done, and those to come.
struct Run {
    int first = 0, last = -1;
};
struct RowRuns {
    Run done, future;
};

void extend(Run& run, int x) {
    if (run.last < run.first) run.first = x;
    run.last = x;
}

[[nodiscard]] RowRuns runs_of(const Sheet& sheet, int row) {
    RowRuns runs;
    const Rect& rect = sheet.picture.window.rect;
    for (int x = rect.x0; x < rect.x1; x += sheet.picture.window.stride) {
        const CanvasCell* cell = sheet.cell({x, row});
        if (cell == nullptr || cell->fate != Fate::written) continue;
        if (cell->visited)
            extend(runs.done, x);
        else if (cell->will_be_visited)
            extend(runs.future, x);
    }
    return runs;
}

void draw_run(const Sheet& sheet, const Run& run, int row, int section, bool done) {
    if (run.last < run.first) return;
    const int stride = sheet.picture.window.stride;
    const ui::Area whole = sheet.map.place_of(Rect{run.first, row, run.last + stride, row + stride});
    const ui::Area place = ui::intersection(whole, sheet.map.area);
    if (place.empty()) return;
    const ui::Color color = sheet.color(ui::section_role(section));
    ui::fill(sheet.list(), place, ui::with_alpha(color, done ? ui::alpha::kSectionFill : kFutureFill));
    if (sheet.map.zoom < kHatchFrom) return;
    const std::array<glm::vec2, 4> ring{glm::vec2(place.x, place.y),
                                        {place.right(), place.y},
                                        {place.right(), place.bottom()},
                                        {place.x, place.bottom()}};
    ui::draw_hatch(sheet.list(), ring, ui::section_degrees(section), sheet.ui().px(kCanvasSectionsHatchStep),
                   sheet.map.at, 1.4F, ui::with_alpha(color, done ? ui::alpha::kSectionHatch : kFutureHatch));
}

[[nodiscard]] std::array<int, 2> rows_in_view(const Sheet& sheet, const SectionShape& section) {
    const Rect& rect = sheet.picture.window.rect;
    const int stride = sheet.picture.window.stride;
    int first = static_cast<int>(std::clamp<Integer>(section.first, rect.y0, rect.y1));
    const int last = static_cast<int>(std::clamp<Integer>(section.last, rect.y0, rect.y1));
    first += (stride - (first - rect.y0) % stride) % stride;
    return {first, last};
}

void draw_border(const Sheet& sheet, const SectionShape& above) {
    const double y = static_cast<double>(above.last);
    const glm::vec2 a = sheet.map.to_window({above.left_bottom.x, y}),
                    b = sheet.map.to_window({above.right_bottom.x, y});
    if (a.y < sheet.map.area.y || a.y > sheet.map.area.bottom()) return;
    const float left = std::clamp(std::min(a.x, b.x), sheet.map.area.x, sheet.map.area.right());
    const float right = std::clamp(std::max(a.x, b.x), sheet.map.area.x, sheet.map.area.right());
    const std::array<glm::vec2, 2> path{glm::vec2(left, std::round(a.y)), {right, std::round(a.y)}};
    static constexpr std::array<float, 2> kDashes{5, 4};
    ui::draw_dashed(sheet.list(), path, {}, 3, ui::with_alpha(sheet.ui().theme().outline, .7F));
    ui::draw_dashed(sheet.list(), path, kDashes, 1.4F, IM_COL32(255, 255, 255, 220));
}

/// The pixels of the current row, wherever the cursor stands in it.
[[nodiscard]] std::optional<ui::Area> row_place(const Sheet& sheet) {
    const auto row = sheet.ctx.derived.row();
    const std::vector<Sample>& samples = sheet.ctx.derived.row_samples();
    if (!row || samples.empty()) return std::nullopt;
    const auto by_x = [](const Sample& a, const Sample& b) { return a.x < b.x; };
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), by_x);
    const int y = static_cast<int>(samples.front().y);
    return sheet.map.place_of(Rect{static_cast<int>(low->x), y, static_cast<int>(high->x) + 1, y + 1});
}

void draw_pointer(Sheet& sheet, glm::vec2 at, float side, std::string_view name) {
    ui::Ui& ui = sheet.ui();
    const float half = ui.px(5);
    const std::array<glm::vec2, 3> tip{at, at + glm::vec2(-half, -1.4F * half), at + glm::vec2(half, -1.4F * half)};
    ui::fill_convex(sheet.list(),
                    std::array{tip[0] + glm::vec2(0, 2), tip[1] + glm::vec2(-2, -1), tip[2] + glm::vec2(2, -1)},
                    ui.theme().outline);
    ui::fill_convex(sheet.list(), tip, sheet.color(Role::now));
    const ui::Font& font = ui.font(ui::Face::title);
    const glm::vec2 size{std::ceil(ui::text_width(font, name)) + 2 * ui.px(5), std::round(font.em * 1.5F)};
    const auto place = sheet.labels.place(at + glm::vec2(side * half, -half), size, {side, -.25F}, ui.px(3));
    if (!place) return;
    const ui::Color plain = ui.ground();
    ui.set_ground(ui.theme().canvas);
    ui::fill(sheet.list(), *place, ui.ground(), ui::size::kBadgeRadius);
    ui::frame(sheet.list(), *place, sheet.color(Role::now), 1, ui::size::kBadgeRadius);
    ui.text_centred(ui::Face::title, *place, Role::text, name);
    ui.set_ground(plain);
}

void draw_number(Sheet& sheet, const SectionShape& section, int index) {
    ui::Ui& ui = sheet.ui();
    const ui::Font& font = ui.font(ui::Face::code_strong);
    const float side = std::round(font.em * 1.7F);
    const double y = (static_cast<double>(section.first) + static_cast<double>(section.last)) / 2;
    const double x = (section.left_top.x + section.right_top.x + section.left_bottom.x + section.right_bottom.x) / 4;
    const glm::vec2 at = sheet.map.to_window({x, y});
    const ui::Area wanted{std::round(at.x - side / 2), std::round(at.y - side / 2), side, side};
    const bool room = sheet.labels.is_free(wanted);
    if (room) sheet.labels.block(wanted);
    const auto place = room ? std::optional(wanted) : sheet.labels.place(at, {side, side}, {-.6F, -1}, side / 2);
    if (!place) return;
    const ui::Color plain = ui.ground();
    ui.set_ground(ui.theme().outline);
    ui::fill(sheet.list(), *place, ui.ground(), ui::size::kRadius);
    ui::frame(sheet.list(), *place, sheet.color(ui::section_role(index)), 1.5F, ui::size::kRadius);
    const bool light = ui.theme().name == ui::ThemeName::light;
    ui.text_centred(ui::Face::code_strong, *place, light ? Role::on_now : Role::text, fmt::format("{}", index + 1));
    ui.set_ground(plain);
}

void add_section(SectionPicture& picture, const Values& values, int stage, Integer stage_now) {
    const std::size_t index = picture.sections.size();
    const auto get = [&](const char* name) {
        const auto at = values.find(name);
        return at == values.end() || index >= at->second.size() ? std::nan("") : at->second[index];
    };
    const auto size = static_cast<double>(picture.ring.size());
    const double left = get("left"), right = get("right"), top = get("y_beg"), bottom = get("y_end");
    const double first = get("first_row"), last = get("last_row");
    if (!(left >= 0 && left < size && right >= 0 && right < size) || std::isnan(first) || std::isnan(last)) return;
    const auto corner = [&](double at) { return picture.ring[static_cast<std::size_t>(at) % picture.ring.size()]; };
    const RingCorner l = corner(left), l2 = corner(left + size - 1), r = corner(right), r2 = corner(right + 1);
    picture.sections.push_back({stage, static_cast<Integer>(first), static_cast<Integer>(last), at_height(l, l2, top),
                                at_height(r, r2, top), at_height(l, l2, bottom), at_height(r, r2, bottom),
                                stage == stage_now, stage_now < 0 || stage <= stage_now});
}

}  // namespace

RingPoint at_height(const RingCorner& a, const RingCorner& b, double y) {
    const double t = a.y == b.y ? 0 : std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
    return {std::lerp(a.x, b.x, t), std::lerp(a.u, b.u, t), std::lerp(a.v, b.v, t)};
}

bool runs_leftward(const SectionPicture& picture) {
    const auto at = std::find_if(picture.sections.begin(), picture.sections.end(),
                                 [](const SectionShape& section) { return section.current; });
    if (at == picture.sections.end()) return false;
    // A section's two sides may meet at one end, never at both.
    return at->left_top.x + at->left_bottom.x > at->right_top.x + at->right_bottom.x;
}

SectionPicture sections_of(const Derived& derived) {
    SectionPicture picture;
    if (derived.shape() < 0 || derived.method().triangles) return picture;
    const Visit& visit = derived.visit();
    const Integer stage_now = visit.path.parts.size() >= 2 ? visit.path.parts[1].index : -1;
    const Values values = values_of(visit);
    picture.ring = ring_from(values);
    for (std::size_t n = 0; n < visit.stages.size() && picture.sections.size() < kMostSections; ++n) {
        if (visit.stages[n].name == kSectionStage) add_section(picture, values, static_cast<int>(n), stage_now);
    }
    return picture;
}

void draw_sections(const Sheet& sheet) {
    const SectionPicture picture = sections_of(sheet.ctx.derived);
    for (std::size_t n = 0; n < picture.sections.size(); ++n) {
        const auto [first, last] = rows_in_view(sheet, picture.sections[n]);
        for (int row = first; row < last; row += sheet.picture.window.stride) {
            const RowRuns runs = runs_of(sheet, row);
            draw_run(sheet, runs.done, row, static_cast<int>(n), true);
            draw_run(sheet, runs.future, row, static_cast<int>(n), false);
        }
    }
    for (std::size_t n = 0; n + 1 < picture.sections.size(); ++n) draw_border(sheet, picture.sections[n]);
}

void draw_section_marks(Sheet& sheet) {
    const ui::Theme& theme = sheet.ui().theme();
    const SectionPicture picture = sections_of(sheet.ctx.derived);
    if (const auto row = row_place(sheet)) {
        const bool at_pixel = sheet.ctx.derived.pixel().has_value();
        ui::pixel_ring(sheet.list(), row->inset(2, 2), sheet.color(Role::now), theme.outline, at_pixel ? 1 : 2.5F, 1);
        // The pointers are named after the ring: where it runs the other way round, "left" is at the right end.
        const bool turned = runs_leftward(picture);
        draw_pointer(sheet, {row->x, row->y}, -1, turned ? kRight : kLeft);
        draw_pointer(sheet, {row->right(), row->y}, 1, turned ? kLeft : kRight);
        sheet.labels.block(*row);
    }
    for (std::size_t n = 0; n < picture.sections.size(); ++n) {
        if (picture.sections[n].last > picture.sections[n].first)
            draw_number(sheet, picture.sections[n], static_cast<int>(n));
    }
}

}  // namespace texelscope::canvas
