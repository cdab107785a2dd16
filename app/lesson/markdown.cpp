#include "app/lesson/markdown.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <md4c.h>

#include "app/lesson/prose.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostBlocks = 512;
constexpr std::string_view kExpected = "expected headings of level 2 (##), paragraphs and fenced blocks";
constexpr std::string_view kInline = "expected plain text, **strong**, `code` and $mathematics$";

class BlockReader {
public:
    BlockReader(std::string_view text, const std::string& file, int first_line)
        : text_(text), file_(file), first_line_(first_line) {}

    Result<std::vector<MarkdownBlock>> read() {
        MD_PARSER parser{};
        parser.flags = MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_LATEXMATHSPANS;
        parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) { return of(self).enter(type, detail); };
        parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) { return of(self).leave(type); };
        parser.enter_span = [](MD_SPANTYPE type, void*, void* self) { return of(self).enter_span(type); };
        parser.leave_span = [](MD_SPANTYPE type, void*, void* self) { return of(self).leave_span(type); };
        parser.text = [](MD_TEXTTYPE type, const char* text, MD_SIZE size, void* self) {
            return of(self).take(type, {text, size});
        };
        const int stopped = md_parse(text_.data(), static_cast<MD_SIZE>(text_.size()), &parser, this);
        if (stopped != 0 && !error_) fail("cannot be read as Markdown");
        if (error_) return *error_;
        return std::move(blocks_);
    }

