#include "scene/json_pointer.h"

namespace raytree {

std::string json_pointer_part(std::string_view key) {
    std::string part = "/";
    for (const char c : key) {
        if (c == '~') {
            part += "~0";
        } else if (c == '/') {
            part += "~1";
        } else {
            part += c;
        }
    }
    return part;
}

std::string JsonPlace::pointer() const {
    if (parent_ == nullptr) {
        return "";
    }
    return parent_->pointer() +
           (key_.data() == nullptr ? "/" + std::to_string(index_) : json_pointer_part(key_));
}

}  // namespace raytree
