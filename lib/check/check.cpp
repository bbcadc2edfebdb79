#include "check/check.h"

#include <algorithm>
#include <exception>
#include <new>

#include "check/catalogue.h"
#include "check/diagnose.h"
#include "check/forge.h"
#include "check/tree_overlay.h"
#include "check/whole.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_truths = 64;  // kept for the next submission of the same pixel

constexpr std::size_t rays_for_profiles = 2000;  // enough to tell courses apart
constexpr std::size_t few_causes = 20;           // that rounding alone may make

constexpr std::size_t most_children = 1000;

constexpr std::size_t spare_rays = 2000;  // that a wrong tree may have too many of

/// How colours are made 8 bits is seen in pictures alone.
Choices seen_in_trees(Choices choices) {
    std::erase_if(choices, [](const Convention* choice) {
        return choice->axis == "quantise" || choice->axis == "gamma";
    });
    return choices;
}

/// Whether a ray has more children than lights and branches explain. No mistake of the catalogue
/// makes such a tree, and looking for one would go through them each time.
bool is_crowded(const Submission& submission) {
    return std::ranges::any_of(
        submission.children, [](const auto& children) { return children.size() > most_children; });
}

}  // namespace

std::size_t Report::causes() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(findings, [](const Finding& f) { return !f.follows_from; }));
}

Checker::Checker(const Scene& scene, CheckOptions options)
    : scene_(scene), books_(scene, options.course_text), options_(std::move(options)) {}

Checker::Truth Checker::truth_at(const Rulebook& book, int i, int j) const {
    const std::string key =
        text_of(book.choices) + ' ' + std::to_string(i) + ',' + std::to_string(j);
    {
        const std::lock_guard lock(mutex_);
        const auto found = truths_.find(key);
        if (found != truths_.end()) {
            return found->second;
        }
    }
    const auto truth =
        std::make_shared<const RayTree<double>>(forge_tree(book.place, book.laws, i, j));
    const std::lock_guard lock(mutex_);
    if (truths_.size() >= most_truths) {
        truths_.clear();
    }
    return truths_.emplace(key, truth).first->second;
}

/// The profile with the fewest causes of differences; the first of equals.
const Profile& Checker::best_profile(const Submission& submission) const {
    const Profile* best = &profiles().front();
    ReplayOptions options;
    options.rtol = options_.rtol;
    options.most_rays = rays_for_profiles;
    std::size_t fewest = ~std::size_t{0};
    for (const Profile& profile : profiles()) {
        options.enough = fewest;
        const Rulebook& book = books_.of(profile);
        Replay replay(book.place, book.names, book.laws, submission, options);
        replay.run();
        if (replay.causes() < fewest) {
            best = &profile;
            fewest = replay.causes();
        }
        if (fewest == 0) {
            break;
        }
    }
    return *best;
}

bool Checker::explains_all(const Submission& submission, const Choices& choices) const {
    const Rulebook& book = books_.of(choices);
    ReplayOptions options;
    options.rtol = options_.rtol;
    options.most_rays = rays_for_profiles;
    const auto causes = [&](std::size_t enough) {
        options.enough = enough;
        Replay replay(book.place, book.names, book.laws, submission, options);
        replay.run();
        return replay.causes();
    };
    const std::size_t left = causes(few_causes);
    if (left == 0 || left >= few_causes) {
        return left == 0;
    }
    const Slacks slacks = slacks_of(book.place, book.names, book.laws, submission, options);
    options.slacks = &slacks;
    return causes(1) == 0;
}

/// What other courses do that would make all of it right: one convention, or a course's.
void Checker::look_for_conventions(const Submission& submission, const Choices& base,
                                   Report& report) const {
    for (const Choices& choices : books_.alternatives(base)) {
        const Choices differing = seen_in_trees(books_.differences(choices, base));
        if (!differing.empty() && explains_all(submission, choices)) {
            report.conventions = differing;
            return;
        }
    }
}

void Checker::judge(const Submission& submission, const Rulebook& book, Report& report) const {
    const Truth truth = truth_at(book, submission.tree.pixel_i, submission.tree.pixel_j);
    ReplayOptions options;
    options.rtol = options_.rtol;
    options.truth = truth.get();
    if (submission.tree.rays.size() > 4 * truth->rays.size() + spare_rays) {
        report.findings.push_back(of_the_whole(
            "rays", "it has " + std::to_string(submission.tree.rays.size()) +
                        " rays, the true tree has " + std::to_string(truth->rays.size()) +
                        "; only the first are looked at"));
        options.most_rays = spare_rays;
    }
    Slacks slacks;
    std::optional<Replay> judged;
    const auto replay = [&] {
        report.tally = {};
        options.tally = &report.tally;
        judged.emplace(book.place, book.names, book.laws, submission, options);
        judged->run();
        options.tally = nullptr;
    };
    replay();
    if (judged->causes() > 0) {
        slacks = slacks_of(book.place, book.names, book.laws, submission, options);
        options.slacks = &slacks;
        replay();
    }
    report.compared = judged->compared();
    const std::size_t before = report.findings.size();
    for (Finding finding : judged->findings()) {
        if (finding.follows_from) {
            *finding.follows_from += before;
        }
        report.findings.push_back(std::move(finding));
    }
    if (judged->causes() > 0 && report.profile_asked_for) {
        look_for_conventions(submission, book.choices, report);
    }
    if (judged->causes() > 0 && options_.name_mistakes && !is_crowded(submission)) {
        diagnose(book.place, book.names, book.laws, submission, options, report);
    }
    for (const NamedMistake& mistake : report.mistakes) {
        if (options_.suggest_pixels && !mistake.ties.empty()) {
            std::vector<std::string> candidates = mistake.ties;
            candidates.insert(candidates.begin(), mistake.id);
            for (std::string& text :
                 suggestions(book.place, book.laws, candidates, options_.suggested_scenes)) {
                report.telling_pixels.push_back(std::move(text));
            }
        }
    }
}

