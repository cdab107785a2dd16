// The method's own source with the current line, how often each line ran, and the values that lines left.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/code_text.h"
#include "app/views/formula_blocks.h"
#include "app/views/terms.h"

namespace texelscope::code_view {
namespace {

constexpr std::string_view kTitle = "Code";
constexpr std::string_view kNoCode = "This method has no listing.";
constexpr std::string_view kTraceLabel = "trace";
constexpr std::string_view kTraceTip =
    "Shows trace(…), which names a value and hands it back; without it plain mathematics is left.";
constexpr std::string_view kUnfoldTip = "Click to show these lines.";
constexpr std::string_view kFoldAllTip = "Folds the lines again that were opened.";
constexpr std::string_view kFoldAll = "fold";
constexpr std::string_view kRanTip = "Line {}: ran {} times so far. Hovering shows the pixels for which it ran.";
constexpr std::string_view kLineTip = "Line {}. Hovering shows the pixels for which it ran.";

struct Columns {
    float number_right = 0, count_right = 0, code = 0;  ///< from the panel's left border [px]
    bool counts = true;
    int characters = 0;  ///< of code in a row
};

[[nodiscard]] Columns columns_of(const ui::Ui& ui, float width, int lines) {
    const float digit = ui::text_width(ui.font(ui::Face::line_number), "0");
    const float letter = ui::text_width(ui.font(ui::Face::code), "0");
    Columns c;
    const auto digits = static_cast<float>(std::max<std::size_t>(3, std::to_string(lines).size()));
    c.number_right = ui.px(25) + std::ceil(digits * digit);
    c.count_right = c.number_right + ui.px(3) + std::ceil(ui::text_width(ui.font(ui::Face::count), "×0000"));
    c.code = c.count_right + ui.px(8);
    constexpr float kFewest = 44;
    if ((width - c.code) / letter < kFewest) c.counts = false, c.code = c.number_right + ui.px(10);
    c.characters = static_cast<int>((width - c.code - ui.px(ui::size::kPadding)) / letter);
    return c;
}

[[nodiscard]] std::string count_text(std::int64_t count) {
    if (count < 10000) return fmt::format("×{}", count);
    if (count < 10000000) return fmt::format("×{}k", count / 1000);
    return fmt::format("×{}M", count / 1000000);
}

[[nodiscard]] ui::Role role_of(TokenKind kind) {
    switch (kind) {
        case TokenKind::keyword: return ui::Role::keyword;
        case TokenKind::comment: return ui::Role::comment;
        case TokenKind::u: return ui::Role::u;
        case TokenKind::v: return ui::Role::v;
        case TokenKind::plain:
        case TokenKind::string:
        case TokenKind::number: break;
    }
    return ui::Role::text;
}

/// The value that each line left last, among the unit's own and what the current one was made from.
[[nodiscard]] std::map<int, std::int32_t> notes_of(const Derived& derived, const Cursor& cursor) {
    std::map<int, std::int32_t> notes;
    const Visit& visit = derived.visit();
    const std::int32_t now = current_name(derived);
    const auto note = [&](std::int32_t n) { notes[visit.tape.names[static_cast<std::size_t>(n)].line] = n; };
    if (now >= 0) {
        for (const std::int32_t n : operands_of(visit.tape, now)) note(n);
    }
    for (const std::int32_t n : visit.unit().expressions) {
        if (!cursor.step.at_expression() || n <= now) note(n);
    }
    if (now >= 0) note(now);
    return notes;
}

[[nodiscard]] std::string note_text(const Tape& tape, std::int32_t named) {
    const Named& name = tape.names[static_cast<std::size_t>(named)];
    const Value& value = tape.operations[static_cast<std::size_t>(name.operation)].value;
    const ui::Number number = shown_number(value);
    const std::string_view fault = fault_of(value);
    if (undefined(value)) return name.name.text() + ": " + std::string(fault);
    return fmt::format("{} {} {}{}{}", name.name.text(), ui::equals_sign(number.exact), number.text,
                       fault.empty() ? "" : ", ", fault);
}

constexpr std::string_view kQuirkComment = "// Q";  ///< of a guilty line, with its number

/// Quirks that are switched on, by the line that causes them.
[[nodiscard]] std::map<int, const QuirkInfo*> guilty_lines(const Derived& derived, QuirkSet quirks) {
    std::map<int, const QuirkInfo*> lines;
    const auto all = derived.method().quirks;
    for (std::size_t n = 0; n < all.size(); ++n) {
        if ((quirks >> n & 1U) == 0) continue;
        const int line = guilty_line(derived.listing(), all[n]);
        if (line > 0) lines.emplace(line, &all[n]);
    }
    return lines;
}

/// A question asks for a line: neither marks nor comments may name the guilty one.
[[nodiscard]] bool asks_for_line(const State& state) { return canvas::pointing(state, Prediction::Kind::line).asked; }

class CodeView {
public:
    CodeView(const ViewContext& context, const ui::Area& place, const ui::Area& area)
        : context_(context),
          ui_(context.ui),
          place_(place),
          area_(area),
          line_(context.derived.line()),
          columns_(columns_of(ui_, area.right() - place.x, static_cast<int>(context.derived.listing().lines.size()))),
          notes_(notes_of(context.derived, context.state.cursor)),
          quirks_(asks_for_line(context.state) ? std::map<int, const QuirkInfo*>()
                                               : guilty_lines(context.derived, context.state.work.quirks)) {}

