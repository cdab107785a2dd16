// The type of the screen: which font file, at which size, for which purpose; baked once a text scale.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/base/result.h"

namespace texelscope::ui {

/// Purposes of running text. Numbers that change are set in the monospaced ones (code to ruler_strong) or in
/// formulas only: the figures of the others are not equally wide.
// clang-format off
enum class Face : std::uint8_t {
    note, title, prose, lead, lesson_title,
    code, code_strong, code_note, line_number, count, ruler, ruler_strong,
};
// clang-format on
inline constexpr std::size_t kFaceCount = 12;

/// Sizes of formulas: within notes, within prose and tables, as a row of their own, enlarged.
enum class MathSize : std::uint8_t { note, prose, row, display };
inline constexpr std::size_t kMathSizeCount = 4;

enum class MathStyle : std::uint8_t { italic, upright, sub_italic, sub_upright };
inline constexpr std::size_t kMathStyleCount = 4;

/// One baked face. Lengths in pixels of the window.
struct Font {
    ImFont* im = nullptr;
    float em = 0;        ///< the nominal size
    float baseline = 0;  ///< from the top of ImGui's line to the baseline
    float cap = 0;       ///< height of a capital
    float x_height = 0;
};

struct FontSpec {
    float scale = 1;          ///< [1, 2.5]
    bool presenting = false;  ///< 24 px at least, subscripts 18
    friend bool operator==(const FontSpec&, const FontSpec&) = default;
};

/// An atlas with every face. A new scale is a new atlas: glyphs are never stretched.
class Fonts {
public:
    /// @param folders  searched before the system's, for fonts shipped with the program.
    /// Fails           where a purpose has no font file at all, or a file is no font.
    static Result<Fonts> bake(const FontSpec& spec, std::span<const std::string> folders = {});

    [[nodiscard]] const FontSpec& spec() const { return spec_; }
    [[nodiscard]] ImFontAtlas& atlas() const { return *atlas_; }
    [[nodiscard]] const Font& face(Face face) const { return faces_[static_cast<std::size_t>(face)]; }
    [[nodiscard]] const Font& math(MathSize size, MathStyle style) const {
        return math_[static_cast<std::size_t>(size) * kMathStyleCount + static_cast<std::size_t>(style)];
    }

private:
    friend class FontBaker;
    Fonts() = default;

    FontSpec spec_;
    std::vector<std::unique_ptr<std::vector<unsigned char>>> files_;  ///< the atlas reads them while it is built
    std::unique_ptr<ImFontAtlas> atlas_;
    std::array<Font, kFaceCount> faces_{};
    std::array<Font, kMathSizeCount * kMathStyleCount> math_{};
};

/// Nominal size of a face [px of the window].
[[nodiscard]] float face_px(Face face, const FontSpec& spec);
[[nodiscard]] float math_px(MathSize size, const FontSpec& spec);
/// Subscripts are 68 % of their base, when presenting 18 at least.
[[nodiscard]] float subscript_px(MathSize size, const FontSpec& spec);

}  // namespace texelscope::ui