private:
    [[nodiscard]] static BlockReader& of(void* self) { return *static_cast<BlockReader*>(self); }

    int fail(std::string_view what) {
        if (!error_) error_ = Error{fmt::format("{}:{}", file_, line_at(at_)), std::string(what)};
        return 1;
    }
    [[nodiscard]] int line_at(std::size_t at) const {
        return first_line_ +
               static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    }
    /// md4c gives no positions, but its texts lie in the text that it reads, except for a few of its own.
    void move_to(std::string_view piece) {
        const bool inside = piece.data() >= text_.data() && piece.data() < text_.data() + text_.size();
        if (inside) at_ = static_cast<std::size_t>(piece.data() - text_.data());
    }
    /// To the next line, this one included, that begins with one of `marks`, blanks aside; stays where there is none.
    void move_to_line_of(std::string_view marks) {
        std::size_t line = at_ == 0 ? 0 : text_.rfind('\n', at_ - 1) + 1;
        while (line < text_.size()) {
            const std::size_t first = text_.find_first_not_of(" \t", line);
            if (first != text_.npos && marks.find(text_[first]) != marks.npos) return static_cast<void>(at_ = first);
            const std::size_t end = text_.find('\n', line);
            if (end == text_.npos) return;
            line = end + 1;
        }
    }
    void move_behind_line() { at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1; }

    int enter(MD_BLOCKTYPE type, void* detail) {
        switch (type) {
            case MD_BLOCK_DOC: return 0;
            case MD_BLOCK_P: return begin(MarkdownBlock::Kind::paragraph);
            case MD_BLOCK_H:
                move_to_line_of("#");
                if (static_cast<MD_BLOCK_H_DETAIL*>(detail)->level != 2)
                    return fail(fmt::format("a heading of another level, {}", kExpected));
                return begin(MarkdownBlock::Kind::heading);
            case MD_BLOCK_CODE: {
                move_to_line_of("`~");
                if (begin(MarkdownBlock::Kind::fence) != 0) return 1;
                blocks_.back().line = line_at(at_);
                const MD_ATTRIBUTE& info = static_cast<MD_BLOCK_CODE_DETAIL*>(detail)->info;
                if (info.text != nullptr) blocks_.back().info.assign(info.text, info.size);
                if (text_.empty()) return 0;
                return move_behind_line(), 0;
            }
            case MD_BLOCK_UL:
            case MD_BLOCK_OL: return move_to_line_of("-+*0123456789"), fail(fmt::format("a list, {}", kExpected));
            case MD_BLOCK_QUOTE: return move_to_line_of(">"), fail(fmt::format("a quotation, {}", kExpected));
            case MD_BLOCK_HR: return move_to_line_of("-*_"), fail(fmt::format("a rule, {}", kExpected));
            default: return fail(kExpected);
        }
    }
    int begin(MarkdownBlock::Kind kind) {
        if (blocks_.size() >= kMostBlocks) return fail("more blocks than a lesson can have");
        blocks_.push_back({.kind = kind, .text = {}, .info = {}, .line = 0});
        return 0;
    }
    int leave(MD_BLOCKTYPE type) {
        if (type == MD_BLOCK_DOC) return 0;
        MarkdownBlock& block = blocks_.back();
        if (block.line == 0) block.line = line_at(at_);
        if (block.kind != MarkdownBlock::Kind::fence) {  // a forced line break may stand at either end
            block.text.erase(0, std::min(block.text.find_first_not_of(" \t"), block.text.size()));
            block.text.erase(block.text.find_last_not_of(" \t") + 1);
        }
        if (text_.empty()) return 0;
        if (type == MD_BLOCK_CODE) move_to_line_of("`~");
        move_behind_line();
        return 0;
    }

    int enter_span(MD_SPANTYPE type) {
        if (span_) return fail(fmt::format("a mark inside another, {}", kInline));
        if (type != MD_SPAN_STRONG && type != MD_SPAN_CODE && type != MD_SPAN_LATEXMATH) {
            return fail(fmt::format("{}, {}",
                                    type == MD_SPAN_EM    ? "*emphasis*"
                                    : type == MD_SPAN_A   ? "a link"
                                    : type == MD_SPAN_IMG ? "a picture"
                                                          : "$$display$$",
                                    kInline));
        }
        span_ = type;
        inside_.clear();
        return 0;
    }
    int leave_span(MD_SPANTYPE type) {
        const std::string_view mark = type == MD_SPAN_STRONG ? "**" : type == MD_SPAN_CODE ? "`" : "$";
        span_.reset();
        if (inside_.empty() || inside_.find(mark[0]) != inside_.npos)
            return fail(fmt::format("nothing, or {} itself, between two {}", mark, mark));
        if (inside_.front() == ' ' || inside_.back() == ' ') return fail(fmt::format("a blank beside {}", mark));
        if (type == MD_SPAN_LATEXMATH) {
            if (const auto fault = fault_of_math(inside_)) return fail(*fault);
        }
        blocks_.back().text.append(mark).append(inside_).append(mark);
        return 0;
    }

    int take(MD_TEXTTYPE type, std::string_view text) {
        move_to(text);
        MarkdownBlock& block = blocks_.back();
        if (block.line == 0) block.line = line_at(at_);
        if (block.kind == MarkdownBlock::Kind::fence) return block.text += text, 0;
        if (type == MD_TEXT_ENTITY) return fail(fmt::format("'{}', expected the character itself", text));
        const bool ends = type == MD_TEXT_SOFTBR || type == MD_TEXT_BR;
        if (span_) return inside_ += ends ? " " : text, 0;
        if (ends) return block.text += ' ', 0;
        for (const char& c : text) {
            if (c == '\\') return fail("a backslash outside of mathematics");
            if (c == '$' || c == '*' || c == '`') {
                move_to({&c, 1});
                if (at_ == 0 || text_[at_ - 1] != '\\')
                    return fail(fmt::format("a {0} without its partner; \\{0} is the character itself", c));
                block.text += '\\';
            }
            block.text += c;
        }
        return 0;
    }

    std::string_view text_;
    const std::string& file_;
    int first_line_;
    std::size_t at_ = 0;  ///< how far the text was read
    std::vector<MarkdownBlock> blocks_;
    std::optional<MD_SPANTYPE> span_;
    std::string inside_;  ///< of the span
    std::optional<Error> error_;
};

}  // namespace

Result<std::vector<MarkdownBlock>> parse_markdown(std::string_view text, const std::string& file, int first_line) {
    return BlockReader(text, file, first_line).read();
}

}  // namespace texelscope
