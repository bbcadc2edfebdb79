#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "check/planting.h"
#include "check/support.h"

namespace raytree::test {
namespace {

struct Score {
    int changed = 0, found = 0, first = 0, tied = 0, sure = 0, wrong_sure = 0, single = 0;
};

/// What of a tree is handed in.
struct Form {
    const char* name;
    int digits;                ///< 0: all
    std::vector<Field> given;  ///< empty: everything
    bool shadow_rays;
};

const Form forms[] = {
    {"everything", 0, {}, true},
    {"everything, six digits", 6, {}, true},
    {"origin, direction, hit, intensity, no shadow rays",
     0,
     {Field::origin, Field::direction, Field::hit, Field::object, Field::t, Field::intensity},
     false},
    {"the same, six digits",
     6,
     {Field::origin, Field::direction, Field::hit, Field::object, Field::t, Field::intensity},
     false},
    {"intensity alone", 0, {Field::intensity}, false},
};

/// Takes away what the form does not have.
void reduce(check::Submission& submission, const Form& form) {
    if (form.given.empty()) {
        return;
    }
    Given kept;
    for (const Field field : form.given) {
        kept.set(place_of(field));
    }
    for (Given& given : submission.given) {
        given &= kept;
    }
    if (!form.shadow_rays) {
        submission.has_shadow_rays = false;
        for (auto& children : submission.children) {
            std::erase_if(children, [&](std::size_t ray) {
                return submission.tree.rays[ray].shadow.has_value();
            });
        }
    }
}

void judge(const check::Checker& checker, const check::MistakeRow& row, const Spot& spot,
           const Form& form, Score& score, std::string& log) {
    std::string text = planted(checker, row, spot);
    if (text.empty()) {
        return;
    }
    text = form.digits > 0 ? with_digits(text, form.digits) : text;
    check::Submission submission = check::parse_submission(text, std::string(row.id));
    reduce(submission, form);
    const check::Report report = checker.check(submission);
    if (report.verdict != check::Verdict::fail) {
        return;
    }
    ++score.changed;
    bool found = false;
    for (const check::NamedMistake& named : report.mistakes) {
        const bool tied = std::ranges::find(named.ties, row.id) != named.ties.end();
        found = found || named.id == row.id || tied;
    }
    const bool any = !report.mistakes.empty();
    const check::NamedMistake none;
    const check::NamedMistake& top = any ? report.mistakes.front() : none;
    score.found += found ? 1 : 0;
    score.first += found && (top.id == row.id || !top.ties.empty()) ? 1 : 0;
    score.tied += found && !top.ties.empty() ? 1 : 0;
    score.sure += top.sure && top.id == row.id ? 1 : 0;
    const bool wrong = any && top.sure && !found;
    score.wrong_sure += wrong ? 1 : 0;
    score.single += report.causes() == 1 ? 1 : 0;
    if (found && !top.ties.empty()) {
        log += std::string(row.id) + " in " + spot.scene + ": " + top.id;
        for (const std::string& tie : top.ties) {
            log += " = " + tie;
        }
        log += '\n';
    }
    if (!found) {
        log += std::string(row.id) + " in " + spot.scene + ' ' + std::to_string(spot.i) + ',' +
               std::to_string(spot.j) + ": " + (any ? "taken for " + top.id : "not named") +
               (wrong ? " SURE" : "") + '\n' + in_words(report).substr(0, 900);
    }
}

/// Which spots and which mistakes: all, or a sample. Six samples hold every mistake.
struct Sample {
    std::size_t spots = 1;     ///< every so many
    std::size_t mistakes = 1;  ///< every so many, other ones at each spot
    std::size_t phase = 0;
};

/// Plants the mistakes of a sample; gives the sum, and the table for people.
Score plant_all(const Form& form, Sample sample, std::string& table, std::string& log) {
    check::CheckOptions options;
    options.profile = "lecture";
    std::map<std::string, Score> scores;
    for (std::size_t k = 0; k < std::size(spots); k += sample.spots) {
        const Scene scene = data_scene(spots[k].scene);
        const check::Checker checker(scene, options);
        for (std::size_t row = sample.phase++ % sample.mistakes; row < check::catalogue().size();
             row += sample.mistakes) {
            const check::MistakeRow& mistake = check::catalogue()[row];
            judge(checker, mistake, spots[k], form, scores[std::string(mistake.id)], log);
        }
    }
    Score all;
    table += std::string("\n") + form.name + "\nmistake changed found first tied sure\n";
    int silent = 0;
    for (const auto& [id, score] : scores) {
        char line[120];
        std::snprintf(line, sizeof line, "%-30s %4d %4d %4d %4d %4d\n", id.c_str(), score.changed,
                      score.found, score.first, score.tied, score.sure);
        table += line;
        silent += score.changed == 0 ? 1 : 0;
        all.changed += score.changed;
        all.found += score.found;
        all.first += score.first;
        all.tied += score.tied;
        all.sure += score.sure;
        all.wrong_sure += score.wrong_sure;
        all.single += score.single;
    }
    char line[250];
    std::snprintf(line, sizeof line,
                  "%s: %zu mistakes, %d silent; %d cases, %d found, %d first, %d tied, %d sure, "
                  "%d wrong and sure, %d with one cause\n",
                  form.name, scores.size(), silent, all.changed, all.found, all.first, all.tied,
                  all.sure, all.wrong_sure, all.single);
    table += line;
    MESSAGE(line);
    return all;
}

TEST_CASE("planted mistakes are found and named") {
    std::string table, log;
    const bool thorough = std::getenv("RAYTREE_PLANTED_TABLE") != nullptr;
    std::size_t phase = 0;
    for (const Form& form : forms) {
        CAPTURE(form.name);
        const bool whole = form.given.empty() && form.digits == 0;
        const Sample sample = thorough ? Sample{whole ? 1U : 5U, 1, 0}
                                       : Sample{whole ? 9U : 18U, is_slow ? 24U : 6U, phase};
        const Score all = plant_all(form, sample, table, log);
        phase += whole ? 2 : 1;
        CHECK(all.found >= 0.98 * all.changed);
        CHECK(all.first >= 0.9 * all.changed);
        CHECK(all.wrong_sure == 0);
    }
    if (const char* const file = std::getenv("RAYTREE_PLANTED_TABLE")) {
        std::ofstream(file) << table << log;
    }
}

TEST_CASE("ids of mistakes are unique, and their sentences end") {
    std::set<std::string_view> ids;
    for (const check::MistakeRow& row : check::catalogue()) {
        CAPTURE(row.id);
        CHECK(ids.insert(row.id).second);
        CHECK(row.text.ends_with("."));
    }
    CHECK(ids.size() >= 110);
}

}  // namespace
}  // namespace raytree::test
