#include "console.h"

#include <cmath>
#include <memory>
#include <mutex>

namespace bead::cli {

void Console::warn(std::string_view message) const {
    fmt::print(stderr, "beadwork: warning: {}\n", message);
}

std::string Console::strong(std::string_view words) const {
    return colour ? fmt::format("\033[1m{}\033[0m", words) : std::string(words);
}

std::string Console::good(std::string_view words) const {
    return colour ? fmt::format("\033[32m{}\033[0m", words) : std::string(words);
}

Progress progress_on(const Console& console) {
    if (console.progress == ProgressStyle::none) return {};
    struct Seen {
        std::mutex lock;
        int percent = -1;
    };
    return [style = console.progress, seen = std::make_shared<Seen>()](double fraction,
                                                                       std::string_view stage) {
        const std::lock_guard guard(seen->lock);
        const int percent = static_cast<int>(100 * fraction);
        if (percent == seen->percent) return;
        seen->percent = percent;
        if (style == ProgressStyle::json) {
            fmt::print(stderr, "{{\"fraction\": {:.2f}, \"stage\": \"{}\"}}\n", fraction, stage);
            return;
        }
        const auto done = static_cast<std::size_t>(percent * 30 / 100);
        if (percent < 100)
            fmt::print(stderr, "\r\033[K[{}{}] {:3d} % {}", std::string(done, '#'),
                       std::string(30 - done, '.'), percent, stage);
        else
            fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    };
}

std::string spoken_time(double seconds) {
    if (seconds < 60) return fmt::format("{:.1f} s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02d} min {:02d} s", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace bead::cli
