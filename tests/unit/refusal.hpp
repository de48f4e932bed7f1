// What is said when something is refused.
#pragma once

#include "framework/math/error.hpp"

#include <string>

namespace glint {

// The message of the Error that act() throws; empty where it throws none.
template <class Act>
std::string refusal(Act&& act) {
    try {
        act();
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

}  // namespace glint
