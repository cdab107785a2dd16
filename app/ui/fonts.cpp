#include "app/ui/fonts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>
#include <tuple>

#include "app/ui/sfnt.h"

namespace texelscope::ui {
namespace {

/// Where Debian's packages fonts-inter, fonts-jetbrains-mono, fonts-lmodern and fonts-dejavu-core put their files.
constexpr std::array kSystemFolders{
    "/usr/share/fonts/opentype/inter",           "/usr/share/fonts/truetype/jetbrains-mono",
    "/usr/share/texmf/fonts/opentype/public/lm", "/usr/share/texmf/fonts/opentype/public/lm-math",
    "/usr/share/fonts/truetype/dejavu",
};

enum class Family : std::uint8_t {
    sans,
    medium,
    semibold,
    mono,
    mono_strong,
    roman,
    italic,
    small_roman,
    small_italic
};

/// The files of a family, best first; the later ones also give the glyphs that the first lacks.
std::span<const char* const> files_of(Family family) {
    static constexpr std::array kSans{"Inter-Regular.otf", "DejaVuSans.ttf"};
    static constexpr std::array kMedium{"Inter-Medium.otf", "DejaVuSans.ttf"};
    static constexpr std::array kSemibold{"Inter-SemiBold.otf", "DejaVuSans-Bold.ttf", "DejaVuSans.ttf"};
    static constexpr std::array kMono{"JetBrainsMono-Regular.ttf", "DejaVuSansMono.ttf"};
    static constexpr std::array kMonoStrong{"JetBrainsMono-Bold.ttf", "DejaVuSansMono-Bold.ttf", "DejaVuSansMono.ttf"};
    static constexpr std::array kRoman{"lmroman8-regular.otf", "latinmodern-math.otf", "DejaVuSerif.ttf",
                                       "DejaVuSans.ttf"};
    static constexpr std::array kItalic{"lmroman8-italic.otf", "latinmodern-math.otf", "DejaVuSerif.ttf",
                                        "DejaVuSans.ttf"};
    static constexpr std::array kSmallRoman{"lmroman7-regular.otf", "latinmodern-math.otf", "DejaVuSerif.ttf",
                                            "DejaVuSans.ttf"};
    static constexpr std::array kSmallItalic{"lmroman7-italic.otf", "latinmodern-math.otf", "DejaVuSerif.ttf",
                                             "DejaVuSans.ttf"};
    switch (family) {
        case Family::sans: return kSans;
        case Family::medium: return kMedium;
        case Family::semibold: return kSemibold;
        case Family::mono: return kMono;
        case Family::mono_strong: return kMonoStrong;
        case Family::roman: return kRoman;
        case Family::italic: return kItalic;
        case Family::small_roman: return kSmallRoman;
        case Family::small_italic: return kSmallItalic;
    }
    return kSans;
}

/// Latin Modern Roman's own middle dot is .83 em wide; Latin Modern Math's is a multiplication dot.
constexpr std::array<ImWchar, 5> kRomanRange{0x20, 0xB6, 0xB8, 0x3FF, 0};

// ASCII, Latin-1 and Extended-A, Greek, dashes and quotes, raised and lowered figures, arrows, operators, floor
// and ceiling, geometric marks, tick and cross.
constexpr ImWchar kRange[] = {
    0x20,   0x7E,   0xA0,   0x17F,  0x391,  0x3C9,  0x2010, 0x2015, 0x2018, 0x201E, 0x2022, 0x2022, 0x2026,
    0x2026, 0x2032, 0x2033, 0x2070, 0x208E, 0x2190, 0x2195, 0x21D2, 0x21D2, 0x21E7, 0x21E7, 0x2202, 0x2202,
    0x2207, 0x2208, 0x2211, 0x2212, 0x221A, 0x221A, 0x221E, 0x221E, 0x2227, 0x222A, 0x2248, 0x2248, 0x2260,
    0x2261, 0x2264, 0x2265, 0x22C5, 0x22C5, 0x2308, 0x230B, 0x25A0, 0x25A1, 0x25B2, 0x25B6, 0x25BC, 0x25BC,
    0x25C0, 0x25C0, 0x25CB, 0x25CF, 0x2713, 0x2717, 0xFFFD, 0xFFFD, 0,
};

Family family_of(Face face) {
    switch (face) {
        case Face::title:
        case Face::lead: return Family::medium;
        case Face::lesson_title: return Family::semibold;
        case Face::code:
        case Face::code_note:
        case Face::line_number:
        case Face::count:
        case Face::ruler: return Family::mono;
        case Face::code_strong:
        case Face::ruler_strong: return Family::mono_strong;
        case Face::note:
        case Face::prose: break;
    }
    return Family::sans;
}

Family family_of(MathStyle style) {
    switch (style) {
        case MathStyle::italic: return Family::italic;
        case MathStyle::upright: return Family::roman;
        case MathStyle::sub_italic: return Family::small_italic;
        case MathStyle::sub_upright: return Family::small_roman;
    }
    return Family::roman;
}

}  // namespace

float face_px(Face face, const FontSpec& spec) {
    static constexpr std::array<float, kFaceCount> kPx{11, 12, 13, 13.5F, 15, 13, 13, 12, 11, 10.5F, 10, 10};
    return spec.scale * (spec.presenting ? 24.0F : kPx[static_cast<std::size_t>(face)]);
}

float math_px(MathSize size, const FontSpec& spec) {
    static constexpr std::array<float, kMathSizeCount> kPx{14, 15, 16, 17}, kPresenting{24, 26, 27, 30};
    return spec.scale * (spec.presenting ? kPresenting : kPx)[static_cast<std::size_t>(size)];
}

float subscript_px(MathSize size, const FontSpec& spec) {
    const float px = 0.68F * math_px(size, spec);
    return spec.presenting ? std::max(18 * spec.scale, px) : px;
}

/// Reads each file once and bakes each pair of family and size once.
class FontBaker {
public:
    explicit FontBaker(std::span<const std::string> folders) : folders_(folders.begin(), folders.end()) {
        folders_.insert(folders_.end(), kSystemFolders.begin(), kSystemFolders.end());
        fonts_.atlas_ = std::make_unique<ImFontAtlas>();
    }

