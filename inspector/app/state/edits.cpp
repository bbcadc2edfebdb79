#include "state/edits.h"

namespace raytree::inspector {

void Edits::begin(Values values) {
    steps_ = {std::make_shared<const Values>(std::move(values))};
    here_ = 0;
    saved_ = steps_.front();
    on_the_way_.clear();
}

void Edits::add(Values values, const std::string& place, Pick how) {
    const bool same_change = how == Pick::on_the_way && goes_on(place);
    auto step = std::make_shared<const Values>(std::move(values));
    steps_.resize(here_ + 1);
    if (same_change) {
        steps_[here_] = std::move(step);
    } else {
        steps_.push_back(std::move(step));
        if (steps_.size() > most_) {
            steps_.erase(steps_.begin() + 1);  // the first is what reset goes back to
        }
        here_ = steps_.size() - 1;
    }
    on_the_way_ = how == Pick::on_the_way ? place : "";
}

void Edits::reset() {
    let_go();
    steps_.resize(here_ + 1);
    steps_.push_back(steps_.front());
    here_ = steps_.size() - 1;
}

void Edits::go_to(std::size_t place) {
    let_go();
    here_ = place;
}

}  // namespace raytree::inspector
