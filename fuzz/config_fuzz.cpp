// Any bytes as a process file, of either form: settings or an Error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "job/config_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    for (const char* file : {"fuzz.toml", "fuzz.ini"}) {
        try {
            bead::Settings settings;
            bead::read_config_text(settings, text, file);
            bead::check(settings);
        } catch (const bead::Error&) {
        }
    }
    return 0;
}
