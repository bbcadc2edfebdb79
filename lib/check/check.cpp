#include "check/check.h"

#include <algorithm>
#include <exception>
#include <new>

#include "check/diagnose.h"
#include "check/forge.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_truths = 64;  // kept for the next submission of the same pixel

constexpr std::size_t rays_for_profiles = 2000;  // enough to tell courses apart
constexpr std::size_t few_causes = 20;           // that rounding alone may make

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

bool near(double a, double b) { return std::abs(a - b) <= 1e-4 * std::max(1.0, std::abs(b)); }

bool same(const ImagePlane& a, const ImagePlane& b) {
    return near(a.left, b.left) && near(a.right, b.right) && near(a.bottom, b.bottom) &&
           near(a.top, b.top);
}

/// The window on the plane at distance 1, whichever way the camera gives it.
ImagePlane window_of(const Camera& camera) {
    if (const auto* plane = std::get_if<ImagePlane>(&camera.window)) {
        return *plane;
    }
    const double x =
        std::tan(std::get<HorizontalFov>(camera.window).degrees * Real<double>::pi / 360);
    const double y = x * camera.height / camera.width;
    return {-x, x, -y, y};
}

/// Whether both cameras send the same rays: `up` may have another length, or lean.
bool same(const Camera& a, const Camera& b) {
    const auto right = [](const Camera& camera) {
        return model::unit(outer(camera.look_at - camera.eye, camera.up));
    };
    return near(a.eye, b.eye) && a.width == b.width && a.height == b.height &&
           near(model::unit(a.look_at - a.eye), model::unit(b.look_at - b.eye)) &&
           near(right(a), right(b)) && near(a.near, b.near) && same(window_of(a), window_of(b));
}

/// How colours are rounded to 8 bits is seen in pictures alone.
Choices seen_in_trees(Choices choices) {
    std::erase_if(choices, [](const Convention* choice) { return choice->axis == "quantise"; });
    return choices;
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

/// False where there is nothing to compare with.
bool Checker::check_whole(const Submission& submission, Report& report) const {
    const Camera& camera = scene_.camera;
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
        submission.has_settings ? other_setting(tree.settings, scene_.settings) : "";
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
    if (judged->causes() > 0 && options_.name_mistakes) {
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

Report Checker::check(const Submission& submission) const {
    Report report;
    report.file = submission.file;
    report.rays = submission.tree.rays.size();
    report.ids = submission.ids;
    report.remarks = submission.remarks;
    report.precision = submission.precision.name;
    report.verdict = Verdict::fail;
    report.profile_asked_for = options_.profile.has_value();
    const Profile& profile =
        options_.profile ? profile_named(*options_.profile) : best_profile(submission);
    report.profile = profile.name;
    if (!check_whole(submission, report)) {
        return report;
    }
    check_fields(submission, report);
    const Rulebook& book = books_.of(profile);
    if (!report.profile_asked_for) {
        report.conventions =
            seen_in_trees(books_.differences(book.choices, books_.lecture().choices));
    }
    judge(submission, book, report);
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

Report Checker::check_file(const std::filesystem::path& file, const std::string& name) const {
    try {
        return check_text(load_submission_text(file), name);
    } catch (const InputError& error) {
        return refused(name, error.mistakes().front().text);
    }
}

}  // namespace raytree::check
