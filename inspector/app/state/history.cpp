#include "state/history.h"

namespace raytree::inspector {

void History::begin(Pixel pixel) {
    pixels_ = {pixel};
    here_ = 0;
    on_the_way_ = false;
}

void History::add(Pixel pixel, Pick how) {
    constexpr std::size_t longest = 1000;
    const bool replaces = how == Pick::on_the_way && on_the_way_;
    pixels_.resize(pixels_.empty() ? 0 : here_ + (replaces ? 0 : 1));
    pixels_.push_back(pixel);
    if (pixels_.size() > longest) {
        pixels_.pop_front();
    }
    here_ = pixels_.size() - 1;
    on_the_way_ = how == Pick::on_the_way;
}

std::optional<Pixel> History::at(int by) const {
    const auto place = static_cast<std::ptrdiff_t>(here_) + by;
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(pixels_.size())) {
        return std::nullopt;
    }
    return pixels_[static_cast<std::size_t>(place)];
}

void History::go(int by) {
    here_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(here_) + by);
    on_the_way_ = false;
}

}  // namespace raytree::inspector
