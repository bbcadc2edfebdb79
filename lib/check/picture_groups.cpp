#include "check/picture_groups.h"

#include <algorithm>
#include <map>
#include <set>

#include "check/forge.h"
#include "check/tree_features.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t grouped = 1200;  // pixels that differ, and as many that do not
constexpr std::size_t most_groups = 4;

using Places = std::vector<PixelPlace>;

/// What the pixels that differ have in common, the largest group first.
class Groups {
  public:
    Groups(const Rulebook& book, const Places& differing, const Places& agreeing)
        : share_(differing.empty() ? 1
                                   : static_cast<double>(differing.size()) /
                                         static_cast<double>(std::min(differing.size(), grouped))) {
        left_ = seen(book, spread(differing, grouped));
        agreeing_ = seen(book, spread(agreeing, grouped));
    }

    std::vector<Finding> findings(std::size_t all) {
        std::vector<Finding> found;
        const std::size_t in_all = left_.size();
        while (!left_.empty() && found.size() < most_groups) {
            const std::string feature = best_feature();
            const auto has = [&](const Seen& pixel) { return pixel.features.contains(feature); };
            const auto count = static_cast<std::size_t>(std::ranges::count_if(left_, has));
            if (feature.empty() || 20 * count < in_all) {
                break;
            }
            const auto sound = static_cast<std::size_t>(std::ranges::count_if(agreeing_, has));
            const PixelPlace example = std::ranges::find_if(left_, has)->at;
            found.push_back(finding(feature, count, in_all, sound, example, all));
            std::erase_if(left_, has);
        }
        return found;
    }

  private:
    struct Seen {
        PixelPlace at;
        std::set<std::string> features;
    };

    static std::vector<Seen> seen(const Rulebook& book, const Places& at) {
        std::vector<Seen> all;
        for (const PixelPlace& pixel : at) {
            try {
                all.push_back(
                    {pixel, features_of(forge_tree(book.place, book.laws, pixel.i, pixel.j))});
            } catch (const InputError&) {
                all.push_back({pixel, {"the intensities grow out of range"}});
            }
        }
        return all;
    }

    /// The one that most of those left have and fewest of those that agree.
    std::string best_feature() const {
        std::map<std::string, std::pair<double, double>> shares;
        for (const Seen& pixel : left_) {
            for (const std::string& feature : pixel.features) {
                shares[feature].first += 1 / static_cast<double>(left_.size());
            }
        }
        for (const Seen& pixel : agreeing_) {
            for (const std::string& feature : pixel.features) {
                shares[feature].second += 1 / static_cast<double>(agreeing_.size());
            }
        }
        std::string best;
        double most = 0;
        for (const auto& [feature, share] : shares) {
            const double gain = share.first * share.first - 0.8 * share.second;
            if (gain > most || best.empty()) {
                most = gain;
                best = feature;
            }
        }
        return best;
    }

    Finding finding(const std::string& feature, std::size_t count, std::size_t in_all,
                    std::size_t sound, PixelPlace example, std::size_t all) const {
        const auto pixels = static_cast<std::size_t>(static_cast<double>(count) * share_ + 0.5);
        const bool whole = count == in_all;
        std::string text = (whole ? "all " : "") + std::to_string(pixels) +
                           (whole ? " that differ" : " differ") + " where " + feature +
                           ", such as " + pixel_text(example);
        if (sound == 0) {
            text += "; where it is not so, none differs";
            text = whole ? text : text.substr(0, text.find("; "));
        } else if (!agreeing_.empty()) {
            text += "; some pixels like these are right";
        }
        return of_pixels(std::move(text), pixels, all);
    }

    double share_;  ///< pixels for each that is looked at
    std::vector<Seen> left_, agreeing_;
};

}  // namespace

Finding of_pixels(std::string reason, std::size_t pixels, std::size_t all) {
    Finding finding;
    finding.problem = Problem::whole;
    finding.subject = "pixels";
    finding.reason = std::move(reason);
    finding.expected.numbers = {1, {0, 0, 0}};
    finding.found.numbers = {1, {static_cast<double>(pixels), 0, 0}};
    finding.error =
        static_cast<double>(pixels) / static_cast<double>(std::max<std::size_t>(all, 1));
    return finding;
}

std::string pixel_text(PixelPlace at) { return std::to_string(at.i) + ',' + std::to_string(at.j); }

std::vector<Finding> groups_of_pixels(const Rulebook& book, const Places& differing,
                                      const Places& agreeing, std::size_t all) {
    return Groups(book, differing, agreeing).findings(all);
}

}  // namespace raytree::check
