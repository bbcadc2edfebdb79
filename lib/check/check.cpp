#include "check/check.h"

#include <algorithm>
#include <exception>
#include <new>

#include "check/catalogue.h"
#include "check/diagnose.h"
#include "check/evidence.h"
#include "check/forge.h"
#include "check/profile_fit.h"
#include "check/tree_overlay.h"
#include "check/whole.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_truths = 64;  // kept for the next submission of the same pixel

constexpr std::size_t most_children = 1000;

constexpr std::size_t spare_rays = 2000;  // that a wrong tree may have too many of

/// Whether a ray has more children than lights and branches explain. No mistake of the catalogue
/// makes such a tree, and looking for one would go through them each time.
bool is_crowded(const Submission& submission) {
    return std::ranges::any_of(
        submission.children, [](const auto& children) { return children.size() > most_children; });
}

/// Other courses' conventions that explain a submission which is wrong by the profile that was
/// asked for, or by the lecture's where none was.
void look_for_conventions(const ProfileFit& fit, const Rulebook& book, const Finding& first,
                          Report& report) {
    if (!report.profile_asked_for && report.profile != profiles().front().name) {
        return;
    }
    const bool surely = !report.mistakes.empty() && report.mistakes.front().sure;
    Choices explain =
        fit.excuses(book.choices, first, surely ? report.mistakes.front().id : std::string());
    if (report.profile_asked_for) {
        report.conventions = std::move(explain);
        return;
    }
    for (const Convention* each : explain) {
        report.remarks.push_back(
            "some courses have it so, and nothing else is wrong: " + std::string(each->axis) + '=' +
            std::string(each->value) + ", " + std::string(each->text));
    }
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
    if (judged->causes() > 0 && options_.name_mistakes && !is_crowded(submission)) {
        diagnose(book.place, book.names, book.laws, submission, options, report);
    }
    const auto first =
        std::ranges::find_if(judged->findings(), [](const Finding& f) { return !f.follows_from; });
    if (first != judged->findings().end()) {
        look_for_conventions(ProfileFit(books_, submission, options_.rtol), book, *first, report);
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

/// By the profile that is asked for; else by the one that fits best, the lecture's among equals.
void Checker::judge_by_fitting(const Submission& submission, Report& report) const {
    if (options_.profile) {
        judge_by(profile_named(*options_.profile), submission, report);
        return;
    }
    const ProfileFit fit(books_, submission, options_.rtol);
    const Profile& lecture = profiles().front();
    const Profile& best = fit.best();
    Report by_lecture = report;
    const std::size_t before = report.causes();
    judge_by(best, submission, report);
    if (&best == &lecture) {
        return;
    }
    if (report.causes() > before) {
        judge_by(lecture, submission, by_lecture);
        if (by_lecture.causes() <= report.causes()) {
            report = std::move(by_lecture);
        }
        return;
    }
    report.conventions = fit.shown(best);
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
    if (!fits_scene(submission, scene_, books_.lecture().names, report.findings)) {
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
        look_for_contradictions(submission, books_.of(profile_named(report.profile)),
                                report.findings);
    }
    if (report.findings.empty()) {
        report.verdict = Verdict::pass;
        report.score = 1;
        return report;
    }
    const std::string& of_scene = submission.tree.scene_sha256;
    if (!of_scene.empty() && !options_.scene_sha256.empty() && of_scene != options_.scene_sha256) {
        report.remarks.push_back(
            "its scene.sha256 is not that of the scene's file: is it of another scene, or of "
            "another version of it?");
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
