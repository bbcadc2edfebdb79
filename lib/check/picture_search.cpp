#include "check/picture_search.h"

#include <algorithm>
#include <set>

#include "check/catalogue.h"
#include "check/diagnose.h"
#include "check/lessons.h"
#include "check/picture_mistakes.h"

namespace raytree::check {
namespace {

constexpr std::size_t telling_that_differ = 56, telling_that_agree = 40;
constexpr std::size_t more_pixels = 500;  // to tell apart what the telling ones do not

using Places = std::vector<PixelPlace>;

/// Looks for conventions and mistakes that give the picture.
class PictureSearch {
  public:
    explicit PictureSearch(const PictureDifference& of)
        : checker_(of.checker),
          book_(of.book),
          truth_(of.truth),
          match_(of.match),
          differing_(of.differing) {
        telling_ = spread(of.differing, telling_that_differ);
        const Places sound = spread(of.agreeing, telling_that_agree);
        telling_.insert(telling_.end(), sound.begin(), sound.end());
        more_ = spread(of.differing, more_pixels);
        const Places rest = spread(of.agreeing, more_pixels);
        more_.insert(more_.end(), rest.begin(), rest.end());
    }

    /// The conventions of other courses that explain the picture; none where none do.
    Choices conventions() const {
        for (const Choices& choices : checker_.rulebooks().alternatives(book_.choices)) {
            const bool other_curve = gamma_of(choices) != gamma_of(book_.choices);
            if (!other_curve && explains(choices)) {
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

Choices conventions_of(const PictureDifference& difference) {
    return PictureSearch(difference).conventions();
}

std::vector<NamedMistake> mistakes_of(const PictureDifference& difference) {
    return PictureSearch(difference).mistakes();
}

}  // namespace raytree::check
