#include "app/views/front_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/views/front_axes.h"
#include "app/views/front_key.h"
#include "app/views/front_labels.h"
#include "app/views/front_marks.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr float kKeyWidth = 206, kKeyFrom = 760;  ///< the key, and the width from which there is one [px at 100 %]
constexpr float kPanelGap = 16, kGrab = 9;        ///< between panels; of the mouse [px at 100 %]
constexpr float kBehindFast = .05F;               ///< tint of what is slower than `fast`
constexpr std::array<float, 2> kDash{5, 4};

class Panel {
public:
    Panel(ui::Ui& ui, const Area& area, std::vector<const FrontPoint*> points, std::string_view chosen)
        : ui_(ui), area_(area), points_(std::move(points)), chosen_(chosen), axes_(ui, area, points_) {}

    [[nodiscard]] const FrontPoint* draw(std::string_view title) {
        ui_.text_within(Face::lead, {area_.x, area_.y + ui_.px(16)}, area_.w, Role::text, title);
        axes_.draw();
        draw_reach_of_fast();
        draw_front();
        for (const FrontPoint* point : points_) draw_bar(*point);
        for (const bool last : {false, true})  // what leads is never hidden
            for (const FrontPoint* point : points_)
                if ((front::leads(*point) || front::is_large(*point)) == last) draw_point(*point);
        front::draw_labels(ui_, axes_, points_, lines_);
        return under_mouse();
    }

private:
    void draw_reach_of_fast() {
        for (const FrontPoint* p : points_) {
            if (p->kind != "fast" || p->max_error > 0) continue;
            const Area& plot = axes_.plot();
            const glm::vec2 at = axes_.place_of(*p);
            const ui::Color color = ui_.theme()[Role::now];
            const std::array<glm::vec2, 2> path{at, glm::vec2(at.x, plot.y)};
            ui::fill(ui_.list(), {at.x, plot.y, plot.right() - at.x, plot.h}, ui::with_alpha(color, kBehindFast));
            ui::draw_dashed(ui_.list(), path, kDash, ui_.px(1.5F), ui::with_alpha(color, .8F));
            lines_.push_back({at.x - 1, plot.y, 2, at.y - plot.y});
        }
    }
    void draw_front() {
        std::vector<const FrontPoint*> front;
        for (const FrontPoint* p : points_)
            if (front::leads(*p)) front.push_back(p);
        std::sort(front.begin(), front.end(),
                  [](const FrontPoint* a, const FrontPoint* b) { return a->min_ns < b->min_ns; });
        glm::vec2 last{0, axes_.plot().y};
        for (std::size_t n = 0; n < front.size(); ++n) {
            const glm::vec2 here = axes_.place_of(*front[n]);
            if (n > 0) step(last, {here.x, last.y});
            step({here.x, last.y}, here);
            last = here;
        }
    }
    void step(glm::vec2 from, glm::vec2 to) {
        ui::line(ui_.list(), from, to, ui_.px(1.6F), ui_.theme()[Role::text]);
        const glm::vec2 low = glm::min(from, to), high = glm::max(from, to);
        lines_.push_back({low.x - 1, low.y - 1, high.x - low.x + 2, high.y - low.y + 2});
    }
    void draw_bar(const FrontPoint& p) {
        if (!(p.bound > p.max_error) || std::isinf(p.max_error)) return;
        const glm::vec2 at = axes_.place_of(p);
        const bool endless = std::isinf(p.bound);
        const float top = endless ? axes_.plot().y : axes_.height_of(p.bound), wide = ui_.px(3), pen = ui_.px(1.2F);
        const ui::Color color = ui::with_alpha(ui_.theme()[front::role_of(p)], .75F);
        ui::line(ui_.list(), at, {at.x, top}, pen, color);
        if (endless)
            ui::arrow(ui_.list(), {at.x, top + ui_.px(10)}, {at.x, top}, pen, color, ui_.px(6));
        else
            ui::line(ui_.list(), {at.x - wide, top}, {at.x + wide, top}, ui_.px(1.6F), color);
        lines_.push_back({at.x - 1, top, 2, at.y - top});
    }
    void draw_point(const FrontPoint& p) {
        const glm::vec2 at = axes_.place_of(p);
        const front::MarkLook look{.filled = front::leads(p) || p.kind == "fast", .crossed = p.missing + p.extra > 0};
        front::draw_mark(ui_, at, p.kind, look, ui_.theme()[front::role_of(p)]);
        if (p.rung == chosen_)
            ui_.list().AddCircle(ui::to_im(at), front::radius_of(ui_, p.kind) + ui_.px(4), ui_.theme()[Role::now], 0,
                                 ui_.px(2));
    }
    [[nodiscard]] const FrontPoint* under_mouse() const {
        const FrontPoint* nearest = nullptr;
        float least = ui_.px(kGrab);
        for (const FrontPoint* p : points_) {
            const float distance = glm::distance(ui_.input().mouse, axes_.place_of(*p));
            if (distance < least) least = distance, nearest = p;
        }
        return nearest;
    }

    ui::Ui& ui_;
    Area area_;
    std::vector<const FrontPoint*> points_;
    std::string_view chosen_;
    front::Axes axes_;
    std::vector<Area> lines_;  ///< that labels keep off
};

}  // namespace

std::string front_mark(const FrontPoint& point) {
    return front::is_plain(point) ? front::letters_of(front::method_of(point)) : point.label;
}

std::string front_number(double value) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return "∞";
    return value != 0 && std::abs(value) < 1e-3 ? fmt::format("{:.1e}", value) : fmt::format("{:.3g}", value);
}

const FrontPoint* draw_front_plot(ui::Ui& ui, const Area& area, std::span<const FrontPoint> points,
                                  std::string_view chosen) {
    std::vector<std::string_view> scenes;
    for (const FrontPoint& point : points)
        if (std::find(scenes.begin(), scenes.end(), point.scene) == scenes.end()) scenes.push_back(point.scene);
    if (scenes.empty()) return nullptr;
    Area plots = area;
    if (area.w >= ui.px(kKeyFrom)) {
        const float key = ui.px(kKeyWidth), gap = ui.px(kPanelGap);
        plots.w -= key + gap;
        front::draw_key(ui, {plots.right() + gap, area.y, key, area.h}, points);
    }
    const auto count = static_cast<int>(scenes.size()), columns = count == 1 ? 1 : count <= 4 ? 2 : 3;
    const int rows = (count + columns - 1) / columns;
    const float gap = ui.px(kPanelGap);
    const float width = std::floor((plots.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    const float height = std::floor((plots.h - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows));
    const FrontPoint* hovered = nullptr;
    for (int n = 0; n < count; ++n) {
        const std::string_view scene = scenes[static_cast<std::size_t>(n)];
        std::vector<const FrontPoint*> own;
        for (const FrontPoint& point : points)
            if (point.scene == scene && point.min_ns > 0) own.push_back(&point);
        const int column = n % columns, row = n / columns;
        const float x = plots.x + static_cast<float>(column) * (width + gap);
        const float y = plots.y + static_cast<float>(row) * (height + gap);
        Panel panel(ui, {x, y, width, height}, std::move(own), chosen);
        const FrontSceneInfo* const info = find_front_scene(scene);
        if (const FrontPoint* here = panel.draw(info != nullptr ? info->title : scene)) hovered = here;
    }
    return hovered;
}

}  // namespace texelscope