/// By the profile that is asked for; else by the lecture's or, where it explains more, by the one
/// that fits best.
void Checker::judge_by_fitting(const Submission& submission, Report& report) const {
    if (options_.profile) {
        judge_by(profile_named(*options_.profile), submission, report);
        return;
    }
    const Profile& lecture = profiles().front();
    const Profile& best = best_profile(submission);
    Report by_best = report;
    judge_by(best, submission, by_best);
    if (&best != &lecture && by_best.causes() > report.causes()) {
        Report by_lecture = report;
        judge_by(lecture, submission, by_lecture);
        if (by_lecture.causes() <= by_best.causes()) {
            by_best = std::move(by_lecture);
        }
    }
    report = std::move(by_best);
}

void Checker::judge_by(const Profile& profile, const Submission& submission, Report& report) const {
    report.profile = profile.name;
    const Rulebook& book = books_.of(profile);
    if (!report.profile_asked_for) {
        report.conventions =
            seen_in_trees(books_.differences(book.choices, books_.lecture().choices));
    }
    judge(submission, book, report);
}

Report Checker::check(const Submission& submission) const {
    Report report;
    report.file = submission.file;
    report.rays = submission.tree.rays.size();
    report.ids = submission.ids;
    report.remarks = submission.remarks;
    report.precision = submission.precision.name;
    report.verdict = Verdict::fail;
    report.profile = options_.profile.value_or(std::string(profiles().front().name));
    report.profile_asked_for = options_.profile.has_value();
    if (!fits_scene(submission, scene_, report.findings)) {
        return report;
    }
    look_for_missing_fields(submission, options_.required, report.findings, report.remarks);
    for (const NotNumber& none : submission.not_numbers) {
        report.findings.push_back(
            of_the_whole(none.place, none.key + " is not a number (NaN, infinity or null)"));
    }
    judge_by_fitting(submission, report);
    const bool explained = !report.mistakes.empty() && tells_enough(report);
    if (!submission.not_numbers.empty() && !explained && options_.name_mistakes) {
        NamedMistake none = named_mistake(*find_mistake("num.nan"));
        none.rays = std::min(report.rays, submission.not_numbers.size());
        report.mistakes = {std::move(none)};
    }
    if (report.compared == 0) {
        report.findings.push_back(
            of_the_whole("rays", "it gives no quantity that could be compared"));
    }
    if (report.findings.empty()) {
        report.verdict = Verdict::pass;
        report.score = 1;
        return report;
    }
    const double all = static_cast<double>(std::max(report.compared, report.findings.size()));
    report.score = 1 - static_cast<double>(report.findings.size()) / all;
    return report;
}

Report refused(const std::string& name, const std::string& why) {
    Report report;
    report.file = name;
    report.findings.push_back(of_the_whole("", why));
    return report;
}

Report Checker::check_text(const std::string& text, const std::string& name) const {
    Report report;
    report.file = name;
    try {
        return check(parse_submission(text, name));
    } catch (const InputError& error) {
        for (const Mistake& mistake : error.mistakes()) {
            report.findings.push_back(of_the_whole(mistake.place, mistake.text));
        }
        return report;
    } catch (const std::bad_alloc&) {
        return refused(name, "needs more memory than there is");
    } catch (const std::exception& error) {
        return refused(name, error.what());
    }
}

std::string Checker::overlay(const std::string& text, const Report& report) const {
    if (report.verdict == Verdict::unreadable || report.compared == 0) {
        return "";
    }
    const Submission submission = parse_submission(text, report.file);
    const Rulebook& book = books_.of(profile_named(report.profile));
    const Truth truth = truth_at(book, submission.tree.pixel_i, submission.tree.pixel_j);
    return write_tree_overlay(submission, *truth, report);
}

Report Checker::check_file(const std::filesystem::path& file, const std::string& name) const {
    try {
        return check_text(load_submission_text(file), name);
    } catch (const InputError& error) {
        return refused(name, error.mistakes().front().text);
    }
}

}  // namespace raytree::check
