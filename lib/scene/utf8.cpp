#include "scene/utf8.h"

namespace raytree {
namespace {

/// ASCII's control characters and those of Latin 1, U+0080 to U+009F, which begin escape sequences
/// as well.
bool is_control(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    return character.size() == 1 ? byte(0) < 0x20 || byte(0) == 0x7F
                                 : character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;
}

/// What hides or turns the text around it: spaces of no width, line separators, and the marks that
/// set the direction of writing (U+200B, U+200E, U+200F, U+2028 to U+202E, U+2060 to U+2069,
/// U+FEFF).
bool misleads(std::string_view character) {
    const auto in = [&](std::string_view from, std::string_view to) {
        return character.size() == 3 && from <= character && character <= to;
    };
    return in("\xE2\x80\x8B", "\xE2\x80\x8B") || in("\xE2\x80\x8E", "\xE2\x80\x8F") ||
           in("\xE2\x80\xA8", "\xE2\x80\xAE") || in("\xE2\x81\xA0", "\xE2\x81\xA9") ||
           character == "\xEF\xBB\xBF";
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) {
        return 1;
    }
    if (lead >= 0xC2 && lead <= 0xDF) {
        return follows(1) ? 2 : 0;
    }
    if (lead >= 0xE0 && lead <= 0xEF) {
        const bool second = follows(1, lead == 0xE0 ? 0xA0 : 0x80, lead == 0xED ? 0x9F : 0xBF);
        return second && follows(2) ? 3 : 0;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        const bool second = follows(1, lead == 0xF0 ? 0x90 : 0x80, lead == 0xF4 ? 0x8F : 0xBF);
        return second && follows(2) && follows(3) ? 4 : 0;
    }
    return 0;
}

std::string legible(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, length);
        const bool shown = length > 0 && !is_control(character) && !misleads(character);
        out += shown ? character : "\xEF\xBF\xBD";
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

}  // namespace raytree
