// The Markdown of a lesson: level-2 headings, paragraphs and fenced blocks, as pieces with their lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace texelscope {

struct MarkdownBlock {
    enum class Kind : unsigned char { heading, paragraph, fence } kind = Kind::paragraph;
    std::string text;  ///< of a fence: its content; else prose as ui::spans_of reads it
    std::string info;  ///< of a fence: the words behind its marks
    int line = 0;      ///< of the file, on which the block begins
};

/// Only headings of level 2, paragraphs, fences, **strong**, `code` and $mathematics$ that can be read; anything else
/// is an error at its line.
Result<std::vector<MarkdownBlock>> parse_markdown(std::string_view text, const std::string& file, int first_line);

}  // namespace texelscope
