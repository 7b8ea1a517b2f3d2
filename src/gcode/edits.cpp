#include "gcode/edits.h"

#include <algorithm>
#include <istream>
#include <ostream>
#include <vector>

#include "core/error.h"
#include "core/expects.h"

namespace bead {
namespace {

constexpr std::int64_t piece = std::int64_t{1} << 20;  // bytes copied at a time

// The text's next bytes, as many as are wanted or are left.
std::string_view next(std::istream& text, std::vector<char>& buffer, std::int64_t count) {
    buffer.resize(std::size_t(count));
    text.read(buffer.data(), count);
    return {buffer.data(), std::size_t(text.gcount())};
}

}  // namespace

void copy_edited(std::istream& text, std::ostream& out, std::span<const Edit> edits,
                 const std::string& name) {
    const auto unchanged = [&](bool condition) {
        if (!condition)
            throw Error(name + ": was changed by another program meanwhile; try again",
                        Fault::other);
    };
    std::vector<char> buffer;
    std::int64_t at = 0;
    for (const Edit& edit : edits) {
        BEAD_EXPECTS(edit.offset >= at);
        while (at < edit.offset) {
            const std::string_view bytes = next(text, buffer, std::min(piece, edit.offset - at));
            unchanged(!bytes.empty());
            out.write(bytes.data(), std::streamsize(bytes.size()));
            at += std::int64_t(bytes.size());
        }
        unchanged(next(text, buffer, std::int64_t(edit.was.size())) == edit.was);
        at += std::int64_t(edit.was.size());
        out.write(edit.now.data(), std::streamsize(edit.now.size()));
    }
    for (std::string_view rest; !(rest = next(text, buffer, piece)).empty();)
        out.write(rest.data(), std::streamsize(rest.size()));
    if (text.bad()) throw Error(name + ": cannot be read to its end", Fault::other);
}

}  // namespace bead
