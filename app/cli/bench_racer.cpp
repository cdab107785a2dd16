#include "app/cli/bench_racer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/cli/json_line.h"
#include "core/fast/raster.h"
#include "core/fast/raster_texels.h"
#include "core/image/packed.h"
#include "core/scene/triangles_scene.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostInScene = 2'000'000;  ///< triangles; as polygons of a scene they take 300 bytes each
constexpr int kPadding = 16;                     ///< beyond each row: rows then are no power of two apart

class FastRacer final : public BenchRacer {
public:
    FastRacer(TrianglesFile file, const Image& texels, const RasterSettings& settings)
        : file_(std::move(file)),
          texels_(texels, Wrap::repeat),
          settings_(settings),
          pitch_(file_.width + kPadding),
          pixels_(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(file_.height)),
          depth_(file_.depth ? pixels_.size() : 0),
          samples_(file_.covered) {
        if (samples_ > 0) return;
        settings_.skips &= ~(1U << static_cast<unsigned>(RasterSkip::overdrawn));
        clear(), draw();
        samples_ = counters_.samples, settings_ = settings;
    }

    void clear() override {
        std::fill(pixels_.begin(), pixels_.end(), packed(Rgb{}));
        std::fill(depth_.begin(), depth_.end(), 1.0F);
    }
    void draw() override {
        counters_ = {};
        const RasterTexture texture = texels_.texture();
        const RasterJob job{.vertices = file_.vertices,
                            .u_texels = texture.width,
                            .v_texels = texture.height,
                            .perspective = file_.perspective,
                            .cull_back = file_.cull_back,
                            .depth = file_.depth};
        const RasterTarget target{.pixels = pixels_.data(),
                                  .pitch = pitch_,
                                  .width = file_.width,
                                  .height = file_.height,
                                  .depth = depth_.data()};
        texelscope::draw(target, texture, job, settings_, counters_);
    }
    [[nodiscard]] Image picture() const override { return unpacked(pixels_.data(), pitch_, file_.width, file_.height); }
    [[nodiscard]] std::uint64_t samples() const override { return samples_; }
    [[nodiscard]] int threads() const override { return settings_.threads; }
    [[nodiscard]] std::string stats() const override {
        JsonLine line;
        const RasterCounters& c = counters_;
        for (const auto& [name, count] : {std::pair{"triangles", c.triangles},
                                          {"set up", c.drawn},
                                          {"refused", c.refused},
                                          {"by blocks", c.by_blocks},
                                          {"slow", c.slow},
                                          {"samples", c.samples},
                                          {"crossings again", c.crossings},
                                          {"texels in double", c.in_double},
                                          {"texels in whole", c.in_whole}})
            line.number(name, static_cast<Integer>(count));
        for (const RasterSkipInfo& skip : kRasterSkips)
            line.number(skip.id, static_cast<Integer>(c.skipped[static_cast<std::size_t>(skip.skip)]));
        return line.line();
    }

private:
    TrianglesFile file_;
    RasterTexels texels_;
    RasterSettings settings_;
    int pitch_;
    std::vector<std::uint32_t> pixels_;
    std::vector<float> depth_;
    RasterCounters counters_;
    std::uint64_t samples_;  ///< inside triangles, whether drawn or not
};

class MethodRacer final : public BenchRacer {
public:
    MethodRacer(const TrianglesFile& file, Image texels, const DrawSettings& settings)
        : scene_(scene_of(file, std::move(texels))),
          drawing_(scene_, settings),
          picture_(file.width, file.height),
          samples_(file.covered) {
        if (samples_ > 0) return;
        each_sample(drawing_, 0, drawing_.shape_count(), {scene_.framebuffer.rect(), 1},
                    [&](int, const Sample& s) { samples_ += s.fate == Fate::written ? 1U : 0U; });
    }

    void clear() override { std::fill_n(picture_.data(), picture_.size(), scene_.framebuffer.clear); }
    void draw() override { draw_into(drawing_, picture_); }
    [[nodiscard]] Image picture() const override { return picture_; }
    [[nodiscard]] std::uint64_t samples() const override { return samples_; }
    [[nodiscard]] int threads() const override { return 1; }

private:
    Scene scene_;
    Drawing drawing_;
    Image picture_;
    std::uint64_t samples_;
};

Result<RasterSettings> fast_settings(const DrawOptions& options) {
    RasterSettings settings;
    for (const SimdLevelInfo& level : kSimdLevels)
        if (level.id == options.target) settings.level = level.level;
    if (!is_supported(settings.level))
        return Error{"", fmt::format("--target {}: this machine has no such instructions", options.target)};
    for (const std::string& word : options.skips) {
        const std::size_t equals = word.find('=');
        const std::string id = word.substr(0, equals), how = equals == std::string::npos ? "" : word.substr(equals + 1);
        const auto skip =
            std::find_if(kRasterSkips.begin(), kRasterSkips.end(), [&](const auto& s) { return s.id == id; });
        if (skip == kRasterSkips.end()) return Error{"", fmt::format("--skip '{}': fast has no such skip", word)};
        if (how != "on" && how != "off")
            return Error{"", fmt::format("--skip '{}', expected {}=on or {}=off", word, id, id)};
        const std::uint32_t bit = 1U << static_cast<unsigned>(skip->skip);
        settings.skips = how == "on" ? settings.skips | bit : settings.skips & ~bit;
    }
    if (options.threads < 1 || options.threads > kMaxRasterThreads)
        return Error{"", fmt::format("--threads {}, expected 1 to {}", options.threads, kMaxRasterThreads)};
    settings.threads = options.threads;
    if (!options.quirks.empty()) return Error{"", fmt::format("--quirk '{}': fast has none", options.quirks[0])};
    return settings;
}

}  // namespace

Result<std::unique_ptr<BenchRacer>> make_racer(TrianglesFile file, Image texels, const DrawOptions& options,
                                               bool certificates, const std::string& name) {
    if (options.method == kFastMethod) {
        auto settings = fast_settings(options);
        if (!settings) return settings.error();
        settings->certain = certificates;
        return std::unique_ptr<BenchRacer>(std::make_unique<FastRacer>(std::move(file), texels, *settings));
    }
    const auto settings = draw_settings(options);
    if (!settings) return settings.error();
    if (!certificates)
        return Error{"", fmt::format("--no-certificates is for the method fast, not for {}", options.method)};
    if (file.vertices.size() / 3 > kMostInScene)
        return Error{name, fmt::format("there are {} triangles, expected at most {} for the method {}",
                                       file.vertices.size() / 3, kMostInScene, options.method)};
    return std::unique_ptr<BenchRacer>(std::make_unique<MethodRacer>(file, std::move(texels), *settings));
}

}  // namespace texelscope
