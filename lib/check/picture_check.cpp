#include "check/picture_check.h"

#include <algorithm>
#include <functional>
#include <map>
#include <new>
#include <set>

#include "check/catalogue.h"
#include "check/forge.h"
#include "check/lessons.h"
#include "check/picture_mistakes.h"
#include "check/picture_values.h"
#include "check/tree_features.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t tried_by_profiles = 400;  // pixels, of all
constexpr std::size_t telling_that_differ = 56, telling_that_agree = 40;
constexpr std::size_t more_pixels = 500;  // to tell apart what the telling ones do not
constexpr std::size_t most_ties_tried = 2000;
constexpr std::size_t grouped = 1200;  // pixels that differ, and as many that do not
constexpr std::size_t most_groups = 4;

using Places = std::vector<PixelPlace>;

Places all_places(const ReadPicture& picture) {
    Places all;
    all.reserve(picture.pixels.size());
    for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
            all.push_back({i, j});
        }
    }
    return all;
}

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
            text += "; some with that are right";
        }
        return of_pixels(std::move(text), pixels, all);
    }

    double share_;  ///< pixels for each that is looked at
    std::vector<Seen> left_, agreeing_;
};

/// Looks for conventions and mistakes that give the picture.
class PictureSearch {
  public:
    PictureSearch(const Checker& checker, const Rulebook& book, const Picture& truth,
                  const PixelMatch& match, const Places& differing, const Places& agreeing)
        : checker_(checker), book_(book), truth_(truth), match_(match), differing_(differing) {
        telling_ = spread(differing, telling_that_differ);
        const Places sound = spread(agreeing, telling_that_agree);
        telling_.insert(telling_.end(), sound.begin(), sound.end());
        more_ = spread(differing, more_pixels);
        const Places rest = spread(agreeing, more_pixels);
        more_.insert(more_.end(), rest.begin(), rest.end());
    }

    /// The conventions of other courses that explain the picture; none where none do.
    Choices conventions() const {
        for (const Choices& choices : checker_.rulebooks().alternatives(book_.choices)) {
            if (explains(choices)) {
                return needed(choices);
            }
        }
        return {};
    }

    std::vector<NamedMistake> mistakes() const {
        std::vector<Candidate> found = fitting(telling_, few_);
        if (found.empty()) {
            return {};
        }
        for (Candidate& candidate : found) {
            candidate.left = misses(candidate, more_);
        }
        std::ranges::stable_sort(found, {}, &Candidate::left);
        keep_best_ways(found);
        const std::size_t fewest = found.front().left;
        std::erase_if(found, [&](const Candidate& c) { return c.left > fewest + allowed() / 2; });
        if (fewest > more_.size() / 10) {
            return {};
        }
        NamedMistake best;
        const Candidate& first = found.front();
        best.id = first.row ? first.row->id : first.picture_row->id;
        best.text = first.row ? first.row->text : first.picture_row->text;
        best.topic = first.row ? first.row->topic : first.picture_row->topic;
        best.lesson = lesson_of(best.id).name();
        best.sure = found.size() == 1 && fewest <= allowed();
        best.rays = differing_.size();
        for (std::size_t k = 1; k < found.size(); ++k) {
            best.ties.emplace_back(found[k].row ? found[k].row->id : found[k].picture_row->id);
        }
        return {best};
    }

  private:
    struct Candidate {
        const MistakeRow* row = nullptr;
        LawChange way = nullptr;
        const PictureMistakeRow* picture_row = nullptr;
        std::size_t left = 0;
    };

    /// Of each mistake the way that leaves the fewest; they are sorted.
    static void keep_best_ways(std::vector<Candidate>& found) {
        std::set<const MistakeRow*> seen;
        std::erase_if(found, [&](const Candidate& candidate) {
            return candidate.row && !seen.insert(candidate.row).second;
        });
    }

    std::size_t allowed() const { return 1 + more_.size() / 200; }

    std::size_t misses(const Candidate& candidate, const Places& at,
                       std::size_t enough = ~std::size_t{0}) const {
        if (candidate.row) {
            Laws laws = book_.laws;
            candidate.way(laws);
            return match_.misses(book_.place, laws, at, enough);
        }
        return static_cast<std::size_t>(std::ranges::count_if(at, [&](const PixelPlace& pixel) {
            return !match_(pixel, candidate.picture_row->colour(truth_, pixel));
        }));
    }

    std::vector<Candidate> fitting(const Places& at, std::size_t most) const {
        std::vector<Candidate> all, found;
        for (const PictureMistakeRow& row : picture_mistakes()) {
            all.push_back({nullptr, nullptr, &row, 0});
        }
        for (const MistakeRow& row : catalogue()) {
            for (const LawChange way : row.ways()) {
                all.push_back({&row, way, nullptr, 0});
            }
        }
        for (Candidate& candidate : all) {
            candidate.left = misses(candidate, at, most + 1);
            if (candidate.left <= most) {
                found.push_back(candidate);
            }
        }
        return found;
    }

    bool explains(const Choices& choices) const {
        const Rulebook& book = checker_.rulebooks().of(choices);
        return match_.misses(book.place, book.laws, telling_, few_ + 1) <= few_ &&
               match_.misses(book.place, book.laws, more_, allowed() + 1) <= allowed();
    }

