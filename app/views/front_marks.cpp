#include "app/views/front_marks.h"

namespace texelscope::front {
namespace {

constexpr float kSmall = 4.2F, kLarge = 6.5F;   ///< half a mark's width [px at 100 %]
constexpr float kRim = 1.5F, kLargeRim = 2.2F;  ///< of a hollow mark [px at 100 %]
constexpr float kOutset = 1;                    ///< ground around a mark, so that neighbours are told apart [px]

[[nodiscard]] bool is_diamond(std::string_view kind) { return kind == "fast" || kind == "exact"; }

}  // namespace

ui::Role role_of(const FrontPoint& point) {
    for (const NumberKey& key : kNumberKeys)
        if (key.id == point.numbers) return key.role;
    return ui::Role::text;
}

bool is_plain(const FrontPoint& p) {
    return p.kind == "method" && p.label == std::string(method_of(p)) + " " + p.numbers;
}

std::string_view method_of(const FrontPoint& point) {
    return std::string_view(point.rung).substr(0, point.rung.find(':'));
}

std::string letters_of(std::string_view method) {
    if (method.empty()) return {};
    const std::size_t dash = method.find('-');
    const bool two = dash != std::string_view::npos && dash + 1 < method.size();
    const auto upper = [](char c) { return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c); };
    return {upper(method.front()), upper(two ? method[dash + 1] : method.back())};
}

float radius_of(const ui::Ui& ui, std::string_view kind) {
    return ui.fonts().spec().scale * (is_diamond(kind) ? kLarge : kSmall);
}

void draw_mark(ui::Ui& ui, glm::vec2 at, std::string_view kind, const MarkLook& look, ui::Color color) {
    ImDrawList& list = ui.list();
    const ui::Color ground = ui.theme().canvas;
    const bool diamond = is_diamond(kind);
    const float r = radius_of(ui, kind), scale = ui.fonts().spec().scale;
    const auto shape = [&](float radius, ui::Color with) {
        if (kind == "kernel") return ui::fill(list, {at.x - radius, at.y - radius, 2 * radius, 2 * radius}, with);
        if (!diamond) return list.AddCircleFilled(ui::to_im(at), radius, with);
        const std::array<glm::vec2, 4> corners{at + glm::vec2(0, -radius), at + glm::vec2(radius, 0),
                                               at + glm::vec2(0, radius), at + glm::vec2(-radius, 0)};
        ui::fill_convex(list, corners, with);
    };
    shape(r + kOutset, ground);
    shape(r, color);
    if (!look.filled) shape(r - scale * (diamond ? kLargeRim : kRim), ground);
    if (look.crossed) ui::cross(list, at, r * .55F, scale * 1.2F, look.filled ? ground : color);
}

}  // namespace texelscope::front