    void draw() {
        const Listing& listing = context_.derived.listing();
        const std::vector<CodeFunction> functions = functions_of(listing);
        const CodeRowsSpec spec{shown_functions(listing, functions), context_.state.look.unfolded,
                                context_.state.look.plain_code, columns_.characters};
        std::vector<CodeRow> rows = rows_of(listing, functions, spec);
        if (asks_for_line(context_.state)) {
            for (CodeRow& row : rows) row.text.resize(std::min(row.text.size(), row.text.find(kQuirkComment)));
        }
        row_height_ = pitch(ui_, 18, ui::Face::code);
        if (area_.h < 12 * row_height_) row_height_ = pitch(ui_, 17, ui::Face::code);
        area_.h = std::max(1.0F, std::floor(area_.h / row_height_)) * row_height_;  // whole rows, so that none is cut
        const float content = static_cast<float>(rows.size()) * row_height_;
        follow_rows(rows, content);
        const ui::Area inner = ui_.begin_scroll("code/scroll", {place_.x, area_.y, place_.right() - place_.x, area_.h});
        for (std::size_t n = 0, end = 0; n < rows.size(); n = end) {
            for (end = n + 1; end < rows.size() && rows[end].continued;) ++end;
            const ui::Area line{inner.x, inner.y + static_cast<float>(n) * row_height_, inner.w,
                                static_cast<float>(end - n) * row_height_};
            if (line.bottom() > area_.y && line.y < area_.bottom())
                draw_line(std::span(rows).subspan(n, end - n), line);
        }
        ui_.end_scroll(content);
    }

