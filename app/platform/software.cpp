#include "app/platform/software.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/fast/paint.h"

namespace texelscope {
namespace {

[[nodiscard]] std::uintptr_t number(ImTextureID id) { return reinterpret_cast<std::uintptr_t>(id); }
[[nodiscard]] ImTextureID handle(std::uintptr_t number) { return reinterpret_cast<ImTextureID>(number); }
const ImTextureID kFontId = handle(1);

static_assert(sizeof(ImDrawIdx) == sizeof(std::uint16_t));

[[nodiscard]] PaintTexture font_texture(ImFontAtlas& fonts) {
    PaintTexture texture;
    if (fonts.TexPixelsAlpha8 == nullptr && fonts.TexPixelsRGBA32 != nullptr) {
        unsigned char* pixels = nullptr;
        fonts.GetTexDataAsRGBA32(&pixels, &texture.width, &texture.height);
        texture.rgba = reinterpret_cast<const Rgba*>(pixels);
        return texture;
    }
    unsigned char* pixels = nullptr;
    fonts.GetTexDataAsAlpha8(&pixels, &texture.width, &texture.height);
    texture.alpha = pixels;
    return texture;
}

/// The pixels whose centres lie in [low, high), within a bound that an int holds.
[[nodiscard]] int first_pixel(float px) {
    constexpr float kBound = 1e6F;
    if (!(px > -kBound)) return static_cast<int>(-kBound);
    return static_cast<int>(std::ceil(std::fmin(px, kBound) - 0.5F));
}

[[nodiscard]] Rect pixels_of(const ImVec4& clip, const ImVec2& origin) {
    return {first_pixel(clip.x - origin.x), first_pixel(clip.y - origin.y), first_pixel(clip.z - origin.x),
            first_pixel(clip.w - origin.y)};
}

}  // namespace

const Grid<Rgba>* SoftwareTextures::find(ImTextureID id) const {
    const auto it = pixels_.find(number(id));
    return it == pixels_.end() ? nullptr : &it->second;
}

ImTextureID SoftwareTextures::upload(ImTextureID old, const Grid<Rgba>& pixels) {
    const ImTextureID id = old != nullptr ? old : handle(++last_);
    pixels_[number(id)] = pixels;
    return id;
}

void SoftwareTextures::release(ImTextureID held) { pixels_.erase(number(held)); }

void SoftwarePlatform::frame(const ui::Input& input, const std::function<void()>& draw) {
    textures_.begin_frame();
    session_.change_fonts();
    session_.fonts().SetTexID(kFontId);
    session_.begin_frame(input);
    draw();
    drawn_ = &session_.end_frame();
}

Image SoftwarePlatform::picture() const {
    if (drawn_ == nullptr) return {};
    Image picture(static_cast<int>(std::ceil(drawn_->DisplaySize.x)),
                  static_cast<int>(std::ceil(drawn_->DisplaySize.y)));
    paint_draw_data(picture, *drawn_, session_.fonts(), textures_);
    return picture;
}

void paint_draw_data(Image& picture, const ImDrawData& drawn, ImFontAtlas& fonts, const SoftwareTextures& textures) {
    const PaintTexture font = font_texture(fonts);
    std::vector<PaintVertex> vertices;
    for (const ImDrawList* list : std::span(drawn.CmdLists, static_cast<std::size_t>(drawn.CmdListsCount))) {
        vertices.clear();
        for (const ImDrawVert& v : list->VtxBuffer) {
            vertices.push_back({v.pos.x - drawn.DisplayPos.x, v.pos.y - drawn.DisplayPos.y, v.uv.x, v.uv.y, v.col});
        }
        for (const ImDrawCmd& command : list->CmdBuffer) {
            if (command.UserCallback != nullptr) {
                if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(list, &command);
                continue;
            }
            PaintTexture texture = font;
            if (command.TextureId != kFontId) {
                const Grid<Rgba>* const pixels = textures.find(command.TextureId);
                if (pixels == nullptr) continue;
                texture = {pixels->width(), pixels->height(), nullptr, pixels->data()};
            }
            paint(picture, std::span<const PaintVertex>(vertices).subspan(command.VtxOffset),
                  {list->IdxBuffer.Data + command.IdxOffset, command.ElemCount}, texture,
                  pixels_of(command.ClipRect, drawn.DisplayPos));
        }
    }
}

}  // namespace texelscope
