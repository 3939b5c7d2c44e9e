// A font of five by nine dots for captions, drawn for Facet.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace facet::image {

inline constexpr std::uint32_t glyph_columns = 5;
inline constexpr std::uint32_t glyph_rows = 9;  ///< the last two for tails

/// Dots of a character, row by row from the top left, lowest bit first.
struct Glyph {
    char character;
    std::uint64_t dots;
};
inline constexpr std::array<Glyph, 78> dotted_font = {{
    {' ', 0x000000000000ULL}, {'%', 0x000672222273ULL}, {'(', 0x000208210888ULL},
    {')', 0x000088842082ULL}, {'+', 0x000109F21000ULL}, {',', 0x02218C000000ULL},
    {'-', 0x000000078000ULL}, {'.', 0x00018C000000ULL}, {'/', 0x000042222210ULL},
    {'0', 0x0003A33AE62EULL}, {'1', 0x0003884210C4ULL}, {'2', 0x0007C444422EULL},
    {'3', 0x0003E107420FULL}, {'4', 0x000211F4A988ULL}, {'5', 0x0003A3083C3FULL},
    {'6', 0x0003A317842EULL}, {'7', 0x00010844221FULL}, {'8', 0x0003A317462EULL},
    {'9', 0x0003A10F462EULL}, {':', 0x00018C031800ULL}, {';', 0x00218C031800ULL},
    {'<', 0x000208208888ULL}, {'=', 0x000001F07C00ULL}, {'>', 0x000088882082ULL},
    {'A', 0x000463F8C544ULL}, {'B', 0x0003E317C62FULL}, {'C', 0x0003A210862EULL},
    {'D', 0x0001D318C527ULL}, {'E', 0x0007C217843FULL}, {'F', 0x00004217843FULL},
    {'G', 0x0007A31E862EULL}, {'H', 0x0004631FC631ULL}, {'I', 0x00038842108EULL},
    {'J', 0x00019284211CULL}, {'K', 0x000452519531ULL}, {'L', 0x0007C2108421ULL},
    {'M', 0x0004631AD771ULL}, {'N', 0x0004639AD671ULL}, {'O', 0x0003A318C62EULL},
    {'P', 0x00004217C62FULL}, {'Q', 0x00059358C62EULL}, {'R', 0x00045257C62FULL},
    {'S', 0x0003E107043EULL}, {'T', 0x00010842109FULL}, {'U', 0x0003A318C631ULL},
    {'V', 0x00011518C631ULL}, {'W', 0x0004775AC631ULL}, {'X', 0x000462A22A31ULL},
    {'Y', 0x000108422A31ULL}, {'Z', 0x0007C222221FULL}, {'_', 0x0007C0000000ULL},
    {'a', 0x0007A3E83800ULL}, {'b', 0x0003E318BC21ULL}, {'c', 0x00038210B800ULL},
    {'d', 0x0007A318FA10ULL}, {'e', 0x000383F8B800ULL}, {'f', 0x000084213C4CULL},
    {'g', 0x00743D18F800ULL}, {'h', 0x00046318BC21ULL}, {'i', 0x000388421804ULL},
    {'j', 0x003250843008ULL}, {'k', 0x00024A32A421ULL}, {'l', 0x000388421086ULL},
    {'m', 0x00056B5AAC00ULL}, {'n', 0x00046318BC00ULL}, {'o', 0x0003A318B800ULL},
    {'p', 0x00085F18BC00ULL}, {'q', 0x00843D18F800ULL}, {'r', 0x00004211B400ULL},
    {'s', 0x0003E0E0F800ULL}, {'t', 0x000304213C42ULL}, {'u', 0x0007A318C400ULL},
    {'v', 0x00011518C400ULL}, {'w', 0x0002AB5AD400ULL}, {'x', 0x000454454400ULL},
    {'y', 0x00743D18C400ULL}, {'z', 0x0007C4447C00ULL}, {'|', 0x000108421084ULL},
}};
/// For what the font lacks.
inline constexpr std::uint64_t unknown_dots = 0x7E318C63FULL;

}  // namespace facet::image