    void draw_title() {
        if (ui_.presenting()) return;
        const float x =
            place_.x + ui_.px(ui::size::kPadding) + ui::text_width(ui_.font(ui::Face::title), kTitle) + ui_.px(12);
        const float width = ui::button_width(ui_, kTraceLabel, ui::Face::note), h = ui_.px(18);
        const Look& look = context_.state.look;
        ui::ButtonStyle style{.face = ui::Face::note, .chosen = !look.plain_code, .kind = ui::Kind::toggle};
        if (ui::button(ui_, "code/trace", {x, place_.y + ui_.px(4), width, h}, kTraceLabel, kTraceTip, style).clicked) {
            Look next = look;
            next.plain_code = !next.plain_code;
            context_.act(action::SetLook{next});
        }
        if (look.unfolded.empty()) return;
        style.chosen = false;
        style.kind = ui::Kind::button;
        const ui::Area area{x + width + ui_.px(8), place_.y + ui_.px(4),
                            ui::button_width(ui_, kFoldAll, ui::Face::note), h};
        if (ui::button(ui_, "code/fold", area, kFoldAll, kFoldAllTip, style).clicked) {
            Look next = look;
            next.unfolded.clear();
            context_.act(action::SetLook{next});
        }
    }

private:
    /// The current function, the first that calls it, and those that prepared what the current value is made from.
    [[nodiscard]] std::vector<int> shown_functions(const Listing& listing,
                                                   const std::vector<CodeFunction>& functions) const {
        std::vector<int> shown;
        const auto show = [&](int function) {
            if (function >= 0 && std::find(shown.begin(), shown.end(), function) == shown.end())
                shown.push_back(function);
        };
        const int current = function_at(functions, line_);
        show(current < 0 && !functions.empty() ? 0 : current);
        const std::vector<int> callers = callers_of(listing, functions, current);
        if (!callers.empty()) show(callers.front());
        const Visit& visit = context_.derived.visit();
        const Selection& pinned = context_.state.pinned;
        if (pinned.kind == Selection::Kind::line) show(function_at(functions, pinned.line));
        const std::int32_t now = current_name(context_.derived);
        if (now < 0) return shown;
        const auto& own = visit.unit().expressions;
        for (const std::int32_t n : setup_names(visit, now)) {
            const bool earlier = std::find(own.begin(), own.end(), n) == own.end();
            if (earlier) show(function_at(functions, visit.tape.names[static_cast<std::size_t>(n)].line));
        }
        return shown;
    }

    /// The rows of a line, as places in the content; empty where it is folded.
    struct Stretch {
        float from = 0, to = 0;
        [[nodiscard]] bool empty() const { return to <= from; }
    };
    [[nodiscard]] Stretch stretch_of(const std::vector<CodeRow>& rows, int line) const {
        Stretch s;
        for (std::size_t n = 0; line > 0 && n < rows.size(); ++n) {
            if (rows[n].line != line || rows[n].folded > 0) continue;
            if (s.empty()) s.from = static_cast<float>(n) * row_height_;
            s.to = static_cast<float>(n + 1) * row_height_;
        }
        return s;
    }
    /// Shows the current line and the pinned one; where there is no room for both, the one that changed last, and
    /// after a change of both the pinned one, which somebody speaks of.
    void follow_rows(const std::vector<CodeRow>& rows, float content) {
        const Selection& pinned = context_.state.pinned;
        const int pin = pinned.kind == Selection::Kind::line ? pinned.line : 0;
        const Stretch current = stretch_of(rows, line_), marked = stretch_of(rows, pin);
        const auto changed = [&](std::string_view name, int now) {
            float& seen = ui_.memory().fades[ui::id_of(name)].value;
            return std::exchange(seen, static_cast<float>(now)) != static_cast<float>(now);
        };
        float& to_pin = ui_.memory().fades[ui::id_of("code/to-pin")].value;
        if (changed("code/current", line_)) to_pin = 0;
        if (changed("code/pinned", pin)) to_pin = 1;
        const bool first = !marked.empty() && (current.empty() || to_pin > 0);
        Stretch shown = first ? marked : current;
        const Stretch both{std::min(current.from, marked.from), std::max(current.to, marked.to)};
        if (!current.empty() && !marked.empty() && both.to - both.from <= area_.h) shown = both;
        if (shown.empty()) return;
        const float spare = std::max(0.0F, area_.h - (shown.to - shown.from));
        const float margin = std::floor(std::min(area_.h / 3, spare / 2) / row_height_) * row_height_;
        const std::size_t key =
            (static_cast<std::size_t>(line_) * 131 + static_cast<std::size_t>(pin) * 17471 + rows.size()) % (1U << 23U);
        follow(ui_, "code/scroll", area_.h, content, shown.from - margin, std::min(content, shown.to + margin),
               static_cast<float>(key));
    }

