#include "check/picture_check.h"

#include <algorithm>
#include <functional>
#include <new>

#include "check/picture_groups.h"
#include "check/picture_search.h"
#include "check/picture_values.h"
#include "formats/image.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t tried_by_profiles = 400;  // pixels, of all
constexpr std::size_t most_ties_tried = 2000;
const Spectrum different(0.70, 0.15, 0.12);  // how a pixel that differs is drawn

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
        if (gamma_of(book.choices) != 1) {
            continue;  // the model has no such curve unless it is asked for
        }
        const std::size_t misses = match.misses(book.place, book.laws, some, fewest);
        if (misses < fewest) {
            fewest = misses;
            best = &profile;
        }
    }
    return *best;
}

/// By the profile that is asked for; else by the one that fits best, unless it explains hardly more
/// than the lecture does: what is wrong throughout is hardly less wrong by any.
Report PictureChecker::judge(const ReadPicture& picture, const std::string& name) const {
    const std::optional<std::string>& asked_for = checker_.options().profile;
    const Profile& lecture = profiles().front();
    const Profile& best = asked_for ? profile_named(*asked_for) : best_profile(picture);
    Report report = judge_by(best, picture, name);
    const bool explained = report.verdict == Verdict::pass || !report.mistakes.empty();
    if (asked_for || &best == &lecture || explained) {
        return report;
    }
    Report by_lecture = judge_by(lecture, picture, name);
    const bool fits = 2 * (1 - report.score) <= 1 - by_lecture.score;
    return fits && by_lecture.mistakes.empty() ? report : by_lecture;
}

Report PictureChecker::judge_by(const Profile& profile, const ReadPicture& picture,
                                const std::string& name) const {
    const CheckOptions& options = checker_.options();
    Report report;
    report.file = name;
    report.verdict = Verdict::fail;
    report.compares = "pixels";
    report.compared = picture.pixels.size();
    report.precision = picture.eight_bit ? "8 bits" : "float";
    report.profile_asked_for = options.profile.has_value();
    const Places all = all_places(picture);
    report.profile = profile.name;
    const Rulebook& book = checker_.rulebooks().of(profile);
    const PixelMatch match(picture, options.rtol, gamma_of(book.choices));
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
                                 (ties == 1
                                      ? " pixel hangs on rounding and is not held against it"
                                      : " pixels hang on rounding and are not held against it"));
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
    for (Finding& group : groups_of_pixels(book, differing, agreeing, all.size())) {
        group.follows_from = 0;
        report.findings.push_back(std::move(group));
    }
    const PictureDifference difference{checker_, book, *truth, match, differing, agreeing};
    if (report.profile_asked_for) {
        report.conventions = conventions_of(difference);
    }
    if (options.name_mistakes && (!report.profile_asked_for || report.conventions.empty())) {
        report.mistakes = mistakes_of(difference);
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

std::string PictureChecker::overlay(std::string_view bytes, const Report& report) const {
    if (report.verdict == Verdict::unreadable) {
        return "";
    }
    const Camera& camera = checker_.scene().camera;
    const ReadPicture picture = read_picture(bytes, "", {camera.width, camera.height});
    const Rulebook& book = checker_.rulebooks().of(profile_named(report.profile));
    const auto truth = truth_by(book);
    const double gamma = gamma_of(book.choices);
    const PixelMatch match(picture, checker_.options().rtol, gamma);
    const auto columns = static_cast<std::size_t>(camera.width);
    Picture drawn{3 * camera.width, camera.height, {}};
    drawn.pixels.resize(3 * columns * static_cast<std::size_t>(camera.height));
    for (const PixelPlace& at : all_places(picture)) {
        Spectrum* const row = &drawn.pixels[3 * columns * static_cast<std::size_t>(at.j)];
        const auto column = static_cast<std::size_t>(at.i);
        const Rgb<float>& found = picture.at(at.i, at.j);
        const Spectrum& due = truth->at(at.i, at.j);
        const double grey = 0.85 - 0.45 * std::clamp((due.r + due.g + due.b) / 3, 0.0, 1.0);
        row[column] = Spectrum(found.r, found.g, found.b);
        row[columns + column] = through_curve(due, gamma);
        row[2 * columns + column] = match(at, due) ? Spectrum(grey) : different;
    }
    return encode_png(quantized(drawn, Quantize::round).image);
}

}  // namespace raytree::check