    Result<Fonts> bake(const FontSpec& spec) {
        fonts_.spec_ = spec;
        for (std::size_t i = 0; i < kFaceCount; ++i) {
            const auto face = static_cast<Face>(i);
            auto font = add(family_of(face), face_px(face, spec));
            if (!font) return font.error();
            fonts_.faces_[i] = *font;
        }
        for (std::size_t i = 0; i < fonts_.math_.size(); ++i) {
            const auto size = static_cast<MathSize>(i / kMathStyleCount);
            const auto style = static_cast<MathStyle>(i % kMathStyleCount);
            const bool sub = style == MathStyle::sub_italic || style == MathStyle::sub_upright;
            auto font = add(family_of(style), sub ? subscript_px(size, spec) : math_px(size, spec));
            if (!font) return font.error();
            fonts_.math_[i] = *font;
        }
        fonts_.atlas_->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoPowerOfTwoHeight;
        fonts_.atlas_->TexDesiredWidth = spec.scale * (spec.presenting ? 2.0F : 1.0F) > 1.5F ? 4096 : 2048;
        if (!fonts_.atlas_->Build()) return Error{"", "the fonts do not fit into one texture"};
        for (Font& font : fonts_.faces_) font.baseline = std::round(font.im->Ascent);
        for (Font& font : fonts_.math_) font.baseline = std::round(font.im->Ascent);
        return std::move(fonts_);
    }

private:
    struct File {
        const std::vector<unsigned char>* bytes = nullptr;
        FontMetrics metrics;
    };

    /// The file's bytes are null where no folder has it.
    Result<File> load(const std::string& name) {
        if (const auto known = files_.find(name); known != files_.end()) return known->second;
        File file;
        for (const std::string& folder : folders_) {
            const std::filesystem::path path = std::filesystem::path(folder) / name;
            std::error_code ignored;
            if (!std::filesystem::is_regular_file(path, ignored)) continue;
            std::ifstream in(path, std::ios::binary);
            auto bytes = std::make_unique<std::vector<unsigned char>>(std::istreambuf_iterator<char>(in),
                                                                      std::istreambuf_iterator<char>());
            auto metrics = read_font_metrics(*bytes);
            if (!metrics) return Error{path.string(), metrics.error().what};
            file = {bytes.get(), *metrics};
            fonts_.files_.push_back(std::move(bytes));
            break;
        }
        return files_[name] = file;
    }

    Result<Font> add(Family family, float em) {
        const auto key = std::make_tuple(family, em);
        if (const auto known = baked_.find(key); known != baked_.end()) return known->second;
        Font font;
        for (const char* name : files_of(family)) {
            auto file = load(name);
            if (!file) return file.error();
            if (file->bytes == nullptr) continue;
            ImFontConfig config;
            config.FontData = const_cast<unsigned char*>(file->bytes->data());
            config.FontDataSize = static_cast<int>(file->bytes->size());
            config.FontDataOwnedByAtlas = false;
            config.SizePixels = em * (file->metrics.ascent + file->metrics.descent);
            // Glyphs are placed at fractional x, which needs the finer sampling; baselines are whole pixels.
            config.OversampleH = em < 28 ? 3 : em < 44 ? 2 : 1;
            config.OversampleV = 1;
            config.MergeMode = font.im != nullptr;
            const bool roman = std::string_view(name).substr(0, 2) == "lm";
            config.RasterizerMultiply = roman ? 1.2F : 1.1F;  // unhinted stems are thinner than a projector likes
            config.GlyphRanges = roman ? kRomanRange.data() : kRange;
            ImFont* im = fonts_.atlas_->AddFont(&config);
            if (font.im == nullptr) font = {im, em, 0, em * file->metrics.cap, em * file->metrics.x_height};
        }
        if (font.im == nullptr)
            return Error{"", std::string("no font ") + files_of(family).front() +
                                 "; install fonts-inter, fonts-jetbrains-mono, fonts-lmodern or fonts-dejavu-core"};
        return baked_[key] = font;
    }

    std::vector<std::string> folders_;
    std::map<std::string, File> files_;
    std::map<std::tuple<Family, float>, Font> baked_;
    Fonts fonts_;
};

Result<Fonts> Fonts::bake(const FontSpec& spec, std::span<const std::string> folders) {
    return FontBaker(folders).bake(spec);
}

}  // namespace texelscope::ui
