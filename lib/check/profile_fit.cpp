#include "check/profile_fit.h"

#include <algorithm>

namespace raytree::check {
namespace {

constexpr std::size_t rays_looked_at = 2000;  // enough to tell courses apart

bool is_seen_in_trees(std::string_view axis) { return axis != "quantise" && axis != "gamma"; }

}  // namespace

Choices seen_in_trees(Choices choices) {
    std::erase_if(choices,
                  [](const Convention* choice) { return !is_seen_in_trees(choice->axis); });
    return choices;
}

Replay ProfileFit::replayed(const Rulebook& book, const ReplayOptions& options) const {
    Replay replay(book.place, book.names, book.laws, submission_, options);
    replay.run();
    return replay;
}

std::size_t ProfileFit::causes(const Choices& choices, std::size_t enough) const {
    ReplayOptions options;
    options.rtol = rtol_;
    options.most_rays = rays_looked_at;
    options.enough = enough;
    return replayed(books_.of(choices), options).causes();
}

const Profile& ProfileFit::best() const {
    const Profile* best = &profiles().front();
    std::size_t fewest = ~std::size_t{0};
    for (const Profile& profile : profiles()) {
        const std::size_t left = causes(books_.choices_of(profile), fewest);
        if (left < fewest) {
            best = &profile;
            fewest = left;
        }
        if (fewest == 0) {
            break;
        }
    }
    const Profile& lecture = profiles().front();
    return best != &lecture && explained_by(books_.choices_of(lecture)) ? lecture : *best;
}

/// What is wrong by other conventions at `first` is so by these too where it is hardly less: more
/// than the submission's rounding is behind it.
bool ProfileFit::explained_by(const Choices& choices, const Finding* first,
                              std::size_t less_than) const {
    const Rulebook& book = books_.of(choices);
    ReplayOptions options;
    options.rtol = rtol_;
    options.most_rays = rays_looked_at;
    options.enough = less_than;
    if (first && !submission_.precision.is_rounded()) {
        options.give_up_at = key_of(*first);
    }
    const Replay plain = replayed(book, options);
    if (plain.causes() == 0 || plain.causes() >= less_than) {
        return plain.causes() == 0;
    }
    const auto is_left = [first](const Finding& left) {
        return !left.follows_from && key_of(left) == key_of(*first) &&
               2 * left.error >= first->error;
    };
    if (first && std::ranges::any_of(plain.findings(), is_left)) {
        return false;
    }
    const Slacks slacks = slacks_of(book.place, book.names, book.laws, submission_, options);
    options.slacks = &slacks;
    options.enough = 1;
    return replayed(book, options).causes() == 0;
}

Choices ProfileFit::shown(const Profile& profile) const {
    const Choices lecture = books_.choices_of(profiles().front());
    const Choices whole = books_.choices_of(profile);
    Choices shown;
    for (const Convention* each : seen_in_trees(books_.differences(whole, lecture))) {
        Choices without = whole;
        const auto place = std::ranges::find(whole, each) - whole.begin();
        without[static_cast<std::size_t>(place)] = lecture[static_cast<std::size_t>(place)];
        if (!explained_by(without)) {
            shown.push_back(each);
        }
    }
    return shown.empty() ? seen_in_trees(books_.differences(whole, lecture)) : shown;
}

Choices ProfileFit::excuses(const Choices& base, const Finding& first,
                            std::string_view mistake) const {
    // What explains everything leaves fewer causes, those that rounding makes.
    const std::size_t less_than = std::min(causes(base, most_), most_);
    for (const Choices& choices : books_.alternatives(base)) {
        const auto [other, of_base] = std::ranges::mismatch(choices, base);
        if (!mistake.empty() && (*other)->mistake != mistake && !(*other)->mistake.empty()) {
            continue;
        }
        if (!explained_by(choices, &first, less_than)) {
            continue;
        }
        if (Choices differing = seen_in_trees(books_.differences(choices, base));
            !differing.empty()) {
            return differing;
        }
    }
    return {};
}

}  // namespace raytree::check
