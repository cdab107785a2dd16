// Fuzzes the line that a state is copied and pasted as: damaged text is an error, and good text prints as it was read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "app/state/link.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace texelscope;
    const std::string fields(reinterpret_cast<const char*>(data), size);
    static_cast<void>(parse_link(fields));
    // The check sum stops nearly every mutation, so the fields behind it are tried with a good one too.
    const auto link = parse_link(with_checksum(fields));
    if (!link) return 0;
    State state;
    auto document = std::make_shared<Document>();
    document->id = link->document;
    state.document = document;
    state.work = link->work, state.cursor = link->cursor;
    const auto again = parse_link(print_link(state));
    if (!again || again->work != link->work || again->cursor != link->cursor) std::abort();
    return 0;
}
