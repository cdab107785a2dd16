// What the program has to say: one line over the canvas, gone with the next action.
#include <cmath>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {

void draw_message(const ViewContext& c, const ui::Area& canvas) {
    const Message& message = c.state.message;
    if (message.text.empty()) return;
    ui::Ui& ui = c.ui;
    const ui::Font& font = ui.font(ui::Face::title);
    const float height = std::max(ui.px(28), std::round(font.em * 1.7F)), bar = ui.px(3);
    const ui::Area at{canvas.x, canvas.bottom() - height, canvas.w, height};
    ui.begin_clip(at);
    ui::fill(ui.list(), at, ui.theme().raise);
    ui::fill(ui.list(), {at.x, at.y, at.w, 1}, ui.theme().hairline);
    ui::fill(ui.list(), {at.x, at.y, bar, at.h}, ui.theme()[message.error ? ui::Role::error : ui::Role::now]);
    ui.set_ground(ui.theme().raise);
    float x = at.x + ui.px(12);
    if (message.error) {
        ui::cross(ui.list(), {x + font.em * .4F, at.centre().y}, font.em * .3F, 2, ui.theme()[ui::Role::error]);
        x += font.em * 1.2F;
    }
    static_cast<void>(ui.control({"message", at, ui::Kind::region, message.text, message.text, true, false}));
    ui.text_within(ui::Face::title, {x, ui::baseline_at_middle(font, at.centre().y)}, at.right() - ui.px(12) - x,
                   ui::Role::text, message.text);
    ui.set_ground(ui.theme().bg);
    ui.end_clip();
}

}  // namespace texelscope
