#include "app/ui/theme.h"

namespace texelscope::ui {
namespace {

void set(Theme& t, Role r, std::uint32_t rgb) { t.role[static_cast<std::size_t>(r)] = hex(rgb); }

void set_sections(Theme& t, const std::array<std::uint32_t, 5>& rgb) {
    for (int i = 0; i < 5; ++i) set(t, section_role(i), rgb[static_cast<std::size_t>(i)]);
}

Theme dark() {
    Theme t;
    t.bg = hex(0x14161A), t.panel = hex(0x191C21), t.raise = hex(0x22262D), t.canvas = hex(0x101215);
    t.hairline = hex(0x2C323A), t.grid = hex(0x2A2F37), t.outline = hex(0x0E1512);
    set(t, Role::text, 0xE7EAED), set(t, Role::muted, 0x9DA6B1), set(t, Role::keyword, 0xB9C2CC);
    set(t, Role::comment, 0x98A2AD), set(t, Role::faint, 0x66707D);
    set(t, Role::now, 0xBFFFD9), set(t, Role::on_now, 0x0E1512);
    set(t, Role::edge_a, 0x56B4E9), set(t, Role::edge_b, 0xF0E442), set(t, Role::edge_c, 0xD55E00);
    set(t, Role::u, 0xFF9466), set(t, Role::v, 0x7F7FFF);
    set(t, Role::covered, 0xAEB6C0), set(t, Role::rejected, 0x4A525D);
    set_sections(t, {0x45E6E6, 0xE6AF0B, 0xBF5B39, 0xFFFFBF, 0x547799});
    set(t, Role::error, 0xFF6B5E);
    return t;
}

Theme light() {
    Theme t;
    t.name = ThemeName::light;
    t.bg = hex(0xF1F2F4), t.panel = hex(0xFFFFFF), t.raise = hex(0xEDEFF2), t.canvas = hex(0xFAFBFC);
    t.hairline = hex(0xD3D8DE), t.grid = hex(0xE3E6EA), t.outline = hex(0x0E1512);
    set(t, Role::text, 0x15181C), set(t, Role::muted, 0x565F6A), set(t, Role::keyword, 0x3A424C);
    set(t, Role::comment, 0x5F6873), set(t, Role::faint, 0x7C8692);
    set(t, Role::now, 0x007A56), set(t, Role::on_now, 0xFFFFFF);
    set(t, Role::edge_a, 0x005A8F), set(t, Role::edge_b, 0xB34700), set(t, Role::edge_c, 0x1A1A1A);
    set(t, Role::u, 0x661100), set(t, Role::v, 0x6A3DF2);
    set(t, Role::covered, 0x8791A0), set(t, Role::rejected, 0xE1E5EA);
    set_sections(t, {0x577306, 0xBF397C, 0x4D79FF, 0x45E6E6, 0xE6E60B});
    set(t, Role::error, 0xB3261E);
    return t;
}

}  // namespace

Theme make_theme(ThemeName name) {
    if (name == ThemeName::light) return light();
    Theme t = dark();
    t.name = name;
    if (name == ThemeName::presenting) {
        set(t, Role::muted, 0xAEB7C1), set(t, Role::comment, 0xAEB7C1), set(t, Role::v, 0xD4BFFF);
    }
    return t;
}

Color letter_color(const Theme& theme, Role r, Color ground) {
    const auto reads = [&](Color c) { return contrast(c, ground) >= theme.text_contrast(); };
    if (reads(theme[r])) return theme[r];
    return reads(theme[Role::text]) || !reads(theme[Role::on_now]) ? theme[Role::text] : theme[Role::on_now];
}

}  // namespace texelscope::ui
