// The list of keys: what the keymap's help says, in place of the side panels.
#include <algorithm>
#include <cmath>

#include "app/state/keymap.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kKeysPanelTitle = "Keys", kKeysPanelClose = "Close",
                           kKeysPanelCloseTip = "Close the list (Esc)";
constexpr float kKeysPanelLeastColumn = 300;

class KeysDrawer {
public:
    KeysDrawer(ui::Ui& ui, const Area& area)
        : ui_(ui), area_(area), row_(std::max(ui.px(24), std::round(ui.font(Face::title).em * 1.75F))) {
        for (const KeyHelp& help : key_help())
            keys_ = std::max(keys_, ui::text_width(ui.font(Face::line_number), help.keys));
        keys_ = std::min(keys_ + ui.px(18), area.w / 2);
    }

    /// @return the height of all.
    [[nodiscard]] float draw() const {
        const bool two = area_.w >= 2 * kKeysPanelLeastColumn * ui_.px(100) / 100 && !ui_.presenting();
        const float gap = ui_.px(16), width = two ? std::floor((area_.w - gap) / 2) : area_.w;
        const auto all = key_help();
        float x = area_.x, y = area_.y, tallest = 0;
        std::string_view group;
        for (std::size_t n = 0; n < all.size(); ++n) {
            if (all[n].group != group) {
                if (two && x == area_.x && n * 2 >= all.size() - 4)
                    x += width + gap, y = area_.y;
                else if (n > 0)
                    y += ui_.px(8);
                group = all[n].group;
                ui_.text_within(Face::title, {x, baseline(Face::title, y)}, width, Role::muted, group);
                y += row_;
            }
            draw_row(all[n], {x, y, width, row_});
            y += row_;
            tallest = std::max(tallest, y - area_.y);
        }
        return tallest;
    }

private:
    [[nodiscard]] float baseline(Face face, float y) const {
        return ui::baseline_at_middle(ui_.font(face), y + row_ / 2);
    }
    void draw_row(const KeyHelp& help, const Area& at) const {
        static_cast<void>(ui::badge(ui_, Face::line_number, {at.x, at.centre().y}, help.keys));
        const float x = at.x + keys_;
        ui_.text_within(Face::title, {x, baseline(Face::title, at.y)}, at.right() - x, Role::text, help.what);
    }

    ui::Ui& ui_;
    Area area_;
    float row_, keys_ = 0;
};

}  // namespace

void draw_keys_panel(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    static_cast<void>(ui.begin_panel("keys", place));
    const float pad = ui.px(ui::size::kPadding), head = std::max(ui.px(37), std::round(ui.font(Face::title).em * 1.7F));
    const float width = ui::button_width(ui, kKeysPanelClose),
                high = std::max(ui.px(24), ui.font(Face::title).em * 1.4F);
    ui.text_within(Face::title, {place.x + pad, ui::baseline_at_middle(ui.font(Face::title), place.y + head / 2)},
                   place.w - 2 * pad - width, Role::muted, kKeysPanelTitle);
    const Area close{place.right() - pad - width, place.y + std::round((head - high) / 2), width, high};
    if (ui::button(ui, "keys/close", close, kKeysPanelClose, kKeysPanelCloseTip).clicked)
        c.act(action::Show{Overlay::none});
    const Area area =
        ui.begin_scroll("keys/scroll", {place.x + pad, place.y + head, place.w - 2 * pad, place.h - head - 2});
    ui.end_scroll(KeysDrawer(ui, area).draw());
    ui.end_panel();
}

}  // namespace texelscope
