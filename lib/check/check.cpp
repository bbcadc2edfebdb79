#include "check/check.h"

#include <algorithm>
#include <exception>
#include <new>

#include "check/conventions.h"
#include "check/diagnose.h"
#include "check/forge.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_truths = 64;  // kept for the next submission of the same pixel

constexpr std::size_t spare_rays = 2000;  // that a wrong tree may have too many of

Finding of_the_whole(std::string subject, std::string reason) {
    Finding finding;
    finding.problem = Problem::whole;
    finding.subject = std::move(subject);
    finding.reason = std::move(reason);
    finding.error = 1;
    return finding;
}

bool near(const Point& a, const Point& b) {
    return largest_component(a - b) <= 1e-4 * std::max(1.0, largest_component(b));
}

bool same(const Camera& a, const Camera& b) {
    return near(a.eye, b.eye) && near(a.look_at, b.look_at) && a.width == b.width &&
           a.height == b.height && a.window.index() == b.window.index();
}

/// A setting that the submission states, other than the scene's. What it leaves out is read as the
/// default.
std::string other_setting(const Settings& stated, const Settings& due) {
    const Settings usual;
    const auto differs = [](const auto& a, const auto& b, const auto& c) {
        return a != b && a != c;
    };
    if (differs(stated.max_depth, due.max_depth, usual.max_depth)) {
        return "max_depth";
    }
    if (differs(stated.specular_model, due.specular_model, usual.specular_model)) {
        return "specular_model";
    }
    if (differs(stated.shadows, due.shadows, usual.shadows)) {
        return "shadows";
    }
    if (differs(stated.pixel_sample, due.pixel_sample, usual.pixel_sample)) {
        return "pixel_sample";
    }
    const bool reflects = stated.total_internal_reflection != due.total_internal_reflection &&
                          stated.total_internal_reflection != usual.total_internal_reflection;
    return reflects ? "total_internal_reflection" : "";
}

/// Whether a ray of this sort has the field at all.
bool can_give(const TreeRay<double>& ray, Field field) {
    const bool of_light = field >= Field::light && field <= Field::transmittance;
    if (ray.shadow) {
        return of_light || field == Field::origin || field == Field::direction ||
               field == Field::diffuse || field == Field::specular;
    }
    const bool of_hit = (field >= Field::object && field <= Field::cos_incident) ||
                        field == Field::ambient || field == Field::diffuse ||
                        field == Field::specular;
    const bool rare =
        field == Field::eta || field == Field::sin2_transmitted || field == Field::termination;
    return !of_light && !rare && (!of_hit || ray.hit);
}

}  // namespace

std::size_t Report::causes() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(findings, [](const Finding& f) { return !f.follows_from; }));
}

Checker::Checker(const Scene& scene, CheckOptions options)
    : place_(scene), names_(place_), options_(std::move(options)) {}

Checker::Truth Checker::truth_at(const Laws& laws, const std::string& profile, int i, int j) const {
    const std::string key = profile + ' ' + std::to_string(i) + ',' + std::to_string(j);
    {
        const std::lock_guard lock(mutex_);
        const auto found = truths_.find(key);
        if (found != truths_.end()) {
            return found->second;
        }
    }
    const auto truth = std::make_shared<const RayTree<double>>(forge_tree(place_, laws, i, j));
    const std::lock_guard lock(mutex_);
    if (truths_.size() >= most_truths) {
        truths_.clear();
    }
    return truths_.emplace(key, truth).first->second;
}

/// False where there is nothing to compare with.
bool Checker::check_whole(const Submission& submission, Report& report) const {
    const Camera& camera = place_.scene().camera;
    const RayTree<double>& tree = submission.tree;
    if (tree.pixel_i >= camera.width || tree.pixel_j >= camera.height) {
        report.findings.push_back(of_the_whole(
            "pixel", "the pixel " + std::to_string(tree.pixel_i) + ',' +
                         std::to_string(tree.pixel_j) + " lies outside the picture of " +
                         std::to_string(camera.width) + " x " + std::to_string(camera.height)));
        return false;
    }
    if (submission.has_camera && !same(tree.camera, camera)) {
        report.findings.push_back(
            of_the_whole("camera", "its camera is not that of the scene; is it another scene?"));
    }
    const std::string setting =
        submission.has_settings ? other_setting(tree.settings, place_.scene().settings) : "";
    if (!setting.empty()) {
        report.findings.push_back(
            of_the_whole("settings", "its " + setting + " is not that of the scene"));
    }
    return true;
}

void Checker::check_fields(const Submission& submission, Report& report) const {
    for (std::size_t k = 0; k < field_count; ++k) {
        const Field field = static_cast<Field>(k);
        std::size_t missing = 0, first = 0, able = 0;
        for (std::size_t ray = 0; ray < submission.tree.rays.size(); ++ray) {
            if (can_give(submission.tree.rays[ray], field)) {
                ++able;
                first = missing == 0 && !submission.given[ray][k] ? ray : first;
                missing += submission.given[ray][k] ? 0 : 1;
            }
        }
        if (missing == 0) {
            continue;
        }
        const std::string what =
            std::string(word_of(field)) + " is not given by " +
            (missing == able ? "any ray"
                             : std::to_string(missing) + " of " + std::to_string(able) + " rays");
        if (options_.required[k]) {
            report.findings.push_back(of_the_whole(
                std::string(word_of(field)),
                what + ", first by ray " + submission.ids[first] + "; it is required"));
        } else {
            report.remarks.push_back(what);
        }
    }
}

void Checker::judge(const Submission& submission, const Laws& laws, Report& report) const {
    const Truth truth =
        truth_at(laws, report.profile, submission.tree.pixel_i, submission.tree.pixel_j);
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
        judged.emplace(place_, names_, laws, submission, options);
        judged->run();
    };
    replay();
    if (judged->causes() > 0) {
        slacks = slacks_of(place_, names_, laws, submission, options);
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
    if (judged->causes() > 0 && options_.name_mistakes) {
        diagnose(place_, names_, laws, submission, options, report);
    }
}

Report Checker::check(const Submission& submission) const {
    Report report;
    report.file = submission.file;
    report.rays = submission.tree.rays.size();
    report.ids = submission.ids;
    report.remarks = submission.remarks;
    report.precision = submission.precision.name;
    report.verdict = Verdict::fail;
    const Profile& profile = options_.profile ? profile_named(*options_.profile)
                                              : best_profile(place_, names_, submission);
    report.profile = profile.name;
    if (!check_whole(submission, report)) {
        return report;
    }
    check_fields(submission, report);
    judge(submission, laws_of(profile), report);
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

Report Checker::check_text(const std::string& text, const std::string& file) const {
    Report report;
    report.file = file;
    try {
        return check(parse_submission(text, file));
    } catch (const InputError& error) {
        for (const Mistake& mistake : error.mistakes()) {
            report.findings.push_back(of_the_whole(mistake.place, mistake.text));
        }
    } catch (const std::bad_alloc&) {
        report.findings.push_back(of_the_whole("", "needs more memory than there is"));
    } catch (const std::exception& error) {
        report.findings.push_back(of_the_whole("", error.what()));
    }
    report.verdict = Verdict::unreadable;
    return report;
}

Report Checker::check_file(const std::filesystem::path& file) const {
    try {
        return check_text(load_submission_text(file), file.string());
    } catch (const InputError& error) {
        Report report;
        report.file = file.string();
        for (const Mistake& mistake : error.mistakes()) {
            report.findings.push_back(of_the_whole(mistake.place, mistake.text));
        }
        return report;
    }
}

}  // namespace raytree::check
