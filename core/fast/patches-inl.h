// Blocks of 4 x 4 samples whose texels lie within a patch of 8 x 8 of the texture: it is loaded whole and looked up in
// registers. AVX-512 alone has such a look-up.
#if defined(TEXELSCOPE_PATCHES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PATCHES_INL
#undef TEXELSCOPE_PATCHES_INL
#else
#define TEXELSCOPE_PATCHES_INL
#endif

#include "core/fast/simd-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

constexpr int kBlock = 4;      ///< samples from one side of a block to the other
constexpr int kPatchBits = 3;  ///< log2 of the texels from one side of a patch to the other
constexpr int kPatch = 1 << kPatchBits;

using Block = hn::CappedTag<uint32_t, kBlock * kBlock>;  ///< row by row
using Samples = hn::Vec<Block>;

/// Texels of the patch that begins at `patch`, its rows `pitch` apart: `place` is 8 v + u, whatever its upper bits are,
/// `lower` where v >= 4.
HWY_INLINE Samples look_up_patch(const uint32_t* patch, std::ptrdiff_t pitch, Samples places, __mmask16 lower) {
    const __m512i place = places.raw;  // the instruction takes the lowest five bits
    const auto two_rows = [pitch](const uint32_t* row) HWY_ATTR {
        const __m256i first = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row));
        const __m256i second = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row + pitch));
        return _mm512_inserti64x4(_mm512_castsi256_si512(first), second, 1);
    };
    const __m512i above = _mm512_permutex2var_epi32(two_rows(patch), place, two_rows(patch + 2 * pitch));
    const __m512i below = _mm512_permutex2var_epi32(two_rows(patch + 4 * pitch), place, two_rows(patch + 6 * pitch));
    return Samples{_mm512_mask_blend_epi32(lower, above, below)};
}

HWY_INLINE void store_block(Samples texels, uint32_t* out, std::ptrdiff_t pitch) {
    const auto store = [](uint32_t* to, __m128i row)
                           HWY_ATTR { _mm_storeu_si128(reinterpret_cast<__m128i*>(to), row); };
    store(out, _mm512_castsi512_si128(texels.raw));
    store(out + pitch, _mm512_extracti32x4_epi32(texels.raw, 1));
    store(out + 2 * pitch, _mm512_extracti32x4_epi32(texels.raw, 2));
    store(out + 3 * pitch, _mm512_extracti32x4_epi32(texels.raw, 3));
}

// In words of the machine: of the compiler's own, GCC 12 carries masks through general registers, and makes one
// instruction of an extraction and a store under a mask, three times as slow.

HWY_INLINE __mmask16 load_mask(const uint16_t& bits) {
    __mmask16 mask;
    asm("kmovw %1, %0" : "=k"(mask) : "m"(bits));
    return mask;
}
/// One row under the lowest bits of a mask.
HWY_INLINE void store_row(uint32_t* to, __m128i row, __mmask16 inside) {
    asm("vmovdqu32 %1, %0%{%2%}" : "+m"(*reinterpret_cast<uint32_t(*)[kBlock]>(to)) : "v"(row), "Yk"(inside));
}
/// The samples whose bits are set in `inside`.
HWY_INLINE void store_block(Samples texels, __mmask16 inside, uint32_t* out, std::ptrdiff_t pitch) {
    store_row(out, _mm512_castsi512_si128(texels.raw), inside);
    store_row(out + pitch, _mm512_extracti32x4_epi32(texels.raw, 1), _kshiftri_mask16(inside, 4));
    store_row(out + 2 * pitch, _mm512_extracti32x4_epi32(texels.raw, 2), _kshiftri_mask16(inside, 8));
    store_row(out + 3 * pitch, _mm512_extracti32x4_epi32(texels.raw, 3), _kshiftri_mask16(inside, 12));
}
/// A block with these samples inside. Returns these.
template <bool kWhole>
HWY_INLINE __mmask16 store_block(Samples texels, const uint16_t& inside, uint32_t* out, std::ptrdiff_t pitch) {
    if constexpr (kWhole) {
        store_block(texels, out, pitch);
        return 0xFFFF;
    } else {
        const __mmask16 mask = load_mask(inside);
        store_block(texels, mask, out, pitch);
        return mask;
    }
}

/// The samples inside whose u or v has none of the bits set that make its texel certain.
HWY_INLINE __mmask16 in_doubt(__mmask16 inside, Samples u, Samples u_tested, Samples v, Samples v_tested) {
    return _kor_mask16(_mm512_mask_testn_epi32_mask(inside, u.raw, u_tested.raw),
                       _mm512_mask_testn_epi32_mask(inside, v.raw, v_tested.raw));
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
