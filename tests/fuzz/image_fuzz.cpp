// Any bytes are an image within the bounds or an error; an image that was read survives a PNG and a palette.
#include <cstdint>
#include <cstdlib>

#include "core/image/load.h"
#include "core/image/palette.h"

namespace {

void demand(bool law) {
    if (!law) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace texelscope;
    const Result<Image> image = decode_image({data, size}, "fuzz");
    if (!image) {
        demand(image.error().where == "fuzz" && !image.error().what.empty());
        return 0;
    }
    demand(image->width() >= 1 && image->width() <= kMaxSize && image->height() >= 1 && image->height() <= kMaxSize);
    if (image->size() > 4096) return 0;
    const Result<std::vector<std::uint8_t>> png = encode_png(*image);
    demand(static_cast<bool>(png));
    const Result<Image> again = decode_image(*png, "again");
    demand(again && *again == *image);
    const Paletted paletted = reduce_to_palette(*image, 16);
    demand(!paletted.palette.empty() && paletted.palette.size() <= 16);
    return 0;
}