    /// Those of them without which it is not explained.
    Choices needed(Choices choices) const {
        for (std::size_t k = 0; k < choices.size(); ++k) {
            Choices less = choices;
            less[k] = book_.choices[k];
            if (less[k] != choices[k] && explains(less)) {
                choices = less;
            }
        }
        return checker_.rulebooks().differences(choices, book_.choices);
    }

    static constexpr std::size_t few_ = 3;  // of the telling pixels: ties that rounding decides
    const Checker& checker_;
    const Rulebook& book_;
    const Picture& truth_;
    const PixelMatch& match_;
    const Places& differing_;
    Places telling_, more_;
};

}  // namespace

std::shared_ptr<const Picture> PictureChecker::truth_by(const Rulebook& book) const {
    const std::string key = text_of(book.choices);
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const Picture>& truth = truths_[key];
    if (!truth) {
        truth = std::make_shared<const Picture>(picture_by(book));
    }
    return truth;
}

/// The profile by which the fewest of some pixels differ, those among them that the lecture gets
/// wrong; the first of equals.
const Profile& PictureChecker::best_profile(const ReadPicture& picture) const {
    const PixelMatch match(picture, checker_.options().rtol);
    const auto lecture = truth_by(checker_.rulebooks().lecture());
    Places all = all_places(picture), differing;
    std::ranges::copy_if(all, std::back_inserter(differing),
                         [&](const PixelPlace& at) { return !match(at, lecture->at(at.i, at.j)); });
    Places some = spread(differing, tried_by_profiles);
    const Places rest = spread(all, tried_by_profiles);
    some.insert(some.end(), rest.begin(), rest.end());
    const Profile* best = &profiles().front();
    std::size_t fewest = ~std::size_t{0};
    for (const Profile& profile : profiles()) {
        const Rulebook& book = checker_.rulebooks().of(profile);
        const std::size_t misses = match.misses(book.place, book.laws, some, fewest);
        if (misses < fewest) {
            fewest = misses;
            best = &profile;
        }
    }
    return *best;
}

Report PictureChecker::judge(const ReadPicture& picture, const std::string& name) const {
    const CheckOptions& options = checker_.options();
    Report report;
    report.file = name;
    report.verdict = Verdict::fail;
    report.compares = "pixels";
    report.compared = picture.pixels.size();
    report.precision = picture.eight_bit ? "8 bits" : "float";
    report.profile_asked_for = options.profile.has_value();
    const PixelMatch match(picture, options.rtol);
    const Places all = all_places(picture);
    const Profile& profile =
        options.profile ? profile_named(*options.profile) : best_profile(picture);
    report.profile = profile.name;
    const Rulebook& book = checker_.rulebooks().of(profile);
    if (!report.profile_asked_for) {
        report.conventions =
            checker_.rulebooks().differences(book.choices, checker_.rulebooks().lecture().choices);
    }
    const std::shared_ptr<const Picture> truth = truth_by(book);
    Places differing, agreeing;
    for (const PixelPlace& at : all) {
        (match(at, truth->at(at.i, at.j)) ? agreeing : differing).push_back(at);
    }
    std::size_t ties = 0;
    if (differing.size() <= most_ties_tried) {
        ties = std::erase_if(differing,
                             [&](const PixelPlace& at) { return is_near_tie(book, match, at); });
    }
    if (ties > 0) {
        report.remarks.push_back(std::to_string(ties) +
                                 " pixels hang on rounding and are not held against it");
    }
    report.score = 1 - static_cast<double>(differing.size()) /
                           static_cast<double>(std::max<std::size_t>(all.size(), 1));
    if (differing.empty()) {
        report.verdict = Verdict::pass;
        return report;
    }
    report.findings.push_back(of_pixels(std::to_string(differing.size()) + " of " +
                                            std::to_string(all.size()) + " differ, such as " +
                                            pixel_text(differing[differing.size() / 2]),
                                        differing.size(), all.size()));
    for (Finding& group : Groups(book, differing, agreeing).findings(all.size())) {
        group.follows_from = 0;
        report.findings.push_back(std::move(group));
    }
    const PictureSearch search(checker_, book, *truth, match, differing, agreeing);
    if (report.profile_asked_for) {
        report.conventions = search.conventions();
    }
    if (options.name_mistakes && (!report.profile_asked_for || report.conventions.empty())) {
        report.mistakes = search.mistakes();
    }
    return report;
}

Report PictureChecker::check(std::string_view bytes, const std::string& name) const {
    const Camera& camera = checker_.scene().camera;
    try {
        return judge(read_picture(bytes, "", {camera.width, camera.height}), name);
    } catch (const InputError& error) {
        const Mistake& mistake = error.mistakes().front();
        return refused(name,
                       mistake.place.empty() ? mistake.text : mistake.place + ": " + mistake.text);
    } catch (const std::bad_alloc&) {
        return refused(name, "needs more memory than there is");
    } catch (const std::exception& error) {
        return refused(name, error.what());
    }
}

}  // namespace raytree::check
