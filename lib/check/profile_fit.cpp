#include "check/profile_fit.h"

#include <algorithm>

namespace raytree::check {
namespace {

constexpr std::size_t rays_looked_at = 2000;  // enough to tell courses apart
constexpr std::size_t few_causes = 20;        // that rounding alone may make

bool is_seen_in_trees(std::string_view axis) { return axis != "quantise" && axis != "gamma"; }

}  // namespace

Choices seen_in_trees(Choices choices) {
    std::erase_if(choices,
                  [](const Convention* choice) { return !is_seen_in_trees(choice->axis); });
    return choices;
}

std::size_t ProfileFit::causes(const Choices& choices, std::size_t enough,
                               const Slacks* slacks) const {
    const Rulebook& book = books_.of(choices);
    ReplayOptions options;
    options.rtol = rtol_;
    options.most_rays = rays_looked_at;
    options.enough = enough;
    options.slacks = slacks;
    Replay replay(book.place, book.names, book.laws, submission_, options);
    replay.run();
    return replay.causes();
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
    return *best;
}

bool ProfileFit::explained_by(const Choices& choices) const {
    const std::size_t left = causes(choices, few_causes);
    if (left == 0 || left >= few_causes) {
        return left == 0;
    }
    const Rulebook& book = books_.of(choices);
    ReplayOptions options;
    options.rtol = rtol_;
    options.most_rays = rays_looked_at;
    const Slacks slacks = slacks_of(book.place, book.names, book.laws, submission_, options);
    return causes(choices, 1, &slacks) == 0;
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
    return shown;
}

bool ProfileFit::is_doubtful(const Profile& profile, const Choices& shown) {
    const auto seen = std::ranges::count_if(profile.named, [](std::string_view choice) {
        return is_seen_in_trees(choice.substr(0, choice.find('=')));
    });
    return shown.size() == 1 && seen > 1;
}

Choices ProfileFit::excuses(const Choices& base) const {
    for (const Choices& choices : books_.alternatives(base)) {
        Choices differing = seen_in_trees(books_.differences(choices, base));
        if (!differing.empty() && explained_by(choices)) {
            return differing;
        }
    }
    return {};
}

}  // namespace raytree::check
