// A lesson of one's own, outside the program's folders.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

namespace texelscope {

inline constexpr std::string_view kOwnScene = R"({ "texelscope": 1,
  "framebuffer": { "width": 16, "height": 12 },
  "textures": [ { "name": "squares", "pattern": "checker", "size": [16, 16] } ],
  "polygons": [ { "texture": "squares",
                  "vertices": [ { "x": 2.5, "y": 1.25, "u": 1, "v": 1 },
                                { "x": 14, "y": 5, "u": 15, "v": 5 },
                                { "x": 5, "y": 11, "u": 4, "v": 15 } ] } ] })";

inline constexpr std::string_view kOwnLesson = R"(+++
title = "My own"
group = "Mine"
summary = "It is short."
method = "edge-equations"
views = ["texels", "code"]
levels = "TGPE"
quirks = ["corners"]
+++

## The first sentence.

Prose.

```set
step = "t0/s5/y5/x6/e8"
pin = "name u"
```

```predict
ask = "What is it?"
kind = "number"
answer = "value u 1 0"
explain = "t0/s1"
```

## The second sentence.

```set
step = "t0/s0"
pin = "line quirk.corners"
```

```predict
ask = "Which texel?"
kind = "texel"
answer = "texel-of 6 5"
```
)";

/// A folder in the system's place for such; gone when the test is over.
class LessonFolder {
public:
    LessonFolder() {
        path = std::filesystem::temp_directory_path() / ("texelscope_lesson_" + std::to_string(getpid())) / "22-mine";
        std::filesystem::create_directories(path);
        write("scene.json", kOwnScene);
        write("lesson.md", kOwnLesson);
    }
    LessonFolder(const LessonFolder&) = delete;
    LessonFolder& operator=(const LessonFolder&) = delete;
    ~LessonFolder() { std::filesystem::remove_all(path.parent_path()); }

    void write(const std::string& file, std::string_view text) const { std::ofstream(path / file) << text; }
    /// The lesson with one place changed.
    void change(std::string_view from, std::string_view to) const {
        std::string text(kOwnLesson);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write("lesson.md", text.replace(at, from.size(), to));
    }
    [[nodiscard]] std::filesystem::path lesson() const { return path / "lesson.md"; }

    std::filesystem::path path;
};

}  // namespace texelscope