    void draw_line(std::span<const CodeRow> rows, const ui::Area& line) {
        const CodeRow& first = rows.front();
        if (first.folded > 0) return draw_fold(first, line);
        if (rows.size() > 1 || !first.text.empty()) act_on_line(first, line);
        for (std::size_t n = 0; n < rows.size(); ++n) {
            const ui::Area row{line.x, line.y + static_cast<float>(n) * row_height_, line.w, row_height_};
            if (row.bottom() > area_.y && row.y < area_.bottom()) draw_row(rows[n], row, n + 1 == rows.size());
        }
        draw_ring(first.line, line);
    }

    void draw_row(const CodeRow& row, const ui::Area& area, bool ends) {
        const bool current = row.line == line_;
        const float baseline = ui::baseline_at_middle(ui_.font(ui::Face::code), area.centre().y);
        const ui::Color ground = ui_.ground();
        if (current) {
            ui::current_row(ui_, area);
            ui_.set_ground(ui::over(ui_.theme()[ui::Role::now], ui::alpha::kChosenRow, ground));
            if (!row.continued) draw_arrow(area);
        }
        if (!row.continued) draw_gutter(row.line, area, baseline);
        float x = area.x + columns_.code;
        const std::vector<Token> tokens =
            row.comment ? std::vector<Token>{{TokenKind::comment, row.text}} : tokens_of(row.text);
        for (const Token& token : tokens) x += ui_.text(ui::Face::code, {x, baseline}, role_of(token.kind), token.text);
        if (ends) draw_ends(row.line, area, baseline, x);
        ui_.set_ground(ground);
    }

    void draw_arrow(const ui::Area& area) {
        const float side = std::round(ui_.font(ui::Face::code).em * .62F), x = area.x + ui_.px(8),
                    y = std::round(area.centre().y);
        const glm::vec2 corners[] = {{x, y - side / 2}, {x + side * .87F, y}, {x, y + side / 2}};
        ui::fill_convex(ui_.list(), corners, ui_.theme()[ui::Role::now]);
    }

    void draw_gutter(int line, const ui::Area& area, float baseline) {
        ui_.text_right(ui::Face::line_number, {area.x + columns_.number_right, baseline}, ui::Role::comment,
                       std::to_string(line));
        const LineCounts& counts = context_.derived.line_counts();
        const auto at = static_cast<std::size_t>(line);
        if (columns_.counts && at < counts.size() && counts[at] > 0) {
            ui_.text_right(ui::Face::count, {area.x + columns_.count_right, baseline}, ui::Role::comment,
                           count_text(counts[at]));
        }
    }

