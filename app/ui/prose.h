// Running text with mathematics in its lines.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/formula.h"

namespace texelscope::ui {

struct Span {
    enum class Kind : std::uint8_t { text, strong, code, math };
    Kind kind = Kind::text;
    std::string text;  ///< of mathematics: what parse_math reads
    Role role = Role::text;
    LinkId link = 0;
};

/// Reads `**strong**`, `` `code` `` and `$mathematics$`; `\$`, `\*` and `` \` `` are the characters themselves, and so
/// is a mark without its partner.
[[nodiscard]] std::vector<Span> spans_of(std::string_view text, Role role = Role::text);

struct ProseStyle {
    Face face = Face::prose, strong = Face::lead, code = Face::code;
    MathSize math = MathSize::prose;
    float lead = 1.55F;  ///< between baselines [em of `face`]
};

/// A word or a formula in its place; `at` is its baseline's left end, from the block's top left corner.
struct ProseItem {
    glm::vec2 at{0};
    float width = 0;
    const Font* font = nullptr;  ///< null where it is a formula
    std::string text;
    MathBox math;
    Role role = Role::text;
    LinkId link = 0;
};

struct ProseLayout {
    std::vector<ProseItem> items;
    float width = 0, height = 0;  ///< of the widest line; of all
    int lines = 0;
    float baseline = 0;  ///< of the first line
};

/// Breaks at spaces, within a word only where it alone is wider than `width`. Mathematics that cannot be read stands
/// as it was written.
[[nodiscard]] ProseLayout layout_prose(const Fonts& fonts, std::span<const Span> spans, float width,
                                       const ProseStyle& style = {});

}  // namespace texelscope::ui
