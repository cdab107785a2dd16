// From blocks of Markdown to beats.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/lesson/fields.h"
#include "app/lesson/lesson.h"
#include "app/lesson/markdown.h"
#include "core/method/method.h"

namespace texelscope {

/// The names that a lesson may use.
struct Vocabulary {
    const Method* method = nullptr;
    std::span<const std::string_view> views;  ///< empty: any
};

/// Remembers a fault of `key` where the name is none.
void demand_quirk(Fields& fields, std::string_view key, std::string_view quirk, const Vocabulary& words);
void demand_views(Fields& fields, std::string_view key, const std::vector<std::string>& views, const Vocabulary& words);

/// @param line  of the text behind the front matter, for a lesson without beats.
Result<std::vector<Beat>> read_beats(const std::vector<MarkdownBlock>& blocks, const std::string& file, int line,
                                     const Vocabulary& words);

}  // namespace texelscope
