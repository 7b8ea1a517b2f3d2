// Any bytes as a load case, and as the SVG that one may name: a case or an Error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "job/case_file.h"
#include "job/outline_svg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    try {
        bead::parsed_case(text, "fuzz/case.toml");
    } catch (const bead::Error&) {
    }
    try {
        bead::outline_of_svg(text, "fuzz.svg");
    } catch (const bead::Error&) {
    }
    return 0;
}