    /// The mark of a quirk, and the value that the line left, where there is room.
    void draw_ends(int line, const ui::Area& area, float baseline, float x) {
        float right = area.right() - ui_.px(ui::size::kPadding);
        if (const auto quirk = quirks_.find(line); quirk != quirks_.end()) {
            const std::string id(quirk->second->id);
            const float width = ui::text_width(ui_.font(ui::Face::count), id) + ui_.px(8),
                        h = std::min(area.h - 2, ui_.px(15));
            const float left = std::min(x + ui_.px(10), right - width);
            const ui::Area badge{std::round(left), std::round(area.centre().y - h / 2), width, h};
            ui::fill(ui_.list(), badge, ui_.ground(), ui::size::kBadgeRadius);
            ui::frame(ui_.list(), badge, ui_.theme()[ui::Role::error], 1, ui::size::kBadgeRadius);
            ui_.text_centred(ui::Face::count, badge, ui::Role::error, id);
            x = badge.right();
        }
        const auto note = notes_.find(line);
        if (note == notes_.end()) return;
        const Tape& tape = context_.derived.visit().tape;
        const std::string text = note_text(tape, note->second);
        const float width = ui::text_width(ui_.font(ui::Face::code_note), text);
        if (right - width < x + ui_.px(12)) return;
        const Operation& operation =
            tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(note->second)].operation)];
        const bool faulty = !fault_of(operation.value).empty();
        const ui::Role role = faulty ? ui::Role::error : line == line_ ? ui::Role::now : ui::Role::muted;
        ui_.text(ui::Face::code_note, {right - width, baseline}, role, text);
    }

    void act_on_line(const CodeRow& row, const ui::Area& area) {
        const LineCounts& counts = context_.derived.line_counts();
        const auto at = static_cast<std::size_t>(row.line);
        std::string tip = at < counts.size() && counts[at] > 0 ? fmt::format(kRanTip, row.line, counts[at])
                                                               : fmt::format(kLineTip, row.line);
        if (const auto quirk = quirks_.find(row.line); quirk != quirks_.end())
            tip = fmt::format("**{}** {}", quirk->second->id, quirk->second->sentence);
        if (const auto note = notes_.find(row.line); note != notes_.end())
            tip += " " + tip_of(context_.derived.visit().tape, note->second);
        const std::string name = fmt::format("code/line{}", row.line);
        const ui::Control control = ui_.control({name, area, ui::Kind::link, row.text, tip});
        under_mouse_ = control.hovered ? row.line : under_mouse_;
        const Selection what{.kind = Selection::Kind::line, .line = row.line};
        if (control.hovered || (control.focused && ui_.memory().ring)) context_.act(action::Hover{what});
        if (control.clicked) context_.act(action::Pin{what});
    }

    /// One ring around all rows of a line, outside of its letters.
    void draw_ring(int line, const ui::Area& area) {
        const auto has = [&](const Highlight& h) {
            return std::find(h.lines.begin(), h.lines.end(), line) != h.lines.end();
        };
        const bool current = line == line_, thick = has(context_.pinned) && !current;
        if (thick) ui::fill(ui_.list(), {area.x, area.y, ui_.px(3), area.h}, ui_.theme()[ui::Role::now]);
        if (!thick && under_mouse_ != line && (current || !has(context_.hover))) return;
        const ui::Area frame{area.x + columns_.code - ui_.px(4), area.y - 1, area.right() - area.x - columns_.code,
                             area.h + 2};
        draw_light(ui_, frame, thick ? Light::pinned : Light::hovered);
    }

    void draw_fold(const CodeRow& row, const ui::Area& area) {
        const float x = area.x + columns_.code,
                    baseline = ui::baseline_at_middle(ui_.font(ui::Face::title), area.centre().y);
        const std::string name = fmt::format("code/fold{}", row.line);
        const ui::Control control = ui_.control({name, area, ui::Kind::button, row.text, kUnfoldTip});
        const float dots = ui_.px(20);
        for (int n = 0; n < 3; ++n) {
            const float at = x + ui_.px(2) + static_cast<float>(n) * ui_.px(4);
            ui::fill(ui_.list(), {at, std::round(area.centre().y) - 1, ui_.px(2), ui_.px(2)},
                     ui_.theme()[ui::Role::comment]);
        }
        const float room = area.right() - x - dots - ui_.px(ui::size::kPadding);
        ui_.text_within(ui::Face::title, {x + dots, baseline}, room,
                        control.hovered ? ui::Role::text : ui::Role::comment, row.text);
        if (!control.clicked) return;
        Look next = context_.state.look;
        next.unfolded.push_back(row.line);
        context_.act(action::SetLook{next});
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    ui::Area place_, area_;
    int line_;
    Columns columns_;
    std::map<int, std::int32_t> notes_;
    std::map<int, const QuirkInfo*> quirks_;
    float row_height_ = 18;
    int under_mouse_ = 0;  ///< the line
};

void draw(const ViewContext& context, const ui::Area& place) {
    const Listing& listing = context.derived.listing();
    const ui::Area area = begin_view(context, "code", place, kTitle, "`" + listing.path + "`");
    if (listing.lines.empty()) {
        draw_empty(context, area, kNoCode);
    } else {
        CodeView view(context, place, area);
        view.draw_title();
        view.draw();
    }
    context.ui.end_panel();
}

constexpr View kView{"code", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::code_view
