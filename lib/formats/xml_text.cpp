#include "formats/xml_text.h"

#include <algorithm>

#include "formats/json_parse.h"
#include "formats/json_text.h"

namespace raytree {

std::string xml_text(std::string_view text) {
    // The JSON writer knows what is UTF-8 and replaces what is not.
    const bool ascii = std::ranges::none_of(text, [](char c) { return (c & 0x80) != 0; });
    const std::string valid =
        ascii ? std::string(text) : Json::parse(json_string(text)).get<std::string>();
    std::string out;
    for (const char c : valid) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
        }
    }
    return out;
}

}  // namespace raytree
