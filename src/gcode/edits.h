// A few places of a long text changed, every other byte left as it is: what is copied is not
// looked at, so nothing can happen to it.
#pragma once
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace bead {

struct Edit {
    std::int64_t offset = 0;  // bytes from the start of the old text
    std::string was, now;     // either may be empty
    bool operator==(const Edit&) const = default;
};

// Copies the text with the edits, which are in order and do not overlap. Throws Error, with the
// input's name, if the text is not what the edits were made for or cannot be read to its end.
void copy_edited(std::istream& text, std::ostream& out, std::span<const Edit> edits,
                 const std::string& name);

}  // namespace bead
