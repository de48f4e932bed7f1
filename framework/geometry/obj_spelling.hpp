// How the words of an OBJ file may be spelled. For the reader alone.
#pragma once

#include <string_view>

namespace glint {

// Decimal, as in -1.5e-3. Neither nan, inf nor 0x10, nor an exponent of more than four digits.
bool is_number(std::string_view word);

// What some programs write for a normal that they could not compute.
bool is_nan_or_inf(std::string_view word);

// A corner of a face: v, v/t, v//n or v/t/n; also v/ and v//, which some programs write for v.
// Indices have at most nine digits and are not 0.
bool is_corner(std::string_view word);

// Letters, digits and _, not beginning with a digit.
bool is_keyword(std::string_view word);

// A statement that says nothing about triangles: free-form surfaces, lines, groups, display.
bool is_passed_over(std::string_view keyword);

}  // namespace glint
