#include "app/views/tuning.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/state/pose.h"
#include "app/ui/text.h"
#include "app/views/canvas_values.h"

namespace texelscope {
namespace {

constexpr std::string_view kTurn = "turn", kScale = "scale", kDegreesText = "{:.0f}°", kScaleText = "{:.2f}";
constexpr std::string_view kTurnTip = "Turns the shape round its middle. Ctrl with the arrows: ten times as far.",
                           kScaleTip = "Pixels a texel";
constexpr std::string_view kDepth = "$w$ of $P_{}$", kDepthElsewhere = "$w$ of corner {}", kDepthText = "{:.3g}",
                           kDiagonal = "other diagonal";
constexpr std::string_view kDepthTip = "Depth of the corner. A click on another corner chooses that one.",
                           kDiagonalTip = "Begins the polygon one corner later: a quad is cut the other way.";
constexpr ui::SliderRange kDepths{.25, 4, .0625};
constexpr ui::SliderRange kTurns{-180, 180, 1}, kTuningScales{.25, 3, .05};

/// The polygon of the cursor's shape, as edited.
[[nodiscard]] std::span<const Vertex> polygon_of(const Derived& derived) {
    const int polygon = derived.drawing().polygon_of(derived.shape());
    return derived.scene().polygons[static_cast<std::size_t>(polygon)].vertices;
}

/// The corner as the canvas names it, where it is one of the cursor's shape.
[[nodiscard]] std::string depth_label(const Derived& derived, int vertex) {
    const int shape = derived.shape();
    const auto count = static_cast<int>(derived.drawing().corners(shape).size());
    for (int n = 0; n < count; ++n)
        if (derived.drawing().vertex_of(shape, n) == vertex) return fmt::format(kDepth, n);
    return fmt::format(kDepthElsewhere, vertex);
}

}  // namespace

float tuning_height(const ui::Ui& ui) {
    return std::max(ui::size::kLeastTarget, std::ceil(ui.font(ui::Face::prose).em * 1.7F));
}

std::optional<double> draw_tuning(ui::Ui& ui, const ui::Area& row, const Tuning& what, double value,
                                  const ui::SliderRange& range) {
    const float gap = ui.px(8), baseline = ui::baseline_at_middle(ui.font(ui::Face::prose), row.centre().y);
    const float label = ui.rich_within(ui::Face::prose, {row.x, baseline}, row.w * .4F, ui::Role::muted, what.label);
    const float number = std::ceil(ui::text_width(ui.font(ui::Face::code), "-180°"));
    const ui::Area track{std::round(row.x + label + gap), row.y,
                         std::max(ui::size::kLeastTarget, std::floor(row.w - label - number - 2 * gap)), row.h};
    ui.text_within(ui::Face::code, {track.right() + gap, baseline}, row.right() - track.right() - gap, ui::Role::text,
                   what.value);
    return ui::slider(ui, what.name, track, std::clamp(value, range.low, range.high), range, what.label, what.tip);
}

bool has_pose_tuning(const ViewContext& context) {
    return context.derived.shape() >= 0 && canvas::may_drag(context.state, false);
}

void draw_pose_tuning(const ViewContext& context, const ui::Area& row, bool scale) {
    if (!has_pose_tuning(context)) return;
    ui::Ui& ui = context.ui;
    const std::span<const Vertex> corners = polygon_of(context.derived);
    const Pose pose = pose_of(corners);
    const float gap = ui.px(24), width = scale ? std::floor((row.w - gap) / 2) : row.w;
    const double turn =
        std::abs(pose.degrees - std::round(pose.degrees)) < 1e-3 ? std::round(pose.degrees) : pose.degrees;
    Pose next = pose;
    if (const auto to = draw_tuning(ui, {row.x, row.y, width, row.h},
                                    {"tune/turn", kTurn, fmt::format(kDegreesText, turn), kTurnTip}, turn, kTurns))
        next.degrees = std::round(*to * 16) / 16;
    if (scale) {
        const auto to = draw_tuning(ui, {row.x + width + gap, row.y, width, row.h},
                                    {"tune/scale", kScale, fmt::format(kScaleText, pose.scale), kScaleTip}, pose.scale,
                                    kTuningScales);
        if (to && std::abs(*to - pose.scale) > 1e-4) next.scale = *to;
    }
    if (next == pose) return;
    const int gesture = ui.memory().active != 0 ? ui.memory().presses : 0;
    context.act(action::MoveShape{context.derived.drawing().polygon_of(context.derived.shape()), posed(corners, next),
                                  gesture});
}

bool has_depth_tuning(const ViewContext& context) {
    if (context.derived.shape() < 0 || !canvas::may_drag(context.state, false)) return false;
    const int polygon = context.derived.drawing().polygon_of(context.derived.shape());
    return context.derived.scene().polygons[static_cast<std::size_t>(polygon)].mesh < 0;
}

void draw_depth_tuning(const ViewContext& context, const ui::Area& row) {
    if (!has_depth_tuning(context)) return;
    ui::Ui& ui = context.ui;
    const int polygon = context.derived.drawing().polygon_of(context.derived.shape());
    const bool chosen = context.state.handle.polygon == polygon;
    const Handle handle{polygon, chosen ? context.state.handle.vertex : 0, false};
    const Vertex* vertex = vertex_of(context.derived.scene(), handle);
    if (vertex == nullptr) return;
    const float gap = ui.px(16), most = std::floor((row.w - gap) / 2);
    const float button = std::min(most, ui::button_width(ui, kDiagonal, ui::Face::note));
    const ui::Area slider{row.x, row.y, row.w - button - gap, row.h};
    if (ui::button(ui, "tune/diagonal", {row.right() - button, row.y, button, row.h}, kDiagonal, kDiagonalTip,
                   {.face = ui::Face::note})
            .clicked)
        context.act(action::TurnRing{polygon});
    const std::string label = depth_label(context.derived, handle.vertex);
    const auto to = draw_tuning(ui, slider, {"tune/depth", label, fmt::format(kDepthText, vertex->w), kDepthTip},
                                vertex->w, kDepths);
    if (to && static_cast<float>(*to) != vertex->w)
        context.act(
            action::SetDepth{handle, static_cast<float>(*to), ui.memory().active != 0 ? ui.memory().presses : 0});
}

}  // namespace texelscope
