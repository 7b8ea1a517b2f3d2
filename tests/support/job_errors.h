// What an Error says, for tests of messages.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace bead::test {

template <class Act>
std::string complaint_of(const Act& act, Fault fault = Fault::input) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), fault) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return "none";
}

inline bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

}  // namespace bead::test
